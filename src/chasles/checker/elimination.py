"""Gaussian elimination of rows of rational numbers, for the checker."""

from __future__ import annotations

from collections.abc import Sequence
from fractions import Fraction


def eliminated(rows: Sequence[Sequence[Fraction]], size: int) -> tuple[list[list[Fraction]], list[int]]:
    """The rows in reduced echelon form, and those of the first `size` columns in which they begin."""
    reduced, pivots = [list(row) for row in rows], list[int]()
    for column in range(size):
        done = len(pivots)
        pivot = next((row for row in range(done, len(reduced)) if reduced[row][column]), None)
        if pivot is not None:
            reduced[done], reduced[pivot] = reduced[pivot], reduced[done]
            lead = reduced[done] = [x / reduced[done][column] for x in reduced[done]]
            for row in {*range(len(reduced))} - {done}:
                if factor := reduced[row][column]:
                    reduced[row] = [x - factor * y for x, y in zip(reduced[row], lead, strict=True)]
            pivots.append(column)
    return reduced, pivots


def rank(rows: Sequence[Sequence[Fraction]]) -> int:
    """The rank."""
    return len(eliminated(rows, len(rows[0]))[1]) if rows else 0
