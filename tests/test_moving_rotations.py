"""Rates of rotations: what is true is proved for all spins, and what is false is refuted by a motion."""

from __future__ import annotations

from fractions import Fraction
from itertools import product

import pytest

from chasles.checker.certificate import Rejected, check
from chasles.checker.refutation import check_counterexample
from chasles.prover.decide import decide_problem
from chasles.statements import Claim, Definition, Hypothesis, Problem, problem_of, rotation
from chasles.statements.spins import with_spins
from chasles.verdict import Fails, HoldsUnder, Verdict
from chasles.vocabulary import (
    CPM,
    FREQUENCY,
    Identity,
    Node,
    Skew,
    Symbol,
    Zero,
    cross,
    det,
    dot,
    norm,
    rate,
    square,
    tr,
    vect,
    vector,
)

a, omega = vector("a", "a", ""), vector("omega", r"\omega", "", FREQUENCY)
Q, R, one = square("Q", "Q", ""), square("R", "R", ""), Identity(3)
spin = vect(rate(Q) @ Q.T)
acceleration = (CPM(rate(spin)) + CPM(spin) @ CPM(spin)) @ Q
TRUE: list[tuple[Node, Node]] = [
    (rate(Q) @ Q.T, -(Q @ rate(Q).T)),
    (rate(Q), CPM(spin) @ Q),
    (rate(Q.T @ Q), rate(one)),
    (tr(rate(Q)), -2 * dot(spin, vect(Q))),
    (vect(rate(Q)), (tr(Q) * one - Q) @ spin / 2),
    (det(rate(Q)), 0 * det(rate(Q))),
    (norm(rate(Q) @ a) ** 2, norm(cross(spin, Q @ a)) ** 2),
    (rate(rate(Q)), acceleration),
    (rate(rate(Q)) @ Q.T + Q @ rate(rate(Q)).T, -2 * rate(Q) @ rate(Q).T),
    (tr(rate(rate(Q)) @ Q.T), -2 * dot(spin, spin)),
]
FALSE: list[tuple[Node, Node]] = [
    (rate(Q) @ Q.T, Q @ rate(Q).T),
    (rate(Q), Q @ CPM(spin)),
    (rate(Q.T @ Q), rate(Q)),
    (tr(rate(Q)), 2 * dot(spin, vect(Q))),
    (vect(rate(Q)), (tr(Q) * one - Q.T) @ spin / 2),
    (rate(rate(Q)), (CPM(rate(spin)) - CPM(spin) @ CPM(spin)) @ Q),
    (tr(rate(rate(Q)) @ Q.T), 2 * dot(spin, spin)),
]


def decided(problem: Problem) -> Verdict:
    return decide_problem(problem)


def about(left: Node, right: Node, *hypotheses: Hypothesis) -> Problem:
    return problem_of(Claim("1", left, right, assuming=hypotheses or (rotation(Q),)))


@pytest.mark.parametrize(("left", "right"), TRUE, ids=str)
def test_what_is_true_of_every_moving_rotation(left: Node, right: Node) -> None:
    problem = about(left, right)
    verdict = decided(problem)
    assert isinstance(verdict, HoldsUnder)
    assert verdict.needs == ("Q is a rotation",)
    check(problem, "", verdict.certificate)


@pytest.mark.parametrize(("left", "right"), FALSE, ids=str)
def test_what_is_false_is_refuted_by_a_motion(left: Node, right: Node) -> None:
    problem = about(left, right)
    verdict = decided(problem)
    assert isinstance(verdict, Fails)
    check_counterexample(problem, verdict.counterexample)
    at = verdict.counterexample.at
    rows = [[at[f"Q_{i}{j}"] for j in "123"] for i in "123"]
    rates = [[at[f"Q_dot_{i}{j}"] for j in "123"] for i in "123"]
    for i, j in product(range(3), repeat=2):
        assert sum(x * y for x, y in zip(rows[i], rows[j], strict=True)) == Fraction(i == j)
        turning = sum(x * y + u * v for x, y, u, v in zip(rates[i], rows[j], rows[i], rates[j], strict=True))
        assert turning == 0


def test_a_certificate_for_spins_proves_nothing_of_what_does_not_turn() -> None:
    left, right = rate(Q), CPM(spin) @ Q
    verdict = decided(about(left, right))
    assert isinstance(verdict, HoldsUnder)
    assert verdict.certificate["spins"]
    with pytest.raises(Rejected):
        check(problem_of(Claim("1", left, right)), "", verdict.certificate)
    with pytest.raises(Rejected):
        check(about(left, right, rotation(R)), "", verdict.certificate)
    with pytest.raises(Rejected):
        check(about(left, -right), "", verdict.certificate)
    without = {key: value for key, value in verdict.certificate.items() if key != "spins"}
    with pytest.raises(Rejected):
        check(about(left, right), "", without)


def test_two_rotations_have_a_spin_each() -> None:
    both = rotation(Q), rotation(R)
    problem = about(rate(Q @ R) @ (Q @ R).T, rate(Q) @ Q.T + Q @ rate(R) @ R.T @ Q.T, *both)
    verdict = decided(problem)
    assert isinstance(verdict, HoldsUnder)
    check(problem, "", verdict.certificate)
    problem = about(rate(Q @ R) @ (Q @ R).T, rate(Q) @ Q.T + rate(R) @ R.T, *both)
    verdict = decided(problem)
    assert isinstance(verdict, Fails)
    check_counterexample(problem, verdict.counterexample)


def test_only_the_rates_of_rotations_are_made_from_spins() -> None:
    def spun(left: Node, right: Node, *hypotheses: Hypothesis, **given: tuple[Definition, ...]) -> set[str]:
        problem = problem_of(Claim("1", left, right, assuming=hypotheses, **given))  # type: ignore[arg-type]
        added = with_spins(problem).rules[len(problem.rules) :]
        return {str(node.of) for _, rule in added for node in rule.factors if isinstance(node, Skew)}  # type: ignore[attr-defined]

    fixed = Symbol("Q", "Q", Q.size, constant=True)
    assert spun(rate(Q @ R), rate(Q), rotation(Q), rotation(R)) == {"Q_spin", "R_spin"}
    assert spun(rate(Q), rate(R), rotation(Q)) == {"Q_spin"}
    assert spun(Q, R, rotation(Q)) == set()
    assert spun(rate(fixed), Zero(3, 3), rotation(fixed)) == set()
    given = (Definition("2", rate(Q), CPM(omega) @ Q),)
    assert spun(rate(Q), rate(R), rotation(Q), given=given) == set()
