"""Matrices of fractions over declared atoms: sums, products, determinants."""

from __future__ import annotations

from collections.abc import Callable
from functools import reduce
from operator import add, mul

from chasles.proof.ratios import Ratio

Matrix = list[list[Ratio]]


def each(matrix: Matrix, change: Callable[[Ratio], Ratio]) -> Matrix:
    """The matrix with each entry changed."""
    return [[change(entry) for entry in row] for row in matrix]


def plus(left: Matrix, right: Matrix) -> Matrix:
    """The sum of two matrices."""
    return [[a + b for a, b in zip(one, other, strict=True)] for one, other in zip(left, right, strict=True)]


def times(left: Matrix, right: Matrix) -> Matrix:
    """The product of two matrices."""
    columns = list(zip(*right, strict=True))
    return [[reduce(add, map(mul, row, column)) for column in columns] for row in left]


def flipped(matrix: Matrix) -> Matrix:
    """The transpose."""
    return [list(column) for column in zip(*matrix, strict=True)]


def equal(left: Matrix, right: Matrix) -> bool:
    """Whether all entries are equal."""
    return all((a - b).is_zero for one, other in zip(left, right, strict=True) for a, b in zip(one, other, strict=True))


def determinant(m: Matrix) -> Ratio:
    """The determinant, by expansion along the first row while it has zeros to save, for at most 6 x 6."""
    if len(m) == 1:
        return m[0][0]
    total: Ratio | None = None
    for j, entry in enumerate(m[0]):
        if entry.is_zero:
            continue
        minor = determinant([row[:j] + row[j + 1 :] for row in m[1:]])
        term = entry * minor if j % 2 == 0 else -(entry * minor)
        total = term if total is None else total + term
    return total if total is not None else m[0][0]


def minor(m: Matrix, i: int, j: int) -> Ratio:
    """The cofactor of an entry of a 3 x 3 matrix."""
    a, b = (i + 1) % 3, (i + 2) % 3
    c, d = (j + 1) % 3, (j + 2) % 3
    return m[a][c] * m[b][d] - m[a][d] * m[b][c]
