"""Every road is walked to its end, each step decided; a step that is not true stops it; `chasles derive` shows it."""

from __future__ import annotations

import json
import re
from dataclasses import replace

import pytest
from chasles.derivations import s02_screw, s03_fixed_point
from chasles.derivations.notation import A_screw, E, N_tilde, Omega, Q, a, alpha, d_A, d_P, e, omega, one, p, phi
from click.testing import CliRunner, Result

from chasles.cli import main
from chasles.cli.answers import chosen_derivations
from chasles.decisions.memory import Memory
from chasles.decisions.recalled import shipped
from chasles.decisions.session import Session
from chasles.deriving import CheckedDerivation, CheckedStep, state, steps, walk
from chasles.statements import Claim, DeclarationError, Definition, Statement, load, nonzero
from chasles.statements.derivation import (
    Ansatz,
    Compare,
    Consider,
    Derivation,
    DerivationStep,
    Differentiate,
    Factor,
    Solve,
    Substitute,
    Take,
)
from chasles.statements.derivations import declared_derivations
from chasles.statements.packages import BOOK
from chasles.verdict import Fails, Undecided
from chasles.vocabulary import Negative, Node, Number, Scale, cos, inverse, plain, rate, scalar, sin

from .sampling import WHOLE, sample

ROADS = declared_derivations()
SOME = sample(ROADS, 4)
KINDS = {
    "take", "consider", "substitute", "expand", "ansatz", "solve", "differentiate", "factor", "multiply",
    "take the vector of", "compare",
}  # fmt: skip
DIFFERENT = {
    ("3.57", 1): "repair",
    ("3.77a", 1): "reading",
    ("3.77b", 1): "reading",
    ("3.77c", 1): "reading",
    ("3.77d", 1): "reading",
    ("3.94", 1): "reading",
    ("3.96a", 1): "repair",
    ("3.96e", 1): "repair",
    ("3.97a", 1): "repair",
    ("3.97b", 1): None,
    ("3.97c", 1): "repair",
    ("3.148", 1): "repair",
}
"""Where what is found is not as printed, and which form it is equal to instead; (3.97b) is right of another matrix."""
OTHER_INVERSES = ("left_inverse_of_N_by_normal_equations", "left_inverse_of_L_by_normal_equations")
"""Roads to a left inverse other than the book's: not even the reading agrees."""


@pytest.fixture(scope="module")
def judge() -> Session:
    """What is shipped is checked; test_shipped.py compares it with what is found."""
    return Session(book=load(), memory=None if WHOLE else Memory(shipped=shipped(BOOK)))


class Walked(dict[str, CheckedDerivation]):
    """The roads by name, each walked when it is asked for."""

    def __init__(self, judge: Session) -> None:
        super().__init__()
        self.judge = judge

    def __missing__(self, name: str) -> CheckedDerivation:
        self[name] = walk(ROADS[name], self.judge)
        return self[name]


@pytest.fixture(scope="module")
def walked(judge: Session) -> Walked:
    return Walked(judge)


def last(road: CheckedDerivation) -> CheckedStep:
    return road.steps[-1]


def road_of(*made: DerivationStep, to: Statement, **more: object) -> Derivation:
    return Derivation("a road of a test", to, "", made, **more)  # type: ignore[arg-type]


@pytest.mark.sampled(4)
@pytest.mark.parametrize("name", SOME)
def test_a_road_arrives(walked: Walked, name: str) -> None:
    road = walked[name]
    assert road.arrives, f"{last(road).kind}: {last(road).reason}"
    assert not [step for step in road.steps if isinstance(step.verdict, Undecided)]
    ends = [comparison.statement for comparison in road.comparisons]
    assert road.derivation.to in (None, *ends)


def test_what_is_found_is_printed_or_the_difference_is_reported(walked: Walked) -> None:
    for name in SOME:
        for comparison in walked[name].comparisons:
            key = comparison.statement.number, comparison.statement.part
            expected = None if name in OTHER_INVERSES else DIFFERENT.get(key, "printed")
            assert comparison.form == expected, (name, key, comparison.words)
            if comparison.form is None:
                assert "differs from the printed equation in row" in comparison.words


