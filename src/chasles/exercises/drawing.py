"""Pictures drawn with matplotlib: equal aspect, labelled axes, colours that colour-blind readers tell apart."""

from __future__ import annotations

from collections.abc import Callable, Iterator
from itertools import chain, pairwise
from math import hypot, nan
from typing import Any

from sympy import lambdify

from chasles.exact.numbers import normal
from chasles.exercises.picture import Arrow, Curve, DrawnBody, Graph, Line, Picture, Point

Place = tuple[float, ...]
Segment = tuple[Place, Place]
# Okabe and Ito's palette.
BLACK, ORANGE, BLUE, GREEN, RED, GREY = "#000000", "#E69F00", "#0072B2", "#009E73", "#D55E00", "#999999"
COLOURS = (BLUE, RED, GREEN, ORANGE)
SAMPLES = 360
LABEL_REACH, LETTER = 0.005, 0.003
"""From a point to the line of a name beside it, and the width of a letter, in the units of the picture's plane."""
SIDES = ((1, 1), (1, 0), (1, -1), (0, 1), (0, -1), (-1, 1), (-1, 0), (-1, -1))


def drawn(picture: Picture) -> Any:
    """The picture as a matplotlib figure, 6 inches wide.

    Raises ImportError, with what to install, where matplotlib is missing.
    """
    figure = blank_figure("pictures", (6, 6))
    graphs = [item for item in picture.items if isinstance(item, Graph)]
    if graphs:
        _draw_graph(figure.add_subplot(), picture.title, graphs[0])
        return figure
    axes = figure.add_subplot(projection="3d")
    _Drawing(axes, picture).draw()
    return figure


def blank_figure(what: str, size: tuple[float, float]) -> Any:
    """A figure of that size in inches. Raises ImportError, which says how such pictures are drawn."""
    try:
        from matplotlib.backends.backend_agg import FigureCanvasAgg
        from matplotlib.figure import Figure
    except ImportError as error:
        raise ImportError(f"{what} are drawn by matplotlib: pip install 'chasles[plots]'") from error
    figure = Figure(figsize=size, layout="constrained")
    FigureCanvasAgg(figure)
    return figure


def _height(value: Any, at: float) -> float:
    """The value of the function there; where it has none, there is a gap in the curve."""
    try:
        return float(value(at))
    except (ZeroDivisionError, OverflowError, ValueError):
        return nan


def _draw_graph(axes: Any, title: str, graph: Graph) -> None:
    styles = ("-", "--", ":", "-.")
    first, last = graph.over
    places = [first + (last - first) * k / SAMPLES for k in range(SAMPLES + 1)]
    for place, (label, function) in enumerate(graph.curves):
        value = lambdify(graph.variable, function, "math")
        heights = [_height(value, at) for at in places]
        axes.plot(places, heights, styles[place % 4], color=COLOURS[place % 4], label=label)
    axes.set_title(title, fontsize=11, wrap=True)
    axes.set_xlabel(graph.unit)
    axes.set_ylabel("no unit")
    axes.set_ylim(graph.least, graph.most)
    axes.grid(color="#DDDDDD")
    axes.legend(fontsize=9)


