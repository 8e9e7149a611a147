"""Matrices of blocks whose sizes are letters, each block a sum of words of the free algebra, and their determinants.

det(X + U V) = det X det(1 + V X^-1 U), and of blocks Schur's formula. Of two matrices of which one is got from the
other by moving factors from one end to the other, the determinants of one plus either are equal, whatever their sizes
(Sylvester 1851): the least of all these is written.
"""

from __future__ import annotations

from collections.abc import Callable, Iterator, Sequence
from dataclasses import dataclass
from fractions import Fraction

from chasles.checker.any_size.free_algebra import FreeAlgebra, Letters, Monomial, Words, added
from chasles.checker.sparse import Rejected
from chasles.vocabulary.measure import Extent

IDENTITY: Monomial = ((), ())


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


class Determinants:
    """Determinants of words of an algebra in which some matrices are known to have inverses."""

    def __init__(
        self,
        algebra: BlockAlgebra,
        inverting: Callable[[], Iterator[tuple[Words, Words]]],
        of_letters: Callable[[Words, Extent], Words],
    ) -> None:
        self.algebra = algebra
        self.inverting = inverting
        self.of_letters = of_letters

    def of_blocks(self, matrix: Blocks) -> Words:
        """By a block on the diagonal beside or above which there is nothing, or by one that has an inverse."""
        count = len(matrix.heights)
        if matrix.heights != matrix.widths:
            raise Rejected("the blocks on the diagonal are not square")
        if count == 1:
            return self.of_words(matrix.rows[0][0], matrix.heights[0])
        for p in range(count):
            others = [k for k in range(count) if k != p]
            if not any(matrix.rows[k][p] for k in others) or not any(matrix.rows[p][k] for k in others):
                return self._by(p, matrix, {})
        for p in range(count):
            inverse = next((w for m, w in self._known(matrix.heights[p]) if m == matrix.rows[p][p]), None)
            if inverse is not None:
                return self._by(p, matrix, inverse)
        raise Rejected("no block on the diagonal is known to have an inverse: assume `invertible` of one")

    def _by(self, p: int, matrix: Blocks, inverse: Words) -> Words:
        """The determinant of a block on the diagonal times that of what is left of the others."""
        product, others = self.algebra.product, [k for k in range(len(matrix.heights)) if k != p]
        rows = []
        for i in others:
            line = [dict(matrix.rows[i][j]) for j in others]
            for words, j in zip(line, others, strict=True):
                added(words, product(product(matrix.rows[i][p], inverse), matrix.rows[p][j]), Fraction(-1))
            rows.append(line)
        sizes = tuple(matrix.heights[k] for k in others)
        return product(self.of_words(matrix.rows[p][p], matrix.heights[p]), self.of_blocks(Blocks(sizes, sizes, rows)))

    def of_words(self, words: Words, size: Extent) -> Words:
        """By a part that has an inverse, if the words have one; else that of the letters, or a letter."""
        for matrix, inverse in self._known(size):
            if matrix.items() < words.items():
                rest = dict(words)
                added(rest, matrix, Fraction(-1))
                behind = self._of_one_and(self.algebra.product(inverse, rest), size)
                return self.algebra.product(self.of_words(matrix, size), behind)
        return self.of_letters(words, size)

    def _known(self, size: Extent) -> Iterator[tuple[Words, Words]]:
        one: Words = {IDENTITY: Fraction(1)}
        yield one, one
        for matrix, inverse in self.inverting():
            if all(self.algebra.fits(word, size, size) for _, word in matrix):
                yield matrix, inverse

    def _of_one_and(self, words: Words, size: Extent) -> Words:
        """The determinant of the identity and a matrix, as that of the least matrix with the same factors."""
        found: dict[tuple[tuple[Monomial, Fraction], ...], Extent] = {}
        waiting = [(words, size), (self.algebra.transposed(words), size)]
        while waiting:
            one, extent = waiting.pop()
            key = tuple(sorted(one.items()))
            if key not in found:
                found[key] = extent
                waiting += self._moved(one)
        for key, extent in found.items():
            if extent == 1:
                total = dict(key)
                added(total, {IDENTITY: Fraction(1)}, Fraction(1))
                return total
        least = min(found, key=lambda key: (max((len(word) for (_, word), _ in key), default=0), key))
        name = f"det(1 + {self.algebra.spelled_sum(dict(least))})"
        return self.algebra.letter(("determinant of one and", least), name, 1, 1)

    def _moved(self, words: Words) -> Iterator[tuple[Words, Extent]]:
        """The words with the factor with which all begin at their end, and with that with which all end in front."""
        if not all(word for _, word in words):
            return
        for end in (0, -1):
            letters = {word[end] for _, word in words}
            if len(letters) != 1:
                continue
            [letter] = letters
            moved: Words = {}
            for (atoms, word), coefficient in words.items():
                turned: Letters = (*word[1:], letter) if end == 0 else (letter, *word[:-1])
                added(moved, {self.algebra.monomial(atoms, turned): coefficient}, Fraction(1))
            yield moved, self.algebra.width(letter) if end == 0 else self.algebra.height(letter)
