"""Matrices as lists of rows, for any numbers that add and multiply; the numbers choose the precision."""

from __future__ import annotations

from functools import reduce
from operator import add, mul
from typing import Any

__all__ = ["Matrix", "cofactors", "determinant", "flipped", "plus", "product"]

Matrix = list[list[Any]]


def plus(left: Matrix, right: Matrix) -> Matrix:
    """The sum; raises ValueError for different shapes."""
    return [[a + b for a, b in zip(one, other, strict=True)] for one, other in zip(left, right, strict=True)]


def product(left: Matrix, right: Matrix) -> Matrix:
    """The matrix product; raises ValueError if the inner sizes differ."""
    columns = list(zip(*right, strict=True))
    return [[reduce(add, map(mul, row, column)) for column in columns] for row in left]


def flipped(matrix: Matrix) -> Matrix:
    """The transpose."""
    return [list(column) for column in zip(*matrix, strict=True)]


def determinant(matrix: Matrix) -> Any:
    """The determinant of a square matrix, by expansion along its first row."""
    if len(matrix) == 1:
        return matrix[0][0]
    terms = [
        (entry if column % 2 == 0 else -entry) * determinant(_without(matrix, 0, column))
        for column, entry in enumerate(matrix[0])
    ]
    return reduce(add, terms)


def cofactors(matrix: Matrix) -> Matrix:
    """The cofactor of every entry of a square matrix; that of a number is one."""
    size = range(len(matrix))
    if len(matrix) == 1:
        return [[matrix[0][0] * 0 + 1]]
    return [[determinant(_without(matrix, i, j)) * (-1) ** (i + j) for j in size] for i in size]


def _without(matrix: Matrix, row: int, column: int) -> Matrix:
    return [line[:column] + line[column + 1 :] for i, line in enumerate(matrix) if i != row]
