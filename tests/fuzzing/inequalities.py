"""Questions with inequalities: signs, sizes, angles and branches, on intervals with and without their ends."""

from __future__ import annotations

from random import Random
from typing import Any

import sympy as sp
from sympy import Abs, Max, Min, Piecewise, Rational, acos, asin, atan, atan2, cos, log, pi, sign, sin, sqrt, tan

from .equations import Equation

__all__ = ["question"]

X, Y, Z = FREE = sp.symbols("x y z", real=True)
P = sp.Symbol("p", positive=True)
R = sp.Symbol("r", nonnegative=True)
N = sp.Symbol("n", integer=True)
T = sp.Symbol("t")
MOVING = tuple(sp.Function(name)(T) for name in "fg")
NUMBERS = (-1, 0, 0, Rational(1, 2), 1, 2)
TURNS = (-pi, -pi / 2, 0, 0, pi / 4, pi / 3, pi / 2, pi, 3 * pi / 2, 2 * pi)
SHARED = 0.1
"""Of how many questions both sides of what is compared have a part in common."""
RELATIONS = (sp.Gt, sp.Ge, sp.Lt, sp.Le)


def _sizes(a: Any, b: Any) -> list[tuple[Any, Any]]:
    """What is true of real numbers where some of them have a sign."""
    return [
        (Abs(a), a), (Abs(a - b), a - b), (Max(a, b), a), (Min(a, b), b), (sqrt(a**2), a), (sign(a), 1), (a, b),
        (sqrt(a * b), sqrt(a) * sqrt(b)), (sqrt(a**2 * b), a * sqrt(b)), (sign(a - b), 1),
        (sqrt(a / b), sqrt(a) / sqrt(b)),
        (Piecewise((a, a > b), (b, True)), a), (Piecewise((a, a >= b), (b, True)), b), (log(a * b), log(a) + log(b)),
        (log(a**2), 2 * log(a)), (atan2(b, a), atan(b / a)), (asin(a), atan(a / sqrt(1 - a**2))), (Abs(a * b), a * b),
        (acos(a), 2 * atan(sqrt((1 - a) / (1 + a)))), (sqrt(a + 2 * sqrt(a - 1)), sqrt(a - 1) + 1),
        (sqrt(1 - a**2) * sqrt(1 - b**2), sqrt((1 - a**2) * (1 - b**2))), (Max(a, b, 0), a), (Abs(a) + Abs(b), a + b),
        (1 / sqrt(1 - ((a + b) / (1 + a * b)) ** 2), (1 + a * b) / sqrt(1 - a**2) / sqrt(1 - b**2)),
    ]  # fmt: skip


def _angles(a: Any, b: Any) -> list[tuple[Any, Any]]:
    """What is true of angles between some multiples of pi."""
    return [
        (acos(cos(a)), a), (asin(sin(a)), a), (atan(tan(a)), a), (atan2(sin(a), cos(a)), a), (Abs(sin(a)), sin(a)),
        (Abs(cos(a)), -cos(a)), (sqrt(1 - cos(a) ** 2), sin(a)), (sqrt((1 - cos(a)) / 2), sin(a / 2)),
        (sqrt((1 + cos(a)) / 2), cos(a / 2)), (tan(a / 2), sqrt((1 - cos(a)) / (1 + cos(a)))), (acos(cos(a)), Abs(a)),
        (acos(cos(a)), 2 * pi - a), (asin(sin(a)), pi - a), (asin(cos(a)), pi / 2 - a), (sign(sin(a)), 1),
        (Max(a, b), a), (Abs(a - b), a - b), (atan(1 / tan(a)), pi / 2 - a), (Abs(tan(a)), tan(a)),
    ]  # fmt: skip


def _between(draw: Random, a: Any, ends: tuple[Any, ...]) -> tuple[Any, ...]:
    """One or two bounds of a quantity, none of which makes it zero: what is zero may be under a complex root."""
    if a.is_integer or a.is_nonnegative:
        ends = tuple(end for end in ends if end >= 1)
    if draw.random() < 0.3:
        return draw.choice((sp.Gt, sp.Ge))(a, 0), draw.choice((sp.Lt, sp.Le))(a, draw.choice(ends[-3:]))
    low, high = sorted(draw.sample(ends, 2), key=float)
    if draw.random() < 0.3 or low == high:
        return (draw.choice(RELATIONS)(a, low),)
    if draw.random() < 0.2 and high > 0:
        return (draw.choice((sp.Lt, sp.Le))(Abs(a), high),)
    return draw.choice((sp.Gt, sp.Ge))(a, low), draw.choice((sp.Lt, sp.Le))(a, high)


def question(draw: Random) -> Equation:
    """Two sides that are often equal where a quantity is in an interval, and such intervals."""
    turning = draw.random() < 0.4
    if turning:
        a, b = draw.sample((X, Y, P, R), 2)
        a = draw.choice((a, a, a / 2, 2 * a, -a))
    elif draw.random() < 0.25:
        a, b = MOVING if draw.random() < 0.5 else (MOVING[0].diff(T), draw.choice((X, MOVING[1])))
    else:
        a, b = draw.sample((X, Y, Z, P, R, N), 2)
        a = draw.choice((a, a, -a, a + 1, a * b, a - b))
    left, right = draw.choice((_angles if turning else _sizes)(a, b))
    ends = TURNS if turning else NUMBERS
    where = _between(draw, a, ends) if draw.random() < 0.8 else (draw.choice(RELATIONS)(a, b),)
    if draw.random() < 0.5:
        where += _between(draw, b, ends) if draw.random() < 0.6 else (draw.choice(RELATIONS)(a, b),)
    where = tuple(item for item in where if item not in (sp.true, sp.false))
    if draw.random() < SHARED:
        # It cancels where one side is subtracted from the other, and has to be defined all the same.
        part = draw.choice((1 / b, log(b), sqrt(b), tan(b), asin(b), 1 / (b - 1)))
        where = tuple(item.func(item.lhs + part, item.rhs + part, evaluate=False) for item in where)
    return Equation(sp.sympify(left), sp.sympify(right), where=where, kind="inequalities", lenient=True)