def test_every_kind_of_step_is_taken(walked: Walked) -> None:
    assert {step.kind for name in SOME for step in walked[name].steps} == KINDS


@pytest.mark.parametrize(
    ("name", "found"),
    [
        ("point_of_the_screw_axis", "A^T A = 2 (1 - cos(phi)) 1 - (1 - 2 cos(phi)) e e^T"),
        ("point_of_the_screw_axis", "beta = (1 - 2 cos(phi)) / [2 (1 - cos(phi))]"),
        ("rates_of_natural_invariants", "omega = phi_dot e + sin(phi) e_dot + (1 - cos(phi)) (e x e_dot)"),
        ("rate_of_H_tilde", "H~_dot = 2 [r_0_dot 1 + R_dot, -r_dot]"),
        ("left_inverse_of_N_by_normal_equations", "N^T N N~ = N^T"),
        ("left_inverses_of_H", "H^T H H~ = H^T"),
    ],
)
def test_unknowns_are_found(walked: Walked, name: str, found: str) -> None:
    equations = [f"{plain(left)} = {plain(right)}" for p in walked[name].steps for left, right in p.equations]
    assert found in equations


@pytest.mark.parametrize(
    ("name", "chosen"),
    [
        ("left_inverses_of_N", "y = sin(phi)"),
        ("left_inverses_of_L", "y = sin(phi) / (1 + cos(phi))"),
        ("left_inverses_of_H", "y = 0"),
    ],
)
def test_the_left_inverse_of_the_book_is_one_of_many(walked: Walked, name: str, chosen: str) -> None:
    comparison = walked[name].comparisons[0]
    assert [f"{plain(symbol)} = {plain(value)}" for symbol, value in comparison.chosen] == [chosen]


@pytest.mark.parametrize("frame", ["fixed", "body"])
def test_euler_angles_are_singular_at_a_zero_of_what_is_found(walked: Walked, frame: str) -> None:
    names = [name for name in ROADS if name.startswith("euler_") and name.endswith(frame)]
    assert len(names) == 12
    determinants = {name.split("_")[1]: plain(last(walked[name]).equations[0][1]) for name in sample(names, 3)}
    for sequence, found in determinants.items():
        kind = "sin" if sequence[0] == sequence[2] else "cos"
        assert found.removeprefix("-") == f"{kind}(theta_2)", sequence


def _wrong(node: Node) -> Node:
    """The expression with its sign changed."""
    return node.term if isinstance(node, Negative) else Negative(node)


def test_a_wrong_expansion_stops_the_road(judge: Session, monkeypatch: pytest.MonkeyPatch) -> None:
    right = steps.multiplied_out
    monkeypatch.setattr(steps, "multiplied_out", lambda node: _wrong(right(node)))
    road = walk(ROADS["point_of_the_screw_axis"], judge)
    assert not road.arrives
    assert (last(road).kind, last(road).verdict.name) == ("expand", "fails")


def test_a_wrong_coefficient_stops_the_road(monkeypatch: pytest.MonkeyPatch) -> None:
    right = state.combined
    monkeypatch.setattr(state, "combined", lambda *given: Scale(Number(2), right(*given)))  # type: ignore[arg-type]
    road = walk(ROADS["velocities_of_a_rigid_body"], Session(book=load()))
    assert (last(road).kind, last(road).verdict.name) == ("factor", "fails")


def test_a_wrong_rate_stops_the_road(judge: Session, monkeypatch: pytest.MonkeyPatch) -> None:
    right = steps.rate_of
    monkeypatch.setattr(steps, "rate_of", lambda node: _wrong(right(node)))
    road = walk(ROADS["accelerations_in_a_moving_frame"], judge)
    assert (last(road).kind, last(road).verdict.name) == ("differentiate", "fails")


def test_a_wrong_substitution_stops_the_road(judge: Session, monkeypatch: pytest.MonkeyPatch) -> None:
    right = steps.put_for
    monkeypatch.setattr(steps, "put_for", lambda node, pattern, value: right(node, pattern, _wrong(value)))
    road = walk(ROADS["least_displacements"], judge)
    assert (last(road).kind, last(road).verdict.name) == ("substitute", "fails")


