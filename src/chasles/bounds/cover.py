"""Which inputs does a program take? Pieces to choose from, which together cover unit vectors and angles."""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from dataclasses import dataclass
from fractions import Fraction
from itertools import product

from chasles.bounds.outline import NoBound, Outline
from chasles.bounds.pieces import AnglePiece, Piece, faces
from chasles.bounds.symmetry import Sign, Symmetry, symmetry
from chasles.lowering.program import Op

Region = tuple[Piece, ...]


@dataclass(frozen=True, slots=True)
class Cover:
    """Pieces to choose one of each of, which together cover the inputs, and the changes of sign that are symmetries."""

    choices: tuple[tuple[Piece, ...], ...]
    symmetry: Symmetry

    @property
    def regions(self) -> Iterator[Region]:
        """Every combination of pieces; of those that changes of sign lead to, the first."""
        seen: set[tuple[object, ...]] = set()
        for pieces in product(*self.choices):
            signs = self.symmetry.canonical([sign for piece in pieces for sign in piece.negative])
            key = (signs, *(piece.kind for piece in pieces))
            if key not in seen:
                seen.add(key)
                yield pieces


def covered(outline: Outline, units: Sequence[int]) -> Cover:
    """The cover of the program's angles and of the unit vectors among its arguments.

    Raises NoBound for a program without angles, one that uses an angle itself, and one that divides by functions of
    two angles.
    """
    if not outline.angles:
        raise NoBound("it has no angles to cover")
    steps = outline.program.steps
    places = sorted({(argument, entry) for argument, entry, _ in outline.angles.values()})
    if any(steps[k].op is Op.INPUT and (steps[k].argument, steps[k].entry) in places for k in outline.needed):
        raise NoBound("it uses an angle itself, not only its sine and cosine")
    singular = [place for place in places if place in _dividing(outline)]
    if len(singular) > 1:
        raise NoBound("it divides by functions of several angles")
    choices: list[tuple[Piece, ...]] = [tuple(faces(argument)) for argument in units]
    for argument, entry in places:
        least = min(f for a, e, f in outline.angles.values() if (a, e) == (argument, entry))
        divides = (argument, entry) in singular
        made = (
            AnglePiece(argument, entry, quarter, side, least, near, divides)
            for near in ((True, False) if divides else (False,))
            for quarter in range(4)
            for side in (1, -1)
        )
        choices.append(tuple(made))
    return Cover(tuple(choices), symmetry(outline, _signs(outline, units)))


def _signs(outline: Outline, vectors: Sequence[int]) -> list[Sign]:
    """The signs of covered inputs, and of sine and cosine of the angles of which one multiple occurs."""
    signs: list[Sign] = [("input", argument, k) for argument in vectors for k in range(3)]
    factors: dict[tuple[int, int], set[Fraction]] = {}
    for argument, entry, factor in outline.angles.values():
        factors.setdefault((argument, entry), set()).add(factor)
    for (argument, entry), found in sorted(factors.items()):
        if len(found) == 1:
            signs += [("sine", argument, entry), ("cosine", argument, entry)]
    return signs


def _dividing(outline: Outline) -> set[tuple[int, int]]:
    """The angles on which a divisor depends."""
    reads: dict[int, set[tuple[int, int]]] = {}
    found: set[tuple[int, int]] = set()
    for number in outline.needed:
        if number in outline.angles:
            reads[number] = {outline.angles[number][:2]}
            continue
        operands = outline.operands(number)
        reads[number] = set().union(*(reads[k] for k in operands))
        if outline.program.steps[number].op is Op.DIVIDE:
            found |= reads[operands[1]]
    return found
