"""Numbers of any precision, and intervals that enclose them: the two arithmetics of mpmath.

Contexts are made once for each precision and never changed, so that evaluations do not disturb one another.
"""

from __future__ import annotations

from fractions import Fraction
from functools import cache
from math import isfinite
from numbers import Real
from typing import Any

import mpmath
from mpmath.ctx_iv import MPIntervalContext

FEW_DIGITS = 15


@cache
def interval_context(digits: int) -> Any:
    """An arithmetic of intervals, whose ends have so many digits."""
    context = MPIntervalContext()
    context.dps = digits
    return context


@cache
def plain_context(digits: int) -> Any:
    """An arithmetic of numbers with so many digits."""
    context = mpmath.mp.clone()
    context.dps = digits
    return context


def exactly(number: Any, context: Any) -> Any:
    """The number in a context of either kind: floats and mpmath numbers as they are, fractions as the context rounds.

    Raises TypeError for what is no real number, ValueError for an infinity or what is not a number.
    """
    if isinstance(number, Fraction):
        return context.mpf(number.numerator) / number.denominator
    if hasattr(number, "_mpf_"):
        raw = number._mpf_
        return context.make_mpf((raw, raw) if isinstance(context, MPIntervalContext) else raw)
    if not isinstance(number, Real):
        raise TypeError(f"expected a number, got {number!r}")
    if not isinstance(number, int) and not isfinite(number):
        raise ValueError(f"{float(number)} has no digits")
    return context.mpf(number if isinstance(number, int) else float(number))


def ends(enclosure: Any, digits: int = FEW_DIGITS) -> tuple[Any, Any]:
    """The two ends of an interval, exactly; what is computed from them has so many digits."""
    make = plain_context(digits).make_mpf
    low, high = enclosure._mpi_
    return make(low), make(high)


def is_narrow(enclosure: Any, digits: int) -> bool:
    """Whether the ends agree in so many digits, or are both zero."""
    low, high = ends(enclosure)
    if low == high:
        return True
    return bool(low * high > 0 and (high - low) * low.context.mpf(10) ** digits <= min(abs(low), abs(high)))


def middle(enclosure: Any, digits: int) -> Any:
    """The number that an interval encloses; zero if it holds zero."""
    low, high = ends(enclosure, digits)
    return (low + high) / 2 if low * high > 0 else low * 0
