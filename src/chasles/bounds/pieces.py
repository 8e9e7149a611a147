"""Which boxes cover the inputs? Unit vectors face by face of a cube, angles quarter by quarter from singular points.

A unit vector is (1, a, b) or a permutation of it over its length, with a and b in [-1, 1]; its length may differ from
1 by rounding. An angle is a singular one (a multiple of a quarter turn, of itself or of its half) plus or minus pi t,
with t no more than half the way to the next. All functions of an angle are periodic, so that this is every angle.
"""

from __future__ import annotations

from collections.abc import Callable, Iterator
from dataclasses import dataclass
from fractions import Fraction
from itertools import product
from typing import Any

import numpy as np

from chasles.bounds.intervals import Interval, balls, between, enclosed
from chasles.bounds.symmetry import Sign

SLACK = 2.0**-21
"""How far a unit vector's length may be from 1: some roundoffs of single precision."""
NEAR = 2.0**-5
"""How near a singular angle t counts as small."""

Range = tuple[float, float]


@dataclass(frozen=True, slots=True)
class FacePiece:
    """A quarter of a face of the cube: entry `axis` is the largest in size, and all entries have the given signs."""

    argument: int
    axis: int
    signs: tuple[int, int, int]

    @property
    def ranges(self) -> tuple[Range, ...]:
        """What the box's coordinates run over."""
        return tuple((0.0, 1.0) if self.signs[k] > 0 else (-1.0, 0.0) for k in range(3) if k != self.axis)

    @property
    def negative(self) -> list[Sign]:
        """The entries that are negative on the piece."""
        return [("input", self.argument, k) for k in range(3) if self.signs[k] < 0]

    @property
    def kind(self) -> tuple[int, ...]:
        """What tells pieces apart that no change of sign takes into one another."""
        return self.argument, self.axis

    @property
    def batch(self) -> tuple[int, ...]:
        """What pieces have in common that are covered in one batch: the powers of t of all steps."""
        return ()


def face_values(axis: int, sign: int, box: tuple[Interval, Interval]) -> list[Interval]:
    """The entries of unit vectors over boxes of one face, its largest entry of that sign."""
    a, b = box
    one = np.ones_like(a.low)
    length = Interval(one - SLACK, one + SLACK)
    square = Interval(one, one) + a.squared + b.squared
    largest = length / square.root
    others = iter((length * _slope(a, b), length * _slope(b, a)))
    return [(largest if sign > 0 else -largest) if k == axis else next(others) for k in range(3)]


def _slope(x: Interval, other: Interval) -> Interval:
    """What x / sqrt(1 + x^2 + y^2) runs over: it grows with x, and its size shrinks with that of y."""
    near, far = other.below, other.above
    low = _at(x.low, np.where(x.low > 0, far, near))
    high = _at(x.high, np.where(x.high > 0, near, far))
    return Interval(low.low, high.high)


def _at(x: Any, y: Any) -> Interval:
    one, a, b = (Interval(z, z) for z in (np.ones_like(x), x, y))
    return a / (one + a.squared + b.squared).root


@dataclass(frozen=True, slots=True)
class AnglePiece:
    """Angles on one side of a singular one, which is `quarter` quarter turns over the smallest factor `least`.

    Where `near` the singular one the box is of s: t is s times any power of two up to 1, and powers of that are kept.
    """

    argument: int
    entry: int
    quarter: int
    side: int
    least: Fraction
    near: bool = True
    singular: bool = True

    @property
    def negative(self) -> list[Sign]:
        """What is negative on the piece: sine and cosine of the smallest multiple of the angle."""
        quadrant = (self.quarter + (self.side - 1) // 2) % 4
        functions = {"sine": quadrant in (2, 3), "cosine": quadrant in (1, 2)}
        return [(name, self.argument, self.entry) for name, below in functions.items() if below]

    @property
    def kind(self) -> tuple[int, ...]:
        """What tells pieces apart that no change of sign takes into one another."""
        return self.argument, self.entry, self.quarter % 2, self.near

    @property
    def batch(self) -> tuple[int, ...]:
        """What pieces have in common that are covered in one batch: the powers of t of all steps."""
        return (self.quarter,) if self.near else ()

    @property
    def ranges(self) -> tuple[Range, ...]:
        """What the box's coordinate runs over: t goes to the middle between two singular angles."""
        most = float(1 / (4 * self.least))
        return ((NEAR / 2, NEAR) if self.near else (NEAR if self.singular else 0.0, most),)

    def functions(self, factor: Fraction) -> Callable[[float, float], tuple[tuple[int, float, float], ...]]:
        """Sine and cosine of the factor times the angle, over a box by its ends: for each a power of t and the ends."""
        arb = balls()
        multiple = float(factor)
        turned = self.quarter * factor / self.least
        shift, quarters = float(turned) / 2, int(turned) % 4 if turned.denominator == 1 else None
        most = arb.pi() * multiple

        def over(low: float, high: float) -> tuple[tuple[int, float, float], ...]:
            moved = self.side * multiple * between(0.0 if self.near else low, high)
            if quarters is None:
                moved += shift
            sine, cosine = (0, moved.sin_pi()), (0, moved.cos_pi())
            if self.near and quarters is not None:
                # sin(x) / x shrinks between 0 and pi.
                ratio = (arb(multiple * high).sin_pi() / high).union(most)
                sine = 1, self.side * ratio * between(low, high)
            for _ in range(quarters or 0):
                sine, cosine = cosine, (sine[0], -sine[1])
            return (sine[0], *enclosed(sine[1])), (cosine[0], *enclosed(cosine[1]))

        return over


Piece = FacePiece | AnglePiece


def faces(argument: int) -> Iterator[FacePiece]:
    """All quarters of faces."""
    for axis in range(3):
        for signs in product((1, -1), repeat=3):
            yield FacePiece(argument, axis, (signs[0], signs[1], signs[2]))
