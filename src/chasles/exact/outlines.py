"""The outlines of prisms and of the sections that planes make in them, for pictures."""

from __future__ import annotations

from collections.abc import Sequence
from math import atan2
from typing import Any

import sympy as sp

from chasles.exact.evaluate import matrix_of
from chasles.exact.numbers import normal, sign

__all__ = ["prism_edges", "section_of"]

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


def _angle(point: Any, corners: Sequence[Any], normal_of_plane: Any) -> float:
    """The direction of a corner as seen from the middle, in the plane; it only orders corners, to be drawn."""
    middle = sum(corners[1:], corners[0]) / len(corners)
    across = corners[0] - middle
    upward = normal_of_plane.cross(across)
    return atan2(
        float((upward.T * (point - middle))[0, 0]), float((across.T * (point - middle))[0, 0]) * _size(upward, across)
    )


def _size(one: Any, other: Any) -> float:
    return float(one.norm()) / float(other.norm())
