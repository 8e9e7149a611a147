"""What equations say twice ties no rates: a motion through a point has to satisfy only those that are independent."""

from __future__ import annotations

from fractions import Fraction

import pytest

from chasles.checker.motion import independent
from chasles.checker.refutation import check_counterexample
from chasles.checker.sparse import Polynomial, number, variable
from chasles.prover.decide import decide_problem
from chasles.statements import Claim, Condition, Statement, nonzero, problem_of, unit
from chasles.verdict import Fails
from chasles.vocabulary import CPM, FREQUENCY, Node, cross, dot, norm, rate, vector
from chasles.vocabulary import number as numeral

x, y, b, e = (vector(name, name, "") for name in ("x", "y", "b", "e"))
w = vector("omega", "omega", "", FREQUENCY)
ON_AXIS = Condition("c1", cross(e, x), cross(e, cross(b, e)), on=(x,))
NEAREST = Condition("c2", dot(e, x), numeral(0), on=(x,))
MOVING = Condition("c1", cross(w, cross(w, x)), cross(w, rate(b)), on=(x,))
ACROSS = Condition("c2", dot(w, x), numeral(0), on=(x,))
BY_MATRIX = Condition("c1", CPM(w) @ CPM(w) @ x, CPM(w) @ rate(b), on=(x,))
FALSE: list[tuple[Node, Node, tuple[Statement, ...]]] = [
    (x, cross(e, b), (ON_AXIS, NEAREST)),
    (dot(x, rate(b)), dot(b, rate(b)), (ON_AXIS, NEAREST)),
    (dot(x, rate(e)), dot(b, rate(e)), (ON_AXIS, NEAREST)),
    (x, cross(w, rate(b)) / norm(w) ** 2, (MOVING, ACROSS)),
    (norm(w) ** 2 * x, cross(rate(b), w) * 2, (MOVING, ACROSS)),
    (dot(x, rate(b)), dot(b, rate(b)), (MOVING, ACROSS)),
    (norm(w) ** 2 * x, cross(w, rate(b)), (BY_MATRIX, ACROSS)),
    (dot(x, b), dot(b, b), (BY_MATRIX, ACROSS)),
]


@pytest.mark.parametrize(("left", "right", "given"), FALSE)
def test_a_condition_of_which_a_part_follows_from_the_rest_refutes(
    left: Node, right: Node, given: tuple[Statement, ...]
) -> None:
    assuming = (unit(e),) if ON_AXIS in given else (nonzero(norm(w)),)
    asked = problem_of(Claim("1", left, right, given=given, assuming=assuming))
    verdict = decide_problem(asked)
    assert isinstance(verdict, Fails), verdict
    check_counterexample(asked, verdict.counterexample)


one, two, three = (variable(place) for place in range(3))
skew = two - one * number(2)
AT = {0: (Fraction(1), 0), 1: (Fraction(2), 0), 2: (Fraction(0), 0)}


@pytest.mark.parametrize(
    ("polynomials", "count"),
    [
        ([three, three * number(3)], 1),
        ([two * three, one * three], 1),
        ([one * three, two * three, three * three], 1),
        ([skew, three, skew - three], 2),
        ([three, skew], 2),
        ([three * three, one * skew], 2),
        ([three * skew, one * skew, two * three], 2),
    ],
)
def test_what_is_a_multiple_near_a_point_is_left_out(polynomials: list[Polynomial], count: int) -> None:
    """A relation by what is zero at the point is none there: x z = 0 does not follow from z^2 = 0."""
    kept = independent(polynomials, AT)
    assert len(kept) == count
    assert all(p in polynomials for p in kept)


def test_what_is_zero_at_the_point_shows_nothing_of_the_other() -> None:
    """z^2 = 0 follows from y z = 0, and y z = 0 from z^2 = 0 not where z is zero."""
    products = [three * three, two * three]
    (kept,) = independent(products, AT)
    assert kept is products[1]
