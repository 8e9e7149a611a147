"""Which programs for a request are as good as the best of them? Those that lose no digits at points that it allows."""

from __future__ import annotations

from collections.abc import Sequence
from math import sqrt

import numpy as np

from chasles.lowering.program import Program
from chasles.lowering.request import Request
from chasles.lowering.rounding import ANGLES, angular_entries, generic_numbers, steady
from chasles.statements.kernel import places_of
from chasles.vocabulary import Node


def stable(request: Request, programs: Sequence[Program]) -> list[Program]:
    """The programs that lose nowhere much more than the best of them does there; all where there are no angles."""
    angles = [node for node in request.of if node in _angles(programs, request)]
    if not angles or len(programs) == 1:
        return list(programs)
    # An array is one of angles, or a rotation vector, whose length is one.
    ways = (True,) if all(node.is_scalar for node in angles) else (True, False)
    points = [_point(request, dict.fromkeys(angles, value), each) for value in ANGLES for each in ways]
    return steady(programs, {place: np.array([point[place] for point in points]) for place in points[0]})


def _angles(programs: Sequence[Program], request: Request) -> set[Node]:
    """The arguments of which some program takes a cosine or sine."""
    return {request.place(*place)[0] for program in programs for place in angular_entries(program)}


def _point(request: Request, angles: dict[Node, float], each: bool) -> dict[tuple[int, int], float]:
    """Values of the arguments: the angles as given, unit vectors of unit length, the rest at large.

    In an array of angles `each` entry is as given, or the length is.
    """
    units = {h.subjects[0] for h in request.hypotheses if h.kind == "unit"}
    values: dict[Node, list[float]] = {}
    drawn = 0
    for node in request.of:
        size = node.shape[0] * node.shape[1]
        values[node] = [float(x) for x in generic_numbers(drawn, size)]
        drawn += size
        if node in units or (node in angles and not each):
            length = sqrt(sum(x * x for x in values[node]))
            values[node] = [x / length for x in values[node]]
        if node in angles:
            values[node] = [angles[node] if each else angles[node] * x for x in values[node]]
    return {
        (number, entry): values[node][i * node.shape[1] + j]
        for number, argument in enumerate(request.arguments)
        for entry, (node, i, j) in enumerate(places_of(argument))
    }
