"""Matrices of blocks whose sizes are letters, each block a sum of words of the free algebra."""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from dataclasses import dataclass
from fractions import Fraction

from chasles.checker.any_size.free_algebra import FreeAlgebra, Monomial, Words, added
from chasles.checker.sparse import Rejected
from chasles.vocabulary.measure import Extent


@dataclass(frozen=True, slots=True)
class Blocks:
    """A matrix, block by block."""

    heights: tuple[Extent, ...]
    widths: tuple[Extent, ...]
    rows: list[list[Words]]


def key_of(matrix: Blocks) -> tuple[tuple[tuple[tuple[Monomial, Fraction], ...], ...], ...]:
    """The same for equal blocks."""
    return tuple(tuple(tuple(sorted(words.items())) for words in row) for row in matrix.rows)


class BlockAlgebra(FreeAlgebra):
    """The free algebra with matrices of blocks."""

    def scaled(self, factor: Words, matrix: Blocks) -> Blocks:
        """The matrix times a scalar."""
        rows = [[self.product(factor, words) for words in row] for row in matrix.rows]
        return Blocks(matrix.heights, matrix.widths, rows)

    def flipped_blocks(self, matrix: Blocks) -> Blocks:
        """The transpose."""
        rows = [[self.transposed(words) for words in column] for column in zip(*matrix.rows, strict=True)]
        return Blocks(matrix.widths, matrix.heights, rows)

    def times(self, left: Blocks, right: Blocks) -> Blocks:
        """The product; raises `Rejected` where blocks do not meet."""
        if left.widths != right.heights:
            raise Rejected("two matrices are cut into blocks in different ways")
        rows: list[list[Words]] = [[{} for _ in right.widths] for _ in left.heights]
        for i, line in enumerate(left.rows):
            for k, words in enumerate(line):
                for j, others in enumerate(right.rows[k]):
                    added(rows[i][j], self.product(words, others), Fraction(1))
        return Blocks(left.heights, right.widths, rows)


def plus(left: Blocks, right: Blocks) -> Blocks:
    """The sum; raises `Rejected` for matrices cut into blocks in different ways."""
    if (left.heights, left.widths) != (right.heights, right.widths):
        raise Rejected("two matrices are cut into blocks in different ways")
    rows = [[dict(words) for words in row] for row in left.rows]
    for total, row in zip(rows, right.rows, strict=True):
        for one, other in zip(total, row, strict=True):
            added(one, other, Fraction(1))
    return Blocks(left.heights, left.widths, rows)


def multiplied(matrix: Blocks, number: Fraction) -> Blocks:
    """The matrix times a number."""
    rows = [[{monomial: number * c for monomial, c in words.items()} for words in row] for row in matrix.rows]
    return Blocks(matrix.heights, matrix.widths, rows)


def differences(left: Blocks, right: Blocks) -> Iterator[tuple[int, int, Words, Extent, Extent]]:
    """Row, column, difference, height and width of each block; raises `Rejected` where blocks do not fit."""
    found = plus(left, multiplied(right, Fraction(-1)))
    for i, (row, height) in enumerate(zip(found.rows, found.heights, strict=True), 1):
        for j, (words, width) in enumerate(zip(row, found.widths, strict=True), 1):
            yield i, j, words, height, width


def stacked(rows: Sequence[Sequence[Blocks]]) -> Blocks:
    """The matrix of these blocks; raises `Rejected` where their own blocks do not go together."""
    heights = tuple(height for row in rows for height in row[0].heights)
    widths = tuple(width for block in rows[0] for width in block.widths)
    for row in rows:
        if any(b.heights != row[0].heights for b in row) or sum((b.widths for b in row), ()) != widths:
            raise Rejected("two matrices are cut into blocks in different ways")
    lines = [[words for block in row for words in block.rows[k]] for row in rows for k, _ in enumerate(row[0].heights)]
    return Blocks(heights, widths, lines)
