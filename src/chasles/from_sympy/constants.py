"""Numbers made of rational ones, roots and cosines: whether one is algebraic, zero, or not negative."""

from __future__ import annotations

from typing import Any

import sympy

from chasles.checker.expressions import enclosed
from chasles.checker.sparse import Rejected


def is_algebraic(e: Any) -> bool:
    """Whether a number is made of rational numbers, roots, and cosines of rational multiples of pi."""
    if isinstance(e, sympy.cos):
        return isinstance(e.args[0] / sympy.pi, sympy.Rational)
    if isinstance(e, sympy.Pow):
        return isinstance(e.exp, sympy.Rational) and is_algebraic(e.base)
    return isinstance(e, sympy.Rational) or (isinstance(e, sympy.Add | sympy.Mul) and all(map(is_algebraic, e.args)))


def vanishes(e: Any) -> bool:
    """Whether an algebraic number is zero; not so if that would take too many digits to tell."""
    try:
        return is_algebraic(e) and enclosed.sign_of_number(e) in (0, None) and enclosed.vanishes(e)
    except Rejected:
        return False


def is_nonnegative(e: Any) -> bool:
    """Whether an expression is a number that is known not to be negative."""
    return not e.free_symbols and enclosed.sign_of_number(e) in (0, 1)
