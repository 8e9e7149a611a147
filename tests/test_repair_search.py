"""The search for a repair on equations made up for it: each kind of slip, hopeless ones, and a prover that says no."""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import replace

import pytest

from chasles.algebra import rings
from chasles.decisions.prediction import predict
from chasles.decisions.session import Session
from chasles.prover.decide import decide_problem
from chasles.repairs import repair as searching
from chasles.repairs.modular_testing import ModularTest
from chasles.repairs.repair import repair
from chasles.statements import (
    Chapter,
    Claim,
    Condition,
    Definition,
    Entry,
    Hypothesis,
    Problem,
    Section,
    Statement,
    load,
    nonzero,
    problem_of,
    unit,
)
from chasles.statements.statement import Equation
from chasles.verdict import Holds, HoldsUnder, Undecided, Verdict
from chasles.vocabulary import (
    CPM,
    FREQUENCY,
    Identity,
    Node,
    Zero,
    column,
    cos,
    cross,
    dot,
    matrix,
    norm,
    number,
    over,
    paren,
    plain,
    printed,
    rate,
    row,
    scalar,
    sin,
    square,
    tr,
    vector,
)
from chasles.vocabulary import (
    replace as replace_words,
)

from .sampling import WHOLE, sample

one, zero = Identity(3), Zero(3, 1)
u, x, y, z, e = (vector(name, name, "a vector") for name in "uxyze")
w = vector("w", "w", "a spin", FREQUENCY)
phi, theta = (scalar(name, name, "an angle") for name in ("phi", "theta"))
M = square("M", "M", "a rotation")
turning = Definition("1", M, e @ e.T + cos(phi) * (one - e @ e.T) + sin(phi) * CPM(e), assuming=(unit(e),))
along = dot(e, x) * e
across = paren(x - dot(e, x) * e)

SLIPS: dict[str, tuple[Claim, str]] = {
    "number": (Claim("9", CPM(x) @ CPM(x), x @ x.T - 2 * dot(x, x) * one), "x x^T - (x . x) 1"),
    "sign": (Claim("9", cross(x, cross(y, z)), dot(x, z) * y + dot(x, y) * z), "(x . z) y - (x . y) z"),
    "missing term": (Claim("9", CPM(x) @ CPM(x), x @ x.T), "x x^T - (x . x) 1"),
    "superfluous term": (Claim("9", tr(CPM(x) @ CPM(y)), -(2 * dot(x, y)) + dot(x, x)), "-2 (x . y)"),
    "order": (Claim("9", CPM(x) @ y, cross(y, x)), "-y x x"),
    "lost transpose": (Claim("9", paren(M @ M).T, M @ M.T, given=(turning,)), "M^T M^T"),
    "wrong letter": (Claim("9", CPM(x) @ y, cross(x, u), given=(Definition("2", u, 2 * z),)), "x x y"),
    "misread letter": (Claim("9", M @ x, along + cos(phi) * across + sin(theta) * cross(e, x), given=(turning,)), ""),
    "cosine": (Claim("9", M @ x, along + sin(phi) * across + sin(phi) * cross(e, x), given=(turning,)), ""),
    "missing function": (Claim("9", M @ x, along + cos(phi) * across, given=(turning,)), ""),
    "other term": (Claim("9", M - M.T, 2 * sin(phi) * e @ e.T, given=(turning,)), "2 sin(phi) CPM(e)"),
    "factor of a block": (
        Claim("9", column(2 * CPM(x) @ y, dot(x, x)), 2 * column(cross(x, y), dot(x, x))),
        "[2 (x x y); x . x]",
    ),
    "sign in a norm": (Claim("9", dot(x - y, x - y), norm(x + y) ** 2), "|x - y|^2"),
    "power": (Claim("9", dot(x, x), norm(x) ** 3, assuming=(nonzero(norm(x)),)), "|x|^2"),
    "block": (Claim("9", matrix((one, CPM(x)), (CPM(x).T, one)).T, matrix((one, CPM(x)), (one, one))), ""),
    "within a sign": (
        Claim("9", CPM(x) @ CPM(x), -paren(2 * dot(x, x) * one - x @ x.T)),
        "-((x . x) 1 - x x^T)",
    ),
    "rates": (Claim("9", rate(cross(x, y)), cross(rate(x), y)), "x_dot x y + x x y_dot"),
}


def proves(claim: Claim, left: Node, right: Node) -> bool:
    verdict = decide_problem(problem_of(replace(claim, left=left, right=right)))
    return isinstance(verdict, Holds | HoldsUnder)


@pytest.mark.sampled(3)
@pytest.mark.parametrize("slip", SLIPS)
def test_one_slip_is_one_change(slip: str) -> None:
    claim, expected = SLIPS[slip]
    assert not proves(claim, claim.left, claim.right)
    found = repair(claim)
    assert found
    assert found[0].edits == len(found[0].changes) == 1
    assert all(proves(claim, each.left, each.right) for each in found)
    assert not expected or expected in [plain(each.right) for each in found]


