"""Polygons in the plane with exact corners: which way round they run, and whether they cross themselves."""

from __future__ import annotations

from collections.abc import Callable, Sequence
from itertools import combinations
from typing import TypeAlias

from chasles.derivations.exercises.calculations.moments import Number, Vector

Sign: TypeAlias = Callable[[Number], int]


def twice_the_area(polygon: Sequence[Vector]) -> Number:
    """Twice the signed area (m^2): positive where the corners run counter-clockwise."""
    terms = [_turn(polygon[0], polygon[i], polygon[i + 1]) for i in range(1, len(polygon) - 1)]
    return sum(terms[1:], terms[0])


def counter_clockwise(polygon: Sequence[Vector], sign: Sign) -> tuple[Vector, ...]:
    """The corners counter-clockwise; ValueError, with what is wrong, unless the polygon is simple and has an area."""
    corners = tuple(tuple(corner) for corner in polygon)
    if len(corners) < 3 or any(len(corner) != 2 for corner in corners):
        raise ValueError("a polygon needs at least three corners, each with two coordinates")
    edges = [(corners[i - 1], corners[i]) for i in range(len(corners))]
    for i, (start, end) in enumerate(edges):
        if not any(sign(b - a) for a, b in zip(start, end, strict=True)):
            raise ValueError(f"the corners {len(corners) if i == 0 else i} and {i + 1} of the polygon coincide")
    for i, j in combinations(range(len(edges)), 2):
        if _conflict(edges[i], edges[j], j == i + 1, (i, j) == (0, len(edges) - 1), sign):
            raise ValueError(f"the edges that end in the corners {i + 1} and {j + 1} of the polygon cross or touch")
    # A simple polygon has an area: two edges at least would overlap otherwise.
    return corners if sign(twice_the_area(corners)) > 0 else tuple(reversed(corners))


def _turn(a: Vector, b: Vector, c: Vector) -> Number:
    """Positive where c lies to the left of the line from a to b."""
    return (b[0] - a[0]) * (c[1] - a[1]) - (b[1] - a[1]) * (c[0] - a[0])


def _conflict(
    one: tuple[Vector, Vector], other: tuple[Vector, Vector], is_next: bool, is_previous: bool, sign: Sign
) -> bool:
    """Whether two edges share a point other than the corner that neighbours have in common."""
    if is_next and _folds_back(one[1], one[0], other[1], sign):
        return True
    if is_previous and _folds_back(one[0], one[1], other[0], sign):
        return True
    if is_next or is_previous:
        return False
    (a, b), (c, d) = one, other
    sides = [sign(_turn(*three)) for three in ((a, b, c), (a, b, d), (c, d, a), (c, d, b))]
    if sides[0] * sides[1] < 0 and sides[2] * sides[3] < 0:
        return True
    threes = ((a, b, c), (a, b, d), (c, d, a), (c, d, b))
    return any(side == 0 and _between(*three, sign) for side, three in zip(sides, threes, strict=True))


def _folds_back(corner: Vector, one: Vector, other: Vector, sign: Sign) -> bool:
    """Whether the edges from a corner to two others lie upon each other."""
    forward = sum((p - c) * (q - c) for p, q, c in zip(one, other, corner, strict=True))
    return sign(_turn(corner, one, other)) == 0 and sign(forward) > 0


def _between(a: Vector, b: Vector, on: Vector, sign: Sign) -> bool:
    """Whether a point of the line through a and b lies on the segment between them."""
    return sign(sum((p - x) * (q - x) for p, q, x in zip(a, b, on, strict=True))) <= 0
