"""What a declaration may say, what `load` refuses, and what is to be decided for every kind of sentence."""

from __future__ import annotations

import re
import sys
from collections.abc import Callable, Iterator
from fractions import Fraction
from operator import methodcaller
from pathlib import Path
from typing import Any

import pytest

from chasles.prover.decide import decide_problem
from chasles.statements import (
    Always,
    Chapter,
    Claim,
    Condition,
    DeclarationError,
    Definition,
    Entry,
    Exists,
    Goal,
    Hypothesis,
    Iff,
    Inverse,
    Minimum,
    Postulate,
    Section,
    Statement,
    Theorem,
    Unique,
    half_turn,
    load,
    nonzero,
    orthonormal,
    perpendicular,
    positive,
    problem_of,
    rotation,
    symmetric,
    unit,
)
from chasles.verdict import Fails, Holds, HoldsUnder
from chasles.vocabulary import (
    CPM,
    FREQUENCY,
    LENGTH,
    MASS,
    Cofactor,
    Family,
    Identity,
    Index,
    Kronecker,
    Misfit,
    Negative,
    Node,
    Number,
    Scale,
    Sum,
    Symbol,
    Zero,
    abbreviation,
    at,
    column,
    cos,
    cross,
    det,
    dot,
    inverse,
    norm,
    number,
    printed,
    rate,
    scalar,
    sin,
    square,
    vector,
)

e, u = vector("e", "e", ""), vector("u", "u", "")
a, p, q = (vector(name, name, "", LENGTH) for name in ("a", "p", "q"))
omega = vector("omega", r"\omega", "", FREQUENCY)
phi, k, mass = scalar("phi", r"\phi", ""), scalar("k", "k", ""), scalar("m", "m", "", MASS)
Q, A = square("Q", "Q", ""), square("A", "A", "")
E = abbreviation("E", "E", CPM(e), "")
one, zero = Identity(3), Zero(3, 1)
i, j = Index("i"), Index("j")
triad = tuple(vector(f"e_{n}", f"e_{n}", "") for n in (1, 2, 3))
e_of = Family(r"\mathbf{e}", triad)

the_rotation = Definition("2.49", Q, e @ e.T + cos(phi) * (one - e @ e.T) + sin(phi) * E, assuming=(unit(e),))
in_section = Section("3.2", "A section")


def goals(*arguments: Any) -> list[tuple[Node, Node]]:
    return [(goal.left, goal.right) for goal in problem_of(*arguments).goals]


# Sides that do not fit.


@pytest.mark.parametrize(
    ("left", "right", "said"),
    [
        (a, phi, "a (3 x 1) and phi (a scalar)"),
        (a, e, "a [m] and e [no dimension]"),
        (a, printed(lambda: p + e), "cannot add p [m] and e [no dimension]"),
    ],
)
@pytest.mark.parametrize("role", [Definition, Condition, Postulate, Claim])
def test_sides_that_do_not_fit_are_printed_so_or_a_mistake(
    role: type[Statement], left: Node, right: Node, said: str
) -> None:
    with pytest.raises(Misfit) as error:
        role("3.99", left, right)
    assert said in str(error.value)
    assert str(error.value).startswith("(3.99) does not fit")
    assert "`sic=True`" in str(error.value)
    read = role("3.99", left, right, reading=p)
    assert read.fault is not None
    assert said in read.fault
    assert read.form("reading") == (a, p)
    assert role("3.99", left, right, corrected=(p, a)).form("corrected") == (p, a)


def test_what_fits_has_no_fault_and_no_other_form() -> None:
    claim = Claim("1", a, p)
    assert claim.fault is None
    assert claim.form("printed") == claim.printed == (a, p)
    assert not claim.form_exists("reading")
    with pytest.raises(KeyError, match="has no reading form"):
        claim.form("reading")


