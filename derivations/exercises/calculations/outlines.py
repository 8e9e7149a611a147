"""What pictures of solids show: the outlines of prisms, the sections that planes make in them, axes in decimals."""

from __future__ import annotations

from collections.abc import Sequence
from math import atan2
from typing import Any

import mpmath
import sympy as sp

from chasles.exact.evaluate import matrix_of
from chasles.exact.numbers import decimals, normal, sign

Edge = tuple[Any, Any]


def prism_edges(polygon: Sequence[Any], height: Any) -> tuple[Edge, ...]:
    """The edges of the prism over a polygon in the plane Z = 0, each a pair of points."""
    bottom = [sp.ImmutableMatrix([*corner, 0]) for corner in polygon]
    top = [sp.ImmutableMatrix([*corner, height]) for corner in polygon]
    around = range(len(polygon))
    rims = [(ring[i - 1], ring[i]) for ring in (bottom, top) for i in around]
    return (*rims, *((bottom[i], top[i]) for i in around))


def section_of(edges: Sequence[Edge], normal_of_plane: Any, offset: Any) -> tuple[Any, ...]:
    """The corners of a convex section, in order around it and closed: where the plane meets the edges."""
    found: list[Any] = []
    for start, end in edges:
        one, other = (normal((normal_of_plane.T * point)[0, 0] - offset) for point in (start, end))
        found += [point for point, height in ((start, one), (end, other)) if height == 0]
        if sign(one) * sign(other) < 0:
            found.append(matrix_of(start + (end - start) * one / (one - other)))
    corners = list(dict.fromkeys(found))
    ordered = sorted(corners, key=lambda point: _angle(point, corners, normal_of_plane))
    return (*ordered, *ordered[:1])


def axes_to_draw(matrix: Any) -> tuple[Any, ...]:
    """Unit eigenvectors of a symmetric 3 x 3 matrix in decimals, by ascending eigenvalue: drawn, and nothing else."""
    _, vectors = mpmath.eigsy(mpmath.matrix([[mpmath.mpf(decimals(x, 20)) for x in row] for row in matrix.tolist()]))
    columns = [[sp.Rational(float(vectors[i, j])) for i in range(3)] for j in range(3)]
    return tuple(sp.ImmutableMatrix(column) * (1 if _first(column) > 0 else -1) for column in columns)


def _first(column: list[Any]) -> Any:
    return next(x for x in column if abs(x) > sp.Rational(1, 10**9))


def _angle(point: Any, corners: Sequence[Any], normal_of_plane: Any) -> float:
    """The direction of a corner as seen from the middle, in the plane; in decimals, as it only orders corners."""
    near = [sp.Matrix([float(decimals(x, 15)) for x in corner]) for corner in (*corners, point, normal_of_plane)]
    middle = sum(near[1:-2], near[0]) / len(corners)
    across, beside = near[0] - middle, near[-2] - middle
    upward = near[-1].cross(across)
    return atan2(upward.dot(beside) / upward.norm(), across.dot(beside) / across.norm())
