"""What is the largest error over all inputs? Boxes that cover them are halved where the bound is largest.

At every moment the largest of the boxes' bounds is a bound for all inputs. Halving ends where it is hardly larger than
the running bound at some point: smaller boxes would gain nothing.
"""

from __future__ import annotations

import math
from collections.abc import Callable, Iterator, Sequence
from dataclasses import dataclass, field
from fractions import Fraction
from heapq import heappop, heappush
from itertools import product
from typing import Any

from chasles.bounds.model import Model
from chasles.bounds.outline import NoBound, Outline
from chasles.bounds.pieces import AnglePiece, Interval, Piece, faces
from chasles.bounds.running import Running
from chasles.bounds.scaled import Scaled
from chasles.bounds.symmetry import Sign, Symmetry, symmetry
from chasles.lowering.program import Op

__all__ = ["Cover", "covered", "largest"]

CLOSE = 1.05
"""How much larger than at a point the bound over all boxes may be."""
WIDEST = 1.5
"""How much larger it may be where the budget is spent, lest it says more of the boxes than of the program."""

EVERY = 8
"""How many boxes are halved between two looks at a point."""

Box = tuple[Interval, ...]
Measure = Callable[[Running], float]


@dataclass(frozen=True, slots=True)
class Cover:
    """Pieces to choose one of each of, which together cover the inputs, and the arguments that they cover."""

    choices: tuple[tuple[Piece, ...], ...]
    symmetry: Symmetry

    @property
    def regions(self) -> Iterator[tuple[tuple[Piece, ...], Box]]:
        """Every combination of pieces, whole; of those that changes of sign lead to, the first."""
        seen: set[tuple[object, ...]] = set()
        for pieces in product(*self.choices):
            signs = self.symmetry.canonical([sign for piece in pieces for sign in piece.negative])
            key = (signs, *(piece.kind for piece in pieces))
            if key not in seen:
                seen.add(key)
                yield pieces, tuple(interval for piece in pieces for interval in piece.ranges)


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
        made = (
            AnglePiece(argument, entry, quarter, side, least, (argument, entry) in singular)
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


@dataclass(order=True, slots=True)
class _Open:
    """A box, the worst first."""

    key: float
    count: int
    pieces: tuple[Piece, ...] = field(compare=False)
    box: Box = field(compare=False)


class _Search:
    """The boxes not yet halved."""

    def __init__(self, outline: Outline, model: Model, measure: Measure) -> None:
        self._outline, self._model, self._measure = outline, model, measure
        self.boxes: list[_Open] = []
        self.count = 0

    def add(self, pieces: tuple[Piece, ...], box: Box) -> None:
        heappush(self.boxes, _Open(-self.bound(pieces, box), self.count, pieces, box))
        self.count += 1

    def bound(self, pieces: tuple[Piece, ...], box: Box) -> float:
        """The bound over a box; infinite where the box is too large for one."""
        values: dict[tuple[int, int], Scaled] = {}
        turns: dict[tuple[int, int], tuple[AnglePiece, Box]] = {}
        small, place = (1.0, 1.0), 0
        for piece in pieces:
            part = box[place : place + len(piece.ranges)]
            place += len(part)
            if isinstance(piece, AnglePiece):
                turns[piece.argument, piece.entry] = piece, part
                small = piece.scale(part) or small
            else:
                values |= piece.values(part)
        known: dict[Any, tuple[Scaled, Scaled]] = {}

        def functions(argument: int, entry: int, factor: Fraction) -> tuple[Scaled, Scaled]:
            if (argument, entry, factor) not in known:
                piece, part = turns[argument, entry]
                known[argument, entry, factor] = piece.functions(part, factor)
            return known[argument, entry, factor]

        try:
            return self._measure(Running(self._outline, self._model, values, functions, small))
        except ZeroDivisionError:
            return math.inf

    def halve(self) -> None:
        """Halve the worst box across its widest side."""
        worst = heappop(self.boxes)
        widths = [
            scale * (high - low) for (low, high), scale in zip(worst.box, self._scales(worst.pieces), strict=True)
        ]
        k = widths.index(max(widths))
        low, high = worst.box[k]
        middle = (low + high) / 2
        for part in ((low, middle), (middle, high)):
            self.add(worst.pieces, (*worst.box[:k], part, *worst.box[k + 1 :]))

    @staticmethod
    def _scales(pieces: tuple[Piece, ...]) -> Iterator[float]:
        """How much a coordinate of a box moves values, about."""
        for piece in pieces:
            yield from (math.pi,) if isinstance(piece, AnglePiece) else (1.0, 1.0)


def largest(outline: Outline, model: Model, cover: Cover, measure: Measure, budget: int) -> float:
    """A bound on the measure over all that is covered, with so many boxes at most.

    Raises NoBound where the boxes still are too large then.
    """
    search = _Search(outline, model, measure)
    for pieces, box in cover.regions:
        search.add(pieces, box)
    reached = 0.0
    while search.count < budget:
        worst = search.boxes[0]
        if search.count % EVERY == 0:
            point = tuple(((low + high) / 2,) * 2 for low, high in worst.box)
            here = search.bound(worst.pieces, point)
            reached = max(reached, here if math.isfinite(here) else 0.0)
            if -worst.key <= CLOSE * reached:
                break
        search.halve()
    found = -search.boxes[0].key
    if not found <= WIDEST * reached:
        raise NoBound("boxes of inputs small enough to be of use are too many")
    return found
