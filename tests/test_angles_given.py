"""Angles between given bounds of which a value is given: the one that they are, and the others that they may be."""

from __future__ import annotations

from dataclasses import replace
from typing import Any

import pytest
import sympy as sp
from sympy import Eq, acosh, asin, asinh, cos, log, pi, sin, sqrt

from chasles.prove import Rejected, prove, recheck
from chasles.verdict import Contradictory, Fails, Holds, HoldsUnder

x, y = sp.symbols("x y", real=True)
d, e = sp.symbols("d e", positive=True)
HALF = sp.Rational(1, 2)


def between(low: Any, high: Any, *symbols: Any) -> list[Any]:
    return [relation for symbol in symbols for relation in (symbol > low, symbol < high)]


DECIDED: list[tuple[Any, Any, list[Any], Any]] = [
    (x, y, [Eq(cos(x), cos(y)), *between(0, pi, x, y)], HoldsUnder),
    (x, pi / 3, [Eq(cos(x), HALF), *between(0, pi, x)], HoldsUnder),
    (x, pi / 6, [Eq(sin(x), HALF), *between(0, pi / 2, x)], HoldsUnder),
    (x, 0, [Eq(cos(x), 1), *between(-pi, pi, x)], HoldsUnder),
    (log(1 + x), log(2), [Eq((x - 1) / (x**2 + 1), 0)], HoldsUnder),
    (log(d), log(e), [Eq(d / (1 + d), e / (1 + e))], HoldsUnder),
    (x, pi / 6, [Eq(sin(x), HALF), *between(0, pi, x)], Fails),
    (x, pi / 3, [Eq(cos(x), HALF), *between(0, 2 * pi, x)], Fails),
    (x, y, [Eq(cos(x), cos(y)), *between(-pi / 2, pi / 2, x, y)], Fails),
    (x, y, [Eq(sin(x), sin(y)), *between(0, pi, x, y)], Fails),
    (x, y, [Eq(1 / sqrt(1 + x**2), 1 / sqrt(1 + y**2))], Fails),
    (x, 0, [Eq(cos(x), 1), *between(0, pi, x)], Contradictory),
    (sin(d), sin(e), [Eq((d - 1) / (d + 1), -2, evaluate=False)], Contradictory),
]


@pytest.mark.sampled(3)
@pytest.mark.parametrize(("left", "right", "given", "kind"), DECIDED, ids=str)
def test_angles_are_what_their_values_say(left: Any, right: Any, given: list[Any], kind: type) -> None:
    verdict = prove(left, right, given)
    assert isinstance(verdict, kind)
    if not isinstance(verdict, Contradictory):
        recheck(verdict, left, right, given)
        with pytest.raises(Rejected):
            recheck(verdict, *((left, right + 1) if kind is HoldsUnder else (left, left)), given)


def test_the_angle_of_a_point_may_be_a_part_of_a_turn() -> None:
    """At the witness d is 1/3, and asin(-1/2) is -pi/6."""
    given = [Eq((d - 1) / (d + 1), -HALF), Eq(x, asin((d - 1) / (d + 1)) + pi / 2)]
    verdict = prove(x, pi / 3, given)
    assert isinstance(verdict, HoldsUnder)
    assert verdict.witness["x"] == pi / 3
    recheck(verdict, x, pi / 3, given)
    with pytest.raises(Rejected):
        recheck(replace(verdict, witness={**verdict.witness, "x": pi / 4}), x, pi / 3, given)


HYPERBOLIC: list[tuple[Any, Any, list[Any], bool]] = [
    (asinh(x) + asinh(y), asinh(x * sqrt(1 + y**2) + y * sqrt(1 + x**2)), [], True),
    (asinh(x) - asinh(y), asinh(x * sqrt(1 + y**2) - y * sqrt(1 + x**2)), [], True),
    (acosh(d) + asinh(x), asinh(x * d + sqrt((d**2 - 1) * (x**2 + 1))), [d >= 1], True),
    (acosh(d) + acosh(e), acosh(d * e + sqrt(d**2 - 1) * sqrt(e**2 - 1)), [d >= 1, e >= 1], True),
    (acosh(d) - acosh(e), acosh(d * e - sqrt(d**2 - 1) * sqrt(e**2 - 1)), [d >= 1, e >= 1], False),
    (asinh(x) + asinh(y), asinh(x * sqrt(1 + y**2) - y * sqrt(1 + x**2)), [], False),
]


@pytest.mark.sampled(2)
@pytest.mark.parametrize(("left", "right", "given", "true"), HYPERBOLIC, ids=str)
def test_sums_of_inverse_hyperbolic_functions(left: Any, right: Any, given: list[Any], true: bool) -> None:
    verdict = prove(left, right, given)
    assert isinstance(verdict, Holds | HoldsUnder if true else Fails)
    recheck(verdict, left, right, given)
    if true:
        with pytest.raises(Rejected):
            recheck(verdict, left + 1, right, given)


@pytest.mark.parametrize("e", [x + sqrt(x**2 + 1), 2 * sqrt(x**2 + y**2 + 1) - x - y], ids=str)
def test_what_is_less_than_a_root_does_not_make_it_vanish(e: Any) -> None:
    assert isinstance(prove(sp.Gt(e, 0)), Holds)
    assert isinstance(prove((sin(x) * e + e) / e, sin(x) + 1), Holds)


def test_a_root_of_a_square_may_be_as_large_as_what_it_is_of() -> None:
    e = x + sqrt(x**2)
    assert isinstance(prove(sp.Gt(e, 0)), Fails)
    assert prove((sin(x) * e + e) / e, sin(x) + 1).needs == ("x + Abs(x) != 0",)
