"""By how much is a number rounded? Half the distance of the numbers of the precision where it lies.

That is the roundoff times the largest power of two that is not above the number's size. Powers of two are numbers of
the precision: what is hardly above one is hardly rounded, and rounding never passes one. Near a singular angle, at the
distance s 2^-j, every value is some power of 2^-j times something that stays away from zero; so one evaluation holds
for all distances, down to the smallest: rounding takes no notice of powers of two.
"""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from chasles.bounds.intervals import SAFE, Array, Interval
from chasles.lowering.program import Op

Places = tuple[NDArray[np.int64], NDArray[np.int64]]
"""The smallest and the largest exponent of two that a step's result may have before it is rounded."""
Sides = tuple[NDArray[np.bool_], NDArray[np.int64]]
"""Whether a result may lie on both sides of a power of two before it is rounded, and of which."""
NOWHERE = -5000
"""An exponent below that of every number."""
TURNS = (Op.SINE, Op.COSINE)


@dataclass(frozen=True, slots=True, eq=False)
class Scaled:
    """2^(-j power) times a value in the interval `value`, with an error of at most 2^(-j power) times `error`."""

    power: int
    value: Interval
    error: Array

    def part(self, rows: NDArray[np.intp]) -> Scaled:
        """The value in these boxes alone."""
        return Scaled(self.power, self.value.part(rows), self.error[rows])


def _exponent(size: Array) -> NDArray[np.int64]:
    """That of the largest power of two that is not above the size."""
    return np.where(size > 0, np.frexp(size)[1].astype(np.int64) - 1, NOWHERE)


def excess(value: Interval, parts: float, op: Op) -> Array:
    """How far what a function rounds is from its value, which for sine and cosine is at most 1."""
    exponent = _exponent(value.above)
    found = np.ldexp(parts, np.minimum(exponent, -1) if op in TURNS else exponent)
    return np.where(value.above == 0, 0, found)


def half_unit(raw: Interval, roundoff: float, op: Op) -> tuple[Array, Sides]:
    """The largest error of rounding what lies in an interval; sine and cosine are at most 1."""
    most, least = _exponent(raw.above), _exponent(raw.below)
    sides = most == least + 1, most
    if op in TURNS:
        most = np.minimum(most, -1)
    power = np.ldexp(1.0, most)
    lower = np.where(least >= most, 0, roundoff / 2 * power)
    found = np.minimum(roundoff * power, np.maximum((raw.above - power) * SAFE, lower))
    return np.where(raw.above == 0, 0, found * SAFE), sides


def rounded(raw: Interval, step: Array, roundoff: float, places: Places | None) -> Interval:
    """What the numbers of an interval may be rounded to."""
    found = raw.widened(step)
    ends = []
    for end, far in ((-raw.low, -found.low), (raw.high, found.high)):
        power = np.ldexp(1.0, _exponent(np.maximum(end, 0)))
        ends.append(np.where((end >= power) & (end - power < roundoff / 2 * power), power, far))
    found = found.common(Interval(-ends[0], ends[1]))
    if places is None:
        return found
    least, most = np.ldexp(1.0, places[0]), np.ldexp(1.0, places[1] + 1)
    return found.common(Interval(np.where(raw.low > 0, least, -most), np.where(raw.high < 0, -least, most)))


def restricted(
    value: Interval, error: Array, raw: Interval, places: Places
) -> tuple[Interval, Interval, NDArray[np.bool_]]:
    """The exact values that are rounded from between powers of two, what is rounded, and where there is nothing."""
    least, most = np.ldexp(1.0, places[0]), np.ldexp(1.0, places[1] + 1)
    outer = Interval(np.maximum(least - error * SAFE, 0), (most + error) * SAFE)
    parts = value.sized(outer), raw.sized(Interval(least, most))
    empty = (parts[0].low > parts[0].high) | (parts[1].low > parts[1].high)
    first, second = (Interval(np.minimum(x.low, x.high), np.maximum(x.low, x.high)) for x in parts)
    return first, second, empty