def test_an_ill_formed_print_has_no_problem_but_its_reading_has() -> None:
    claim = Claim("3.57", a, dot(p, q / norm(q)), reading=p)
    with pytest.raises(Misfit, match="equate a"):
        problem_of(claim)
    assert goals(claim, "reading") == [(a, p)]


def test_a_reading_must_fit_too() -> None:
    with pytest.raises(Misfit, match=r"equate a \(3 x 1\) and k"):
        problem_of(Claim("1", a, phi, reading=k), "reading")
    with pytest.raises(Misfit, match=r"equate phi .* and a"):
        problem_of(Theorem("Thm", "", (Always(phi, a),)))


# Hypotheses.


@pytest.mark.parametrize("hypothesis", [unit, positive, symmetric, rotation, half_turn])
@pytest.mark.parametrize("subject", [Q @ e, Q @ Q, -phi, E, rate(a), one])
def test_hypotheses_are_said_of_symbols(hypothesis: Callable[[Node], Hypothesis], subject: Node) -> None:
    with pytest.raises(TypeError, match="is said of a symbol"):
        hypothesis(subject)


def test_hypotheses_on_several_vectors_are_said_of_symbols() -> None:
    for write in (
        lambda: perpendicular(a, Q @ a),
        lambda: perpendicular(-a, p),
        lambda: orthonormal(e, u, cross(e, u)),
    ):
        with pytest.raises(TypeError, match="is said of a symbol"):
            write()


@pytest.mark.parametrize(
    "write",
    [
        lambda: unit(a),
        lambda: unit(Q),
        lambda: symmetric(e),
        lambda: rotation(square("M", "M", "", MASS)),
        lambda: rotation(e),
        lambda: orthonormal(a, p, q),
        lambda: perpendicular(e, Q),
    ],
)
def test_a_hypothesis_must_fit(write: Callable[[], Hypothesis]) -> None:
    with pytest.raises(Misfit):
        write()


@pytest.mark.parametrize("write", [lambda: positive(e), lambda: nonzero(e), lambda: nonzero(Q)])
def test_only_a_scalar_is_positive_or_not_zero(write: Callable[[], Hypothesis]) -> None:
    with pytest.raises(TypeError, match="is said of a scalar"):
        write()


def test_hypotheses_speak_to_the_reader() -> None:
    said = [
        (unit(e), r"\|\mathbf{e}\| = 1", "|e| = 1"),
        (nonzero(1 - cos(phi)), r"1 - \cos \phi \neq 0", "1 - cos(phi) != 0"),
        (nonzero(1 - cos(phi), r"\phi \neq 0"), r"\phi \neq 0", "phi != 0"),
        (nonzero(norm(p - q), r"\mathbf{p} \neq \mathbf{q}"), r"\mathbf{p} \neq \mathbf{q}", "p != q"),
        (positive(mass), "m > 0", "m > 0"),
        (perpendicular(a, p), r"\mathbf{a} \perp \mathbf{p}", "a is perpendicular to p"),
    ]
    assert [(h.latex, h.text) for h, _, _ in said] == [(latex, text) for _, latex, text in said]
    assert nonzero(phi).equations == ()
    assert len(rotation(Q).equations) == 3


# What is to be decided, for every role.


def test_a_definition_has_nothing_to_decide() -> None:
    problem = problem_of(the_rotation)
    assert problem.goals == problem.rules == problem.conditions == ()
    assert problem.hypotheses == (unit(e),)


def test_a_postulate_states_its_equation() -> None:
    assert goals(Postulate("3.137", a, p)) == [(a, p)]


def test_a_claim_states_its_equation() -> None:
    assert problem_of(Claim("1", a, p)).goals == (Goal("", a, p),)


def test_a_claim_about_an_inverse_states_both_products() -> None:
    assert goals(Claim("1", inverse(Q), A)) == [(Q @ A, one), (A @ Q, one)]


def test_a_claim_with_indices_states_all_instances() -> None:
    claim = Claim("1", dot(e_of[i], e_of[j]), Kronecker(i, j))
    assert goals(claim)[:2] == [(dot(triad[0], triad[0]), number(1)), (dot(triad[0], triad[1]), number(0))]
    assert len(goals(claim)) == 9


