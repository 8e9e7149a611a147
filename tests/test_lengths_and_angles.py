"""Lengths of scaled and turned vectors, angles with quarter turns, angles that conditions determine: all decided."""

from __future__ import annotations

from typing import Any

import pytest

from chasles.checker.certificate import check
from chasles.checker.refutation import check_counterexample
from chasles.decisions.session import Session
from chasles.statements import (
    Claim,
    Condition,
    Definition,
    nonzero,
    positive,
    problem_of,
    rotation,
    unit,
)
from chasles.verdict import Fails, Holds, HoldsUnder, Undecided, Verdict
from chasles.vocabulary import PI, Node, cos, cross, dot, norm, number, scalar, sin, square, vector

a, b, e = (vector(name, name, "") for name in "abe")
k, m = scalar("k", "k", ""), scalar("m", "m", "")
phi, theta = scalar("phi", r"\phi", ""), scalar("theta", r"\theta", "")
Q = square("Q", "Q", "")
halved = Condition("1", 2 * phi, theta, on=(phi,))
supplement = Condition("1", phi + theta, PI, on=(phi,))
quarter = Condition("1", 2 * phi, PI, on=(phi,))


def verdict_on(left: Node, right: Node | int, **rest: Any) -> Verdict:
    """The verdict, checked again."""
    claim = Claim("2", left, number(right) if isinstance(right, int) else right, **rest)
    verdict = Session().decide(claim).verdict
    if isinstance(verdict, Holds | HoldsUnder):
        check(claim, "printed", verdict.certificate)
    if isinstance(verdict, Fails):
        check_counterexample(problem_of(claim), verdict.counterexample)
    return verdict


@pytest.mark.parametrize(
    ("left", "right", "assuming", "needs"),
    [
        (norm(2 * a), 2 * norm(a), (), ()),
        (norm(-2 * a), 2 * norm(a), (), ()),
        (norm(-a), norm(a), (), ()),
        (norm(a / 2), norm(a) / 2, (), ()),
        (norm(a) ** 2, dot(a, a), (), ()),
        (norm(m * a), m * norm(a), (positive(m),), ("m > 0",)),
        (norm(norm(b) * a), norm(a) * norm(b), (), ()),
        (norm(k**2 * a), k**2 * norm(a), (), ()),
        (norm(3 * cross(a, b)), 3 * norm(cross(b, a)), (), ()),
        (norm(a / norm(a)), number(1), (nonzero(norm(a)),), ("|a| != 0",)),
        (norm(a) / norm(2 * a), number(1) / 2, (nonzero(norm(2 * a)),), ("|2 a| != 0",)),
        (norm(e), number(1), (unit(e),), ("|e| = 1",)),
        (norm(m * e), m, (unit(e), positive(m)), ("|e| = 1", "m > 0")),
        (norm(Q @ a), norm(a), (rotation(Q),), ("Q is a rotation",)),
        (norm(Q.T @ Q @ (2 * a)), 2 * norm(a), (rotation(Q),), ("Q is a rotation",)),
        (norm(3 * Q @ e), number(3), (rotation(Q), unit(e)), ("Q is a rotation", "|e| = 1")),
    ],
    ids=str,
)
def test_lengths(left: Node, right: Node, assuming: tuple[Any, ...], needs: tuple[str, ...]) -> None:
    verdict = verdict_on(left, right, assuming=assuming)
    assert isinstance(verdict, Holds | HoldsUnder)
    assert set(verdict.needs) == set(needs)
    assert verdict.unused == ()


@pytest.mark.parametrize(
    ("left", "right", "assuming"),
    [
        (norm(2 * a), 3 * norm(a), ()),
        (norm(-2 * a), -2 * norm(a), ()),
        (norm(k * a), k * norm(a), ()),
        (norm(k**3 * a), k**3 * norm(a), ()),
        (norm(k * e), k, (unit(e),)),
        (norm(e), 1, ()),
        (norm(a / 2), norm(a), ()),
        (norm(a + b), norm(a) + norm(b), ()),
    ],
    ids=str,
)
def test_false_lengths(left: Node, right: Node | int, assuming: tuple[Any, ...]) -> None:
    assert isinstance(verdict_on(left, right, assuming=assuming), Fails)


