"""Random angles, numbers, vectors and directions, to 50 digits: at large, near where formulas fail, or simple."""

from __future__ import annotations

from typing import Any

import numpy as np

from chasles.numerics.enclosures import exactly, plain_context
from chasles.numerics.small_matrices import Matrix, flipped, product

__all__ = ["CONTEXT", "Draws", "DrawsAtLarge", "DrawsNearby", "SimpleDraws", "turned", "unit_of"]

CONTEXT = plain_context(50)
Numbers = list[Any]


def unit_of(vector: Numbers) -> Numbers:
    """The vector divided by its norm; raises ZeroDivisionError for the zero vector."""
    size = CONTEXT.sqrt(sum(x * x for x in vector))
    return [x / size for x in vector]


def turned(axis: Numbers, angle: Any) -> Matrix:
    """The rotation about a unit axis through an angle: that of the quaternion [sin(angle/2) axis; cos(angle/2)]."""
    w, sine = CONTEXT.cos(angle / 2), CONTEXT.sin(angle / 2)
    x, y, z = (sine * entry for entry in axis)
    left = [[w, -z, y, x], [z, w, -x, y], [-y, x, w, z]]
    right = [[w, -z, y, -x], [z, w, -x, -y], [-y, x, w, -z]]
    return product(left, flipped(right))


class Draws:
    """Draws from a seeded generator; `decades` says how close to a singular set the nearest draws come."""

    def __init__(self, generator: np.random.Generator, decades: int) -> None:
        self.generator = generator
        self.decades = decades

    def angle(self) -> Any:
        """An angle in radians."""
        raise NotImplementedError

    def scalar(self) -> Any:
        """A number."""
        return self.vector(1)[0]

    def vector(self, size: int) -> Numbers:
        """A column of numbers."""
        raise NotImplementedError

    def direction(self) -> Numbers:
        """A unit vector in space."""
        raise NotImplementedError

    def related(self, other: Numbers) -> Numbers | None:
        """A column that stands in a special relation to another one, or None if this one is drawn by itself."""
        return None

    def chance(self, probability: float) -> bool:
        """True with the given probability."""
        return bool(self.generator.random() < probability)

    def pick(self, choices: Any) -> Any:
        """One of the choices."""
        return choices[int(self.generator.integers(len(choices)))]

    def _normal(self, size: int) -> Numbers:
        return [exactly(float(x), CONTEXT) for x in self.generator.standard_normal(size)]


class DrawsAtLarge(Draws):
    """Nothing is special: angles within two turns, vectors and directions without preference."""

    def angle(self) -> Any:
        return exactly(float(self.generator.uniform(-6.3, 6.3)), CONTEXT)

    def vector(self, size: int) -> Numbers:
        return self._normal(size)

    def direction(self) -> Numbers:
        return unit_of(self._normal(3))


class DrawsNearby(DrawsAtLarge):
    """Close to where formulas fail: angles near 0, pi/2, pi and 2 pi, small and nearly equal or parallel vectors."""

    def angle(self) -> Any:
        quarters = self.pick((0, 0, 2, -2, 2, -2, 1, -1, 4))
        offset = 0 if quarters and self.chance(0.1) else self._tiny()
        return quarters * CONTEXT.pi / 2 + offset

    def vector(self, size: int) -> Numbers:
        small = self._tiny() if self.chance(0.5) else 1
        return [small * x for x in self._normal(size)]

    def direction(self) -> Numbers:
        axis = self.pick(AXES)
        return unit_of([a + self._tiny() * x for a, x in zip(axis, self._normal(3), strict=True)])

    def related(self, other: Numbers) -> Numbers | None:
        if self.chance(0.5):
            return None
        factor = 1 if self.chance(0.7) else self._normal(1)[0]
        return [factor * x + self._tiny() * y for x, y in zip(other, self._normal(len(other)), strict=True)]

    def _tiny(self) -> Any:
        sign = 1 if self.chance(0.5) else -1
        return sign * CONTEXT.mpf(10) ** exactly(float(self.generator.uniform(-self.decades, -1)), CONTEXT)


class SimpleDraws(Draws):
    """Values that a person would try: quarter turns and small integers, axes, zeros."""

    def angle(self) -> Any:
        return self.pick((0, 1, -1, 2, 3, CONTEXT.pi / 2, -CONTEXT.pi / 2, CONTEXT.pi, -CONTEXT.pi, CONTEXT.mpf(0.5)))

    def vector(self, size: int) -> Numbers:
        return [CONTEXT.mpf(int(x)) for x in self.generator.integers(-2, 3, size)]

    def direction(self) -> Numbers:
        sign = 1 if self.chance(0.5) else -1
        return [sign * CONTEXT.mpf(x) for x in self.pick(AXES)]


AXES = ((1, 0, 0), (0, 1, 0), (0, 0, 1))