def test_a_condition_states_its_equation_or_that_its_solution_satisfies_it() -> None:
    assert goals(Condition("1", a, p, on=(p,))) == [(a, p)]
    solved = Condition("2", p - a, q, on=(p,), solution=q + a)
    assert goals(solved) == [(Sum((q + a, Negative(a))), q)]


def test_a_restatement_is_a_multiple_of_what_it_restates() -> None:
    other = Condition("1", Q @ p, a, on=(p,))
    same = Claim("2", Q @ p - a, zero, restates=other)
    assert goals(same) == [(Sum((Q @ p - a, Negative(zero))), Sum((Q @ p, Negative(a))))]
    by_matrix = Claim("3", Q.T @ Q @ p, Q.T @ a, restates=other, by=Q.T)
    assert goals(by_matrix)[0][1] == Q.T @ Sum((Q @ p, Negative(a)))
    by_number = Claim("4", a, Q @ p, restates=other, by=-1)
    assert goals(by_number)[0][1] == Scale(Number(Fraction(-1)), Sum((Q @ p, Negative(a))))
    stacked = Claim("5", column(Q @ p, p), column(a, a), restates=(other, Condition("6", p, a)))
    assert goals(stacked)[0][1] == column(Sum((Q @ p, Negative(a))), Sum((p, Negative(a))))
    assert isinstance(decide_problem(problem_of(by_matrix)), Holds)


def test_a_restatement_restates_the_form_that_stands() -> None:
    misread = Condition("1", p, phi, reading=q, on=(p,))
    restated = Claim("2", -p, -q, restates=misread, by=-1)
    assert goals(restated)[0][1] == Scale(Number(Fraction(-1)), Sum((p, Negative(q))))
    solution = Claim("3", p, q, solves=misread)
    assert goals(solution) == [(q, q)]


def test_a_solution_is_put_into_the_equation() -> None:
    equation = Condition("1", Q @ p, a, on=(p,))
    assert goals(Claim("2", p, inverse(Q) @ a, solves=equation)) == [(Q @ ((Cofactor(Q).T / det(Q)) @ a), a)]
    with pytest.raises(TypeError, match=r"\(3\) solves \(1\) for Q p, which is no symbol"):
        problem_of(Claim("3", Q @ p, a, solves=equation))


# What is given.


def test_definitions_claims_and_rates_are_rules() -> None:
    velocity = Definition("1", omega, e / scalar("T", "T", "", LENGTH) * scalar("c", "c", "", LENGTH * FREQUENCY))
    moving = Claim("2", rate(at(p)), cross(omega, at(p)))
    problem = problem_of(Claim("3", a, p, given=(the_rotation, velocity, moving)))
    assert [left for left, _ in problem.rules] == [Q, omega, rate(p)]


def test_a_family_given_is_a_rule_for_each_member() -> None:
    orthogonal = Claim("1", dot(e_of[i], e_of[j]), Kronecker(i, j), assuming=(orthonormal(*triad),))
    problem = problem_of(Claim("2", a, p, given=(orthogonal,)))
    assert len(problem.rules) == 9
    assert problem.rules[1] == (dot(triad[0], triad[1]), number(0))


def test_conditions_determine_their_symbols() -> None:
    on_plane, on_line = Condition("1", e.T @ p, number(0) * norm(p), on=(p,)), Condition("2", p, a, on=(p,))
    on_nothing = Condition("3", dot(e, e), number(1), assuming=(unit(e),))
    problem = problem_of(Claim("4", p, a, given=(on_plane, on_line, on_nothing)))
    assert problem.unknowns == (p,)
    assert [goal.label for goal in problem.conditions] == ["(1)", "(2)"]
    assert problem.rules == ()
    assert [h.text for h in problem.hypotheses] == ["|e| = 1", "(3.1)"]