def kinds(claim: Claim) -> list[str]:
    """The kinds of the single changes that repair a claim, the first one first."""
    found = [each.changes[0] for each in repair(claim)]
    names = {"the sign of": "sign", "the factor": "factor", "is left out": "left out", "is added": "missing"}
    return [next((kind for words, kind in names.items() if words in change), "coefficient") for change in found]


def test_the_smallest_change_comes_first() -> None:
    by_half = over(1, 2) * column(CPM(x) @ y, dot(x, y))
    sign = Claim("9", CPM(x) @ y, -cross(x, y))
    factor = Claim("9", column(over(1, 2) * CPM(x) @ y, dot(x, y)), by_half)
    term = Claim("9", 3 * dot(x, y) * z, 2 * dot(x, y) * z)
    assert kinds(sign)[0] == "sign"
    assert kinds(factor)[:2] == ["factor", "coefficient"]
    assert kinds(term)[0] == "coefficient"
    assert all(kind != "missing" for claim in (sign, factor, term) for kind in kinds(claim)[:1])


def test_what_is_true_of_several_changes_is_told_as_it_is_for_one() -> None:
    """A number times a printed term is a factor and its opposite a sign, beside other changes too."""
    claim = Claim("9", M @ x, -along + 3 * cos(phi) * across + sin(phi) * cross(e, x), given=(turning,))
    first, *_ = repair(claim)
    assert first.edits == 2
    assert any(change.startswith("the sign of") for change in first.changes)
    assert plain(first.right) == "(e . x) e + cos(phi) (x - (e . x) e) + sin(phi) (e x x)"


def test_two_changes_are_found_together() -> None:
    claim = Claim("9", M @ x, 2 * along + cos(phi) * across, given=(turning,))
    found = repair(claim)
    assert {each.edits for each in found} == {2}
    assert all(proves(claim, each.left, each.right) for each in found)


def test_what_stood_in_brackets_and_was_dropped_is_found_as_two_terms() -> None:
    """Of the pairs of terms that could be missing none is passed over because there are many."""
    A, B = square("A", "A", "a matrix"), square("B", "B", "another")
    a, b, c, d = (vector(name, name, "a vector") for name in "abcd")
    whole = Definition("1", d, A @ a + B @ b - c)
    (found, *_) = repair(Claim("2", d, A @ a, given=(whole,)))
    assert plain(found.right) == "A a - c + B b"


def test_a_wrong_letter_beside_a_dropped_term_is_told_as_a_letter() -> None:
    phi, theta = scalar("phi", "phi", "an angle"), scalar("theta", "theta", "another")
    E, N = square("E", "E", "a matrix"), square("N", "N", "another")
    turning = Definition("1", N, sin(phi) * Identity(3) + (1 - cos(phi)) * E)
    turned = rate(phi) * cos(phi) * Identity(3) + rate(phi) * sin(theta) * E
    (found, *_) = repair(Claim("2", rate(N), turned, given=(turning,)))
    assert "phi instead of theta" in found.changes
    assert plain(found.right) == "phi_dot cos(phi) 1 + phi_dot sin(phi) E + (1 - cos(phi)) E_dot"


def test_a_change_in_each_block() -> None:
    claim = Claim("9", column(CPM(x) @ y, CPM(x) @ z), column(-cross(x, y), cross(z, x)))
    (found,) = repair(claim)
    assert found.edits == 1
    claim = Claim("9", column(CPM(x) @ y, CPM(x) @ z, dot(x, y)), column(-cross(x, y), cross(z, x), dot(y, x)))
    found, *_ = repair(claim)
    assert found.edits == 2
    assert proves(claim, found.left, found.right)


def test_lost_separator_and_lost_factor() -> None:
    blocks = Claim("9", row(CPM(x), y), printed(lambda: row(-CPM(x).T @ y)), corrected=row(CPM(x), y))
    (found,) = repair(blocks)
    assert found.marks == found.edits == 1
    assert plain(found.right) == "[-CPM(x)^T, y]"
    projected = CPM(e) @ CPM(e) @ x + x
    scalar_for_vector = Claim("9", projected, printed(lambda: dot(e, x)), assuming=(unit(e),), corrected=projected)
    (found,) = repair(scalar_for_vector)
    assert found.changes == ("the vector factor e is added",)


HOPELESS = (
    Claim("9", dot(x, y), norm(x) * norm(y)),
    Claim("9", M, CPM(x), given=(turning,)),
    Claim("9", norm(x + y), norm(x) + norm(y)),
    # Another letter would only repeat the left side.
    Claim("9", norm(x) ** 2, norm(y) ** 2, assuming=(nonzero(norm(y)),)),
    # Nothing of the print would stay.
    Claim("9", CPM(x) @ CPM(x), y @ y.T, assuming=(nonzero(norm(y)),)),
)


