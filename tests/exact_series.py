"""Power series in time, cut off, with rational coefficients, and matrices of them."""

from __future__ import annotations

from collections.abc import Callable, Iterable
from fractions import Fraction
from math import isqrt

__all__ = [
    "Broken",
    "Matrix",
    "Series",
    "chain",
    "constant",
    "determinant",
    "each",
    "flipped",
    "inverse",
    "minus",
    "rational_root",
    "skew",
    "solution",
    "square_root",
    "summed",
    "times",
]

Series = list[Fraction]
Matrix = list[list[Series]]


class Broken(AssertionError):
    """The point does not do what it must: it misses a value, or does not satisfy a hypothesis."""


def constant(value: Fraction | int, n: int) -> Series:
    """A number that does not change."""
    return [Fraction(value), *[Fraction(0)] * n]


def summed(entries: Iterable[Series]) -> Series:
    """The sum."""
    return [sum(coefficients, Fraction(0)) for coefficients in zip(*entries, strict=True)]


def minus(one: Series, other: Series) -> Series:
    """The difference."""
    return [a - b for a, b in zip(one, other, strict=True)]


def times(one: Series, other: Series) -> Series:
    """The product."""
    return [sum((one[k] * other[m - k] for k in range(m + 1)), Fraction(0)) for m in range(len(one))]


def inverse(series: Series) -> Series:
    """One over a series; raises `Broken` if it begins with zero."""
    if series[0] == 0:
        raise Broken("a divisor is zero")
    found = [1 / series[0]]
    for m in range(1, len(series)):
        found.append(-sum((series[k] * found[m - k] for k in range(1, m + 1)), Fraction(0)) / series[0])
    return found


def square_root(series: Series) -> Series:
    """The square root, not negative; raises `Broken` if its first coefficient has none that is rational."""
    found = [rational_root(series[0])]
    if not any(series):
        return series
    for m in range(1, len(series)):
        if found[0] == 0:
            raise Broken("the rate of a norm where the norm is zero")
        found.append((series[m] - sum((found[k] * found[m - k] for k in range(1, m)), Fraction(0))) / (2 * found[0]))
    return found


def rational_root(square: Fraction) -> Fraction:
    """The square root of a number; raises `Broken` if it is not rational."""
    root = Fraction(isqrt(square.numerator), isqrt(square.denominator)) if square >= 0 else Fraction(0)
    if root * root != square:
        raise Broken(f"{square} is not the square of a rational number")
    return root


def each(matrix: Matrix, change: Callable[[Series], Series]) -> Matrix:
    """The matrix with each entry changed."""
    return [[change(entry) for entry in row] for row in matrix]


def flipped(matrix: Matrix) -> Matrix:
    """The transpose."""
    return [list(column) for column in zip(*matrix, strict=True)]


def chain(matrices: list[Matrix]) -> Matrix:
    """The product of matrices."""
    found = matrices[0]
    for matrix in matrices[1:]:
        columns = list(zip(*matrix, strict=True))
        found = [[summed(map(times, row, column)) for column in columns] for row in found]
    return found


def skew(vector: Matrix) -> Matrix:
    """The cross-product matrix of a vector."""
    (x,), (y,), (z,) = vector
    nothing = minus(x, x)
    return [[nothing, minus(nothing, z), y], [z, nothing, minus(nothing, x)], [minus(nothing, y), x, nothing]]


def determinant(matrix: Matrix) -> Series:
    """The determinant, by expansion along the first row."""
    if len(matrix) == 1:
        return matrix[0][0]
    terms = []
    for j, entry in enumerate(matrix[0]):
        if any(entry):
            minor = times(entry, determinant([row[:j] + row[j + 1 :] for row in matrix[1:]]))
            terms.append(minor if j % 2 == 0 else [-c for c in minor])
    return summed(terms) if terms else minus(matrix[0][0], matrix[0][0])


def solution(rows: list[list[Fraction]], size: int) -> list[Fraction]:
    """A solution of the linear system whose last column is the right side; raises `Broken` if there is none."""
    pivots: list[int] = []
    for column in range(size):
        done = len(pivots)
        row = next((r for r in range(done, len(rows)) if rows[r][column]), None)
        if row is None:
            continue
        rows[done], rows[row] = rows[row], rows[done]
        rows[done] = [x / rows[done][column] for x in rows[done]]
        for r, line in enumerate(rows):
            if r != done and line[column]:
                rows[r] = [x - line[column] * y for x, y in zip(line, rows[done], strict=True)]
        pivots.append(column)
    if any(row[-1] for row in rows[len(pivots) :]):
        raise Broken("the conditions contradict each other at the point")
    found = [Fraction(0)] * size
    for place, column in enumerate(pivots):
        found[column] = rows[place][-1]
    return found
