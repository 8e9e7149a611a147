"""Norms of rational vectors, made rational by moving a vector that is free."""

from __future__ import annotations

from fractions import Fraction
from random import Random

from chasles.algebra.localization import Ratio
from chasles.checker.witness import root_of
from chasles.evaluation.matrices import Matrix
from chasles.points.evaluation import Point, ratio_at
from chasles.problems.context import Context
from chasles.vocabulary import Node, Symbol

PYTHAGOREAN = (
    (0, 0, 1, 1),
    (1, 2, 2, 3),
    (0, 3, 4, 5),
    (2, 1, 2, 3),
    (2, -1, 2, 3),
    (2, 3, 6, 7),
    (1, -2, 2, 3),
    (4, 4, 7, 9),
)


def give_norm(
    context: Context, node: Node, name: str, point: Point, bound: set[Symbol], draw: Random, rich: bool
) -> bool:
    """Give a norm its value, moving a free vector to make it rational if need be."""
    rows = context.unfold(node)
    value = [_rational(context, row[0], point) for row in rows]
    root = root_of(sum((x * x for x in value), Fraction(0)))
    if root is None or root == 0:
        *numbers, size = draw.choice(PYTHAGOREAN)
        scale = Fraction(draw.randint(1, 3) if rich else 1)
        target = [scale * k for k in numbers]
        if not _move(context, rows, value, target, point, bound):
            if root is None:
                return False
        else:
            root = scale * size
    point[name] = root if root is not None else Fraction(0)
    return True


def _move(
    context: Context, rows: Matrix, value: list[Fraction], target: list[Fraction], point: Point, bound: set[Symbol]
) -> bool:
    """Shift a free vector so that the expression takes the target value; False if none moves it one to one."""
    if len(value) != 3:
        return False
    for symbol in dict.fromkeys(v.symbol for v in context.variables if v.kind == "entry" and v.order == 0):
        if symbol is None or symbol in bound or symbol.shape != (3, 1):
            continue
        names = [f"{symbol.name}_{i + 1}" for i in range(3)]
        if any(name not in point for name in names):
            continue
        for sign in (1, -1):
            moved = dict(point)
            for name, have, want in zip(names, value, target, strict=True):
                moved[name] += sign * (want - have)
            if [_rational(context, row[0], moved) for row in rows] == target:
                point.update(moved)
                return True
    return False


def _rational(context: Context, ratio: Ratio, point: Point) -> Fraction:
    value = ratio_at(context, ratio, point)
    if value is None or set(value) - {0}:
        raise KeyError("not a rational number")
    return value.get(0, Fraction(0))
