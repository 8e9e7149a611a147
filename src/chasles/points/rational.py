"""Simple rational numbers, vectors and matrices: unit vectors, points of the circle, rotations, definite matrices.

Unit vectors come from stereographic projection, points of the circle from its rational parametrisation (Pythagorean
triples), rotations from quaternions of integers (the Euler-Rodrigues formula).
"""

from __future__ import annotations

from collections.abc import Sequence
from fractions import Fraction
from random import Random
from typing import TypeVar

Numbers = list[list[Fraction]]

AXES = ((0, 0, 1), (1, 0, 0), (0, 1, 0))
UNIT_VECTORS = tuple(
    tuple(Fraction(k, d) for k in numbers)
    for *numbers, d in (
        (0, 0, 1, 1), (1, 0, 0, 1), (0, 1, 0, 1), (0, 3, 4, 5), (3, 0, 4, 5), (4, 3, 0, 5), (1, 2, 2, 3), (2, 1, -2, 3),
        (2, -2, 1, 3), (2, 3, 6, 7), (-6, 2, 3, 7), (4, 4, 7, 9),
    )
)  # fmt: skip  # fmt: skip
CIRCLE = tuple(
    (Fraction(c, d), Fraction(s, d))
    for c, s, d in (
        (0, 1, 1),
        (3, 4, 5),
        (-1, 0, 1),
        (4, 3, 5),
        (0, -1, 1),
        (-3, 4, 5),
        (5, 12, 13),
        (-4, -3, 5),
        (8, 15, 17),
    )
)
_T = TypeVar("_T")


class RationalRandom(Random):
    """Draws numbers by a seed; where they are not `rich`, of axes, quarter turns, zeros and ones as far as possible."""

    rich = False

    def circle(self) -> tuple[Fraction, Fraction]:
        """The cosine and sine of some angle."""
        if not self.rich:
            return self.choice(CIRCLE)
        t = Fraction(self.randint(-7, 7), self.randint(1, 5))
        return (1 - t * t) / (1 + t * t), 2 * t / (1 + t * t)

    def free(self, shape: tuple[int, int]) -> Numbers:
        """A matrix without conditions."""
        rows, columns = shape
        if not self.rich and columns == 1 and rows == 3:
            axis = self.choice([*AXES, (0, 0, 0), (1, 1, 0), (1, 2, 0), (1, 0, 1), (1, 2, 3)])
            return [[Fraction(x)] for x in axis]
        reach = 5 if self.rich else 2
        return [[Fraction(self.randint(-reach, reach)) for _ in range(columns)] for _ in range(rows)]

    def spin(self, size: int) -> list[Fraction]:
        """The entries of a skew-symmetric matrix: in three dimensions, those of a vector."""
        return [row[0] for row in self.free((size * (size - 1) // 2, 1))]

    def unit_vector(self, size: int = 3) -> tuple[Fraction, ...]:
        """A column of length one."""
        if size != 3:
            return tuple(self.on_sphere(size))
        if not self.rich:
            return self.choice(UNIT_VECTORS)
        a, b = (Fraction(self.randint(-4, 4), self.randint(1, 3)) for _ in range(2))
        below = 1 + a * a + b * b
        return 2 * a / below, 2 * b / below, (below - 2) / below

    def on_sphere(self, size: int) -> list[Fraction]:
        """So many numbers whose squares add to one; what the first of them leave of it is a square too."""
        if size == 1:
            return [Fraction(self.choice((1, -1)))]
        cosine, sine = self.circle()
        return [cosine, *(sine * entry for entry in self.on_sphere(size - 1))]

    def rotation(self) -> Numbers:
        """A rotation from a quaternion of integers; half of them have rational Euler-Rodrigues parameters too."""
        reach = 3 if self.rich else 1
        while True:
            x, y, z, w = (Fraction(self.randint(-reach, reach)) for _ in range(4))
            if self.rich and self.randint(0, 1):
                w, sine = self.choice(CIRCLE)
                x, y, z = (sine * entry for entry in self.choice(UNIT_VECTORS))
            if total := x * x + y * y + z * z + w * w:
                break
        rows = [
            [w * w + x * x - y * y - z * z, 2 * (x * y - w * z), 2 * (x * z + w * y)],
            [2 * (x * y + w * z), w * w - x * x + y * y - z * z, 2 * (y * z - w * x)],
            [2 * (x * z - w * y), 2 * (y * z + w * x), w * w - x * x - y * y + z * z],
        ]
        return [[Fraction(entry, total) for entry in row] for row in rows]

    def half_turn(self) -> Numbers:
        """A symmetric rotation other than the identity."""
        u = self.unit_vector()
        return [[2 * u[i] * u[j] - (i == j) for j in range(3)] for i in range(3)]

    def definite(self, shape: tuple[int, int]) -> Numbers:
        """A symmetric, positive-definite matrix: a diagonal one, or 1 + G^T G."""
        size = shape[0]
        if not self.rich:
            return [[Fraction(self.randint(1, 3) if i == j else 0) for j in range(size)] for i in range(size)]
        g = self.free((size, size))
        return [[sum((row[i] * row[j] for row in g), Fraction(int(i == j))) for j in range(size)] for i in range(size)]


class SimpleRandom(RationalRandom):
    """Draws as a person would: the first of a list half of the time, zero and one rather than other numbers."""

    def choice(self, items: Sequence[_T]) -> _T:  # type: ignore[override]
        """An item, each half as likely as the one before it."""
        return items[self._place(len(items))]

    def randint(self, lowest: int, highest: int) -> int:
        """A whole number, each half as likely as the next smaller one."""
        numbers = sorted(range(lowest, highest + 1), key=lambda number: (abs(number), -number))
        return numbers[self._place(len(numbers))]

    def _place(self, size: int) -> int:
        place = 0
        while place < size - 1 and self.random() < 0.5:
            place += 1
        return place
