"""Linear equations over exact numbers: all solutions, or none."""

from __future__ import annotations

from dataclasses import dataclass
from typing import Any

import sympy as sp

from chasles.exact.evaluate import column_of, matrix_of
from chasles.exact.numbers import is_zero, normal


@dataclass(frozen=True, slots=True)
class Solutions:
    """All solutions: one of them and the directions in which it is free; `one` is None if there are none."""

    one: Any
    directions: tuple[Any, ...] = ()

    @property
    def exist(self) -> bool:
        """Whether there is a solution."""
        return self.one is not None

    @property
    def unique(self) -> bool:
        """Whether there is exactly one solution."""
        return self.exist and not self.directions


def solve_linear(matrix: Any, right: Any) -> Solutions:
    """The solutions x, columns, of matrix x = right."""
    size = matrix.shape[1]
    rows, pivots = _reduced(sp.Matrix.hstack(sp.Matrix(matrix), sp.Matrix(right)))
    if size in pivots:
        return Solutions(None)
    one = [sp.Integer(0)] * size
    for k, pivot in enumerate(pivots):
        one[pivot] = rows[k, size]
    directions = []
    for free in (k for k in range(size) if k not in pivots):
        way = [sp.Integer(int(k == free)) for k in range(size)]
        for k, pivot in enumerate(pivots):
            way[pivot] = normal(-rows[k, free])
        directions.append(column_of(*way))
    return Solutions(column_of(*one), tuple(directions))


def rank_of(matrix: Any) -> int:
    """How many rows are linearly independent."""
    return len(_reduced(matrix)[1])


def kernel_of(matrix: Any) -> tuple[Any, ...]:
    """A basis of the vectors that the matrix takes to zero."""
    return solve_linear(matrix, sp.zeros(matrix.shape[0], 1)).directions


def _reduced(matrix: Any) -> tuple[Any, tuple[int, ...]]:
    """The rows in reduced echelon form, and the columns of the pivots."""
    rows, pivots = matrix_of(matrix).rref(iszerofunc=is_zero, simplify=normal, normalize_last=False)
    return rows, pivots