class _Drawing:
    """The items on one pair of axes."""

    def __init__(self, axes: Any, picture: Picture) -> None:
        from matplotlib.patheffects import withStroke

        self.axes = axes
        self.picture = picture
        self.taken = 0
        self._halo = [withStroke(linewidth=2.5, foreground="white")]
        self.low, self.high = _box(picture)

    def draw(self) -> None:
        from matplotlib.ticker import MaxNLocator

        self.axes.set_title(self.picture.title, fontsize=11, wrap=True)
        for item in self.picture.items:
            self._item(item)
        for axis, name, low, high in zip("xyz", self.picture.axes, self.low, self.high, strict=True):
            getattr(self.axes, f"set_{axis}label")(name, labelpad=8)
            getattr(self.axes, f"set_{axis}lim")(low, high)
            getattr(self.axes, f"{axis}axis").set_major_locator(MaxNLocator(4))
        spans = [high - low for low, high in zip(self.low, self.high, strict=True)]
        self.axes.set_box_aspect(spans, zoom=0.86)
        self.axes.view_init(elev=self.picture.view[0], azim=self.picture.view[1])
        self._labels()
        if any(item.label for item in self.picture.items if not isinstance(item, Point | Graph)):
            self.axes.legend(loc="upper left", fontsize=8, framealpha=0.9)

    def _item(self, item: Any) -> None:
        match item:
            case DrawnBody(edges, label, faded):
                style = {"color": GREY if faded else BLACK, "linestyle": "--" if faded else "-", "linewidth": 1.2}
                for place, (start, end) in enumerate(edges):
                    name = {"label": label} if label and place == 0 else {}
                    self.axes.plot(*zip(_at(start), _at(end), strict=True), **style, **name)
            case Line(point, direction, label):
                ends = _clipped(_at(point), _at(direction), self.low, self.high)
                colour, width = (self._colour(), 2) if label else (GREY, 0.9)
                self.axes.plot(*zip(*ends, strict=True), color=colour, linewidth=width, label=label or None)
            case Arrow(start, vector, label):
                self.axes.quiver(*_at(start), *_at(vector), color=self._colour(), linewidth=1.8,
                                 arrow_length_ratio=0.12, label=label or None)  # fmt: skip
            case Point(at, label):
                self.axes.scatter(*([c] for c in _at(at)), color=BLACK, s=18, depthshade=False)
            case Curve(points, label):
                self.axes.plot(*zip(*map(_at, points), strict=True), color=self._colour(), label=label or None)

    def _labels(self) -> None:
        """The names of points, each on the side where it is farthest from what is drawn and from other names."""
        segments = _segments(self.picture, lambda point, way: _clipped(point, way, self.low, self.high))
        taken = [self._flat(place) for ends in segments for place in _between(*ends)]
        for item in self.picture.items:
            if not isinstance(item, Point) or not item.label:
                continue
            x, y = self._flat(_at(item.at))
            half = LETTER * len(item.label) / 2
            names = [[(x + LABEL_REACH * a + half * (a + k / 2), y + LABEL_REACH * b) for k in range(-2, 3)]
                     for a, b in SIDES]  # fmt: skip
            room = [min(hypot(u - s, v - t) for u, v in name for s, t in taken) for name in names]
            best = max(range(len(SIDES)), key=lambda k: (round(room[k], 6), -k))
            a, b = SIDES[best]
            taken += names[best]
            self.axes.annotate(
                item.label, (x, y), xytext=(6 * a, 6 * b), textcoords="offset points", fontsize=10, zorder=9,
                ha=("right", "center", "left")[a + 1], va=("top", "center", "bottom")[b + 1],
                path_effects=self._halo,
            )  # fmt: skip

    def _flat(self, place: Place) -> tuple[float, float]:
        """The place in the plane of the picture."""
        x, y, _, scale = self.axes.get_proj() @ (*place, 1.0)
        return float(x / scale), float(y / scale)

    def _colour(self) -> str:
        self.taken += 1
        return COLOURS[(self.taken - 1) % len(COLOURS)]


def _at(point: Any) -> Place:
    return tuple(float(normal(entry)) for entry in point)


def _between(start: Place, end: Place) -> list[Place]:
    """Places along a segment, close enough to keep a name off it."""
    return [tuple(a + (b - a) * k / 40 for a, b in zip(start, end, strict=True)) for k in range(41)]


def _segments(picture: Picture, ends_of: Callable[[Place, Place], Segment]) -> Iterator[Segment]:
    """The segments that are drawn; `ends_of` a line, by a point and its direction, are where it leaves the picture."""
    for item in picture.items:
        match item:
            case DrawnBody(edges):
                yield from ((_at(start), _at(end)) for start, end in edges)
            case Line(point, direction):
                yield ends_of(_at(point), _at(direction))
            case Arrow(start, vector):
                yield _at(start), tuple(a + b for a, b in zip(_at(start), _at(vector), strict=True))
            case Curve(points):
                yield from pairwise(map(_at, points))
            case Point(at):
                yield _at(at), _at(at)


def _box(picture: Picture) -> tuple[list[float], list[float]]:
    """The corners of a box around everything, a sixth of its longest side wider; no side is less than half of that."""
    columns = list(zip(*chain(*_segments(picture, lambda point, way: (point, point))), strict=True))
    longest = max(max(column) - min(column) for column in columns) or 2.0
    halves = [max(max(column) - min(column), longest / 2) / 2 + longest / 12 for column in columns]
    middles = [(max(column) + min(column)) / 2 for column in columns]
    return ([m - half for m, half in zip(middles, halves, strict=True)],
            [m + half for m, half in zip(middles, halves, strict=True)])  # fmt: skip


def _clipped(point: Place, way: Place, low: list[float], high: list[float]) -> Any:
    """The two points at which the line leaves the box."""
    spans = [
        sorted(((a - p) / w, (b - p) / w)) for p, w, a, b in zip(point, way, low, high, strict=True) if abs(w) > 1e-12
    ]
    first, last = max(span[0] for span in spans), min(span[1] for span in spans)
    return [tuple(p + s * w for p, w in zip(point, way, strict=True)) for s in (first, last)]
