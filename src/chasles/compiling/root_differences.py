"""Sums with a root that may cancel, by the difference of the squares: a - b is (a^2 - b^2)/(a + b).

So are the smaller solution of a quadratic equation, and the difference of two roots that are close, computed with all
digits (Forsythe, How do you solve a quadratic equation?, 1966).
"""

from __future__ import annotations

from typing import Any

import sympy

from chasles.compiling.angles import MOST_PARTS, size_of
from chasles.compiling.taylor import NearZero

_MOST_TERMS = 4
"""Beside the root; of more the square is long."""


def by_conjugate(total: Any) -> Any:
    """The sum; where its root and the rest have opposite signs it is divided by what they are with the same ones."""
    for term in total.args if len(total.args) <= _MOST_TERMS + 1 and size_of(total) <= MOST_PARTS else ():
        for root in (factor for factor in sympy.Mul.make_args(term) if _is_root_of_sum(factor)):
            rest, factor = total - term, term / root
            left = _difference(rest**2, factor**2 * root.base)
            if left is not None:
                # Both are zero at once only where nothing cancels.
                opposite = sympy.StrictLessThan(rest * factor, 0)
                near = left / (rest - term)
                return NearZero((near, opposite), (total, True), evaluate=False) if opposite != sympy.false else total
    return total


def _is_root_of_sum(factor: Any) -> bool:
    return bool(factor.is_Pow and factor.exp == sympy.S.Half and factor.base.is_Add)


def _difference(one: Any, other: Any) -> Any:
    """The difference of two sums in which terms cancel; None where none do."""
    one, other = one.expand(), other.expand()
    shared = set(sympy.Add.make_args(one)) & set(sympy.Add.make_args(other))
    return sympy.factor_terms(one - other) if shared else None
