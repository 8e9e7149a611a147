"""Equations that hold between words, by their labels: what is said, and that powers of a matrix commute."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass
from itertools import product
from typing import Any

from chasles.checker.any_size.free_algebra import Words
from chasles.checker.any_size.free_blocks import Blocks, differences, key_of
from chasles.checker.any_size.tensors import TensorAlgebra
from chasles.checker.sparse import Rejected
from chasles.vocabulary.measure import Extent


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