def test_hypotheses_of_all_that_a_statement_rests_on_are_collected_once() -> None:
    first = Claim("1", k, cos(phi), assuming=(nonzero(phi),), given=(the_rotation,))
    second = Claim("2", k, cos(phi), assuming=(unit(u), nonzero(phi)), given=(first,))
    assert problem_of(second).hypotheses == (unit(u), nonzero(phi), unit(e))


@pytest.mark.parametrize(
    ("given", "said"),
    [
        (Condition("1", cross(e, u), zero, on=(u,), solution=k * e), r"\(1\), which leaves u free"),
        (Theorem("Thm 1", "", (Always(a, p),)), r"part 1 of `given` is a Theorem, and must be a Statement"),
    ],
)
def test_what_cannot_be_used_is_refused(given: Any, said: str) -> None:
    with pytest.raises(TypeError, match=said):
        problem_of(Claim("9", a, p, given=(given,)))


def test_rules_that_contradict_or_chase_each_other_are_refused() -> None:
    by_axis, by_another = Definition("1", p, a), Definition("2", p, -a)
    with pytest.raises(TypeError, match=r"\(9\) is given two statements that say what p is"):
        problem_of(Claim("9", a, p, given=(by_axis, by_another)))
    assert problem_of(Claim("9", a, p, given=(by_axis, Claim("2", p, a)))).rules == ((p, a), (p, a))
    with pytest.raises(TypeError, match=r"say what . is by . itself: state one of them as a Condition"):
        problem_of(Claim("9", a, p, given=(Definition("1", p, -q), Definition("2", q, -p))))
    spinning = (Definition("1", rate(p), cross(omega, p)),)
    assert len(problem_of(Claim("9", a, q, given=spinning)).rules) == 1


def test_what_no_rule_says_is_used_as_it_stands() -> None:
    hidden = abbreviation("P", "P", CPM(p), "")
    for given in (Claim("1", Q @ p, a), Claim("1", e, Q @ e), Claim("1", p, hidden @ e), Postulate("1", Q @ p, a)):
        problem = problem_of(Claim("9", a, q, given=(given,)))
        assert (problem.rules, [h.text for h in problem.hypotheses]) == ((), ["(1)"])
    by_axis, by_another = Definition("1", p, a), Claim("2", p, -a)
    for order in ((by_axis, by_another), (by_another, by_axis)):
        problem = problem_of(Claim("9", a, q, given=order))
        assert (problem.rules, [h.text for h in problem.hypotheses]) == (((p, a),), ["(2)"])


def test_a_given_statement_stands_in_the_form_it_is_said_to() -> None:
    given = Claim("1", p, a, corrected=-a)
    claim = Claim("2", p, a, given=(given,))
    assert problem_of(claim).rules == ((p, a),)
    assert problem_of(claim, standing=methodcaller("form", "corrected")).rules == ((p, -a),)


# Theorems.


def test_always_is_an_equation() -> None:
    assert goals(Theorem("T", "", (Always(a, p), Always(e, u)))) == [(a, p), (e, u)]


def test_a_minimum_is_a_sum_of_squares_that_vanish_there() -> None:
    form = Minimum(of=norm(p) ** 2 + k**2 * norm(a) ** 2, value=k**2 * norm(a) ** 2, over=p, at=0 * a, squares=(p,))
    theorem = Theorem("T", "", (form,))
    (excess, squares), (there, nothing) = goals(theorem)
    assert excess == Sum((form.of, Negative(form.value)))
    assert squares == dot(p, p)
    assert (there, nothing) == (0 * a, Zero(3, 1))
    assert isinstance(decide_problem(problem_of(theorem)), Holds)
    wrong = Minimum(form.of, form.value, over=p, at=a, squares=(p,))
    assert isinstance(decide_problem(problem_of(Theorem("T", "", (wrong,)))), Fails)


