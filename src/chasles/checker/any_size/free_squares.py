"""Squares in the free algebra: |v|^2, v^T M v with a matrix M that is visibly not negative, tr(V^T V)."""

from __future__ import annotations

from collections.abc import Collection, Sequence
from fractions import Fraction
from typing import Any

from chasles.checker.any_size.free_algebra import FreeAlgebra, Letters, Words, added
from chasles.checker.any_size.words import SymbolicReading
from chasles.checker.sparse import Rejected

PROJECTION = {"idempotent", "symmetric"}
"""What makes a matrix an orthogonal projection: x . P x is the square of the length of P x."""


def is_mirrored(algebra: FreeAlgebra, word: Letters, letters: Collection[int]) -> bool:
    """Whether it is a word with its transpose before it, with one of the letters, or nothing, between them."""
    size = len(word) // 2
    end = len(word) - size
    return algebra.flipped(word[:size]) == word[end:] and all(k >> 1 in letters for k in word[size:end])


def nonnegative(reading: SymbolicReading) -> set[int]:
    """The letters that are not negative: by a hypothesis, as lengths are, and the inverses of visibly such matrices."""
    kinds: dict[Any, set[str]] = {}
    for hypothesis in reading.problem.hypotheses:
        for node in hypothesis.subjects:
            kinds.setdefault(node, set()).add(hypothesis.kind)
    said = [n for n, k in kinds.items() if n not in reading.rules and (k & {"positive", "definite"} or k >= PROJECTION)]
    found = {letter for node in said for letter in _letters(reading(node).rows[0][0])} | reading.lengths
    for _ in reading.inverses:
        for inverse, of in reading.inverses.values():
            parts = [(c, word, {inner for _, inner in scalars}) for (scalars, word), c in of.items()]
            single = all(len(scalar) == 1 and scalar[0] >> 1 in found for _, _, each in parts for scalar in each)
            if single and all(c > 0 and is_mirrored(reading, word, found) for c, word, _ in parts):
                found |= _letters(inverse)
    return found


def _letters(words: Words) -> set[int]:
    """The letters that occur."""
    return {k >> 1 for scalars, word in words for part in (word, *(inner for _, inner in scalars)) for k in part}


def square(
    reading: SymbolicReading,
    times: str,
    middle: Sequence[str],
    root: Sequence[tuple[str, Sequence[Any], Sequence[str]]],
) -> Words:
    """A square, or v^T M v with a letter M that is not negative; `Rejected` for what is none."""
    between, total = reading.read(middle), Words()
    words = [reading.read(word) for _, _, word in root]
    height, width = (reading.height(words[0][0]), reading.width(words[0][-1])) if words[0] else (1, 1)
    fits = all(reading.fits(word, height, width) for word in words)
    fits = fits and (reading.fits(between, height, height) or reading.fits(between, 1, 1))
    if Fraction(times) <= 0 or len(between) > 1 or not fits or not {k >> 1 for k in between} <= nonnegative(reading):
        raise Rejected(f"{times} times the square of {root} is not seen not to be negative")
    for (coefficient, scalars, _), word in zip(root, words, strict=True):
        one = reading.alone(word)
        for kind, inner in scalars:
            one = reading.product(reading.of_atom(kind, reading.read(inner)), one)
        added(total, one, Fraction(coefficient))
    inner_words = reading.product(reading.product(reading.transposed(total), reading.alone(between)), total)
    return {monomial: Fraction(times) * c for monomial, c in reading.trace(inner_words, width).items()}