def test_a_wrong_solution_stops_the_road(judge: Session, monkeypatch: pytest.MonkeyPatch) -> None:
    from chasles.deriving import solving

    right = solving.alone
    monkeypatch.setattr(solving, "alone", lambda *given: (_wrong(right(*given)[0]), right(*given)[1]))
    road = walk(ROADS["least_displacements"], judge)
    assert (last(road).kind, last(road).verdict.name) == ("solve", "fails")


def test_an_ansatz_that_is_too_narrow_has_no_solution(judge: Session) -> None:
    narrow = road_of(
        Ansatz(inverse(A_screw.T @ A_screw), alpha * one),
        Substitute(s02_screw.screw_axis_matrix, both=True),
        Solve(alpha, using=(s02_screw.rotation_from_axis_angle,)),
        Compare(s02_screw.coefficient_of_identity),
        to=s02_screw.coefficient_of_identity,
        assuming=(s02_screw.phi_is_not_zero,),
    )
    road = walk(narrow, judge)
    assert not road.arrives
    assert last(road).kind == "solve"


@pytest.mark.parametrize("terms", [(d_A,), (d_A, (Q - one) @ (p + a)), (d_A, (Q - one) @ p, (Q - one) @ a, d_P)])
def test_terms_that_do_not_suffice_or_are_too_many_stop_the_road(judge: Session, terms: tuple[Node, ...]) -> None:
    made = road_of(
        Take(s02_screw.displacement_by_positions),
        Factor(*terms, using=(s02_screw.displacement_of_landmark, s02_screw.displacement_of_a_point)),
        Compare(s02_screw.displacement_rearranged),
        to=s02_screw.displacement_rearranged,
    )
    road = walk(made, judge)
    assert (last(road).kind, last(road).verdict.name) == ("factor", "undecided")
    assert "combination" in last(road).reason


def test_a_wrong_print_is_reported_and_not_used(judge: Session) -> None:
    right = s03_fixed_point.angular_velocity_matrix_of_vector
    wrong = replace(right, right=_wrong(right.right))
    made = road_of(
        Take(s03_fixed_point.angular_velocity_matrix),
        Factor(right.right, using=(s03_fixed_point.angular_velocity, s03_fixed_point.angular_velocity_matrix)),
        Compare(wrong),
        Consider(Omega @ e),
        Substitute(wrong),
        to=wrong,
        assuming=right.assuming,
    )
    road = walk(made, judge)
    assert road.arrives
    (comparison,) = road.comparisons
    assert isinstance(comparison.printed, Fails)
    assert plain(last(road).equations[0][1]) == "CPM(omega) e"


def test_a_claim_that_fails_is_not_taken_nor_used(judge: Session) -> None:
    true = s02_screw.axis_is_not_turned
    wrong = Claim("wrong", omega, -omega)
    for first in (Take(wrong), Factor(e, using=(wrong,))):
        made = road_of(Consider(Q @ e), first, Compare(true), to=true)
        road = walk(made, judge)
        assert len(road.steps) == 2
        assert not road.arrives


def test_what_is_not_there_cannot_be_replaced(judge: Session) -> None:
    true = s02_screw.axis_is_not_turned
    road = walk(road_of(Consider(E @ e), Substitute(s02_screw.displacement), Compare(true), to=true), judge)
    assert "does not occur" in last(road).reason


def test_what_is_assumed_of_what_is_taken_holds_all_along(judge: Session) -> None:
    x, y, z = (scalar(name, name, "a number") for name in "xyz")
    quotient = Definition("1", z, x / y, assuming=(nonzero(y),))
    slope = Claim("2", rate(z), (rate(x) - z * rate(y)) / y, given=(quotient,), assuming=(nonzero(y),))
    road = walk(road_of(Take(quotient), Differentiate(), Compare(slope, using=(quotient,)), to=slope), judge)
    assert road.arrives
    assert not road.differences
    assert [step.verdict.needs for step in road.steps[1:]] == [("y != 0",)] * 2


