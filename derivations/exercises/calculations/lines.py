"""Lines in space, exactly: directions of length one that solve linear equations, intersections with planes."""

from __future__ import annotations

from typing import Any

from chasles.exact.evaluate import matrix_of
from chasles.exact.linear import Solutions
from chasles.exact.numbers import is_zero, normal, root, sign


def unit_vectors_of(found: Solutions) -> tuple[Any, ...] | None:
    """The solutions of length one, none, one or two of them; None where there are infinitely many candidates.

    |x + s w|^2 = 1 is quadratic in s; of two solutions the one with the larger s comes first.
    """
    if not found.exist:
        return ()
    if found.unique:
        return (found.one,) if is_zero(_dot(found.one, found.one) - 1) else ()
    if len(found.directions) > 1:
        return None
    x, (w,) = found.one, found.directions
    squared, mixed, rest = _dot(w, w), _dot(x, w), normal(_dot(x, x) - 1)
    discriminant = normal(mixed**2 - squared * rest)
    if sign(discriminant) < 0:
        return ()
    half = root(discriminant)
    turns = (half, -half) if not is_zero(half) else (half,)
    return tuple(matrix_of(x + w * normal((turn - mixed) / squared)) for turn in turns)


def meets_plane(point: Any, direction: Any, axis: int) -> Any:
    """Where the line meets the plane on which that coordinate is zero: the point, "parallel" or "contained"."""
    if is_zero(direction[axis]):
        return "contained" if is_zero(point[axis]) else "parallel"
    return matrix_of(point - direction * normal(point[axis] / direction[axis]))


def direction_of(*vectors: Any) -> Any:
    """The first of the vectors that is not zero, divided by its length; None if all are zero."""
    for vector in vectors:
        length = root(_dot(vector, vector))
        if not is_zero(length):
            return matrix_of(vector / length)
    return None


def normal_to(vector: Any) -> Any:
    """A unit vector at right angles to the vector, which is not zero; its first entry that is not zero is positive."""
    for axis in range(3):
        unit = matrix_of([[int(k == axis)] for k in range(3)])
        found = direction_of(vector.cross(unit))
        if found is not None:
            first = next(entry for entry in found if not is_zero(entry))
            return matrix_of(found * sign(first))
    raise ValueError("the zero vector has no normal")


def _dot(one: Any, other: Any) -> Any:
    return normal((one.T * other)[0, 0])