def test_several_squares_are_added() -> None:
    form = Minimum(of=norm(p) ** 2 + norm(q) ** 2, value=0 * norm(a) ** 2, over=p, at=q - q, squares=(p, q))
    assert goals(Theorem("T", "", (form,)))[0][1] == Sum((dot(p, p), dot(q, q)))
    assert len(goals(Theorem("T", "", (form,)))) == 3


def test_if_and_only_if_carries_a_multiplier_each_way() -> None:
    form = Iff(one=Q @ p, other=p, forth=Q.T, back=Q)
    assert goals(Theorem("T", "", (form,))) == [(p, Q.T @ (Q @ p)), (Q @ p, Q @ p)]
    verdict = decide_problem(problem_of(Theorem("T", "", (form,), assuming=(rotation(Q),))))
    assert isinstance(verdict, HoldsUnder)
    assert isinstance(decide_problem(problem_of(Theorem("T", "", (form,)))), Fails)
    scaled = Iff(one=2 * p, other=p, forth=number(1) / 2, back=number(2))
    assert isinstance(decide_problem(problem_of(Theorem("T", "", (scaled,)))), Holds)


def test_existence_is_a_witness() -> None:
    form = Exists(p, witness=Q.T @ a, left=Q @ p, right=a)
    assert goals(Theorem("T", "", (form,))) == [(Q @ (Q.T @ a), a)]
    verdict = decide_problem(problem_of(Theorem("T", "", (form,), assuming=(rotation(Q),))))
    assert isinstance(verdict, HoldsUnder)


def test_uniqueness_is_a_left_inverse() -> None:
    form = Unique(p, residual=Q @ p - a, by=Q.T)
    ((left, right),) = goals(Theorem("T", "", (form,)))
    other = Symbol("p_other", r"\mathbf{p}^*", p.size)
    assert left == Sum((p, Negative(other)))
    assert right == Q.T @ Sum((Q @ p - a, Negative(Q @ other - a)))
    verdict = decide_problem(problem_of(Theorem("T", "", (form,), assuming=(rotation(Q),))))
    assert isinstance(verdict, HoldsUnder)
    assert isinstance(decide_problem(problem_of(Theorem("T", "", (form,)))), Fails)


def test_rules_that_hide_the_varied_symbol_are_applied_first() -> None:
    minus_p = Definition("1", q, -p)
    not_unique = Theorem("T", "", (Unique(p, residual=p + q, by=number(1)),), given=(minus_p,))
    assert isinstance(decide_problem(problem_of(not_unique)), Fails)
    hidden_twice = (Definition("1", q, a - p), Definition("2", u, 1 / norm(a) * q))
    form = Exists(p, witness=a, left=u, right=zero)
    theorem = Theorem("T", "", (form,), given=hidden_twice, assuming=(nonzero(norm(a)),))
    assert isinstance(decide_problem(problem_of(theorem)), HoldsUnder)
    assert goals(theorem) == [(1 / norm(a) * (a - a), zero)]


@pytest.mark.parametrize(
    ("form", "given", "said"),
    [
        (Minimum(norm(p), norm(p), p, a, (0 * p,)), (), r"the least value, \|p\|, depends on p"),
        (
            Minimum(norm(p), norm(q), p, a, (0 * p,)),
            (Definition("1", q, -p),),
            r"the least value, \|-p\|, depends on p",
        ),
        (Minimum(norm(p), norm(a), p, -p, (p,)), (), r"the value put in its place, -p, depends on p"),
        (Exists(p, p, p, a), (), "the value put in its place, p, depends on p"),
        (Exists(p, q, p, a), (Definition("1", q, 2 * p),), "the value put in its place, .*, depends on p"),
        (Exists(p, a, p, a), (Definition("1", p, a),), "cannot be given what determines p"),
        (Exists(p, a, p, a), (Condition("1", p, a, on=(p,)),), "cannot be given what determines p"),
        (Unique(p, p - a, number(1)), (Condition("1", q, p, on=(q,)),), "cannot be given what determines p"),
    ],
)
def test_what_must_not_depend_on_the_varied_symbol_is_refused(
    form: Any, given: tuple[Statement, ...], said: str
) -> None:
    with pytest.raises(TypeError, match=rf"\(Thm 1\): .*{said}"):
        problem_of(Theorem("Thm 1", "", (form,), given=given))


