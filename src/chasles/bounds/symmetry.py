"""Which changes of sign leave every bound as it is? So that inputs of one sign stand for those of others.

A change of the signs of inputs, sines and cosines that changes each step's sign or leaves it, and nothing else, leaves
all sizes, and so all bounds. Which changes do is a system of linear equations over the field of two elements, one for
each sum.
"""

from __future__ import annotations

from chasles.bounds.outline import Outline
from chasles.lowering.program import Op

Sign = tuple[str, int, int]
"""The word "input", "sine" or "cosine", an argument, an entry."""


class Symmetry:
    """The changes of sign that are symmetries, each a set of bits: which of the covered signs it changes."""

    def __init__(self, places: dict[Sign, int], changes: list[int]) -> None:
        self._places = places
        self._rows = _echelon(changes)

    def canonical(self, negative: list[Sign]) -> tuple[int, tuple[Sign, ...]]:
        """What is the same for two choices of signs just if a symmetry takes one into the other."""
        fixed = tuple(sign for sign in negative if sign not in self._places)
        word = sum(1 << self._places[sign] for sign in negative if sign in self._places)
        return _reduced(word, self._rows), fixed


def symmetry(outline: Outline, signs: list[Sign]) -> Symmetry:
    """The program's changes of sign, as far as they concern these signs.

    Signs that are not among them may change along where they are those of inputs; sines and cosines may not.
    """
    places = {sign: k for k, sign in enumerate(signs)}
    equations: list[int] = []
    parity: dict[int, int] = {}
    for number in outline.needed:
        step = outline.program.steps[number]
        if number in outline.angles:
            argument, entry, _ = outline.angles[number]
            place = places.get((step.op.value, argument, entry))
            parity[number] = 0 if place is None else 1 << place
            continue
        of = [parity[k] for k in outline.operands(number)]
        match step.op:
            case Op.INPUT:
                parity[number] = 1 << places.setdefault(("input", step.argument, step.entry), len(places))
            case Op.ADD | Op.SUBTRACT:
                equations.append(of[0] ^ of[1])
                parity[number] = of[0]
            case Op.MULTIPLY | Op.DIVIDE:
                parity[number] = of[0] ^ of[1]
            case Op.NEGATE:
                parity[number] = of[0]
            case _:
                equations += of
                parity[number] = 0
    kernel = _kernel(equations, len(places))
    kept = (1 << len(signs)) - 1
    return Symmetry({sign: k for sign, k in places.items() if k < len(signs)}, [word & kept for word in kernel])


def _reduced(word: int, rows: list[int]) -> int:
    """The word with the leading bits of the rows taken out of it."""
    for row in rows:
        word = min(word, word ^ row)
    return word


def _echelon(words: list[int]) -> list[int]:
    """A basis of what the words span, no leading bit of one in another, the largest first."""
    rows: list[int] = []
    for word in words:
        rest = _reduced(word, rows)
        if rest:
            rows = [min(row, row ^ rest) for row in rows]
            rows.append(rest)
    return sorted(rows, reverse=True)


def _kernel(equations: list[int], size: int) -> list[int]:
    """A basis of the words that have an even number of bits in common with every equation."""
    rows = _echelon(equations)
    leading = {row.bit_length() - 1: row for row in rows}
    found = []
    for free in (k for k in range(size) if k not in leading):
        found.append(1 << free | sum(1 << k for k, row in leading.items() if row >> free & 1))
    return found
