"""Tests whether numbers satisfy a hypothesis: one for each kind, over all batch axes at once.

A test gets the arrays that the hypothesis is about, their entries on the last axis, and the tolerance; it says where
the hypothesis is broken and by how much, in a sentence with a placeholder for the number.
"""

from __future__ import annotations

from collections.abc import Callable, Mapping
from dataclasses import dataclass
from functools import reduce
from operator import add
from typing import Any

import numpy as np
from numpy.typing import NDArray

Numbers = NDArray[np.floating[Any]]

_SIX = [0, 1, 2, 1, 3, 4, 2, 4, 5]
"""Where the entries of a symmetric matrix stand among (xx, xy, xz, yy, yz, zz)."""


@dataclass(frozen=True, slots=True)
class BrokenHypothesis:
    """Where a hypothesis is broken, along the batch axes, and the amount that a sentence says of each place."""

    broken: NDArray[np.bool_]
    amount: Numbers
    says: str


def is_finite(array: Numbers) -> BrokenHypothesis:
    """Every entry is finite."""
    bad = ~np.isfinite(array)
    return BrokenHypothesis(np.asarray(bad.any(axis=-1)), np.where(bad, array, 0).sum(axis=-1), "there is {:.3g}")


def _unit(parts: list[Numbers], tolerance: float) -> BrokenHypothesis:
    square = reduce(add, ((part * part).sum(axis=-1) for part in parts))
    return _within(np.abs(square - 1), tolerance, "the square of the length is off by {:.3g}")


def _rotation(parts: list[Numbers], tolerance: float) -> BrokenHypothesis:
    Q = _matrix(parts)
    off = np.abs(np.swapaxes(Q, -1, -2) @ Q - np.eye(3)).max(axis=(-1, -2))
    finding = _within(off, tolerance, "an entry of Q^T Q is off by {:.3g}")
    if finding.broken.any():
        return finding
    determinant = np.linalg.det(Q)
    return BrokenHypothesis(determinant < 0, determinant, "its determinant is {:.3g}")


def _positive(parts: list[Numbers], _: float) -> BrokenHypothesis:
    number = parts[0][..., 0]
    return BrokenHypothesis(~(number > 0), number, "it is {:.3g}")


def _symmetric(parts: list[Numbers], tolerance: float) -> BrokenHypothesis:
    matrix = _matrix(parts)
    size = np.abs(matrix).max(axis=(-1, -2))
    off = np.abs(matrix - np.swapaxes(matrix, -1, -2)).max(axis=(-1, -2))
    return _within(_divided(off, size), tolerance, "entries across the diagonal differ by {:.3g} of the largest")


def _definite(parts: list[Numbers], tolerance: float) -> BrokenHypothesis:
    finding = _symmetric(parts, tolerance)
    if finding.broken.any():
        return finding
    values = np.linalg.eigvalsh(_matrix(parts))
    least = _divided(values[..., 0], np.abs(values).max(axis=-1))
    return BrokenHypothesis(~(least > tolerance**2), least, "its smallest principal value is {:.3g} of the largest")


def _matrix(parts: list[Numbers]) -> Numbers:
    """The 3 x 3 matrix that nine numbers are, or six."""
    entries = parts[0][..., _SIX] if parts[0].shape[-1] == 6 else parts[0]
    return entries.reshape(*entries.shape[:-1], 3, 3)


def _within(off: Numbers, tolerance: float, says: str) -> BrokenHypothesis:
    return BrokenHypothesis(~(off <= tolerance), off, f"{says}, and {tolerance:.2g} is allowed")


def _divided(above: Numbers, below: Numbers) -> Numbers:
    """The quotient; nothing of nothing is nothing."""
    return above / np.where(below > 0, below, 1)


TESTS: Mapping[str, Callable[[list[Numbers], float], BrokenHypothesis]] = {
    "unit": _unit,
    "unit column": _unit,
    "rotation": _rotation,
    "positive": _positive,
    "symmetric": _symmetric,
    "definite": _definite,
}
