"""How large does a measure of error become over all inputs? Boxes that cover them, the worst ones halved.

Each box has a bound, and the largest of all boxes' bounds is a bound for all inputs. Halving ends where it is hardly
larger than the bound at some point: smaller boxes would gain nothing. This is branch and bound with interval arithmetic
(Moore, Interval Analysis, 1966).
"""

from __future__ import annotations

import math
from collections.abc import Callable, Mapping, Sequence
from dataclasses import dataclass, field, replace
from fractions import Fraction
from itertools import product
from typing import Any

import numpy as np
from numpy.typing import NDArray

from chasles.bounds.cover import Cover, Region
from chasles.bounds.intervals import Array, Interval, halves
from chasles.bounds.model import Model
from chasles.bounds.outline import NoBound, Outline
from chasles.bounds.pieces import AnglePiece, FacePiece, face_values
from chasles.bounds.places import Places, Scaled
from chasles.bounds.running import Running

Measure = Callable[[Running, float], Array]
"""In each box a bound on the error; what is small enough need not be the smallest that can be proved."""
CLOSE = 1.033
"""How much larger than at a point the bound over all boxes may be."""
PARTED = 1.25
"""How much too large a bound may be for its box to be parted at a power of two besides being halved."""
POINTS, MOVES, CLIMBS = 32, 8, 14
"""How many of the best points are kept, into how many each is moved, and how often."""
FAIR, STUCK = 1.2, 4
"""How much larger it may be where so many rounds have made it no smaller."""
WIDEST = 1.5
"""How much larger it may be where the budget is spent, lest it says more of the boxes than of the program."""


@dataclass(frozen=True, slots=True, eq=False)
class Boxes:
    """Boxes of several regions of one batch: the ends of each coordinate, a row a box."""

    regions: tuple[Region, ...]
    owner: NDArray[np.intp]
    low: Array
    high: Array
    places: Mapping[int, Places] = field(default_factory=dict)

    def kept(self, which: Any) -> Boxes:
        """The boxes of these rows, in their order."""
        places = {k: (least[which], most[which]) for k, (least, most) in self.places.items()}
        return Boxes(self.regions, self.owner[which], self.low[which], self.high[which], places)

    def parted(self, split: tuple[NDArray[Any], NDArray[Any]]) -> Boxes:
        """Boxes in which a step's size may lie on both sides of a power of two, once for each of the sides."""
        steps, powers = split
        which = np.concatenate((np.arange(len(steps)), np.flatnonzero(steps >= 0)))
        found, first = self.kept(which), len(steps)
        places = dict(found.places)
        for number in np.unique(steps[steps >= 0]).tolist():
            least, most = places.get(number, (np.full(len(which), -5000), np.full(len(which), 5000)))
            mine = steps[which] == number
            above = mine & (np.arange(len(which)) >= first)
            below = mine & ~above
            least[above] = np.maximum(least, powers[which])[above]
            most[below] = np.minimum(most, powers[which] - 1)[below]
            places[number] = least, most
        return replace(found, places=places)

    def halved(self, scales: Array) -> Boxes:
        """Both halves of every box, across its widest side."""
        low, high = halves(self.low, self.high, (self.high - self.low) * scales)
        return replace(self.kept(np.tile(np.arange(len(self.owner)), 2)), low=low, high=high)


def bounds_over(
    boxes: Boxes, outline: Outline, model: Model, measure: Measure, enough: float = 0.0
) -> tuple[Array, tuple[NDArray[Any], NDArray[Any]]]:
    """The bound over each box, infinite where that is too large for one, and the step at whose power of two to part."""
    values: dict[tuple[int, int], Scaled] = {}
    turns: dict[tuple[int, int], int] = {}
    place = 0
    for k, piece in enumerate(boxes.regions[0]):
        if isinstance(piece, AnglePiece):
            turns[piece.argument, piece.entry] = place
        else:
            values |= _vectors(boxes, k, place)
        place += len(piece.ranges)
    known: dict[tuple[int, int, Fraction], tuple[Scaled, Scaled]] = {}
    position = {(p.argument, p.entry): k for k, p in enumerate(boxes.regions[0]) if isinstance(p, AnglePiece)}

    def functions(argument: int, entry: int, factor: Fraction) -> tuple[Scaled, Scaled]:
        key = argument, entry, factor
        if key not in known:
            known[key] = _turned(boxes, position[argument, entry], turns[argument, entry], factor)
        return known[key]

    running = Running(outline, model, values, functions, len(boxes.owner), boxes.places)
    return np.where(running.empty, 0, measure(running, enough)), running.split


def _column(boxes: Boxes, place: int) -> Interval:
    return Interval(boxes.low[:, place], boxes.high[:, place])


def _vectors(boxes: Boxes, k: int, place: int) -> dict[tuple[int, int], Scaled]:
    """The entries of a unit vector, whose pieces are the k-th of each region's."""
    found = [Interval(np.empty(len(boxes.owner)), np.empty(len(boxes.owner))) for _ in range(3)]
    pieces = [region[k] for region in boxes.regions]
    argument = pieces[0].argument
    for axis, sign in product(range(3), (1, -1)):
        mine = [isinstance(p, FacePiece) and p.axis == axis and p.signs[axis] == sign for p in pieces]
        rows = np.array(mine)[boxes.owner]
        if rows.any():
            part = boxes.kept(rows)
            for entry, value in zip(
                found, face_values(axis, sign, (_column(part, place), _column(part, place + 1))), strict=True
            ):
                entry.low[rows], entry.high[rows] = value.low, value.high
    zero = np.zeros(len(boxes.owner))
    return {(argument, entry): Scaled(0, value, zero) for entry, value in enumerate(found)}


