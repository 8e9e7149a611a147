"""Intervals, many at once: the same operation on as many boxes as there are, ends rounded outwards.

NumPy rounds each operation on floats to nearest, so that an end moved outwards by a unit in its last place holds the
exact result. Sines, cosines and arctangents are enclosed by ball arithmetic. An end that is not a number stays so, and
says that the interval holds whatever it may.
"""

from __future__ import annotations

import math
from collections.abc import Callable, Iterable
from dataclasses import dataclass
from fractions import Fraction
from typing import Any

import numpy as np
from numpy.typing import NDArray

from chasles.bounds.functions import ENCLOSED, slope

Array = NDArray[np.float64]

UNIT = 2.0**-52
LEAST = 5e-324
SAFE = 1 + 2.0**-40
"""By what a sum of products of sizes is multiplied, lest it lies below the exact one: thousands of its roundings."""


def _down(x: Array) -> Array:
    return x - (abs(x) * UNIT + LEAST)


def _up(x: Array) -> Array:
    return x + (abs(x) * UNIT + LEAST)


@dataclass(frozen=True, slots=True, eq=False)
class Interval:
    """All numbers from `low` to `high`, in each of the boxes."""

    low: Array
    high: Array

    def __neg__(self) -> Interval:
        return Interval(-self.high, -self.low)

    def __add__(self, other: Interval) -> Interval:
        return Interval(_down(self.low + other.low), _up(self.high + other.high))

    def __sub__(self, other: Interval) -> Interval:
        return Interval(_down(self.low - other.high), _up(self.high - other.low))

    def __mul__(self, other: Interval) -> Interval:
        if self is other:
            return self.squared
        a, b, c, d = self.low * other.low, self.low * other.high, self.high * other.low, self.high * other.high
        low, high = np.minimum(np.minimum(a, b), np.minimum(c, d)), np.maximum(np.maximum(a, b), np.maximum(c, d))
        return Interval(_down(low), _up(high))

    def __truediv__(self, other: Interval) -> Interval:
        """The quotients; not numbers where the divisor may be zero."""
        known = (other.low > 0) | (other.high < 0)
        least, most = np.where(known, other.low, np.nan), np.where(known, other.high, np.nan)
        return self * Interval(_down(1 / most), _up(1 / least))

    @property
    def squared(self) -> Interval:
        """The squares, never negative: tighter than the interval times itself."""
        low, high = self.below, self.above
        return Interval(np.maximum(_down(low * low), 0), _up(high * high))

    @property
    def root(self) -> Interval:
        """The square roots; not numbers where there may be none."""
        known = np.where(self.low >= 0, self.low, np.nan)
        return Interval(np.maximum(_down(np.sqrt(known)), 0), _up(np.sqrt(self.high)) + 0 * known)

    @property
    def above(self) -> Array:
        """The largest size."""
        return np.maximum(abs(self.low), abs(self.high))

    @property
    def below(self) -> Array:
        """The smallest size."""
        return np.maximum(np.maximum(self.low, -self.high), 0)

    def union(self, other: Interval) -> Interval:
        """The smallest interval that holds both."""
        return Interval(np.minimum(self.low, other.low), np.maximum(self.high, other.high))

    def part(self, rows: NDArray[np.intp]) -> Interval:
        """The interval in these boxes alone."""
        return Interval(self.low[rows], self.high[rows])

    def common(self, other: Interval) -> Interval:
        """The intersection; where that is empty, what lies between the two."""
        low, high = np.maximum(self.low, other.low), np.minimum(self.high, other.high)
        return Interval(np.minimum(low, high), np.maximum(low, high))

    @property
    def size(self) -> Interval:
        """The absolute values."""
        return Interval(self.below, self.above)

    def sized(self, size: Interval) -> Interval:
        """The part whose absolute values are in the given interval; low > high where there is none."""
        low = np.maximum(self.low, np.where(self.low > 0, size.low, -size.high))
        high = np.minimum(self.high, np.where(self.high < 0, -size.low, size.high))
        return Interval(low, high)

    def widened(self, by: Array) -> Interval:
        """The interval widened by a distance on both sides."""
        return Interval(_down(self.low - by), _up(self.high + by))

    def times(self, factor: float) -> Interval:
        """The interval times a power of two, which rounds nothing, or times zero."""
        ends = self.low * factor, self.high * factor
        return Interval(np.minimum(*ends), np.maximum(*ends))


