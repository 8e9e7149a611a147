"""Linear systems modulo a large prime, and the rational numbers that their solutions are images of.

A system of residues is the image of one over the rational numbers. What is found in it is a conjecture until it is
proved; that it has no solution, or several, is true of the rational system unless the prime divides one of its minors.
"""

from __future__ import annotations

from collections.abc import Iterable, Sequence
from fractions import Fraction
from math import isqrt

MODULUS = (1 << 61) - 1
LARGEST = 1 << 20
"""Numerators and denominators above this one are no coefficients that a book prints."""

Column = list[int]


class Span:
    """The span of a growing set of columns, in echelon form: each row has a one at its pivot."""

    def __init__(self, columns: Iterable[Column] = ()) -> None:
        self.rows: list[tuple[int, Column]] = []
        self.independent = True
        for column in columns:
            self.independent &= self.add(column)

    @property
    def pivots(self) -> list[int]:
        """Places whose entries tell the columns of the span apart."""
        return [pivot for pivot, _ in self.rows]

    def reduced(self, column: Column) -> Column:
        """The column less multiples of the rows, zero at all pivots; all zero exactly if it is in the span."""
        for pivot, row in self.rows:
            if factor := column[pivot]:
                column = [(a - factor * b) % MODULUS for a, b in zip(column, row, strict=True)]
        return column

    def add(self, column: Column) -> bool:
        """Whether the column is new to the span, which has it from then on."""
        column = self.reduced(column)
        pivot = next((place for place, entry in enumerate(column) if entry), None)
        if pivot is None:
            return False
        inverse = pow(column[pivot], -1, MODULUS)
        self.rows.append((pivot, [entry * inverse % MODULUS for entry in column]))
        return True


def minus(one: Column, other: Column) -> Column:
    """The difference of two columns."""
    return [(a - b) % MODULUS for a, b in zip(one, other, strict=True)]


def plus(one: Column, other: Column) -> Column:
    """The sum of two columns."""
    return [(a + b) % MODULUS for a, b in zip(one, other, strict=True)]


def multiple(column: Column, of: Column) -> int | None:
    """The residue k with column = k of; None if there is none, or if `of` vanishes."""
    place = next((place for place, entry in enumerate(of) if entry), None)
    if place is None:
        return None
    k = column[place] * pow(of[place], -1, MODULUS) % MODULUS
    return k if all((a - k * b) % MODULUS == 0 for a, b in zip(column, of, strict=True)) else None


def normalized(column: Column) -> tuple[int, ...]:
    """The column divided by its first entry that is not zero: the same for all its multiples; () if it is zero."""
    lead = next((entry for entry in column if entry), None)
    if lead is None:
        return ()
    inverse = pow(lead, -1, MODULUS)
    return tuple(entry * inverse % MODULUS for entry in column)


def combination(columns: Sequence[Column], target: Column) -> list[Fraction] | None:
    """The rational coefficients with which the columns add up to the target; None if there are none, or several."""
    size, rows = len(columns), list(map(list, zip(*columns, target, strict=True)))
    span = Span()
    for row in rows:
        if len(span.rows) < size:
            span.add(row)
    if len(span.rows) < size or size in span.pivots:
        return None
    values = [0] * size
    for column, pivot in reversed(span.rows):
        values[column] = (pivot[size] - sum(pivot[k] * values[k] for k in range(size) if k != column)) % MODULUS
    if any((sum(a * x for a, x in zip(row, values, strict=False)) - row[size]) % MODULUS for row in rows):
        return None
    found = [rational(value) for value in values]
    return [value for value in found if value is not None] if None not in found else None


def rational(residue: int) -> Fraction | None:
    """Rational reconstruction: the one fraction with small numerator and denominator that has this residue, or None.

    P. S. Wang, A p-adic algorithm for univariate partial fractions, SYMSAC 1981.
    """
    bound = min(LARGEST, isqrt(MODULUS // 2))
    above, below = (MODULUS, residue % MODULUS), (0, 1)
    while above[1] > bound:
        quotient = above[0] // above[1]
        above = above[1], above[0] - quotient * above[1]
        below = below[1], below[0] - quotient * below[1]
    if below[1] == 0 or abs(below[1]) > bound:
        return None
    return Fraction(above[1], below[1])


def inverted(rows: Sequence[Column]) -> tuple[list[Column], int]:
    """The inverse of a square matrix and its determinant; no inverse where the determinant is zero."""
    size, determinant = len(rows), 1
    lines = [[*row, *(int(k == place) for k in range(size))] for place, row in enumerate(rows)]
    for k in range(size):
        lead = next((i for i in range(k, size) if lines[i][k]), None)
        if lead is None:
            return [], 0
        if lead != k:
            lines[k], lines[lead] = lines[lead], lines[k]
            determinant = -determinant
        determinant = determinant * lines[k][k] % MODULUS
        factor = pow(lines[k][k], -1, MODULUS)
        lines[k] = pivot = [entry * factor % MODULUS for entry in lines[k]]
        for i, line in enumerate(lines):
            if i != k and (other := line[k]):
                lines[i] = [(a - other * b) % MODULUS for a, b in zip(line, pivot, strict=True)]
    return [line[size:] for line in lines], determinant
