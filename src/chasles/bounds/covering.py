"""How large does a measure of error become over all inputs? Boxes that cover them, the worst ones halved.

Each box has a bound, and the largest of all boxes' bounds is a bound for all inputs. Halving ends where it is hardly
larger than the bound at some point: smaller boxes would gain nothing. This is branch and bound with interval arithmetic
(Moore, Interval Analysis, 1966).
"""

from __future__ import annotations

import math
from collections.abc import Sequence
from typing import Any

import numpy as np
from numpy.typing import NDArray

from chasles.bounds.boxes import Boxes, Measure, bounds_over, scales_of, whole
from chasles.bounds.cover import Cover, Region
from chasles.bounds.intervals import Array
from chasles.bounds.model import Model
from chasles.bounds.outline import NoBound, Outline

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
