"""Equations that hold between words, by their labels: what is said, and that powers of a matrix commute.

The Kronecker product of A and B is that of A x 1 and 1 x B, which commute; vec(X) is 1 x X before vec(1), where 1 x A
says what A^T x 1 says. Source: C. F. Van Loan, The ubiquitous Kronecker product (2000).
"""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from dataclasses import dataclass
from fractions import Fraction
from itertools import product
from typing import Any

from chasles.checker.any_size.free_algebra import Words, added
from chasles.checker.any_size.free_blocks import BlockAlgebra, Blocks, differences, key_of
from chasles.checker.sparse import Rejected
from chasles.vocabulary.measure import Extent
from chasles.vocabulary.sizes import times

Relation = tuple[Words, Extent, Extent]
"""Words that are zero, their height and width."""


class TensorAlgebra(BlockAlgebra):
    """The free algebra with letters for A x 1 and 1 x B; a letter may be on either side, beside each size."""

    def __init__(self) -> None:
        super().__init__()
        self._placed: dict[tuple[int, bool, Extent], int] = {}
        self._places: dict[int, tuple[int, Extent, Extent]] = {}
        self._columns: list[tuple[Words, Extent, Extent]] = []

    def tensor(self, left: Blocks, right: Blocks) -> Blocks:
        """The Kronecker product; raises `Rejected` if its right factor has several blocks."""
        beside, height, width = _only(right)
        rows = [
            [self.product(self._beside(words, True, height), self._beside(beside, False, n))
             for words, n in zip(row, left.widths, strict=True)] for row in left.rows
        ]  # fmt: skip
        return Blocks(
            tuple(times(each, height) for each in left.heights), tuple(times(each, width) for each in left.widths), rows
        )

    def vec(self, matrix: Blocks) -> Blocks:
        """The columns of a matrix, one below the other; raises `Rejected` if it has several blocks."""
        words, height, width = _only(matrix)
        self._columns.append((words, height, width))
        return Blocks((times(width, height),), (1,), [[self._as_column(words, width)]])

    def relations(self) -> Iterator[Relation]:
        """What holds of the letters that were placed beside identities."""
        placed = {(straight >> 1, left) for straight, left, _ in self._placed}
        letters = sorted({place for place, _ in placed})
        for one, other in product(letters, repeat=2):
            if (one, True) in placed and (other, False) in placed:
                for turned in (0, 1):
                    yield self._commuting(2 * one + turned, 2 * other)
        for k in (2 * place + turned for place in letters for turned in (0, 1)) if self._columns else ():
            words, height, width = self.alone((k,)), self.height(k), self.width(k)
            again = self.product(self._beside(self.transposed(words), True, height), self._unit(height))
            yield _difference(self._as_column(words, width), again), times(width, height), 1
        for (first, *shape, width), (second, *same) in product(self._columns, repeat=2):
            if [*shape, width] == same:
                row, column = self.transposed(self._as_column(first, width)), self._as_column(second, width)
                trace = self.trace(self.product(self.transposed(first), second), width)
                yield _difference(self.product(row, column), trace), 1, 1

    def placed(self, words: Words, height: Extent, width: Extent) -> Iterator[Relation]:
        """The words beside identities, as far as all of their letters are."""
        for left, size in dict.fromkeys((left, size) for _, left, size in self._placed):
            if all((letter & ~1, left, size) in self._placed for _, word in words for letter in word):
                yield self._beside(words, left, size), times(height, size), times(width, size)

    def _as_column(self, words: Words, width: Extent) -> Words:
        return words if width == 1 else self.product(self._beside(words, False, width), self._unit(width))

    def _unit(self, size: Extent) -> Words:
        """The identity as a column."""
        one: Words = {((), ()): Fraction(1)}
        return one if size == 1 else self.letter(("vec", size), f"vec(1_{size})", times(size, size), 1)

    def _commuting(self, one: int, other: int) -> Relation:
        """That A x 1 and 1 x B may be exchanged."""
        (p, n), (m, q) = ((self.height(letter), self.width(letter)) for letter in (one, other))
        first, second = self.alone((one,)), self.alone((other,))
        before = self.product(self._beside(first, True, m), self._beside(second, False, n))
        after = self.product(self._beside(second, False, p), self._beside(first, True, q))
        return _difference(before, after), times(p, m), times(n, q)

    def _beside(self, words: Words, left: bool, size: Extent) -> Words:
        """The words as the `left` or the right factor beside an identity."""
        return {
            self.monomial(atoms, tuple(self._letter_beside(letter, left, size) for letter in word)): coefficient
            for (atoms, word), coefficient in words.items()
        }

    def _letter_beside(self, letter: int, left: bool, size: Extent) -> int:
        if size == 1:
            return letter
        straight = letter & ~1
        if (straight, left, size) not in self._placed:
            alone, before, behind = self._places.get(straight, (straight, 1, 1))
            before, behind = (before, times(behind, size)) if left else (times(size, before), behind)
            shape = (times(each, times(before, behind)) for each in (self.height(alone), self.width(alone)))
            key = "beside", alone, before, behind
            self.letter(key, f"1_({before}) x {self.names[alone >> 1]} x 1_({behind})", *shape)
            self._placed[straight, left, size] = 2 * self._known[key]
            self._places[2 * self._known[key]] = alone, before, behind
        return self._placed[straight, left, size] | (letter & 1)


