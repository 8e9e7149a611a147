"""Whether an algebraic number is zero: it is if it is smaller than its separation bound.

C. Burnikel, S. Funke, K. Mehlhorn, S. Schirra, S. Schmitt, A separation bound for real algebraic expressions (2009): a
number is U/L with algebraic integers U and L all of whose conjugates are at most u and l in size; where D is the degree
of the field that they are in, the number is zero or at least 1/(u^(D-1) l) in size.
"""

from __future__ import annotations

from fractions import Fraction
from functools import reduce
from math import lcm, prod
from typing import Any

import sympy

from chasles.from_sympy.enclosed_functions import NotEnclosed
from chasles.from_sympy.enclosures import ends_of

MOST_BITS = 20_000
GUARD = 64
NEAR = 200


def is_algebraic(e: Any) -> bool:
    """Whether a number is made of rational numbers, roots, and cosines of rational multiples of pi."""
    if isinstance(e, sympy.cos):
        return isinstance(e.args[0] / sympy.pi, sympy.Rational)
    if isinstance(e, sympy.Pow):
        return isinstance(e.exp, sympy.Rational) and is_algebraic(e.base)
    return isinstance(e, sympy.Rational) or (isinstance(e, sympy.Add | sympy.Mul) and all(map(is_algebraic, e.args)))


def vanishes(e: Any) -> bool:
    """Whether an algebraic number is zero; not so if that would take too many digits to tell."""
    if not is_algebraic(e):
        return False
    above, below = _sizes(e)
    bits = (_degree(e) - 1) * above + below
    if bits > MOST_BITS:
        return False
    try:
        least, most = ends_of(e, 2 * bits + GUARD)
    except NotEnclosed:
        return False
    return max(-least, most) < Fraction(1, 2**bits) and least <= 0 <= most


def _sizes(e: Any) -> tuple[int, int]:
    """Binary logarithms, rounded up, of what bounds the conjugates of U and L."""
    match e:
        case sympy.Rational():
            return int(abs(e.p)).bit_length(), int(e.q).bit_length()
        case sympy.Add():
            parts = [_sizes(part) for part in e.args]
            below = sum(low for _, low in parts)
            return max(high + below - low for high, low in parts) + len(parts).bit_length(), below
        case sympy.Mul():
            return reduce(lambda one, other: (one[0] + other[0], one[1] + other[1]), map(_sizes, e.args))
        case sympy.Pow():
            above, below = _sizes(e.base)
            power, degree = int(e.exp.p), int(e.exp.q)
            above = -(-(above + (degree - 1) * below) // degree)
            above, below = (above, below) if power > 0 else (below, above)
            return above * abs(power), below * abs(power)
        case _:
            return 1, 1


def _degree(e: Any) -> int:
    """A bound of the degree of a field that a number and its parts are in."""
    roots = {(part.base, int(part.exp.q)) for part in e.atoms(sympy.Pow)}
    turns = lcm(*(int((call.args[0] / sympy.pi).q) for call in e.atoms(sympy.cos)))
    return prod(degree for _, degree in roots) * max(1, int(sympy.totient(2 * turns)) // 2)


def is_nonnegative(e: Any) -> bool:
    """Whether an expression is a number that is known not to be negative."""
    try:
        return not e.free_symbols and ends_of(e, NEAR)[0] >= 0
    except NotEnclosed:
        return False
