"""Motions, lines and wrenches made from known answers, by formulas of their own (quaternions, plain SymPy)."""

from __future__ import annotations

from dataclasses import dataclass
from random import Random
from typing import Any

import sympy as sp

from chasles.exact.grammar import read_number
from chasles.exact.numbers import is_zero

__all__ = ["Motion", "motion", "number", "plain", "rational", "rotation", "same", "unit", "vector"]


def rational(draw: Random, most: int = 5) -> sp.Rational:
    return sp.Rational(draw.randint(-most, most), draw.randint(1, 3))


def vector(draw: Random) -> sp.Matrix:
    return sp.Matrix([rational(draw) for _ in range(3)])


def rotation(w: int, x: int, y: int, z: int) -> sp.Matrix:
    """The rotation of a quaternion that need not be a unit."""
    q = sp.Matrix(
        [
            [w * w + x * x - y * y - z * z, 2 * (x * y - w * z), 2 * (x * z + w * y)],
            [2 * (x * y + w * z), w * w - x * x + y * y - z * z, 2 * (y * z - w * x)],
            [2 * (x * z - w * y), 2 * (y * z + w * x), w * w - x * x - y * y + z * z],
        ]
    )
    return q / sp.Integer(w * w + x * x + y * y + z * z)


def unit(draw: Random) -> sp.Matrix:
    """A rational unit vector: a column of a rational rotation."""
    return rotation(*quaternion(draw))[:, 0]


def quaternion(draw: Random) -> tuple[int, int, int, int]:
    while True:
        found = (draw.randint(0, 4), *(draw.randint(-4, 4) for _ in range(3)))
        if any(found[1:]):
            return found


@dataclass(frozen=True)
class Motion:
    """A screw motion by its answers."""

    Q: sp.Matrix
    e: sp.Matrix
    cosine: sp.Expr
    p0: sp.Matrix
    d0: sp.Expr

    def moved(self, point: Any) -> sp.Matrix:
        return self.p0 + self.Q * (sp.Matrix(point) - self.p0) + self.d0 * self.e


def motion(draw: Random, half_turn: bool = False) -> Motion:
    w, x, y, z = quaternion(draw)
    w = 0 if half_turn else w
    along = sp.Matrix([x, y, z])
    if w == 0 and next(c for c in along if c) < 0:
        along = -along
    squared = along.dot(along)
    e = along / sp.sqrt(squared)
    somewhere = vector(draw)
    p0 = somewhere - along * somewhere.dot(along) / squared
    cosine = sp.Integer(w * w - squared) / (w * w + squared)
    return Motion(rotation(w, x, y, z), e, cosine, p0, rational(draw) * sp.sqrt(squared))


def plain(value: Any) -> Any:
    """As a data file has it."""
    if isinstance(value, sp.MatrixBase):
        rows = [[str(x) for x in value.row(i)] for i in range(value.rows)]
        return [row[0] for row in rows] if value.cols == 1 else rows
    return str(value)


def number(text: str) -> Any:
    return read_number(text)


def same(one: Any, other: Any) -> bool:
    """Whether two numbers, matrices, or the lists and texts that JSON holds of them, are equal, exactly."""
    left, right = entries(one), entries(other)
    return len(left) == len(right) and all(is_zero(a - b) for a, b in zip(left, right, strict=True))


def entries(value: Any) -> list[Any]:
    match value:
        case str():
            return [number(value)]
        case list() | tuple():
            return [entry for part in value for entry in entries(part)]
        case sp.MatrixBase():
            return list(value)
        case _:
            return [sp.sympify(value)]