def test_a_witness_must_satisfy_what_is_assumed_of_the_symbol() -> None:
    form = Exists(e, witness=2 * u, left=cross(e, u), right=zero)
    theorem = Theorem("T", "", (form,), assuming=(unit(e), unit(u)))
    assert goals(theorem)[1] == (dot(2 * u, 2 * u), number(1))
    assert isinstance(decide_problem(problem_of(theorem)), Fails)
    right = Theorem("T", "", (Exists(e, u, cross(e, u), zero),), assuming=(unit(e), unit(u)))
    assert isinstance(decide_problem(problem_of(right)), HoldsUnder)
    with pytest.raises(TypeError, match=r"\(T\): a theorem varies phi, of which phi != 0 is assumed"):
        problem_of(Theorem("T", "", (Exists(phi, k, phi, k),), assuming=(nonzero(phi),)))


# The chapter.


def chapter(*statements: Any) -> Chapter:
    entries = tuple(Entry(f"s{place}", in_section, statement) for place, statement in enumerate(statements))
    return Chapter("A book", entries)


def test_a_number_is_said_once_for_each_part() -> None:
    assert chapter(Claim("3.1", a, p), Claim("3.1", a, p, part=2)).numbers == ("3.1",)
    with pytest.raises(
        DeclarationError, match=r"s0 and s1 are both declared as \(3\.1\), part 1: give the second another"
    ):
        chapter(Claim("3.1", a, p), Definition("3.1", a, p))


def test_a_name_is_given_once() -> None:
    entries = (Entry("twist", in_section, Claim("1", a, p)), Entry("twist", in_section, Claim("2", a, p)))
    with pytest.raises(DeclarationError, match=r"\(1\) and \(2\) are both called twist"):
        Chapter("A book", entries)


def test_nothing_rests_on_what_comes_later() -> None:
    later = Condition("3.2", a, p, on=(p,))
    for early in (
        Claim("3.1", a, p, given=(later,)),
        Claim("3.1", a, p, restates=later),
        Claim("3.1", a, p, restates=(Claim("3.0", a, p), later)),
        Claim("3.1", p, a, solves=later),
        Theorem("3.1", "", (Always(a, p),), given=(later,)),
        Inverse("3.1", later, branches=(), gives=()),
    ):
        assert chapter(later, early)
        with pytest.raises(DeclarationError, match=r"s0 \(3\.1\) rests on \(3\.2\), which does not come before it"):
            chapter(early, later)


def test_numbers_are_in_the_book_s_order() -> None:
    numbers = ("text 3.2 a", "Ex 3.8", "Thm 3.2.2", "3.10", "3.9b", "Cor 3.4.1", "3.9a", "3.100", "2.49")
    book = chapter(*(Claim(number_, a, p) for number_ in numbers))
    assert book.numbers[:5] == ("2.49", "3.9a", "3.9b", "3.10", "3.100")
    assert set(book.numbers[5:]) == {"text 3.2 a", "Ex 3.8", "Thm 3.2.2", "Cor 3.4.1"}


def test_entries_are_selected_by_number_name_and_section() -> None:
    sections = (Section("3.2", "One"), Section("3.2.1", "Within"), Section("3.20", "Another"))
    entries = tuple(Entry(f"s{n}", section, Claim(f"3.{n}", a, p)) for n, section in enumerate(sections))
    book = Chapter("A book", entries)
    assert book.sections == sections
    assert book.select() == entries == tuple(book)
    assert book.select(["3.1"]) == book.select(["s1"]) == book.select(sections=["3.2.1"]) == entries[1:2]
    assert book.select(sections=["3.2"]) == entries[:2]
    for numbers, names in ((["3.7"], []), ([], ["3.3"])):
        with pytest.raises(KeyError, match=r"3\.7|3\.3"):
            book.select(numbers, names)


