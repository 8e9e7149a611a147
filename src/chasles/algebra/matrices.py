"""Matrices of fractions over declared nonzero factors: sums, products, determinants."""

from __future__ import annotations

from collections.abc import Callable
from functools import reduce
from operator import add, mul

from chasles.algebra.localization import Ratio

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
    terms = [entry * cofactor(m, 0, j) for j, entry in enumerate(m[0]) if not entry.is_zero]
    return reduce(add, terms) if terms else m[0][0]


def cofactor(m: Matrix, i: int, j: int) -> Ratio:
    """The cofactor of an entry of a square matrix that has more than one."""
    minor = determinant([row[:j] + row[j + 1 :] for row in (*m[:i], *m[i + 1 :])])
    return -minor if (i + j) % 2 else minor
