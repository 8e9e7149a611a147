"""A random motion at which equations hold, found by Newton's method; whether two sides are equal at a motion."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from itertools import chain
from math import prod

import numpy as np

from chasles.evaluation.matrices import Matrix
from chasles.motions.random_motion import Key, NotInMotion, RandomMotion, ValuesInMotion
from chasles.motions.time_series import Array, stacked
from chasles.vocabulary import Node, Symbol

TOLERANCE = 1e-6
"""Relative to the size of what is compared: what is left of rounding is smaller, and mostly what differs is larger."""
STEPS = 24
"""So many steps Newton's method takes."""
SHORTER = (1, 1 / 2, 1 / 4, 1 / 8, 1 / 32)
"""The parts of a step of which the first is taken that leaves less."""
ENOUGH = 0.9
"""A step has to leave less than this of the equations."""
PRECISION = 1e-9
"""Relative to the size of the sides: what is left of equations that hold."""
DAMPING = 1e-12
"""Relative to the largest sum of squares: slopes below its root are not followed."""
MOST_NUMBERS = 600
"""With more free numbers no motion is looked for that satisfies equations."""
SMALL_CHANGE = 1e-7
"""Of a free number, by which slopes are found."""
MOTIONS_COMPARED = 2
"""At so many motions sides are compared, the first at which they are real: of angles more may be of other branches."""
Pair = tuple[Node, Node]
Running = Mapping[Symbol, bool]


def satisfying(
    equations: Sequence[Pair], rules: Mapping[Node, Node], running: Running, terms: int, motion: RandomMotion
) -> RandomMotion | None:
    """A motion nearby at which equations hold with their rates, by Newton's method; None if there is none.

    Raises `NotInMotion` where it is not found soon, or there are too many numbers to look for.
    """
    known = motion.undrawn
    _residual(equations, ValuesInMotion(known, rules, running, terms))
    keys = [key for key in known.numbers if not key[1]]
    numbers = {key: known.numbers[key][:, :, :, :1].copy() for key in known.numbers}
    shapes = {key: (*key[0].shape, 1 if key[0].constant else terms) for key in keys}
    count = sum(map(prod, shapes.values()))
    if count > MOST_NUMBERS:
        raise NotInMotion
    shifts = SMALL_CHANGE * np.eye(count, 1 + count, 1)

    def residual_at(step: Array) -> tuple[Array, float, float]:
        """What is left there, and beside it for each number changed a little; the size of the sides, what is left."""
        lanes = _changed(numbers, shapes, step[:, None] + shifts)
        found, size = _residual(equations, ValuesInMotion(motion.with_numbers(lanes), rules, running, terms))
        return found, size, float(np.max(np.abs(found[:, 0])))

    residual, size, left = residual_at(np.zeros(count))
    for _ in range(STEPS):
        if not np.all(np.isfinite(residual)):
            raise NotInMotion
        slopes = (residual[:, 1:] - residual[:, :1]) / SMALL_CHANGE
        whole, before = _least_solution(slopes, -residual[:, 0]), left
        for part in SHORTER:
            residual, size, left = residual_at(part * whole)
            if left < max(ENOUGH * before, PRECISION * size):
                break
        else:
            return None
        numbers = _changed(numbers, shapes, part * whole[:, None])
        if left < PRECISION * size:
            return motion.with_numbers(numbers)
    raise NotInMotion


def _least_solution(slopes: Array, wanted: Array) -> Array:
    """The smallest solution of linear equations, or what comes nearest to one.

    It is that of the normal equations with a little damping (Levenberg and Marquardt), as Newton's method goes on from
    there: a decomposition into singular values takes ten times as long.
    """
    is_wide = slopes.shape[0] <= slopes.shape[1]
    square = slopes @ slopes.T if is_wide else slopes.T @ slopes
    damping = DAMPING * max(float(np.max(np.diag(square))), np.finfo(float).tiny)
    square[np.diag_indices_from(square)] += damping
    found = np.linalg.solve(square, wanted if is_wide else slopes.T @ wanted)
    return np.asarray(slopes.T @ found if is_wide else found)


def _changed(numbers: Mapping[Key, Array], shapes: Mapping[Key, tuple[int, ...]], steps: Array) -> dict[Key, Array]:
    """The numbers changed by each of the columns of steps, one beside the other; those of these shapes are changed."""
    found, start = dict(numbers), 0
    for key, shape in shapes.items():
        end = start + prod(shape)
        found[key] = np.repeat(numbers[key], steps.shape[1], axis=3)
        found[key][:, :, : shape[2]] += steps[start:end].reshape(*shape, -1, 1)
        start = end
    return found


def _residual(equations: Sequence[Pair], values: ValuesInMotion) -> tuple[Array, float]:
    """What is left of the equations, term by term, and the size of their sides."""
    rows, size = [], 1.0
    for left, right in equations:
        pairs = [*zip(*(chain.from_iterable(values(side)) for side in (left, right)), strict=True)]
        is_even = len({len(entry) for pair in pairs for entry in pair}) == 1
        for together in (pairs,) if is_even else ([pair] for pair in pairs):
            one, other = (stacked(side, len(side[0])) for side in zip(*together, strict=True))
            size = max(size, float(np.abs(one).max()), float(np.abs(other).max()))
            n = min(one.shape[1], other.shape[1])
            apart = one[:, :n] - other[:, :n]
            rows.append(apart.transpose(0, 1, 3, 2).reshape(-1, apart.shape[2]))
    width = max(row.shape[1] for row in rows)
    wide = (row if row.shape[1] == width else np.broadcast_to(row, (row.shape[0], width)) for row in rows)
    return np.concatenate([*wide]), size


def equal(left: Matrix, right: Matrix, most: int = MOTIONS_COMPARED) -> bool | None:
    """Whether the values are equal now; None where they have none, or that is not the same at all motions compared."""
    values = stacked([*chain(*left, *right)], 1)[:, 0]
    one, other = np.split(values, 2)
    sizes, apart = np.abs(values).max(axis=(0, 2)), np.abs(one - other).max(axis=(0, 2))
    is_real = np.flatnonzero(np.isfinite(apart) & np.isfinite(sizes))[:most]
    if not is_real.size:
        return None
    apart, size = apart[is_real], 1 + np.max(sizes[is_real])
    if np.all(apart > TOLERANCE * size):
        return False
    return True if np.all(apart <= TOLERANCE * size) else None
