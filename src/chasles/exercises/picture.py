"""A picture of a solution as data: bodies, lines, arrows and points in space, in exact coordinates."""

from __future__ import annotations

from dataclasses import dataclass
from typing import Any


@dataclass(frozen=True, slots=True)
class DrawnBody:
    """A polyhedron by its edges, each a pair of points; one that is `faded` is where it was before."""

    edges: tuple[tuple[Any, Any], ...]
    label: str = ""
    faded: bool = False


@dataclass(frozen=True, slots=True)
class Line:
    """A line through a point along a direction, drawn as long as the picture."""

    point: Any
    direction: Any
    label: str = ""


@dataclass(frozen=True, slots=True)
class Arrow:
    """A vector that begins at a point."""

    start: Any
    vector: Any
    label: str = ""


@dataclass(frozen=True, slots=True)
class Point:
    """A point with its name."""

    at: Any
    label: str = ""


@dataclass(frozen=True, slots=True)
class Curve:
    """Points joined in their order."""

    points: tuple[Any, ...]
    label: str = ""


@dataclass(frozen=True, slots=True)
class Graph:
    """Functions of one variable, each with its label; `unit` says what the variable is, which runs over a range.

    They are drawn from the `least` value to the `most`; from the least and to the most there are, where it is None.
    """

    unit: str
    variable: Any
    over: tuple[int, int]
    curves: tuple[tuple[str, Any], ...]
    most: int | None = None
    least: int | None = 0


@dataclass(frozen=True, slots=True)
class Picture:
    """What is drawn, with a title, the names of the axes and where it is seen from; a graph stands alone.

    `view` is elevation and azimuth in degrees.
    """

    title: str
    items: tuple[DrawnBody | Line | Arrow | Point | Curve | Graph, ...]
    axes: tuple[str, str, str] = ("X", "Y", "Z")
    view: tuple[int, int] = (22, 35)
