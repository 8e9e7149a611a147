"""SymPy numbers that square roots make, as elements of a tower of such roots, and these as SymPy spells them."""

from __future__ import annotations

from fractions import Fraction
from functools import reduce
from typing import Any

import sympy as sp

from chasles.exact.tower import Surd, Tower

__all__ = ["NotInTower", "in_tower", "is_surd", "spelled"]


class NotInTower(ValueError):
    """The number is not made by square roots alone."""


def in_tower(tower: Tower, expression: Any) -> Surd:
    """The element of the tower that the number is; roots that the tower lacks are taken in. Raises NotInTower."""
    if expression.is_Rational:
        return Fraction(int(expression.p), int(expression.q))
    if expression.is_Add:
        return reduce(tower.add, [in_tower(tower, term) for term in expression.args])
    if expression.is_Mul:
        return reduce(tower.multiply, [in_tower(tower, factor) for factor in expression.args])
    if expression.is_Pow and expression.exp.is_Rational:
        return _power(tower, expression.base, int(expression.exp.p), int(expression.exp.q))
    if isinstance(expression, sp.cos | sp.sin | sp.tan) and (expression.args[0] / sp.pi).is_Rational:
        written = expression.rewrite(sp.sqrt)
        if not written.has(sp.cos, sp.sin, sp.tan):
            return in_tower(tower, written)
    if isinstance(expression, sp.cos | sp.sin | sp.tan):
        written = sp.expand_trig(expression)
        if written != expression:
            return in_tower(tower, written)
    raise NotInTower(expression)


def _power(tower: Tower, base: Any, above: int, below: int) -> Surd:
    if below & (below - 1):
        raise NotInTower(base)
    value = in_tower(tower, base)
    while below > 1:
        value, below = tower.root(value), below // 2
    if above < 0:
        value = tower.inverse(value)
    one: Surd = Fraction(1)
    return reduce(tower.multiply, [value] * abs(above), one)


def spelled(tower: Tower, x: Surd) -> Any:
    """The element as SymPy spells it: one spelling for one number."""
    if isinstance(x, Fraction):
        return sp.Rational(x.numerator, x.denominator)
    level, a, b = x
    radicand = tower.radicands[level - 1]
    inside = sp.sqrt(spelled(tower, radicand))
    if isinstance(radicand, Fraction):
        return spelled(tower, a) + sp.expand_mul(spelled(tower, b) * inside)
    above, below = spelled(tower, b), spelled(tower, tower.multiply(b, radicand))
    # Whichever is shorter: b sqrt(r), or b r / sqrt(r).
    shorter = above * inside if len(str(above)) <= len(str(below)) else below / inside
    return spelled(tower, a) + shorter


def is_surd(expression: Any) -> bool:
    """Whether the number is made by square roots alone."""
    try:
        in_tower(Tower(), expression)
    except NotInTower:
        return False
    return True
