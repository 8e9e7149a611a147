"""SymPy numbers that square roots make, as elements of a tower of such roots, and these as SymPy spells them."""

from __future__ import annotations

from functools import lru_cache, reduce
from math import lcm
from typing import Any

import sympy as sp
from sympy.functions.elementary.trigonometric import TrigonometricFunction

from chasles.exact.tower import QuadraticTower, Surd

MOST_PARTS, MOST_FACTORS, FEW_FACTORS = 600, 64, 16
"""Of a turn are taken, for sines, cosines and tangents, and for cotangents: Euler's function of these is a degree."""


class NotInTower(ValueError):
    """The number is not made by square roots alone."""


def in_tower(tower: QuadraticTower, expression: Any) -> Surd:
    """The element of the tower that the number is; roots that the tower lacks are taken in. Raises NotInTower."""
    if expression.is_Rational:
        return tower.ground(expression)
    if expression.is_Mul:
        return reduce(tower.multiply, [in_tower(tower, factor) for factor in expression.args])
    if expression not in tower.known:
        tower.known[expression] = _read(tower, expression)
    return tower.known[expression]


def _read(tower: QuadraticTower, expression: Any) -> Surd:
    if expression.is_Add:
        return reduce(tower.add, [in_tower(tower, term) for term in expression.args])
    if expression.is_Pow and expression.exp.is_Rational:
        return _power(tower, expression.base, int(expression.exp.p), int(expression.exp.q))
    for atom in tower.ground.atoms:
        beside = expression / atom
        if (beside**2).is_Rational:
            return tower.multiply(tower.ground(atom), in_tower(tower, beside))
    if isinstance(expression, sp.cos | sp.sin | sp.tan | sp.cot):
        return _of_angle(tower, expression)
    raise NotInTower(expression)


def _of_angle(tower: QuadraticTower, function: Any) -> Surd:
    (angle,) = function.args
    turns = angle / sp.pi
    if isinstance(function, sp.cot) or any(atom.has(sp.cot(angle)) for atom in tower.ground.atoms):
        if turns.is_Rational and not _is_constructible(turns, FEW_FACTORS):
            raise NotInTower(function)
        other = {sp.cot: sp.tan, sp.tan: sp.cot}.get(type(function), type(function))
        return tower.inverse(in_tower(tower, other(angle)))
    if not turns.is_Rational:
        written = sp.expand_trig(function)
    elif _is_constructible(turns, MOST_FACTORS):
        written = function.rewrite(sp.sqrt)
    else:
        raise NotInTower(function)
    if written.has(type(function)):
        raise NotInTower(function)
    return in_tower(tower, written)


def _is_constructible(turns: Any, most: int) -> bool:
    """Whether square roots express the cosine of that angle (Gauss), and few enough to be handled."""
    part = int((turns / 2).q)
    degree = int(sp.totient(part)) if part < MOST_PARTS else 0
    return 0 < degree <= most and not degree & (degree - 1)


def _power(tower: QuadraticTower, base: Any, above: int, below: int) -> Surd:
    if below & (below - 1):
        raise NotInTower(base)
    value = in_tower(tower, base)
    while below > 1:
        value, below = tower.root(value), below // 2
    if above < 0:
        value = tower.inverse(value)
    if not isinstance(value, tuple):
        return value ** abs(above)
    return reduce(tower.multiply, [value] * abs(above), tower.ground(sp.Integer(1)))


def spelled(tower: QuadraticTower, x: Surd, times: Any = sp.S.One) -> Any:
    """The element, times roots of integers, as SymPy spells it: one spelling for one number."""
    if not isinstance(x, tuple):
        return tower.ground.expression(x, times)
    level, a, b = x
    radicand = tower.radicands[level - 1]
    if radicand not in tower.spelled:
        tower.spelled[radicand] = spelled(tower, radicand)
    under = tower.spelled[radicand]
    inside = sp.sqrt(under)
    if under.is_Rational:
        return spelled(tower, a, times) + spelled(tower, b, times * inside)
    beside = tower.multiply(b, radicand)
    square = tower.multiply(b, beside)
    length, own = tower.length, tower.length(radicand)
    if 2 * length(square) < min(length(b), length(beside)) + own:
        root = tower.sign(b) * sp.sqrt(spelled(tower, square))
    elif length(b) <= length(beside):
        root = spelled(tower, b) * inside
    else:
        root = spelled(tower, beside) / inside
    return spelled(tower, a, times) + (root if times == 1 else sp.expand_mul(root * times))


def is_surd(expression: Any) -> bool:
    """Whether the number is made by square roots alone."""
    try:
        in_tower(QuadraticTower(), expression)
    except NotInTower:
        return False
    return True


def independent_atoms(*values: Any) -> tuple[Any, ...] | None:
    """The numbers of which some are made by arithmetic and square roots; None where they are related.

    Sines and cosines are, by the unit circle. Between others nothing is used: only a chance equality is not seen.
    Each is taken times the root of the integers whose roots occur: most of what is made of them then lacks these.
    """
    found = {atom for value in values for atom, _ in _leaves(value)}
    angles = [atom for atom in found if isinstance(atom, TrigonometricFunction)]
    related = len(angles) > 1 and not all(isinstance(atom, sp.cot) for atom in angles)
    if related:
        return None
    under = {under for value in values for under in _integers_under_roots(value)}
    beside = sp.sqrt(lcm(*under))
    return tuple(beside * atom for atom in sorted(found, key=sp.default_sort_key))


@lru_cache(maxsize=20_000)
def _integers_under_roots(value: Any) -> frozenset[int]:
    """The integers whose square roots occur, not those within angles."""
    if value.is_Pow and value.base.is_Integer and value.exp.q == 2:
        return frozenset({int(value.base)})
    parts = () if isinstance(value, TrigonometricFunction) else value.args
    return frozenset().union(*map(_integers_under_roots, parts))


def has_roots_of_atoms(value: Any) -> bool:
    """Whether it holds a cotangent, or a square root of a number, that square roots alone do not make."""
    return any(under_root or isinstance(atom, sp.cot) for atom, under_root in _leaves(value))


@lru_cache(maxsize=20_000)
def _leaves(value: Any, under_root: bool = False) -> frozenset[tuple[Any, bool]]:
    """What arithmetic and square roots do not take apart, and whether it stands under a root."""
    if value.is_Add or value.is_Mul or (value.is_Pow and value.exp.is_Rational):
        within = under_root or (value.is_Pow and int(value.exp.q) > 1)
        return frozenset().union(*(_leaves(part, within) for part in value.args[: 1 if value.is_Pow else None]))
    if is_surd(value):
        return frozenset()
    return frozenset({(sp.cot(value.args[0]) if isinstance(value, sp.tan) else value, under_root)})