def test_a_length_of_what_is_no_rotation_is_not_kept() -> None:
    assert not verdict_on(norm(Q @ a), norm(a)).true


def test_nothing_is_concluded_from_what_is_assumed_of_a_defined_symbol() -> None:
    given = (Definition("1", e, 2 * a),)
    assert not verdict_on(norm(e), 1, given=given, assuming=(unit(e),)).true
    assert verdict_on(norm(e), 2 * norm(a), given=(Definition("1", e, 2 * a),)).true is not None


@pytest.mark.parametrize(
    ("left", "right"),
    [
        (cos(PI), -1),
        (sin(PI), 0),
        (cos(PI / 2), 0),
        (sin(3 * PI / 2), -1),
        (sin(-PI / 2), -1),
        (cos(2 * PI), 1),
        (cos(phi + PI), -cos(phi)),
        (cos(PI - phi), -cos(phi)),
        (sin(phi + PI / 2), cos(phi)),
        (cos(phi - 5 * PI / 2), sin(phi)),
        (phi * cos(phi + PI), -phi * cos(phi)),
        (PI * cos(phi + PI), -PI * cos(phi)),
        (cos(phi / 2 + PI) ** 2, (1 + cos(phi)) / 2),
    ],
    ids=str,
)
def test_quarter_turns(left: Node, right: Node | int) -> None:
    assert verdict_on(left, right).true


@pytest.mark.parametrize(
    ("left", "right"),
    [
        (cos(PI), 1),
        (sin(PI / 2), 0),
        (cos(phi + PI), cos(phi)),
        (phi * cos(phi + PI), phi * cos(phi)),
        (PI * cos(phi + PI), PI * cos(phi)),
        (cos(phi + PI), PI),
        (phi + cos(theta + PI), PI * cos(theta)),
    ],
    ids=str,
)
def test_false_quarter_turns(left: Node, right: Node | int) -> None:
    assert isinstance(verdict_on(left, right), Fails)


def test_other_parts_of_a_turn_are_decided_as_questions_of_scalars() -> None:
    assert isinstance(verdict_on(cos(PI / 5), 1), Fails)
    assert isinstance(verdict_on(4 * cos(PI / 5) ** 2 - 2 * cos(PI / 5), 1), Holds)


@pytest.mark.parametrize(
    ("left", "right", "given", "true"),
    [
        (cos(phi), cos(theta / 2), halved, True),
        (sin(theta), 2 * sin(phi) * cos(phi), halved, True),
        (phi * cos(theta), theta * cos(2 * phi) / 2, halved, True),
        (sin(theta), sin(phi), halved, False),
        (cos(phi), -cos(theta), supplement, True),
        (sin(phi), sin(theta), supplement, True),
        (cos(phi), cos(theta), supplement, False),
        (cos(phi), 0, quarter, True),
        (sin(phi), 0, quarter, False),
    ],
    ids=str,
)
def test_an_angle_that_a_condition_determines(left: Node, right: Node | int, given: Condition, true: bool) -> None:
    verdict = verdict_on(left, right, given=(given,))
    assert verdict.true is true
    assert true or isinstance(verdict, Fails)


def test_a_condition_that_says_more_of_an_angle_is_refused_in_words_unless_it_leaves_the_angle_free() -> None:
    more = Condition("1", k * phi, theta, on=(phi,))
    verdict = verdict_on(theta * sin(phi), 0, given=(more,))
    assert isinstance(verdict, Undecided)
    assert "is to determine the angle phi" in verdict.reason
    assert isinstance(verdict_on(sin(phi), 0, given=(more,)), Fails)
    assert not isinstance(verdict_on(sin(phi), 0, given=(Condition("1", phi * phi, number(0), on=(phi,)),)), Fails)


def test_a_condition_on_the_cosine_of_an_angle_is_assumed() -> None:
    upright = Condition("1", cos(phi), number(0), on=(phi,))
    assert verdict_on(sin(phi) ** 2, 1, given=(upright,)).true
    assert isinstance(verdict_on(sin(phi), 1, given=(upright,)), Fails)
