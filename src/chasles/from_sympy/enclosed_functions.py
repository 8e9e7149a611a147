"""Functions of numbers that are exact or enclosed in intervals: rational arithmetic is exact, functions are bounded.

Interval arithmetic is that of mpmath (R. E. Moore, Interval Analysis, 1966). Where a function is not known to be
defined at a point, nothing is said.
"""

from __future__ import annotations

from collections.abc import Callable, Mapping
from fractions import Fraction
from functools import reduce
from typing import Any

import sympy
from mpmath import MPIntervalContext

BITS = 200
MARGIN = Fraction(1, 2**60)
"""Numbers count as different if they are at least so far apart: far more than interval arithmetic could be wrong by."""
LARGEST_EXPONENT = 10_000

iv = MPIntervalContext()
iv.prec = BITS
Value = Any
"""A Fraction, which is exact, or an interval."""


class NotEnclosed(Exception):
    """The value is not known to exist, or no bounds for it are known."""


def apart(one: Value, other: Value) -> bool:
    """Whether two values are certainly different."""
    gap = plus(one, -other)
    if isinstance(gap, Fraction):
        return gap != 0
    low, high = ends(gap)
    return low > MARGIN or high < -MARGIN


def sign_of(value: Value) -> int:
    """The sign of a value; raises `NotEnclosed` if it is not clear."""
    if isinstance(value, Fraction):
        return (value > 0) - (value < 0)
    if not apart(value, Fraction(0)):
        raise NotEnclosed
    return 1 if ends(value)[0] > 0 else -1


def ends(interval: Any) -> tuple[Fraction, Fraction]:
    """Both ends, which are dyadic numbers; raises `NotEnclosed` if one is infinite."""
    found = []
    for sign, mantissa, exponent, bits in (interval.a._mpi_[0], interval.b._mpi_[1]):
        if not mantissa and (exponent or bits):
            raise NotEnclosed
        found.append(Fraction(-mantissa if sign else int(mantissa)) * Fraction(2) ** exponent)
    return found[0], found[1]


def _interval(value: Value) -> Any:
    return iv.mpf(value.numerator) / value.denominator if isinstance(value, Fraction) else value


def plus(one: Value, other: Value) -> Value:
    """The sum."""
    return one + other if type(one) is type(other) else _interval(one) + _interval(other)


def times(one: Value, other: Value) -> Value:
    """The product."""
    return one * other if type(one) is type(other) else _interval(one) * _interval(other)


def _over(one: Value, other: Value) -> Value:
    if sign_of(other) == 0:
        raise NotEnclosed
    return one / other if type(one) is type(other) else _interval(one) / _interval(other)


def power(base: Value, exponent: Value) -> Value:
    """A power with an integral exponent, or of a number that is not negative: its root is the one that is not."""
    if isinstance(exponent, Fraction) and exponent.denominator == 1:
        if abs(exponent) > LARGEST_EXPONENT:
            raise NotEnclosed
        power = base ** abs(int(exponent))
        return power if exponent >= 0 else _over(Fraction(1), power)
    sign = sign_of(base)
    if sign == 0 and sign_of(exponent) > 0:
        return Fraction(0)
    if sign <= 0:
        raise NotEnclosed
    return iv.exp(_interval(exponent) * iv.log(_interval(base)))


def _log(value: Value, base: Value = None) -> Value:
    if base is not None:
        return _over(_log(value), _log(base))
    if sign_of(value) <= 0:
        raise NotEnclosed
    return Fraction(0) if value == 1 else iv.log(_interval(value))


def _rational_at(place: int, exact: int, function: Callable[[Any], Any]) -> Callable[[Value], Value]:
    return lambda value: Fraction(exact) if value == place else function(_interval(value))


_exp, _sin, _cos = _rational_at(0, 1, iv.exp), _rational_at(0, 0, iv.sin), _rational_at(0, 1, iv.cos)


def _root(value: Value) -> Value:
    return power(value, Fraction(1, 2))


def _sinh(value: Value) -> Value:
    return times(plus(_exp(value), -_exp(-value)), Fraction(1, 2))


