"""The mass moments of homogeneous bodies of unit density: volume, first and second moments, as numbers that add.

The numbers are of any field: they are added, multiplied and divided, and nothing else is asked of them.
"""

from __future__ import annotations

from dataclasses import dataclass
from typing import Any, TypeAlias

Number: TypeAlias = Any  # SymPy's domain elements, surds, fractions: whatever divides exactly
Vector: TypeAlias = tuple[Number, ...]
Square: TypeAlias = tuple[tuple[Number, ...], ...]

AXES = range(3)


@dataclass(frozen=True, slots=True)
class Moments:
    """Integrals over a body of unit density about the origin: of 1 (m^3), x (m^4), and x x^T (m^5)."""

    volume: Number
    first: Vector
    second: Square

    def __add__(self, other: Moments) -> Moments:
        return Moments(
            self.volume + other.volume,
            tuple(one + another for one, another in zip(self.first, other.first, strict=True)),
            tuple(
                tuple(one + another for one, another in zip(row, other_row, strict=True))
                for row, other_row in zip(self.second, other.second, strict=True)
            ),
        )

    def moved(self, by: Vector) -> Moments:
        """The moments, about the same origin, of the body after the translation `by` (m)."""
        return Moments(
            self.volume,
            tuple(self.first[i] + self.volume * by[i] for i in AXES),
            tuple(
                tuple(
                    self.second[i][j] + self.first[i] * by[j] + by[i] * self.first[j] + self.volume * by[i] * by[j]
                    for j in AXES
                )
                for i in AXES
            ),
        )

    def stretched(self, factors: Vector) -> Moments:
        """The moments of the body after its coordinates are multiplied by positive factors, one for each axis."""
        volume = factors[0] * factors[1] * factors[2]
        return Moments(
            volume * self.volume,
            tuple(volume * factors[i] * self.first[i] for i in AXES),
            tuple(tuple(volume * factors[i] * factors[j] * self.second[i][j] for j in AXES) for i in AXES),
        )


def of_tetrahedron(a: Vector, b: Vector, c: Vector) -> Moments:
    """The signed moments of the tetrahedron with one corner at the origin; positive where a, b, c are right-handed."""
    volume = (
        a[0] * (b[1] * c[2] - b[2] * c[1]) + a[1] * (b[2] * c[0] - b[0] * c[2]) + a[2] * (b[0] * c[1] - b[1] * c[0])
    ) / 6
    total = tuple(a[i] + b[i] + c[i] for i in AXES)
    return Moments(
        volume,
        tuple(volume * x / 4 for x in total),
        tuple(
            tuple(volume * (total[i] * total[j] + a[i] * a[j] + b[i] * b[j] + c[i] * c[j]) / 20 for j in AXES)
            for i in AXES
        ),
    )


def sum_of(parts: list[Moments], zero: Number) -> Moments:
    """The moments of all parts together; `zero` is that of their field."""
    total = Moments(zero, (zero,) * 3, ((zero,) * 3,) * 3)
    for part in parts:
        total = total + part
    return total
