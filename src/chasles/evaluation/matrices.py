"""Matrices as lists of rows, over anything that can be added and multiplied."""

from __future__ import annotations

from collections.abc import Callable
from functools import reduce
from operator import add, mul
from typing import Any

Matrix = list[list[Any]]


def each(matrix: Matrix, change: Callable[[Any], Any]) -> Matrix:
    """The matrix with each entry changed."""
    return [[change(entry) for entry in row] for row in matrix]


def plus(left: Matrix, right: Matrix) -> Matrix:
    """The sum; raises ValueError for different shapes."""
    return [[a + b for a, b in zip(one, other, strict=True)] for one, other in zip(left, right, strict=True)]


def product(left: Matrix, right: Matrix) -> Matrix:
    """The matrix product; raises ValueError if the inner sizes differ."""
    columns = list(zip(*right, strict=True))
    return [[reduce(add, map(mul, row, column)) for column in columns] for row in left]


def transposed(matrix: Matrix) -> Matrix:
    """The transpose."""
    return [list(column) for column in zip(*matrix, strict=True)]


def skew(vector: Matrix, zero: Any) -> Matrix:
    """The cross-product matrix of a 3 x 1 column."""
    (x,), (y,), (z,) = vector
    return [[zero, -z, y], [z, zero, -x], [-y, x, zero]]


def cross(left: Matrix, right: Matrix) -> Matrix:
    """The cross product of two 3 x 1 columns."""
    a, b = ([row[0] for row in side] for side in (left, right))
    return [[a[j] * b[k] - a[k] * b[j]] for j, k in ((1, 2), (2, 0), (0, 1))]


def determinant(matrix: Matrix, is_zero: Callable[[Any], bool] = lambda _: False) -> Any:
    """The determinant of a square matrix, by expansion along its first row, whose zeros are left out."""
    if len(matrix) == 1:
        return matrix[0][0]
    terms = [entry * cofactor(matrix, 0, j, is_zero) for j, entry in enumerate(matrix[0]) if not is_zero(entry)]
    return reduce(add, terms) if terms else matrix[0][0]


def cofactor(matrix: Matrix, row: int, column: int, is_zero: Callable[[Any], bool] = lambda _: False) -> Any:
    """The cofactor of an entry of a square matrix that has more than one."""
    minor = determinant([line[:column] + line[column + 1 :] for i, line in enumerate(matrix) if i != row], is_zero)
    return -minor if (row + column) % 2 else minor


def cofactors(matrix: Matrix, one: Any) -> Matrix:
    """The cofactor of every entry of a square matrix; that of a number is `one`."""
    size = range(len(matrix))
    return [[cofactor(matrix, i, j) for j in size] for i in size] if len(matrix) > 1 else [[one]]