def _cosh(value: Value) -> Value:
    return times(plus(_exp(value), _exp(-value)), Fraction(1, 2))


def _atan(value: Value) -> Value:
    return Fraction(0) if value == 0 else iv.atan2(_interval(value), iv.mpf(1))


def _atan2(y: Value, x: Value) -> Value:
    """By the arctangent in a half plane in which the point surely lies."""
    unclear = not isinstance(x, Fraction) and not apart(x, Fraction(0))
    if unclear or (sign_of(x) <= 0 and sign_of(y) != 0):
        return plus(times(iv.pi / 2, Fraction(sign_of(y))), -_atan(_over(x, y)))
    return _atan(_over(y, x)) if sign_of(x) >= 0 else iv.pi + 0


def _asin(value: Value) -> Value:
    """By the angle of the point on the circle."""
    return _atan2(value, _root(plus(Fraction(1), -times(value, value))))


def _acos(value: Value) -> Value:
    return _atan2(_root(plus(Fraction(1), -times(value, value))), value)


def _asinh(value: Value) -> Value:
    return _log(plus(value, _root(plus(times(value, value), Fraction(1)))))


def _acosh(value: Value) -> Value:
    if sign_of(plus(value, Fraction(-1))) < 0:
        raise NotEnclosed
    return _log(plus(value, _root(plus(times(value, value), Fraction(-1)))))


def _atanh(value: Value) -> Value:
    quotient = _over(plus(Fraction(1), value), plus(Fraction(1), -value))
    return times(Fraction(1, 2), _log(quotient))


def _inverted(function: Callable[[Value], Value]) -> Callable[[Value], Value]:
    return lambda value: function(_over(Fraction(1), value))


def _under(function: Callable[[Value], Value]) -> Callable[[Value], Value]:
    return lambda value: _over(Fraction(1), function(value))


def _quotient(above: Callable[[Value], Value], below: Callable[[Value], Value]) -> Callable[[Value], Value]:
    return lambda value: _over(above(value), below(value))


def _largest(sign: int) -> Callable[..., Value]:
    return lambda *values: reduce(lambda a, b: a if sign_of(plus(a, -b)) * sign >= 0 else b, values)


FUNCTIONS: Mapping[type, Callable[..., Value]] = {
    sympy.exp: _exp, sympy.log: _log, sympy.sin: _sin, sympy.cos: _cos, sympy.sinh: _sinh, sympy.cosh: _cosh,
    sympy.tan: _quotient(_sin, _cos), sympy.cot: _quotient(_cos, _sin),
    sympy.sec: _under(_cos), sympy.csc: _under(_sin),
    sympy.tanh: _quotient(_sinh, _cosh), sympy.coth: _quotient(_cosh, _sinh),
    sympy.sech: _under(_cosh), sympy.csch: _under(_sinh),
    sympy.atan: _atan, sympy.atan2: _atan2, sympy.asin: _asin, sympy.acos: _acos, sympy.acot: _inverted(_atan),
    sympy.asec: _inverted(_acos), sympy.acsc: _inverted(_asin),
    sympy.asinh: _asinh, sympy.acosh: _acosh, sympy.atanh: _atanh,
    sympy.acoth: _inverted(_atanh), sympy.asech: _inverted(_acosh), sympy.acsch: _inverted(_asinh),
    sympy.Abs: lambda value: times(value, Fraction(sign_of(value))),
    sympy.sign: lambda value: Fraction(sign_of(value)),
    sympy.Heaviside: lambda value, at_zero: Fraction(sign_of(value) > 0) if sign_of(value) else at_zero,
    sympy.Max: _largest(1), sympy.Min: _largest(-1),
    sympy.floor: lambda value: Fraction(_whole(value)), sympy.ceiling: lambda value: Fraction(-_whole(-value)),
}  # fmt: skip


def _whole(value: Value) -> int:
    low, high = (value, value) if isinstance(value, Fraction) else ends(value)
    if low // 1 != high // 1:
        raise NotEnclosed
    return int(low // 1)
