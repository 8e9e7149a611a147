"""Linear equations over exact numbers: all solutions, or none."""

from __future__ import annotations

from dataclasses import dataclass
from itertools import chain
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
    rows, pivots = _reduced(matrix_of(sp.Matrix.hstack(sp.Matrix(matrix), sp.Matrix(right))), matrix.shape[1])
    size = matrix.shape[1]
    if any(not is_zero(row[size]) for row in rows[len(pivots) :]):
        return Solutions(None)
    one = [sp.Integer(0)] * size
    for row, pivot in zip(rows, pivots, strict=False):
        one[pivot] = row[size]
    directions = []
    for free in (k for k in range(size) if k not in pivots):
        way = [sp.Integer(int(k == free)) for k in range(size)]
        for row, pivot in zip(rows, pivots, strict=False):
            way[pivot] = normal(-row[free])
        directions.append(column_of(*way))
    return Solutions(column_of(*one), tuple(directions))


def rank_of(matrix: Any) -> int:
    """How many rows are linearly independent."""
    return len(_reduced(matrix_of(matrix), matrix.shape[1])[1])


def kernel_of(matrix: Any) -> tuple[Any, ...]:
    """A basis of the vectors that the matrix takes to zero."""
    return solve_linear(matrix, sp.zeros(matrix.shape[0], 1)).directions


def _reduced(matrix: Any, columns: int) -> tuple[list[list[Any]], list[int]]:
    """The rows in reduced echelon form with respect to the first columns, and the columns of the pivots."""
    rows = [list(matrix[i, :]) for i in range(matrix.shape[0])]
    pivots: list[int] = []
    for column in range(columns):
        place = len(pivots)
        found = next((k for k in range(place, len(rows)) if not is_zero(rows[k][column])), None)
        if found is None:
            continue
        rows[place], rows[found] = rows[found], rows[place]
        divisor = rows[place][column]
        rows[place] = [normal(entry / divisor) for entry in rows[place]]
        for other in chain(range(place), range(place + 1, len(rows))):
            factor = rows[other][column]
            if not is_zero(factor):
                rows[other] = [normal(x - factor * y) for x, y in zip(rows[other], rows[place], strict=True)]
        pivots.append(column)
    return rows, pivots
