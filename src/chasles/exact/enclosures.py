"""Two numbers between which an exact number lies, by interval arithmetic with as many bits as are asked for."""

from __future__ import annotations

from functools import lru_cache, partial, reduce
from math import log10
from operator import add, mul
from typing import Any

import sympy as sp
from mpmath.ctx_iv import MPIntervalContext
from mpmath.libmp import fzero, mpf_lt

FEW_BITS = 64
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


def is_bounded(number: Any) -> bool:
    """Whether 256 bits show that the number has a real value."""
    try:
        return bool(enclosed(number, 256).delta < 1)
    except NoEnclosure:
        return False


@lru_cache(maxsize=50_000)
def enclosed(number: Any, bits: int) -> Any:
    """An interval of mpmath with the number in it; its comparisons are true only where they are for all of it.

    Raises NoEnclosure.
    """
    context, of = intervals(bits), partial(enclosed, bits=bits)
    match number:
        case sp.Rational():
            return context.mpf(int(number.p)) / int(number.q)
        case sp.Add():
            return reduce(add, map(of, number.args))
        case sp.Mul():
            return reduce(mul, map(of, number.args))
        case sp.Pow(exp=sp.Rational(p=p, q=q)) if int(q).bit_count() == 1:
            value = of(number.base)
            for _ in range(int(q).bit_length() - 1):
                value = _root(context, value)
            return value ** int(p)
        case sp.CRootOf():
            near = _near(number, bits)
            return context.mpf(int(near.p)) / int(near.q) + context.mpf([-1, 1]) / 2**bits
        case _ if number == sp.pi:
            return +context.pi
        case sp.Function():
            return _function(context, number, of(number.args[0]))
    raise NoEnclosure(number)


@lru_cache(maxsize=50)
def intervals(bits: int) -> MPIntervalContext:
    """Intervals with so many bits; to make them anew takes longer than most numbers."""
    context = MPIntervalContext()
    context.prec = bits
    return context


@lru_cache(maxsize=1000)
def _near(root: Any, bits: int) -> Any:
    """A rational number that far from the root at most: SymPy's decimals if it is beside them, else by halving."""
    near, width = root.eval_rational(sp.Rational(1, 2**FEW_BITS)), sp.Rational(1, 2**FEW_BITS)
    if bits <= FEW_BITS:
        return near
    digits = int((bits + int(abs(near)).bit_length()) * log10(2)) + 3
    times = int(root.eval_approx(digits) * 2**bits)
    low, high = (sp.Rational(times + beside, 2**bits) for beside in (-1, 1))
    is_within = near - width <= low and high <= near + width
    if is_within and all(root.poly.count_roots(*ends) == 1 for ends in ((near - width, near + width), (low, high))):
        return sp.Rational(times, 2**bits)
    return root.eval_rational(sp.Rational(1, 2**bits))


def _function(context: Any, function: Any, x: Any) -> Any:
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
            return context.atan2(_root(context, (1 - x) * (1 + x)), x)
        case sp.asin() | sp.acsc():
            x = x if isinstance(function, sp.asin) else 1 / x
            return context.atan2(x, _root(context, (1 - x) * (1 + x)))
        case sp.atan():
            return context.atan2(x, context.mpf(1))
        case sp.acot():
            if x < 0:
                return -context.atan2(context.mpf(1), -x)
            return context.atan2(context.mpf(1), x) if x >= 0 else context.mpf([-2, 2])
    raise NoEnclosure(function)


def _root(context: Any, x: Any) -> Any:
    """The square root of a number that is known not to be negative, of whatever its interval holds below zero."""
    low, high = x._mpi_
    if mpf_lt(high, fzero):
        raise NoEnclosure("the square root of a negative number")
    return context.sqrt(context.make_mpf((fzero, high)) if mpf_lt(low, fzero) else x)
