"""Prisms over polygons, and their parts on either side of a plane: exact mass moments.

A solid is its faces, each a loop of corners that runs counter-clockwise as seen from outside. The moments are a sum
over signed tetrahedra from one apex. For a part cut off by a plane the apex lies in that plane: the face that the cut
makes then adds nothing and need not be found, however many pieces it has.

Only the signs of numbers decide a case. With symbols in the data they are those at a sample, and the result holds
wherever the same numbers have the same signs.
"""

from __future__ import annotations

from collections.abc import Callable, Sequence
from dataclasses import dataclass

from chasles.derivations.exercises.calculations.moments import Moments, Number, Vector, of_tetrahedron, sum_of
from chasles.derivations.exercises.calculations.polygons import Sign, counter_clockwise

Face = tuple[Vector, ...]


@dataclass(frozen=True, slots=True)
class Plane:
    """The points x with normal . x = offset (m times the unit of the normal, which need not be of unit length)."""

    normal: Vector
    offset: Number

    def height(self, point: Vector) -> Number:
        """Normal . x - offset: negative below the plane, positive above."""
        return sum((n * x for n, x in zip(self.normal, point, strict=True)), -self.offset)


@dataclass(frozen=True, slots=True)
class Solid:
    """A body of unit density bounded by flat faces, each counter-clockwise as seen from outside."""

    faces: tuple[Face, ...]

    def moments(self) -> Moments:
        """The moments about the origin of the frame in which the corners are given."""
        return _from_apex(self.faces, self.faces[0][0])

    def cut(self, plane: Plane, sign: Sign) -> tuple[Moments, Moments]:
        """The moments of the part below the plane (against its normal) and of the part above it.

        A part that the plane leaves empty has the moments zero. ValueError if the plane's normal is zero.
        """
        apex = _point_of(plane, sign)
        below = tuple(_clipped(face, plane.height, sign) for face in self.faces)
        above = tuple(_clipped(face, lambda x: -plane.height(x), sign) for face in self.faces)
        return _from_apex(below, apex), _from_apex(above, apex)


def prism(polygon: Sequence[Vector], height: Number, sign: Sign) -> Solid:
    """The right prism over a simple polygon in the plane Z = 0 (corners x, y in m, either way round) up to Z = height.

    ValueError, with what is wrong, for a polygon that crosses or touches itself or has no area, or a height that is
    not positive.
    """
    if sign(height) <= 0:
        raise ValueError("the height of a prism must be positive")
    corners = counter_clockwise(polygon, sign)
    zero = height - height
    bottom = [(x, y, zero) for x, y in corners]
    top = [(x, y, height) for x, y in corners]
    around = range(len(corners))
    sides = [(bottom[i - 1], bottom[i], top[i], top[i - 1]) for i in around]
    return Solid((tuple(reversed(bottom)), tuple(top), *sides))


def _from_apex(faces: Sequence[Face], apex: Vector) -> Moments:
    """The moments about the origin, summed over the tetrahedra from the apex to each triangle of each face's fan."""
    zero = apex[0] - apex[0]
    parts = []
    for face in faces:
        seen = [tuple(x - a for x, a in zip(corner, apex, strict=True)) for corner in face]
        parts += [of_tetrahedron(seen[0], seen[i], seen[i + 1]) for i in range(1, len(seen) - 1)]
    return sum_of(parts, zero).moved(apex)


def _clipped(face: Face, height: Callable[[Vector], Number], sign: Sign) -> Face:
    """The part of a face where the height is not positive.

    Where a face that is not convex falls into pieces, these stay joined along the plane, back and forth: what lies
    between cancels in every integral.
    """
    heights = [height(corner) for corner in face]
    signs = [sign(value) for value in heights]
    kept: list[Vector] = []
    for i, corner in enumerate(face):
        if signs[i - 1] * signs[i] < 0:
            share = heights[i - 1] / (heights[i - 1] - heights[i])
            kept.append(tuple(a + share * (b - a) for a, b in zip(face[i - 1], corner, strict=True)))
        if signs[i] <= 0:
            kept.append(corner)
    return tuple(kept)


def _point_of(plane: Plane, sign: Sign) -> Vector:
    """A point of the plane: where it meets the first coordinate axis to which it is not parallel."""
    zero = plane.offset - plane.offset
    for axis, component in enumerate(plane.normal):
        if sign(component):
            return tuple(plane.offset / component if i == axis else zero for i in range(3))
    raise ValueError("the normal of the cutting plane must not be zero")