@pytest.mark.sampled(3)
@pytest.mark.parametrize("claim", HOPELESS, ids=lambda claim: plain(claim.right))
def test_the_hopeless_is_not_repaired(claim: Claim) -> None:
    assert repair(claim) == ()


def test_only_claims_that_fail_are_repaired() -> None:
    assert repair(Claim("9", CPM(x) @ y, cross(x, y))) == ()
    assert repair(turning) == ()
    assert repair(Condition("9", dot(x, y), dot(x, x), on=(x,))) == ()


def test_what_rests_on_the_statement_is_not_asked() -> None:
    wrong = Claim("9", rate(M), CPM(w))
    later = Claim("10", rate(u), M @ rate(z), given=(wrong,))

    def accepted(statement: Statement) -> Equation:
        assert statement.number != "9"
        return statement.printed

    assert repair(wrong, accepted, context=(wrong, later)) == ()


def test_what_rests_on_a_statement_that_does_not_stand_is_not_repaired() -> None:
    claim = Claim("9", z, 2 * cross(x, y), given=(Definition("8", z, cross(x, y)),))
    assert repair(claim)

    def accepted(statement: Statement) -> Equation:
        raise TypeError(f"({statement.number}) does not stand")

    assert repair(claim, accepted) == ()


def test_nothing_is_given_that_was_not_proved(monkeypatch: pytest.MonkeyPatch) -> None:
    claim, _ = SLIPS["number"]
    assert repair(claim)
    monkeypatch.setattr(searching, "decided", lambda *_: Undecided("the prover is asleep"))
    assert repair(claim) == ()


def test_only_what_the_prover_confirms_is_given(monkeypatch: pytest.MonkeyPatch) -> None:
    claim, _ = SLIPS["sign in a norm"]
    first, *others = repair(claim)
    assert others

    def not_the_first(problem: Problem, own: tuple[Hypothesis, ...] = ()) -> Verdict:
        right = problem.goals[0].right
        return Undecided("not this one") if right == first.right else decide_problem(problem, own)

    monkeypatch.setattr(searching, "decided", not_the_first)
    assert [each.right for each in repair(claim)][: len(others)] == [each.right for each in others]


def test_candidates_that_do_not_even_agree_at_points_are_refuted(monkeypatch: pytest.MonkeyPatch) -> None:
    claim, _ = SLIPS["sign"]
    monkeypatch.setattr(ModularTest, "holds", lambda *_: True)
    assert all(proves(claim, each.left, each.right) for each in repair(claim))


@pytest.fixture
def without_flint(monkeypatch: pytest.MonkeyPatch) -> Iterator[None]:
    monkeypatch.setenv("CHASLES_POLYNOMIALS", "sympy")
    rings.backend.cache_clear()
    yield
    monkeypatch.undo()
    rings.backend.cache_clear()


def searched() -> list[tuple[str, ...]]:
    book = {entry.name: entry.statement for entry in load()}
    names = ("rate_of_natural_velocity_matrix", "upper_block_of_natural_rate_matrix_rate")
    claims = [statement for name in names if isinstance(statement := book[name], Claim)]
    return [
        (plain(each.right), *each.changes)
        for claim in (*(claims if WHOLE else claims[:1]), *sample([c for c, _ in SLIPS.values()], 3))
        for each in repair(claim)
    ]


@pytest.mark.slow
def test_either_kind_of_polynomials_finds_the_same(request: pytest.FixtureRequest) -> None:
    found = searched()
    request.getfixturevalue("without_flint")
    assert rings.backend() == "sympy"
    assert searched() == found


def _of_a_quaternion(right: Node) -> tuple[Chapter, Claim]:
    """That it has length one is said of the definition, which is all that the claim is given."""
    a, q0 = vector("a", "a", "a vector part"), scalar("q0", "q_0", "a scalar part")
    length = Condition("1", dot(a, a) + q0**2, number(1), on=(a, q0))
    turned = Definition("2", M, (q0**2 - dot(a, a)) * one - 2 * q0 * CPM(a) + 2 * a @ a.T, given=(length,))
    claim = Claim("3", M @ a, replace_words(right, {x: a}), given=(turned,))
    entries = (Entry(f"s{k}", Section("1", "Attitude"), each) for k, each in enumerate((length, turned, claim)))
    return Chapter("A book", tuple(entries)), claim


def test_the_simplest_is_found_whatever_brings_it() -> None:
    book, claim = _of_a_quaternion(-x)
    correction = Session(book=book).decide(claim).correction
    assert correction is not None
    assert correction.sides == (claim.left, claim.right.term)


def test_nothing_is_searched_for_that_holds_by_all_it_rests_on(monkeypatch: pytest.MonkeyPatch) -> None:
    searched: list[Statement] = []
    monkeypatch.setattr(Session, "search", lambda _, statement: searched.append(statement) or {})
    for right, count in ((x, 0), (-x, 1)):
        book, _ = _of_a_quaternion(right)
        predict(Session(book=book), [entry.statement for entry in book])
        assert len(searched) == count