def _turned(boxes: Boxes, k: int, place: int, factor: Fraction) -> tuple[Scaled, Scaled]:
    """Sine and cosine of an angle, whose pieces are the k-th of each region's."""
    pieces = [region[k] for region in boxes.regions]
    first = np.array([pieces.index(piece) for piece in pieces], dtype=np.float64)[boxes.owner]
    keys = np.stack((first, boxes.low[:, place], boxes.high[:, place]), axis=1)
    distinct, where = np.unique(keys, axis=0, return_inverse=True)
    over = {n: piece.functions(factor) for n, piece in enumerate(pieces) if isinstance(piece, AnglePiece)}
    found_of = [over[owner](low, high) for owner, low, high in distinct.tolist()]
    zero = np.zeros(len(where))
    found = []
    for which in (0, 1):
        low_ends, high_ends = (np.array([row[which][end] for row in found_of])[where.ravel()] for end in (1, 2))
        found.append(Scaled(found_of[0][which][0], Interval(low_ends, high_ends), zero))
    return found[0], found[1]


def whole(regions: Sequence[Region]) -> Boxes:
    """The boxes of regions of one batch, each undivided."""
    ranges = np.array([[x for piece in region for x in piece.ranges] for region in regions])
    return Boxes(tuple(regions), np.arange(len(regions)), ranges[:, :, 0].copy(), ranges[:, :, 1].copy())


def scales_of(boxes: Boxes) -> Array:
    """How much a coordinate of a box moves values, about."""
    scales: list[Array] = []
    for piece in boxes.regions[0]:
        place = len(scales)
        if isinstance(piece, AnglePiece) and piece.singular:
            scales.append(1 / boxes.low[:, place])
        else:
            one = np.ones(len(boxes.owner))
            scales += [one * math.pi] if isinstance(piece, AnglePiece) else [one, one]
    return np.stack(scales, axis=1)


def largest(outline: Outline, model: Model, cover: Cover, measure: Measure, budget: int) -> float:
    """A bound on the measure over all that is covered, with about so many boxes at most.

    Raises NoBound where the boxes still are too large then.
    """
    found, reached = _largest(outline, model, cover, measure, budget)
    if not found <= WIDEST * reached:
        raise NoBound("boxes of inputs small enough to be of use are too many")
    return found


def _largest(outline: Outline, model: Model, cover: Cover, measure: Measure, budget: int) -> tuple[float, float]:
    """The bound, and the largest at a point."""
    batches: dict[tuple[object, ...], list[Region]] = {}
    for region in cover.regions:
        batches.setdefault(tuple(piece.batch for piece in region), []).append(region)
    at_large = [regions for kind, regions in batches.items() if not any(kind)]
    reached = max(_climbed(outline, model, measure, regions) for regions in at_large)
    found, spent, within, before = 0.0, 0, CLOSE * reached, [math.inf] * STUCK
    ahead = [whole(regions) for regions in batches.values()]
    while ahead:
        measured = [(boxes, *bounds_over(boxes, outline, model, measure, within)) for boxes in ahead]
        spent += sum(len(bounds) for _, bounds, _ in measured)
        worst = max(found, *(float(bounds.max()) for _, bounds, _ in measured))
        if spent > budget or (worst <= FAIR * reached and worst > 0.998 * before[-STUCK]):
            return worst, reached
        before.append(worst)
        found = max(found, *(float(bounds[bounds <= within].max(initial=0.0)) for _, bounds, _ in measured))
        ahead = [_finer(boxes, bounds, split, within) for boxes, bounds, split in measured if bounds.max() > within]
    return found, reached


def _climbed(outline: Outline, model: Model, measure: Measure, regions: Sequence[Region]) -> float:
    """The largest bound at points, the best of which are moved about, ever less."""
    undivided = whole(regions)
    generator = np.random.default_rng(0)
    owner = np.arange(POINTS * MOVES) % len(regions)
    low, high = undivided.low[owner], undivided.high[owner]
    places = low + generator.random(low.shape) * (high - low)
    reached = 0.0
    for attempt in range(CLIMBS):
        bounds, _ = bounds_over(Boxes(undivided.regions, owner, places, places), outline, model, measure)
        bounds = np.where(np.isfinite(bounds), bounds, 0)
        reached = max(reached, float(bounds.max()))
        best = np.repeat(np.argsort(-bounds)[:POINTS], MOVES)
        owner, low, high = owner[best], undivided.low[owner[best]], undivided.high[owner[best]]
        moved = generator.standard_normal(low.shape) * (high - low) * 0.25 * 0.5**attempt
        moved[::MOVES] = 0
        places = np.clip(places[best] + moved, low, high)
    return reached


def _finer(boxes: Boxes, bounds: Array, split: tuple[NDArray[Any], NDArray[Any]], within: float) -> Boxes:
    """The boxes whose bound is too large, halved, and parted where it is hardly too large."""
    wide = bounds > within
    near = bounds[wide] < PARTED * within
    parted = boxes.kept(wide).parted((np.where(near, split[0][wide], -1), split[1][wide]))
    return parted.halved(scales_of(parted))
