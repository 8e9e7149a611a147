"""Matrices whose sizes are letters: sums of words, in which nothing commutes but scalars.

A letter is a matrix or its transpose. A word breaks where one row meets one column: what lies between two breaks is a
scalar, which stands before the word, as do traces. A scalar is its own transpose, and a trace does not change when its
factors go round: of words that say the same, the least is written. Source: the free algebra with trace (Procesi).
"""

from __future__ import annotations

from collections.abc import Iterable, Mapping
from fractions import Fraction
from itertools import pairwise
from typing import Any

from chasles.checker.sparse import Rejected
from chasles.vocabulary.measure import Extent

Letters = tuple[int, ...]
"""Letter k is written 2k, its transpose 2k + 1."""
Atom = tuple[str, Letters]
"""A scalar: a "word" of one row and one column, or the "trace" of a word; that of the identity bears its size."""
Monomial = tuple[tuple[Atom, ...], Letters]
Words = dict[Monomial, Fraction]
TRANSPOSED = "^T"


class FreeAlgebra:
    """The letters, each with its height and width, and how words of them are multiplied."""

    def __init__(self) -> None:
        self.names: list[str] = []
        self.shapes: list[tuple[Extent, Extent]] = []
        self._known: dict[Any, int] = {}

    def letter(self, key: Any, name: str, height: Extent, width: Extent) -> Words:
        """The letter of a key, alone."""
        if key not in self._known:
            if name in self.names:
                raise Rejected(f"two different quantities are both named {name}: rename one")
            self._known[key] = len(self.names)
            self.names.append(name)
            self.shapes.append((height, width))
        return {self.monomial((), (2 * self._known[key],)): Fraction(1)}

    def height(self, letter: int) -> Extent:
        """The number of rows."""
        return self.shapes[letter >> 1][letter & 1]

    def width(self, letter: int) -> Extent:
        """The number of columns."""
        return self.shapes[letter >> 1][1 - (letter & 1)]

    def flipped(self, word: Letters) -> Letters:
        """The transpose of a word."""
        return tuple(letter ^ 1 for letter in reversed(word))

    def monomial(self, atoms: Iterable[Atom], word: Letters) -> Monomial:
        """The scalars, with those that the word contains, and what is left of the word."""
        cuts = [0, *(k + 1 for k, letter in enumerate(word) if self.width(letter) == 1)]
        if word and cuts[-1] != len(word):
            cuts.append(len(word))
        parts = [word[start:end] for start, end in pairwise(cuts)]
        kept = [part for part in parts if self.height(part[0]) != 1 or self.width(part[-1]) != 1]
        scalars = [part for part in parts if self.height(part[0]) == 1 == self.width(part[-1])]
        least = (min(part, self._straight(self.flipped(part))) for part in map(self._straight, scalars))
        return tuple(sorted((*atoms, *(("word", part) for part in least)))), sum(kept, ())

    def _straight(self, word: Letters) -> Letters:
        """The word without transposes of scalars."""
        return (word[0] & ~1,) if len(word) == 1 and self.shapes[word[0] >> 1] == (1, 1) else word

    def trace(self, words: Words, size: Extent) -> Words:
        """The trace of a square matrix of the given size."""
        total: Words = {}
        for (atoms, word), coefficient in words.items():
            for monomial, factor in self._trace(word, size).items():
                added(total, {(tuple(sorted((*atoms, *monomial[0]))), ()): factor}, coefficient)
        return total

    def _trace(self, word: Letters, size: Extent) -> Words:
        if not word:
            if isinstance(size, int):
                return {((), ()): Fraction(size)}
            total: Words = {}
            for part in size.parts or (size,):
                one: Words = {((), ()): Fraction(1)} if isinstance(part, int) else self.letter(part, part.name, 1, 1)
                added(total, one, Fraction(part if isinstance(part, int) else 1))
            return total
        cut = next((k + 1 for k, letter in enumerate(word) if self.width(letter) == 1), None)
        if cut is not None:
            return {self.monomial((), word[cut:] + word[:cut]): Fraction(1)}
        turned = (one[k:] + one[:k] for one in (word, self.flipped(word)) for k in range(len(word)))
        return {((("trace", min(turned)),), ()): Fraction(1)}

    def alone(self, word: Letters) -> Words:
        """The word with nothing before it."""
        return {self.monomial((), word): Fraction(1)}

    def of_atom(self, kind: str, word: Letters) -> Words:
        """The scalar that a word of one row and one column, or the trace of a word, is; `Rejected` for any other."""
        size = self.height(word[0])
        if not self.fits(word, *((1, 1) if kind == "word" else (size, size))):
            raise Rejected("the factors of a scalar do not fit")
        return self.alone(word) if kind == "word" else self._trace(word, size)

    def product(self, left: Words, right: Words) -> Words:
        """The matrix product, or a multiple by a scalar."""
        total: Words = {}
        for (atoms, word), coefficient in left.items():
            for (others, behind), factor in right.items():
                added(total, {self.monomial((*atoms, *others), word + behind): factor}, coefficient)
        return total

    def transposed(self, words: Words) -> Words:
        """The transpose."""
        return {(atoms, self.flipped(word)): coefficient for (atoms, word), coefficient in words.items()}

    def spelled(self, word: Letters) -> list[str]:
        """The letters by name, with a mark behind those that are transposed."""
        return [self.names[letter >> 1] + TRANSPOSED * (letter & 1) for letter in word]

    def spelled_sum(self, words: Words) -> str:
        """The sum with its letters by name, the same for the same words."""
        terms = []
        for (atoms, word), coefficient in sorted(words.items()):
            scalars = (f"{kind}({' '.join(self.spelled(inner))})" for kind, inner in atoms)
            terms.append(" ".join([str(coefficient), *scalars, *self.spelled(word)]))
        return " + ".join(terms)

    def read(self, spelled: Iterable[str]) -> Letters:
        """The word of the letters that are spelled."""
        known = {name: k for k, name in enumerate(self.names)}
        straight = ((name, name.removesuffix(TRANSPOSED)) for name in spelled)
        return tuple(2 * known[name] if name in known else 2 * known[letter] + 1 for name, letter in straight)

    def fits(self, word: Letters, height: Extent, width: Extent) -> bool:
        """Whether it is a product of that shape; without letters, an identity."""
        if not word:
            return bool(height == width)
        inner = all(self.width(one) == self.height(other) for one, other in pairwise(word))
        return inner and self.height(word[0]) == height and self.width(word[-1]) == width


def added(total: Words, words: Mapping[Monomial, Fraction], factor: Fraction) -> None:
    """Add a multiple of words to the total."""
    for monomial, coefficient in words.items():
        value = total.get(monomial, Fraction(0)) + factor * coefficient
        if value:
            total[monomial] = value
        else:
            total.pop(monomial, None)
