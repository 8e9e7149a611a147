"""A ball times a power of a small number, so that what grows or vanishes at a singular point keeps its digits.

Near a singular angle, at the distance t in (0, T], every value is t^p times something in a ball that stays away from
zero; so one evaluation holds for all t, down to the smallest. Elsewhere t is 1.
"""

from __future__ import annotations

from dataclasses import dataclass
from fractions import Fraction
from typing import Any

__all__ = ["Scaled", "between", "exactly"]


@dataclass(frozen=True, slots=True)
class Scaled:
    """t^power times a value in the ball `value`, computed with an error of at most t^power times `error`."""

    power: int
    value: Any
    error: Any


def between(low: float, high: float) -> Any:
    """The ball around the numbers between two, each a binary number of few digits."""
    from flint import arb

    return arb(low).union(arb(high)) if low != high else arb(low)


def exactly(value: Fraction) -> Any:
    """The ball around a fraction."""
    from flint import arb

    return arb(value.numerator) / value.denominator