def test_two_identities_are_not_the_same_equation(judge: Session) -> None:
    true = s02_screw.axis_is_not_turned
    using = (s02_screw.rotation_from_axis_angle,)
    other = road_of(Consider(cos(phi) * e), Compare(true, using=using), to=true)
    road = walk(other, judge)
    assert road.comparisons[0].form is None


def test_roads_that_are_none_are_refused() -> None:
    true = s02_screw.axis_is_not_turned
    form = sin(phi) * N_tilde
    with pytest.raises(DeclarationError, match="must begin with"):
        road_of(Differentiate(), Compare(true), to=true)
    with pytest.raises(DeclarationError, match="last"):
        road_of(Consider(rate(e)), to=true)
    with pytest.raises(DeclarationError, match="before it comes there"):
        road_of(Take(true), Compare(true), to=true)
    with pytest.raises(DeclarationError, match="before it comes there"):
        road_of(Consider(e), Factor(e, using=(true,)), Compare(true), to=true)
    with pytest.raises(DeclarationError, match="no later Solve"):
        road_of(Ansatz(N_tilde, form), Compare(true), to=true)
    with pytest.raises(DeclarationError, match="a condition"):
        road_of(Consider(e), Compare(true), to=true, given=(s02_screw.inverse_is_sought_as,))
    with pytest.raises(DeclarationError, match="before it comes there"):
        road_of(Consider(e), Solve(e, by=true), Compare(true), to=true)


def test_every_statement_on_a_road_comes_from_the_book() -> None:
    from chasles.statements import load

    known = {id(entry.statement) for entry in load()}
    moved = {("3.83b", 1), *(("Ex 3.10", part) for part in range(1, 6))}
    for name, road in ROADS.items():
        for statement in [cited for step in road.steps for cited in step.cited]:
            assert id(statement) in known or (statement.number, statement.part) in moved, (name, statement.number)


def call(*words: str) -> Result:
    return CliRunner(env={"COLUMNS": None}).invoke(main, list(words), prog_name="chasles")


def test_derive_prints_a_road() -> None:
    done = call("derive", "3.18")
    assert done.exit_code == 0, done.stderr
    assert done.stdout.startswith("(3.18)  ")
    assert re.search(r"^ +9 ansatz \(A\^T A\)\^-1 is sought as alpha 1 \+ beta e e\^T", done.stdout, re.MULTILINE)
    assert "compare (3.18): equal to the printed equation" in done.stdout
    assert "complete; all results are as printed" in done.stdout
    assert r"\mathbf{A}^T \mathbf{A}" in call("derive", "3.18", "--latex").stdout


def test_derive_finds_the_roads_that_come_past_a_number() -> None:
    found = json.loads(call("derive", "--json", "3.13").stdout)["roads"]
    assert [road["name"] for road in found] == ["point_of_the_screw_axis"]
    (by_name,) = json.loads(call("derive", "--json", "Thm", "3.2.2").stdout)["roads"]
    assert by_name["arrives"]
    assert {step["kind"] for step in by_name["steps"]} <= KINDS
    assert all(set(e) == {"text", "latex"} for step in by_name["steps"] for e in step["equations"])


@pytest.mark.slow
def test_derive_without_a_number_names_all_roads(monkeypatch: pytest.MonkeyPatch) -> None:
    """A sample of them is walked."""
    assert chosen_derivations(load(), ()).keys() == ROADS.keys()
    some = dict(sample(list(ROADS.items()), 13))
    monkeypatch.setattr("chasles.cli.answers.chosen_derivations", lambda book, numbers: some)
    lines = call("derive").stdout.splitlines()
    assert len(lines) == len(some)
    assert all("complete" in line for line in lines)


def test_derive_speaks_to_the_person() -> None:
    done = call("derive", "3.999")
    assert done.exit_code == 2
    assert "no derivation leads to '3.999'" in done.stderr


def test_derive_fails_where_a_step_does(monkeypatch: pytest.MonkeyPatch) -> None:
    right = steps.multiplied_out
    monkeypatch.setattr(steps, "multiplied_out", lambda node: _wrong(right(node)))
    done = call("derive", "3.18")
    assert done.exit_code == 1
    assert "point_of_the_screw_axis stops at step 6, expand" in done.stderr
