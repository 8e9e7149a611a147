"""Lines in space, exactly: directions of length one that solve linear equations, intersections with planes."""

from __future__ import annotations

from typing import Any

from chasles.exact.evaluate import matrix_of
from chasles.exact.linear import Solutions
from chasles.exact.numbers import is_zero, normal, root, sign

__all__ = ["meets_plane", "unit_vectors_of"]


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


def _dot(one: Any, other: Any) -> Any:
    return normal((one.T * other)[0, 0])
