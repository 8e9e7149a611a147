"""Which boxes cover the inputs? Unit vectors face by face of a cube, angles quarter by quarter from singular points.

A unit vector is (1, a, b) or a permutation of it over its length, with a and b in [-1, 1]; its length may differ from
1 by rounding. An angle is a singular one (a multiple of a quarter turn, of itself or of its half) plus or minus pi t,
with t no more than half the way to the next. All functions of an angle are periodic, so that this is every angle.
"""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import dataclass
from fractions import Fraction
from itertools import product
from typing import Any

from chasles.bounds.scaled import Scaled, between
from chasles.bounds.symmetry import Sign

__all__ = ["SLACK", "AnglePiece", "FacePiece", "Interval", "Piece", "faces"]

SLACK = 2.0**-21
"""How far a unit vector's length may be from 1: some roundoffs of single precision."""

Interval = tuple[float, float]


@dataclass(frozen=True, slots=True)
class FacePiece:
    """A quarter of a face of the cube: entry `axis` is the largest in size, and all entries have the given signs."""

    argument: int
    axis: int
    signs: tuple[int, int, int]

    @property
    def ranges(self) -> tuple[Interval, ...]:
        """What the box's coordinates run over."""
        return tuple((0.0, 1.0) if self.signs[k] > 0 else (-1.0, 0.0) for k in range(3) if k != self.axis)

    @property
    def negative(self) -> list[Sign]:
        """What is negative on the piece."""
        return [("input", self.argument, k) for k in range(3) if self.signs[k] < 0]

    @property
    def kind(self) -> tuple[int, ...]:
        """What changes of sign leave as it is."""
        return self.argument, self.axis

    def values(self, box: tuple[Interval, ...]) -> dict[tuple[int, int], Scaled]:
        """The entries over a box."""
        from flint import arb

        a, b = box
        others = [k for k in range(3) if k != self.axis]
        length = between(1 - SLACK, 1 + SLACK)
        square = 1 + between(*_squared(a)) + between(*_squared(b))
        largest = self.signs[self.axis] * length / square.sqrt()
        entries = {self.axis: largest, others[0]: length * _slope(a, b), others[1]: length * _slope(b, a)}
        return {(self.argument, k): Scaled(0, value, arb(0)) for k, value in entries.items()}


def _squared(x: Interval) -> Interval:
    """The squares of the numbers of an interval."""
    low, high = sorted(map(abs, x))
    return (0.0 if x[0] < 0 < x[1] else low * low, high * high)


def _slope(x: Interval, other: Interval) -> Any:
    """What x / sqrt(1 + x^2 + y^2) runs over: it grows with x, and its size shrinks with that of y."""
    from flint import arb

    near, far = _squared(other)
    low = arb(x[0]) / (1 + arb(x[0]) ** 2 + (far if x[0] > 0 else near)).sqrt()
    high = arb(x[1]) / (1 + arb(x[1]) ** 2 + (near if x[1] > 0 else far)).sqrt()
    return low.union(high)


@dataclass(frozen=True, slots=True)
class AnglePiece:
    """Angles on one side of a singular one, which is `quarter` quarter turns over the smallest factor `least`.

    If the piece is `singular`, t is kept as a power.
    """

    argument: int
    entry: int
    quarter: int
    side: int
    least: Fraction
    singular: bool = True

    @property
    def negative(self) -> list[Sign]:
        """What is negative on the piece: sine and cosine of the smallest multiple of the angle."""
        quadrant = (self.quarter + (self.side - 1) // 2) % 4
        functions = {"sine": quadrant in (2, 3), "cosine": quadrant in (1, 2)}
        return [(name, self.argument, self.entry) for name, below in functions.items() if below]

    @property
    def kind(self) -> tuple[int, ...]:
        """What changes of sign leave as it is."""
        return self.argument, self.entry, self.quarter % 2

    @property
    def ranges(self) -> tuple[Interval, ...]:
        """What the box's coordinate t runs over: to the middle between two singular angles."""
        return ((0.0, float(1 / (4 * self.least))),)

    def scale(self, box: tuple[Interval, ...]) -> Interval | None:
        """What t runs over, where t is kept as a power."""
        return box[0] if self.singular else None

    def functions(self, box: tuple[Interval, ...], factor: Fraction) -> tuple[Scaled, Scaled]:
        """Sine and cosine of the factor times the angle over a box."""
        from flint import arb

        ((low, high),) = box
        zero = arb(0)
        multiple = float(factor)
        turned = self.quarter * factor / self.least
        moved = self.side * multiple * between(low, high)
        cosine = Scaled(0, moved.cos_pi(), zero)
        if self.singular and turned.denominator == 1:
            # sin(x) / x shrinks between 0 and pi.
            first = arb(multiple * low).sin_pi() / low if low else arb.pi() * multiple
            sine = Scaled(1, self.side * (arb(multiple * high).sin_pi() / high).union(first), zero)
        else:
            sine = Scaled(0, moved.sin_pi(), zero)
        if turned.denominator != 1:
            whole = float(turned) / 2 + moved
            return Scaled(0, whole.sin_pi(), zero), Scaled(0, whole.cos_pi(), zero)
        return _turned(sine, cosine, int(turned) % 4)


def _turned(sine: Scaled, cosine: Scaled, quarters: int) -> tuple[Scaled, Scaled]:
    """Sine and cosine after so many quarter turns."""
    for _ in range(quarters):
        sine, cosine = cosine, Scaled(sine.power, -sine.value, sine.error)
    return sine, cosine


Piece = FacePiece | AnglePiece


def faces(argument: int) -> Iterator[FacePiece]:
    """All quarters of faces."""
    for axis in range(3):
        for signs in product((1, -1), repeat=3):
            yield FacePiece(argument, axis, (signs[0], signs[1], signs[2]))
