"""Inequalities with powers and factorials of a letter, by products up to it: then induction on it is tried."""

from __future__ import annotations

from typing import Any

import sympy

from chasles.from_sympy.inequalities import COMPARED

STEP = sympy.Symbol("k_1", integer=True)


def stepwise(claim: Any) -> Any:
    """An inequality with products for b**n and n! of an integer n from zero on; the same if there are none."""
    if not isinstance(claim, COMPARED) or STEP in claim.free_symbols:
        return claim
    found = {part: _product(part) for part in claim.atoms(sympy.Pow, sympy.factorial)}
    found = {part: value for part, value in found.items() if value is not None}
    return claim.func(*(side.xreplace(found) for side in claim.args), evaluate=False) if found else claim


def _product(part: Any) -> Any:
    """What a power or a factorial is up to its letter; None for others."""
    base, exponent = (STEP, part.args[0]) if isinstance(part, sympy.factorial) else part.args
    letters = [s for s in exponent.free_symbols if s.is_integer and s.is_nonnegative and not base.has(s)]
    if len(letters) != 1 or base is sympy.E:
        return None
    (letter,) = letters
    slope, start = exponent.coeff(letter), exponent.xreplace({letter: sympy.S.Zero})
    whole = slope.is_Integer and start.is_Integer and exponent == slope * letter + start
    if not whole or slope < 1 or (base is STEP and exponent is not letter):
        return None
    product = sympy.Product(base**slope, (STEP, 1, letter))
    return product if base is STEP else base**start * product
