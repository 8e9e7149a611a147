"""Power series in time, cut off: their coefficients are floats, arrays of floats, or mpmath's numbers to 50 digits.

Source of the recurrences: R. E. Moore, Interval Analysis, 1966, chapter 11.
"""

from __future__ import annotations

from collections.abc import Sequence
from typing import Any

import numpy as np
from mpmath.ctx_mp import MPContext

__all__ = [
    "NOTHING",
    "Series",
    "Undefined",
    "absolute",
    "arc",
    "chosen",
    "constant",
    "cosine",
    "divided",
    "exponential",
    "logarithm",
    "minus",
    "mp",
    "mpc",
    "mpf",
    "negative",
    "over",
    "plus",
    "power",
    "rate",
    "sign",
    "sine",
    "times",
]

mp = MPContext()
"""A context of its own: whoever else computes with mpmath keeps his digits."""
mp.dps = 50
mpf, mpc = mp.mpf, mp.mpc
Series = list[Any]
NOTHING = mpf(10) ** -35
"""A smaller number of mpmath is a zero that was rounded."""


class Undefined(ArithmeticError):
    """The expression has no real value at the point: a divisor vanishes, or a root is that of a negative number."""


def constant(value: Any, n: int) -> Series:
    """A number that does not change."""
    return [value, *[value * 0] * n]


def plus(one: Series, other: Series) -> Series:
    """The sum."""
    return [a + b for a, b in zip(one, other, strict=True)]


def negative(one: Series) -> Series:
    """The series with the opposite sign."""
    return [-a for a in one]


def minus(one: Series, other: Series) -> Series:
    """The difference."""
    return [a - b for a, b in zip(one, other, strict=True)]


def times(one: Series, other: Series) -> Series:
    """The product."""
    return [_total([one[k] * other[m - k] for k in range(m + 1)]) for m in range(len(one))]


def over(one: Series, other: Series) -> Series:
    """The quotient; raises `Undefined` where the divisor vanishes."""
    _refuse(_vanishes(other[0]), "a divisor vanishes")
    found: Series = []
    for m, value in enumerate(one):
        found.append((value - _total([other[k] * found[m - k] for k in range(1, m + 1)])) / other[0])
    return found


def divided(one: Series, by: int) -> Series:
    """The series over a whole number."""
    return [a / by for a in one]


def rate(one: Series) -> Series:
    """The time derivative; it has one coefficient less."""
    return [k * a for k, a in enumerate(one)][1:]


def power(base: Series, above: int, below: int = 1) -> Series:
    """The base to a rational power; raises `Undefined` where that is not real."""
    if below == 1:
        found = constant(base[0] * 0 + 1, len(base) - 1)
        for _ in range(abs(above)):
            found = times(found, base)
        return over(constant(base[0] * 0 + 1, len(base) - 1), found) if above < 0 else found
    exponent = mpf(above) / below if not _machine(base[0]) else above / below
    if not _machine(base[0]) and _vanishes(base[0]):
        # The root of what vanishes is zero; it has no rate.
        _refuse(above < 0 or len(base) > 1, "a root of what vanishes is divided by, or has a rate")
        return [base[0] * 0]
    _refuse(_below_zero(base[0]), "a root of a negative number")
    found = [base[0] ** exponent if _machine(base[0]) else mp.power(base[0], exponent)]
    for m in range(1, len(base)):
        terms = [(k * exponent - (m - k)) * base[k] * found[m - k] for k in range(1, m + 1)]
        found.append(_total(terms) / (m * base[0]))
    return found


def exponential(one: Series) -> Series:
    """The exponential function."""
    found = [_call("exp", one[0])]
    for m in range(1, len(one)):
        found.append(_total([k * one[k] * found[m - k] for k in range(1, m + 1)]) / m)
    return found


def logarithm(one: Series) -> Series:
    """The logarithm; raises `Undefined` unless it is that of a positive number."""
    _refuse(
        not _machine(one[0]) and (_vanishes(one[0]) or _below_zero(one[0])), "the logarithm of what is not positive"
    )
    return _primitive(_call("log", one[0]), over(rate(one), one[:-1]) if len(one) > 1 else [])


def sine(one: Series) -> Series:
    """The sine."""
    return _circular(one)[1]


def cosine(one: Series) -> Series:
    """The cosine."""
    return _circular(one)[0]


def arc(function: str, one: Series) -> Series:
    """The principal value of "asin", "acos" or "atan"; raises `Undefined` outside their domain."""
    unit = constant(one[0] * 0 + 1, len(one) - 1)
    if function != "atan":
        _refuse(not _machine(one[0]) and abs(one[0]) > 1, "an arc of what exceeds one")
    if len(one) == 1:
        return [_call(function, one[0])]
    square = times(one, one)
    slope = over(unit, plus(unit, square) if function == "atan" else power(minus(unit, square), 1, 2))
    slope = negative(slope) if function == "acos" else slope
    return _primitive(_call(function, one[0]), times(rate(one), slope[:-1]))


def sign(one: Series) -> Series:
    """The sign, which does not change; raises `Undefined` where it jumps, unless it is asked for there alone."""
    if _machine(one[0]):
        return constant(np.sign(one[0]), len(one) - 1)
    if _vanishes(one[0]):
        _refuse(len(one) > 1, "the sign jumps")
        return [one[0] * 0]
    return constant(mpf(-1 if _below_zero(one[0]) else 1), len(one) - 1)


def absolute(one: Series) -> Series:
    """The absolute value; that of a complex number too, if nothing moves."""
    if isinstance(one[0], mpc) and abs(one[0].imag) > NOTHING:
        _refuse(len(one) > 1, "the rate of a complex number's size")
        return [abs(one[0])]
    factor = sign(one)[0]
    return [factor * a for a in one]


def chosen(one: Series, other: Series, condition: Any) -> Series:
    """The one where the condition holds, else the other."""
    if isinstance(condition, np.ndarray):
        return [np.where(condition, a, b) for a, b in zip(one, other, strict=True)]
    return one if condition else other


def _circular(one: Series) -> tuple[Series, Series]:
    cosines, sines = [_call("cos", one[0])], [_call("sin", one[0])]
    for m in range(1, len(one)):
        cosines.append(-_total([k * one[k] * sines[m - k] for k in range(1, m + 1)]) / m)
        sines.append(_total([k * one[k] * cosines[m - k] for k in range(1, m + 1)]) / m)
    return cosines, sines


def _primitive(first: Any, slope: Series) -> Series:
    return [first, *(value / (k + 1) for k, value in enumerate(slope))]


def _total(values: Sequence[Any]) -> Any:
    total = 0
    for value in values:
        total = total + value
    return total


def _machine(value: Any) -> bool:
    return isinstance(value, np.ndarray | float)


ARRAY = {"asin": "arcsin", "acos": "arccos", "atan": "arctan"}


def _call(function: str, value: Any) -> Any:
    if _machine(value):
        return getattr(np, ARRAY.get(function, function))(value)
    return getattr(mp, function)(value)


def _vanishes(value: Any) -> bool:
    return not _machine(value) and bool(abs(value) < NOTHING)


def _below_zero(value: Any) -> bool:
    """Whether an mpmath number is no real one from zero on."""
    if _machine(value):
        return False
    return abs(mp.im(value)) > NOTHING or bool(mp.re(value) < 0)


def _refuse(refused: bool, reason: str) -> None:
    if refused:
        raise Undefined(reason)
