"""Angles of points: equal where their difference is less than a turn, whose ends count."""

from __future__ import annotations

from fractions import Fraction
from typing import Any

import pytest
import sympy as sp
from sympy import Abs, Eq, acos, asin, atan, atan2, pi, sign, sqrt

from chasles.prove import Rejected, prove, recheck
from chasles.verdict import Contradictory, Fails, Holds, HoldsUnder, Undecided, Verdict

x, y, z, u, v = sp.symbols("x y z u v", real=True)
p, q = sp.symbols("p q", positive=True)
left = sp.Symbol("l", negative=True)
above, below = sp.Symbol("a", nonnegative=True), sp.Symbol("b", nonpositive=True)

TRUE = [
    (atan2(p * y, p * x), atan2(y, x)),
    (atan2(p + y, z), atan2(p * (p + y), p * z)),
    (atan2(sqrt(x**2 + y**2), z), acos(z / sqrt(x**2 + y**2 + z**2))),
    (acos(p), atan2(sqrt(1 - p**2), p)),
    (acos(x), 2 * atan2(sqrt(1 - x), sqrt(1 + x))),
    (2 * asin(sqrt((1 - x) / 2)), acos(x)),
    (2 * asin(above), acos(1 - 2 * above**2)),
    (-asin(above / sqrt(above**2 + below**2)), atan2(-above, -below)),
    (atan(x), sign(x) * acos(1 / sqrt(1 + x**2))),
    (atan2(2 * x, 1 - x**2), 2 * atan(x)),
    (atan2(-u, p), -atan2(u, p)),
    (atan2(-p, u), -atan2(p, u)),
    (atan2(x, x), atan2(sign(x), sign(x))),
    (atan2(x**2, -(x**2)), 3 * pi / 4),
    (atan2(p * x, p), atan(x)),
    (atan(left) + atan2(p, above * Abs(y)) + pi, atan(left) + atan(p / (above * Abs(y))) + pi),
]
HALVES = [
    (sp.cos(acos(x) / 2), sqrt((1 + x) / 2)),
    (sp.sin(acos(x) / 2), sqrt((1 - x) / 2)),
    (sp.cos(acos(x) / 4), sqrt((1 + sqrt((1 + x) / 2)) / 2)),
    (sp.cos(acos(x) / 2) ** 2 - sp.sin(acos(x) / 2) ** 2, x),
    (sp.cos(acos(x) / 2 + y), sqrt((1 + x) / 2) * sp.cos(y) - sqrt((1 - x) / 2) * sp.sin(y)),
    (sp.cos(asin(x) / 2 + pi / 4) ** 2, (1 - x) / 2),
    (acos(x) / 2, acos(sqrt((1 + x) / 2))),
    (sp.sin(sp.acot(p) / 2), sqrt((1 - p / sqrt(1 + p**2)) / 2)),
]
FALSE_AT_AN_END: list[tuple[Any, Any, list[Any]]] = [
    (atan2(-(x**2), left), -atan2(x**2, left), []),
    (atan2(below, left), -atan2(-below, left), []),
    (atan2(-u, v), -atan2(u, v), []),
    (atan2(-above, left) + atan2(above, left), 0, []),
    (atan2(-(x**2), left) + atan2(y**2, left), 0, [Eq(x, 0), Eq(y, 0)]),
    (atan2(y, x) - atan2(-y, -x), pi, []),
    (2 * atan2(y, x), atan2(2 * x * y, x**2 - y**2), []),
    (acos(x / sqrt(x**2 + y**2)), Abs(atan2(y, x)) + (Abs(y) - y) / 100, []),
    (atan2(-y, x), -atan2(y, x), []),
    (sp.arg(x + sp.I * y) + sp.arg(x - sp.I * y), 0, []),
    (sp.arg(x + sp.I * y), -sp.arg(x - sp.I * y), [x < 0]),
    (sp.sin(atan2(y, x) / 2), y / sqrt(2 * (x**2 + y**2 + x * sqrt(x**2 + y**2)) + Abs(Abs(x) - x - 4) - 4), []),
]


def _proved(one: Any, other: Any) -> Verdict:
    """The verdict that two sides are equal, which the checker follows."""
    verdict = prove(one, other)
    assert isinstance(verdict, Holds | HoldsUnder)
    recheck(verdict, one, other)
    return verdict


@pytest.mark.sampled(3)
@pytest.mark.parametrize(("one", "other"), TRUE, ids=str)
def test_angles_of_points_are_equal(one: Any, other: Any) -> None:
    _proved(one, other)


@pytest.mark.sampled(2)
@pytest.mark.parametrize(("one", "other"), HALVES, ids=str)
def test_half_of_an_angle_between_zero_and_half_a_turn(one: Any, other: Any) -> None:
    """Where acos(x) is pi/2 - asin(x), half of it is no half of asin(x)."""
    verdict = _proved(one, other)
    with pytest.raises(Rejected):
        recheck(verdict, one, -other)
    assert isinstance(prove(one, -other), Fails)


def test_half_of_any_angle_is_none_of_one_between_zero_and_half_a_turn() -> None:
    assert isinstance(prove(sp.cos(atan2(y, x) / 2 - pi / 4), sqrt((1 + y / sqrt(x**2 + y**2)) / 2)), Fails)


@pytest.mark.parametrize(("one", "other", "given"), FALSE_AT_AN_END, ids=str)
def test_the_ends_of_the_range_count(one: Any, other: Any, given: list[Any]) -> None:
    verdict = prove(one, other, given)
    assert isinstance(verdict, Fails)
    recheck(verdict, one, other, given)


@pytest.mark.parametrize("given", [[Eq(x, -1), Eq(y, 0)], [x < 0, Eq(y, 0)], [Eq(sp.cos(atan2(y, x) / 2), 0)]], ids=str)
def test_half_an_angle_is_also_that_of_a_half_turn(given: list[Any]) -> None:
    assert not isinstance(prove(sp.cos(atan2(y, x) / 2), 0, given), Contradictory | Fails)
    assert isinstance(prove(sp.sin(atan2(y, x) / 2), -1, given), Fails | Undecided)


def test_an_angle_is_not_mirrored_where_it_is_half_a_turn() -> None:
    certificate = {
        "variant": 0,
        "names": {"atan2_u_v": "atan2(u, v)", "u": "u", "v": "v"},
        "witness": {"u": "1", "v": "1"},
    }
    forged = HoldsUnder(("u**2 + v**2 != 0",), certificate, {"u": Fraction(1), "v": Fraction(1)})
    with pytest.raises(Rejected, match="does not follow"):
        recheck(forged, atan2(-u, v), -atan2(u, v))