# Loading a book from a package.


@pytest.fixture
def write_book(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> Iterator[Callable[..., str]]:
    """Writes a package of declarations and returns its name; forgets it afterwards."""
    monkeypatch.syspath_prepend(tmp_path)
    names: list[str] = []

    def write(**modules: str) -> str:
        name = f"book_{len(names)}_{tmp_path.name.replace('-', '_')}"
        (tmp_path / name).mkdir()
        for module, text in modules.items():
            (tmp_path / name / f"{module}.py").write_text(text.replace("BOOK", name), "utf-8")
        names.append(name)
        return name

    yield write
    for module in [module for module in sys.modules if module.split(".")[0] in names]:
        del sys.modules[module]


NOTATION = """
from chasles.statements import *
from chasles.vocabulary import *
a, p = vector("a", "a", "", LENGTH), vector("p", "p", "", LENGTH)
"""
FIRST = """
from BOOK.notation import *
motion = Section("3.2", "Motion")
displacement = Definition("3.1", p, a)
within = Section("3.2.1", "Its screw")
claim = Claim("3.2", p, a, given=(displacement,))
"""
SECOND = """
from BOOK.notation import *
from BOOK.first import displacement
rest = Section("3.3", "Rest")
another = Claim("3.3", -p, -a, given=(displacement,))
"""


def test_a_book_is_loaded_section_by_section(write_book: Callable[..., str]) -> None:
    name = write_book(
        __init__='SECTIONS = ("first", "second")\nTITLE = "A book"\n', notation=NOTATION, first=FIRST, second=SECOND
    )
    book = load(name)
    assert book.title == "A book"
    assert [(entry.name, entry.number, entry.section.number) for entry in book] == [
        ("displacement", "3.1", "3.2"),
        ("claim", "3.2", "3.2.1"),
        ("another", "3.3", "3.3"),
    ]
    assert book.entries[2].statement.given == (book.entries[0].statement,)


@pytest.mark.parametrize(
    ("modules", "said"),
    [
        ({"__init__": "", "first": ""}, "has no SECTIONS"),
        (
            {"__init__": "SECTIONS = ('first',)", "first": FIRST.replace("motion =", "motion = 0 and")},
            "before any Section",
        ),
        (
            {"__init__": "SECTIONS = ('first',)", "first": FIRST.replace('"3.2", p', '"3.1", p')},
            r"both declared as \(3\.1\)",
        ),
        ({"__init__": "SECTIONS = ('second', 'first')", "first": FIRST, "second": SECOND}, "before any Section"),
    ],
)
def test_a_contradictory_book_is_refused(write_book: Callable[..., str], modules: dict[str, str], said: str) -> None:
    with pytest.raises(DeclarationError, match=said):
        load(write_book(notation=NOTATION, **modules))


def test_a_typo_and_a_missing_book_fail_at_import(write_book: Callable[..., str]) -> None:
    misspelled = FIRST.replace("given=(displacement,)", "given=(displacment,)")
    with pytest.raises(NameError, match="displacment"):
        load(write_book(__init__="SECTIONS = ('first',)", notation=NOTATION, first=misspelled))
    with pytest.raises(ModuleNotFoundError):
        load("no_such_book")


LEANING = re.compile(r"(The same|It|Its|They|Their|This|That|These|Those|So|Nor|Likewise|Here|There is such|With it)\b")


def test_what_a_statement_of_the_book_says_can_be_understood_alone() -> None:
    """A kernel's documentation, a verdict in the terminal and an erratum show it without what stands before it."""
    leaning = [f"{entry.number}: {entry.statement.says}" for entry in load() if LEANING.match(entry.statement.says)]
    assert leaning == []
    assert LEANING.match("The same by a scalar product.")
