"""What SymPy assumes of a quantity, its sign and what kind of number it is, and whether a number is so."""

from __future__ import annotations

import sympy

from chasles.checker.expressions.algebra import constant
from chasles.checker.expressions.reals import Reals
from chasles.checker.sparse import Polynomial

SIGNS = {
    "positive": (1,), "negative": (-1,), "nonnegative": (0, 1), "nonpositive": (-1, 0),
    "zero": (0,), "nonzero": (-1, 1),
}  # fmt: skip
NUMBERS = (
    "integer", "noninteger", "even", "odd", "prime", "composite", "rational", "irrational", "algebraic",
    "transcendental",
)  # fmt: skip
"""What SymPy may assume of a quantity: its sign, and what kind of number it is."""


def is_so(point: Reals, value: Polynomial, assumption: str) -> bool | None:
    """Whether a number is what SymPy assumes; None where that is not known."""
    if assumption in SIGNS:
        return point.sign(value) in SIGNS[assumption]
    numerator, below = point.cleared(value)
    known = constant(numerator)
    if known is not None and not below:
        return bool(getattr(sympy.Rational(known.numerator, known.denominator), f"is_{assumption}"))
    if point.sign(value) < 0 and assumption in ("prime", "composite"):
        return False
    if len(numerator.places) > 1 or below:
        return None
    # A multiple of pi, or of another arctangent of a rational number, is transcendental (Lindemann).
    transcendental = not numerator.places & point.squares.keys()
    if transcendental or len(numerator.terms) == 1:
        return assumption in ("irrational", "noninteger", "transcendental" if transcendental else "algebraic")
    return {"algebraic": True, "transcendental": False}.get(assumption)
