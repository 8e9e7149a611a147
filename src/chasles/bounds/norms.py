"""How large is the error of a result, relative to its largest entry, over boxes of inputs?"""

from __future__ import annotations

from collections.abc import Sequence
from fractions import Fraction

import numpy as np

from chasles.bounds.intervals import SAFE, Array, below
from chasles.bounds.running import Running
from chasles.bounds.sensitivity import entry_error

Group = tuple[int, ...]
"""Steps that hold the entries of one result and one physical dimension."""


def against_largest(running: Running, groups: Sequence[Group], unit: Fraction, enough: float = 0.0) -> Array:
    """In each box the largest ratio, over groups, of an entry's error to the largest entry, in units of the roundoff.

    Infinite in boxes that are too large for a bound. A ratio is not made smaller where it is small `enough`.
    """
    found = running.zero
    with np.errstate(all="ignore"):
        for group in groups:
            found = np.maximum(found, _ratio(running, group, enough * float(unit)))
    return np.where(running.bad | np.isnan(found), np.inf, found) / float(unit) * SAFE


def errors(running: Running, group: Group, power: int, enough: Array) -> Array:
    """The largest error of the group's entries, as a multiple of a power of t; what is small enough is left so."""
    error = running.zero
    first = {k: running.values[k].error for k in group}
    for number in sorted(first, key=lambda k: -float(np.nan_to_num(first[k], posinf=1e300, nan=1e300).max())):
        wide = ~(first[number] <= np.maximum(error, enough)) & ~running.bad & ~running.empty
        rows, finer = np.flatnonzero(wide), first[number].copy()
        if len(rows):
            part = running.part(rows, number)
            finer[rows] = np.fmin(finer[rows], entry_error(part, number, power))
            running.split[0][rows], running.split[1][rows] = part.split
            running._weight[rows] = part._weight
        error = np.maximum(error, finer)
    return error


def _ratio(running: Running, group: Group, enough: float) -> Array:
    power = min(running.values[k].power for k in group)
    size = running.zero
    for k in group:
        value = running.values[k]
        if value.power == power:
            size = np.maximum(size, value.value.below)
    size = below(size)
    error = errors(running, group, power, enough * size)
    return np.where(error == 0, 0, error / size * SAFE)
