"""Two numbers between which an exact number lies, by interval arithmetic with as many bits as are asked for."""

from __future__ import annotations

from functools import lru_cache, reduce
from operator import add, mul
from typing import Any

import mpmath
import sympy as sp
from mpmath.ctx_iv import MPIntervalContext
from mpmath.libmp import fzero, mpf_lt

FEW_BITS = 64
MOST_KNOWN = 5_000
"""Enclosures that are kept for each number of bits."""
INVERSES = (sp.acos, sp.asin, sp.atan, sp.acot, sp.asec, sp.acsc)


class NoEnclosure(ValueError):
    """The number holds what intervals are not known for, or it has no real value."""


def sign_by_enclosure(number: Any, most_bits: int) -> int:
    """1 or -1 if intervals of so many bits tell the sign, else 0: the number may be zero."""
    bits = 64
    while bits <= most_bits:
        try:
            interval = enclosed(number, bits)
        except NoEnclosure:
            return 0
        if interval > 0 or interval < 0:
            return 1 if interval > 0 else -1
        bits *= 2
    return 0


def is_bounded(number: Any, bits: int = 256) -> bool:
    """Whether so many bits show that the number has a real value."""
    try:
        return bool(enclosed(number, bits).delta < 1)
    except NoEnclosure:
        return False


def enclosed(number: Any, bits: int) -> Any:
    """An interval of mpmath with the number in it; its comparisons are true only where they are for all of it.

    Raises NoEnclosure.
    """
    return _intervals_of(bits)(number)


@lru_cache(maxsize=50)
def _intervals_of(bits: int) -> _Intervals:
    return _Intervals(bits)


@lru_cache(maxsize=50)
def intervals(bits: int) -> MPIntervalContext:
    """Intervals with so many bits; to make them anew takes longer than most numbers."""
    context = MPIntervalContext()
    context.prec = bits
    return context


@lru_cache(maxsize=1000)
def _near(root: Any, bits: int) -> Any:
    """A rational number that far from the root at most: Newton's, where the signs beside it differ, else by halving."""
    near, width = root.eval_rational(sp.Rational(1, 2**FEW_BITS)), sp.Rational(1, 2**FEW_BITS)
    if bits <= FEW_BITS:
        return near
    coefficients = [int(c) for c in root.poly.all_coeffs()]
    times = _by_newton(coefficients, near, bits)
    low, high = (sp.Rational(times + beside, 2**bits) for beside in (-1, 1))
    is_alone = near - width <= low and high <= near + width and root.poly.count_roots(near - width, near + width) == 1
    if is_alone and _scaled_value(coefficients, times - 1, bits) * _scaled_value(coefficients, times + 1, bits) <= 0:
        return sp.Rational(times, 2**bits)
    return root.eval_rational(sp.Rational(1, 2**bits))


def _by_newton(coefficients: list[int], start: Any, bits: int) -> int:
    """Newton's approximation to a root with FEW_BITS known bits, as a multiple of 1 / 2^bits."""
    with mpmath.workprec(bits + FEW_BITS):
        x = mpmath.mpf(int(start.p)) / int(start.q)
        for _ in range((bits // FEW_BITS).bit_length() + 1):
            value, slope = mpmath.polyval(coefficients, x, derivative=True)
            x -= value / slope if slope else 0
        return int(mpmath.nint(mpmath.ldexp(x, bits)))


def _scaled_value(coefficients: list[int], times: int, bits: int) -> int:
    """The value of the polynomial at times / 2^bits, times a power of two."""
    return reduce(lambda value, term: value * times + (term[1] << bits * term[0]), enumerate(coefficients), 0)


class _Intervals:
    def __init__(self, bits: int) -> None:
        self._context = intervals(bits)
        self._known: dict[Any, Any] = {}

    def __call__(self, number: Any) -> Any:
        found = self._known.get(number)
        if found is None:
            found = self._interval(number)
            if len(self._known) >= MOST_KNOWN:
                self._known.clear()
            self._known[number] = found
        return found

    def _interval(self, number: Any) -> Any:
        match number:
            case sp.Rational():
                return self._context.mpf(int(number.p)) / int(number.q)
            case sp.Add():
                return reduce(add, map(self, number.args))
            case sp.Mul():
                return reduce(mul, map(self, number.args))
            case sp.Pow(exp=sp.Rational(p=p, q=q)) if int(q).bit_count() == 1:
                value = self(number.base)
                for _ in range(int(q).bit_length() - 1):
                    value = self._root(value)
                return value ** int(p)
            case sp.CRootOf():
                near = _near(number, self._context.prec)
                width = self._context.mpf([-1, 1]) / 2**self._context.prec
                return self._context.mpf(int(near.p)) / int(near.q) + width
            case _ if number == sp.pi:
                return +self._context.pi
            case sp.Function():
                return self._function(number, self(number.args[0]))
        raise NoEnclosure(number)

    def _function(self, function: Any, x: Any) -> Any:
        context = self._context
        match function:
            case sp.cos():
                return context.cos(x)
            case sp.sin():
                return context.sin(x)
            case sp.tan():
                return context.sin(x) / context.cos(x)
            case sp.cot():
                return context.cos(x) / context.sin(x)
            case sp.sec() | sp.csc():
                return 1 / (context.cos(x) if isinstance(function, sp.sec) else context.sin(x))
            case sp.acos() | sp.asec():
                x = x if isinstance(function, sp.acos) else 1 / x
                return context.atan2(self._root((1 - x) * (1 + x)), x)
            case sp.asin() | sp.acsc():
                x = x if isinstance(function, sp.asin) else 1 / x
                return context.atan2(x, self._root((1 - x) * (1 + x)))
            case sp.atan():
                return context.atan2(x, context.mpf(1))
            case sp.acot():
                if x < 0:
                    return -context.atan2(context.mpf(1), -x)
                return context.atan2(context.mpf(1), x) if x >= 0 else context.mpf([-2, 2])
        raise NoEnclosure(function)

    def _root(self, x: Any) -> Any:
        """The square root of a number that is known not to be negative, of whatever its interval holds below zero."""
        low, high = x._mpi_
        if mpf_lt(high, fzero):
            raise NoEnclosure("the square root of a negative number")
        return self._context.sqrt(self._context.make_mpf((fzero, high)) if mpf_lt(low, fzero) else x)
