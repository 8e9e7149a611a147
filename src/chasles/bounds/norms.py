"""How large is the error of a result, relative to its largest entry, over a box of inputs?"""

from __future__ import annotations

import math
from collections.abc import Sequence
from fractions import Fraction
from typing import Any

from chasles.bounds.running import SAFE, Running
from chasles.bounds.sensitivity import entry_error

__all__ = ["Group", "against_largest"]

Group = tuple[int, ...]
"""Steps that hold the entries of one result and one physical dimension."""


def against_largest(running: Running, groups: Sequence[Group], unit: Fraction) -> float:
    """The largest ratio, over groups, of an entry's error to the largest entry, in units of the roundoff."""
    return max((_ratio(running, group) for group in groups), default=0.0) / float(unit)


def _ratio(running: Running, group: Group) -> float:
    """Entries are looked at from the largest running bound down, until that is below what is found."""
    values = {k: running.values[k] for k in group}
    power = min(x.power for x in values.values())
    size = max(_below(running.lowered(x.value, x.power, power)) for x in values.values())
    first = {k: _above(running.lowered(x.error, x.power, power)) for k, x in values.items()}
    error = 0.0
    for number in sorted(first, key=lambda k: -first[k]):
        if first[number] <= error:
            break
        error = max(error, min(first[number], _above(entry_error(running, number, power))))
    if not error:
        return 0.0
    return error / size * (1 + SAFE) if size else math.inf


def _below(x: Any) -> float:
    """A float not above the size of anything in the ball."""
    return max(0.0, float(x.abs_lower()) * (1 - SAFE))


def _above(x: Any) -> float:
    """A float not below the size of anything in the ball."""
    return float(x.abs_upper()) * (1 + SAFE)
