"""Random angles, numbers, vectors and directions, to 50 digits: at large, near where formulas fail, or simple."""

from __future__ import annotations

from collections.abc import Sequence
from typing import Any

import numpy as np

from chasles.evaluation.matrices import Matrix, product, transposed
from chasles.numerics.enclosures import exactly, plain_context

AXES = ((1, 0, 0), (0, 1, 0), (0, 0, 1))
CONTEXT = plain_context(50)
Numbers = list[Any]


def unit_of(vector: Numbers) -> Numbers:
    """The vector divided by its norm; raises ZeroDivisionError for the zero vector."""
    size = CONTEXT.sqrt(sum(x * x for x in vector))
    return [x / size for x in vector]


def turned(axis: Numbers, angle: Any) -> Matrix:
    """The rotation about a unit axis through an angle: that of the quaternion [sin(angle/2) axis; cos(angle/2)].

    An angle that is a multiple of pi to 45 digits is one: the rotation is the identity or a half-turn exactly.
    """
    w, sine = (x if abs(x) > CONTEXT.mpf(10) ** -45 else 0 for x in (CONTEXT.cos(angle / 2), CONTEXT.sin(angle / 2)))
    x, y, z = (sine * entry for entry in axis)
    left = [[w, -z, y, x], [z, w, -x, y], [-y, x, w, z]]
    right = [[w, z, -y, x], [-z, w, x, y], [y, -x, w, z]]
    return product(left, transposed(right))


class Draws:
    """Draws at large, from a seeded generator; `decades` says how close to a singular set the nearest draws come."""

    def __init__(self, generator: np.random.Generator, decades: int) -> None:
        self.generator = generator
        self.decades = decades

    def angle(self) -> Any:
        """An angle in radians, within two turns."""
        return exactly(float(self.generator.uniform(-6.3, 6.3)), CONTEXT)

    def vector(self, size: int) -> Numbers:
        """A column of numbers of the order of one."""
        return [exactly(float(x), CONTEXT) for x in self.generator.standard_normal(size)]

    def direction(self) -> Numbers:
        """A unit vector in space, no direction preferred."""
        return unit_of(Draws.vector(self, 3))

    def related(self, other: Numbers) -> Numbers | None:
        """A column nearly equal or parallel to another one, or None if this one is drawn by itself."""
        return None

    def chance(self, probability: float) -> bool:
        """True with the given probability."""
        return bool(self.generator.random() < probability)

    def pick(self, choices: Sequence[Any]) -> Any:
        """One of the choices."""
        return choices[int(self.generator.integers(len(choices)))]


class DrawsNearby(Draws):
    """Draws close to where formulas fail."""

    def angle(self) -> Any:
        """An angle near 0, pi/2, pi or 2 pi; now and then the float nearest to it."""
        quarters = self.pick((0, 0, 2, -2, 2, -2, 1, -1, 4))
        offset = 0 if quarters and self.chance(0.1) else self._tiny()
        return quarters * CONTEXT.pi / 2 + offset

    def vector(self, size: int) -> Numbers:
        """A column that is small every other time."""
        small = self._tiny() if self.chance(0.5) else 1
        return [small * x for x in super().vector(size)]

    def direction(self) -> Numbers:
        """A unit vector near a coordinate axis."""
        return unit_of([a + self._tiny() * x for a, x in zip(self.pick(AXES), super().vector(3), strict=True)])

    def related(self, other: Numbers) -> Numbers | None:
        """A column nearly equal or nearly parallel to the other one, every other time."""
        if self.chance(0.5):
            return None
        factor = 1 if self.chance(0.7) else super().vector(1)[0]
        return [factor * x + self._tiny() * y for x, y in zip(other, super().vector(len(other)), strict=True)]

    def _tiny(self) -> Any:
        sign = 1 if self.chance(0.5) else -1
        return sign * CONTEXT.mpf(10) ** exactly(float(self.generator.uniform(-self.decades, -1)), CONTEXT)


class SimpleDraws(Draws):
    """Draws that a person would try."""

    def angle(self) -> Any:
        """Zero, a quarter or half a turn, a small number."""
        return self.pick((0, 1, -1, 2, 3, CONTEXT.pi / 2, -CONTEXT.pi / 2, CONTEXT.pi, -CONTEXT.pi, CONTEXT.mpf(0.5)))

    def vector(self, size: int) -> Numbers:
        """A column of small integers."""
        return [CONTEXT.mpf(int(x)) for x in self.generator.integers(-2, 3, size)]

    def direction(self) -> Numbers:
        """A coordinate axis, either way."""
        sign = 1 if self.chance(0.5) else -1
        return [sign * CONTEXT.mpf(x) for x in self.pick(AXES)]
