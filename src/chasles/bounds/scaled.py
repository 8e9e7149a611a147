"""An interval times a power of 2^-j, for all j at once: what grows or vanishes at a singular point keeps its digits.

Near a singular angle, at the distance s 2^-j, every value is some power of 2^-j times something that stays away from
zero; so one evaluation holds for all distances, down to the smallest. Rounding takes no notice of powers of two.
"""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from chasles.bounds.intervals import Array, Interval


@dataclass(frozen=True, slots=True, eq=False)
class Scaled:
    """2^(-j power) times a value in the interval `value`, with an error of at most 2^(-j power) times `error`."""

    power: int
    value: Interval
    error: Array

    def part(self, rows: NDArray[np.intp]) -> Scaled:
        """The value in these boxes alone."""
        return Scaled(self.power, self.value.part(rows), self.error[rows])