def halves(low: Array, high: Array, widths: Array) -> tuple[Array, Array]:
    """The ends of both halves of every box, a row each, across its widest side: all lower halves, then the others."""
    rows, side = np.arange(len(low)), np.argmax(widths, axis=1)
    middle = (low[rows, side] + high[rows, side]) / 2
    first, second = high.copy(), low.copy()
    first[rows, side], second[rows, side] = middle, middle
    return np.concatenate((low, second)), np.concatenate((first, high))


def below(x: Array) -> Array:
    """Lower bounds of absolute values that were computed with rounding."""
    return x * (2 - SAFE)


def point(value: float, like: Array) -> Interval:
    """A number that is a float, in every box."""
    ends = np.full_like(like, value)
    return Interval(ends, ends)


def exactly(value: Fraction, like: Array) -> Interval:
    """A fraction in every box."""
    near = value.numerator / value.denominator
    if Fraction(near) == value:
        return point(near, like)
    low, high = math.nextafter(near, -math.inf), math.nextafter(near, math.inf)
    return Interval(np.full_like(like, low), np.full_like(like, high))


def enclosed(ball: Any) -> tuple[float, float]:
    """The floats around a ball, rounded outwards."""
    low, high = float(ball.lower()), float(ball.upper())
    return low - (abs(low) * 2 * UNIT + LEAST), high + (abs(high) * 2 * UNIT + LEAST)


def function_of(name: str, *of: Interval) -> Interval:
    """A function of balls on intervals, by its name: box by box, the same box once."""
    known: dict[tuple[float, ...], tuple[float, float]] = {}
    rows = list(zip(*(end.tolist() for x in of for end in (x.low, x.high)), strict=True))
    for row in rows:
        if row not in known:
            known[row] = _value(name, row)
    return _intervals(known[row] for row in rows)


def _intervals(ends: Iterable[tuple[float, float]]) -> Interval:
    found = np.array(list(ends), dtype=np.float64).reshape(-1, 2)
    return Interval(found[:, 0].copy(), found[:, 1].copy())


def balls() -> Any:
    """The ball arithmetic of python-flint. Raises ModuleNotFoundError, which says what to install, without it."""
    try:
        from flint import arb
    except ModuleNotFoundError:
        needs = "an error bound with sines, exponentials and the like needs python-flint"
        raise ModuleNotFoundError(f"{needs}; install it with: pip install 'chasles[fast]'", name="flint") from None
    return arb


def between(low: float, high: float) -> Any:
    """The ball around the numbers between two, each a binary number of few digits."""
    arb = balls()
    return arb(low).union(arb(high)) if low != high else arb(low)


def _value(name: str, row: tuple[float, ...]) -> tuple[float, float]:
    if not all(map(math.isfinite, row)):
        return math.nan, math.nan
    function: Callable[..., Any] = _FUNCTIONS[name]
    value = function(*(between(low, high) for low, high in zip(*[iter(row)] * 2, strict=True)))
    return enclosed(value) if value.is_finite() else (math.nan, math.nan)


def _sine(x: Any) -> Any:
    """The part of the interval within [-1, 1]."""
    return _within(x.sin(), 1)


def _cosine(x: Any) -> Any:
    return _within(x.cos(), 1)


def _direction(y: Any, x: Any) -> Any:
    """No number where the origin, or a point of the half line on which the angle jumps, is among the points."""
    return y / 0 if x.lower() <= 0 and y.contains(0) else type(y).atan2(y, x)


def _within(ball: Any, most: int) -> Any:
    one = type(ball)
    return max(ball.lower(), one(-most)).union(min(ball.upper(), one(most)))


_FUNCTIONS: dict[str, Callable[..., Any]] = {
    "sine": _sine,
    "cosine": _cosine,
    "arctangent2": _direction,
    **{name: function.value for name, function in ENCLOSED.items()},
    **{slope(name, k): by for name, function in ENCLOSED.items() for k, by in enumerate(function.slopes)},
}