def _only(matrix: Blocks) -> tuple[Words, Extent, Extent]:
    if (len(matrix.heights), len(matrix.widths)) != (1, 1):
        raise Rejected("a Kronecker product with a matrix of several blocks on its right is not read")
    return matrix.rows[0][0], matrix.heights[0], matrix.widths[0]


def _difference(one: Words, other: Words) -> Words:
    total = dict(one)
    added(total, other, Fraction(-1))
    return total


@dataclass(frozen=True, slots=True)
class Known:
    """Words of a shape that are zero; `needs` is the text of the hypothesis that says so, if one does."""

    words: Words
    height: Extent
    width: Extent
    needs: str = ""


class KnownRelations(TensorAlgebra):
    """The free algebra, in which the `known` words are zero."""

    def __init__(self) -> None:
        super().__init__()
        self.known: dict[str, Known] = {}
        self._powers: dict[tuple[Any, Extent], tuple[Blocks, Blocks]] = {}

    def note(self, label: str, words: Words, height: Extent, width: Extent, needs: str) -> None:
        """Words are zero, under the hypothesis of the text `needs`."""
        if words:
            self.known[label] = Known(words, height, width, needs)

    def lettered(self, key: Any, name: str, heights: Sequence[Extent], widths: Sequence[Extent]) -> Blocks:
        """A letter, or one for each of its blocks."""
        rows: list[list[Words]] = []
        for i, height in enumerate(heights):
            marks = [f"[{i + 1},{j + 1}]" * (len(heights) * len(widths) > 1) for j, _ in enumerate(widths)]
            rows.append([self.letter((key, i, j), name + marks[j], height, width) for j, width in enumerate(widths)])
        return Blocks(tuple(heights), tuple(widths), rows)

    def power(self, matrix: Blocks, name: str, exponent: Extent) -> list[Blocks]:
        """The factors of a power: so many times the base, or letters for the blocks of a power to a letter."""
        if isinstance(exponent, int):
            return [matrix] * exponent
        if matrix.heights != matrix.widths:
            raise Rejected("two matrices are cut into blocks in different ways")
        key = key_of(matrix), exponent
        found = self.lettered(("power", *key), f"({name})^{exponent}", matrix.heights, matrix.widths)
        self._powers[key] = matrix, found
        return [found]

    def note_powers(self) -> None:
        """Powers of a matrix commute with it and with each other, and so do those of matrices that commute."""
        together = [(matrix, matrix, "") for matrix, _ in self._powers.values()]
        for known in tuple(self.known.values()) if together else ():
            match [*known.words.items()]:
                case [(((), (a, b)), c), (((), (d, e)), f)] if (a, b, c) == (e, d, -f):
                    together.append((self._letter_alone(a), self._letter_alone(b), known.needs))
        for one, other, needs in together:
            for left, right in product(self._with_powers(one), self._with_powers(other)):
                for _, _, words, height, width in differences(self.times(left, right), self.times(right, left)):
                    self.note(f"powers [{len(self.known) + 1}]", words, height, width, needs)

    def note_tensors(self) -> None:
        """What is known of letters is known of them beside identities."""
        for place, relation in enumerate(self.relations()):
            self.note(f"Kronecker products [{place}]", *relation, "")
        for label, known in tuple(self.known.items()):
            for place, relation in enumerate(self.placed(known.words, known.height, known.width)):
                self.note(f"{label} beside an identity [{place}]", *relation, known.needs)

    def _letter_alone(self, letter: int) -> Blocks:
        return Blocks((self.height(letter),), (self.width(letter),), [[self.alone((letter,))]])

    def _with_powers(self, matrix: Blocks) -> list[Blocks]:
        """The matrix and its powers that occur, as they are or as those of the transpose."""
        found = [matrix]
        for base, power in self._powers.values():
            found += [power] if key_of(base) == key_of(matrix) else []
            found += [self.flipped_blocks(power)] if key_of(self.flipped_blocks(base)) == key_of(matrix) else []
        return found
