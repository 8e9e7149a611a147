"""Exponents that are numbers: how large they may be."""

from __future__ import annotations

from collections.abc import Iterable
from typing import Any

import sympy

from chasles.from_sympy.opening import excerpt
from chasles.problems.variables import Untreatable

LARGEST_EXPONENT = 10_000
MOST_FACTORED = 40
"""Polynomials of a higher degree are not factored."""


def require_moderate_exponents(expressions: Iterable[Any]) -> None:
    """Raise `Untreatable` for a numeric exponent whose numerator or denominator is too large for polynomials."""
    for power in (power for e in expressions for power in e.atoms(sympy.Pow)):
        exponent = power.exp
        if exponent.is_Rational and max(abs(exponent.p), exponent.q) > LARGEST_EXPONENT:
            which = "its exponent is" if exponent.is_Integer else "the numerator or denominator of its exponent is"
            raise Untreatable(f"{excerpt(power)} is not treated: {which} larger than {LARGEST_EXPONENT}")


def may_be_factored(expression: Any) -> bool:
    """Whether no power in the expression makes it a polynomial of too high a degree."""
    return all(not power.exp.is_Integer or power.exp <= MOST_FACTORED for power in expression.atoms(sympy.Pow))
