"""Bodies by their exact mass moments, in the numbers of exercises: prisms, their parts, point masses."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass
from itertools import chain
from typing import Any

import sympy as sp
from chasles.derivations.exercises.calculations.moments import Moments
from chasles.derivations.exercises.calculations.solids import Plane, prism
from chasles.derivations.exercises.calculations.surds import SurdField

from chasles.exact.evaluate import column_of, matrix_of
from chasles.exact.grounds import NotDecided
from chasles.exact.numbers import is_zero, normal
from chasles.exact.tower_elements import independent_atoms

MOST_ROOTS, MOST_ROOTS_BESIDE = 4, 3
"""Square roots, that of three among them, with which a cut prism takes seconds: alone, and beside others."""
HIGHEST_POWER = 8


@dataclass(frozen=True, slots=True)
class Body:
    """Integrals over a body: of 1, of x, of x x^T, each times the density, about the origin."""

    mass: Any
    first: Any
    second: Any

    @property
    def inertia(self) -> Any:
        """The integral of |x|^2 1 - x x^T about the origin."""
        return _inertia(self.second)

    @property
    def centroidal_inertia(self) -> Any:
        """The same about the center of mass."""
        return _inertia(matrix_of(self.second - self.first * self.first.T / self.mass))


def regular_hexagon(side: Any) -> tuple[Any, ...]:
    """The corners (x, y), counter-clockwise about the origin, two opposite ones on the X axis."""
    turns = [sp.pi * k / 3 for k in range(6)]
    return tuple(column_of(side * sp.cos(turn), side * sp.sin(turn)) for turn in turns)


def whole_prism(polygon: Sequence[Any], height: Any) -> Body:
    """The right prism of unit density over a polygon in the plane Z = 0.

    Raises ValueError for a polygon that is not simple and a height that is not positive, NotDecided for coordinates
    that square roots do not express.
    """
    field = SurdField(height, *chain(*polygon))
    corners = [tuple(map(field, corner)) for corner in polygon]
    return _body(field, prism(corners, field(height), field.sign).moments())


def cut_prism(
    polygon: Sequence[Any], height: Any, normal_of_plane: Any, offset: Any, factors: Sequence[Any] = (1, 1, 1)
) -> tuple[Body, Body]:
    """The parts of the prism with normal . x below the offset and above it; raises as `whole_prism` does.

    Their coordinates are multiplied by positive factors afterwards, one for each axis.
    """
    field = SurdField(height, offset, *normal_of_plane, *chain(*polygon), *map(sp.sympify, factors))
    corners = [tuple(map(field, corner)) for corner in polygon]
    plane = Plane(tuple(map(field, normal_of_plane)), field(offset))
    below, above = prism(corners, field(height), field.sign).cut(plane, field.sign)
    scale = tuple(field(sp.sympify(factor)) for factor in factors)
    return _body(field, below.stretched(scale)), _body(field, above.stretched(scale))


def cut_hexagonal_prism(side: Any, height: Any, slope: Any) -> tuple[Body, Body]:
    """The parts of the prism over the regular hexagon below and above the plane Z = slope (Y + (sqrt(3)/2) side).

    They are those of a prism with corners at integers, stretched, where one number tells how steep the plane is.
    NotDecided where more than one independent number stands beside the square roots: what is made of two grows long.
    """
    atoms = independent_atoms(side, height, slope)
    if atoms is None or len(atoms) > 1:
        strangers = "sines and cosines" if atoms is None else " and ".join(map(str, atoms))
        raise NotDecided(f"{strangers}: only one number that square roots do not express can be handled here")
    field = SurdField(side, height, slope)
    for number in (side, height, slope, sp.sqrt(3)):
        field(number)
    powers = [int(abs(power.exp)) for number in (side, height, slope) for power in number.atoms(sp.Pow)]
    if atoms and max(powers, default=1) > HIGHEST_POWER:
        raise NotDecided(f"powers above {HIGHEST_POWER} of {atoms[0]} grow too long")
    if len(field.tower.radicands) > (MOST_ROOTS_BESIDE if atoms else MOST_ROOTS):
        raise NotDecided("the sizes and the angle have too many different square roots in them")
    hexagon = [column_of(*corner) for corner in ((2, 0), (1, 1), (-1, 1), (-2, 0), (-1, -1), (1, -1))]
    steep = normal(sp.sqrt(3) * slope * side / (2 * height))
    scale = (side / 2, sp.sqrt(3) * side / 2, height)
    return cut_prism(hexagon, sp.Integer(1), column_of(0, -steep, 1), steep, scale)


def point_masses(mass: Any, points: Sequence[Any]) -> Body:
    """Equal masses at some points."""
    together = matrix_of(sp.Matrix.hstack(*points))
    total = matrix_of(mass * together * together.T)
    return Body(normal(mass * len(points)), matrix_of(mass * together * sp.ones(len(points), 1)), total)


def joined(one: Body, other: Body) -> Body:
    """Both bodies as one."""
    return Body(normal(one.mass + other.mass), matrix_of(one.first + other.first), matrix_of(one.second + other.second))


def cotangent_of_degrees(angle: Any) -> Any:
    """The cotangent of an angle given in degrees, between 0 and 90.

    Square roots express it for multiples of 3 degrees, and whenever those of the tangent do; else it stays as it is.
    """
    return normal(sp.cot(normal(angle * sp.pi / 180)))


def tangent_of_double_angle(inertia: Any) -> Any:
    """2 I_yz / (I_yy - I_zz), for the angle of the principal axes in the YZ plane; a word where it has no value."""
    difference = normal(inertia[1, 1] - inertia[2, 2])
    if not is_zero(difference):
        return normal(2 * inertia[1, 2] / difference)
    return "undetermined" if is_zero(inertia[1, 2]) else "infinite"


def _inertia(second: Any) -> Any:
    return matrix_of(second.trace() * sp.eye(3) - second)


def _body(field: SurdField, moments: Moments) -> Body:
    def read(x: Any) -> Any:
        return normal(field.expression(x))

    return Body(
        read(moments.volume),
        column_of(*map(read, moments.first)),
        matrix_of([[read(x) for x in row] for row in moments.second]),
    )
