"""Enclosing hold the numbers they are said to hold, and are narrow."""

from __future__ import annotations

from fractions import Fraction
from random import Random

import mpmath
import pytest

from chasles.checker.expressions.intervals import Enclosing, Enclosure, Unbounded

BITS = 100
FINE = Enclosing(BITS)
ARGUMENTS = [Fraction(0), Fraction(1), Fraction(-1), Fraction(7, 3), Fraction(-22, 7), Fraction(1, 10**6), Fraction(50)]
ARGUMENTS += [Fraction(Random(k).randint(-(10**6), 10**6), Random(k + 1).randint(1, 10**5)) for k in range(20)]


def holds(found: Enclosure, exact: mpmath.mpf, units: int = 2**12) -> None:
    with mpmath.workdps(120):
        scaled = exact * mpmath.mpf(2) ** BITS
        assert found.low <= scaled <= found.high
        assert found.high - found.low <= units * (1 + abs(exact)) + 4


def of(x: Fraction) -> mpmath.mpf:
    return mpmath.mpf(x.numerator) / x.denominator


@pytest.mark.parametrize("x", ARGUMENTS, ids=str)
def test_elementary_functions(x: Fraction) -> None:
    with mpmath.workdps(120):
        interval = FINE.number(x)
        cosine, sine = FINE.cosine_and_sine(interval)
        holds(cosine, mpmath.cos(of(x)))
        holds(sine, mpmath.sin(of(x)))
        holds(FINE.atan(interval), mpmath.atan(of(x)))
        holds(FINE.erf(interval), mpmath.erf(of(x)))
        if abs(x) <= 60:
            holds(FINE.exp(interval), mpmath.exp(of(x)))
        if x > 0:
            holds(FINE.log(interval), mpmath.log(of(x)), 2**40)
            for degree in (2, 3, 4, 7, 65, 10**9):
                holds(FINE.root(interval, degree), mpmath.root(of(x), degree), 2**60)
        if x:
            holds(FINE.inverse(interval), 1 / of(x), 2**60)
        for exponent in (0, 1, 2, 3, 5):
            holds(FINE.power(interval, exponent), of(x) ** exponent, 2**40)


@pytest.mark.parametrize("size", [-90, 20, 1000, 10**5])
def test_the_logarithm_of_a_very_large_or_small_number_is_as_narrow_as_others(size: int) -> None:
    x = Fraction(5, 3) * Fraction(2) ** size
    with mpmath.workdps(120):
        found, width = FINE.log(FINE.number(x)), 2**92 if size < 0 else 8
        holds(found, mpmath.log(mpmath.mpf(5) / 3) + size * mpmath.log(2), width)


def test_pi() -> None:
    for bits in (10, 50, 300):
        found = Enclosing(bits).pi
        with mpmath.workdps(200):
            assert found.low <= mpmath.pi * mpmath.mpf(2) ** bits <= found.high
        assert found.high - found.low < 20


def test_products_of_all_signs() -> None:
    ends = [(Fraction(a), Fraction(b)) for a in range(-2, 3) for b in range(a, 3)]
    for one in ends:
        for other in ends:
            found = FINE.times(*(Enclosure(FINE.number(low).low, FINE.number(high).high) for low, high in (one, other)))
            exact = sorted(a * b for a in one for b in other)
            assert found == Enclosure(FINE.number(exact[0]).low, FINE.number(exact[-1]).high)


def test_wide_intervals_hold_what_is_between() -> None:
    wide = Enclosure(-FINE.one, 2 * FINE.one)
    assert FINE.power(wide, 2).low == 0
    assert FINE.power(wide, 2).high >= 4 * FINE.one
    assert FINE.power(wide, 3).low <= -FINE.one
    cosine, sine = FINE.cosine_and_sine(Enclosure(0, 7 * FINE.one))
    assert (cosine.low, cosine.high) == (sine.low, sine.high) == (-FINE.one, FINE.one)
    assert wide.sign is None
    assert (Enclosure(0, 0).sign, Enclosure(1, 2).sign, Enclosure(-2, -1).sign) == (0, 1, -1)


BEYOND = {
    "inverse": lambda: FINE.inverse(Enclosure(-1, 1)),
    "log": lambda: FINE.log(Enclosure(-1, 1)),
    "root": lambda: FINE.root(Enclosure(-1, 1), 2),
    "exp": lambda: FINE.exp(FINE.number(10**5)),
}


@pytest.mark.parametrize("operation", BEYOND)
def test_what_is_not_bounded_is_said(operation: str) -> None:
    with pytest.raises(Unbounded):
        BEYOND[operation]()
