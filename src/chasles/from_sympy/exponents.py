"""Exponents and arguments that are too large for SymPy to come to an end with are refused."""

from __future__ import annotations

from collections.abc import Iterable
from typing import Any

import sympy
from sympy.concrete.expr_with_limits import ExprWithLimits
from sympy.functions.combinatorial.factorials import CombinatorialFunction

from chasles.from_sympy.opening import excerpt, parts_of
from chasles.problems.variables import Untreatable

LARGEST_EXPONENT = 10_000
COUNTED = CombinatorialFunction, sympy.gamma, sympy.fibonacci, sympy.lucas, sympy.bell, sympy.bernoulli, sympy.harmonic
INFINITE = sympy.oo, -sympy.oo, sympy.zoo, sympy.nan
MOST_FACTORED = 40
"""Polynomials of a higher degree are not factored."""


def require_moderate(expressions: Iterable[Any]) -> None:
    """Raise `Untreatable` for a numeric exponent whose numerator or denominator is too large, or a limit at infinity.

    SymPy would not come to an end with these.
    """
    for part in (part for e in expressions for part in parts_of(e)):
        ends = [end for limit in getattr(part, "limits", ()) for end in limit[1:] if isinstance(part, ExprWithLimits)]
        infinite = [end for end in ends if end.has(*INFINITE)]
        if infinite and not (isinstance(part, sympy.Integral) and {*infinite} <= {sympy.oo, -sympy.oo}):
            raise Untreatable(f"{excerpt(part)} is not treated: it has an infinite limit")
        if isinstance(part, COUNTED) and any(each.is_Integer and each > LARGEST_EXPONENT for each in part.args):
            raise Untreatable(f"{excerpt(part)} is not treated: its argument is larger than {LARGEST_EXPONENT}")
        exponent = part.exp if isinstance(part, sympy.Pow) else sympy.S.One
        if exponent.is_Pow and exponent.is_number and exponent.is_integer:
            raise Untreatable(f"{excerpt(part)} is not treated: its exponent is a power that is not evaluated")
        if exponent.is_Rational and max(abs(exponent.p), exponent.q) > LARGEST_EXPONENT:
            which = "its exponent is" if exponent.is_Integer else "the numerator or denominator of its exponent is"
            raise Untreatable(f"{excerpt(part)} is not treated: {which} larger than {LARGEST_EXPONENT}")


def may_be_factored(expression: Any) -> bool:
    """Whether no power in the expression makes it a polynomial of too high a degree."""
    return all(not power.exp.is_Integer or power.exp <= MOST_FACTORED for power in expression.atoms(sympy.Pow))
