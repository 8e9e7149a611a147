"""Pictures drawn with matplotlib: equal aspect, labelled axes, colours that colour-blind readers tell apart."""

from __future__ import annotations

from math import nan
from typing import Any

from sympy import lambdify

from chasles.exact.numbers import normal
from chasles.exact.picture import Arrow, Body, Curve, Graph, Line, Picture, Point

__all__ = ["drawn"]

# Okabe and Ito's palette.
BLACK, ORANGE, BLUE, GREEN, RED, GREY = "#000000", "#E69F00", "#0072B2", "#009E73", "#D55E00", "#999999"
COLOURS = (BLUE, RED, GREEN, ORANGE)
SAMPLES = 360


def drawn(picture: Picture) -> Any:
    """The picture as a matplotlib figure, 6 inches wide.

    Raises ImportError, with what to install, where matplotlib is missing.
    """
    try:
        from matplotlib.backends.backend_agg import FigureCanvasAgg
        from matplotlib.figure import Figure
    except ImportError as error:
        raise ImportError("pictures are drawn by matplotlib: pip install 'chasles[plots]'") from error
    figure = Figure(figsize=(6, 6), layout="constrained")
    FigureCanvasAgg(figure)
    graphs = [item for item in picture.items if isinstance(item, Graph)]
    if graphs:
        _draw_graph(figure.add_subplot(), picture.title, graphs[0])
        return figure
    axes = figure.add_subplot(projection="3d")
    _Drawing(axes, picture).draw()
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
    axes.set_ylim(0, graph.most)
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
            getattr(self.axes, f"set_{axis}label")(name)
            getattr(self.axes, f"set_{axis}lim")(low, high)
            getattr(self.axes, f"{axis}axis").set_major_locator(MaxNLocator(5))
        self.axes.set_aspect("equal")
        self.axes.view_init(elev=22, azim=35)
        if any(item.label for item in self.picture.items if not isinstance(item, Point | Graph)):
            self.axes.legend(loc="upper left", fontsize=8, framealpha=0.9)

    def _item(self, item: Any) -> None:
        match item:
            case Body(edges, label, faded):
                style = {"color": GREY if faded else BLACK, "linestyle": "--" if faded else "-", "linewidth": 1.2}
                for place, (start, end) in enumerate(edges):
                    name = {"label": label} if label and place == 0 else {}
                    self.axes.plot(*zip(_at(start), _at(end), strict=True), **style, **name)
            case Line(point, direction, label):
                ends = _clipped(_at(point), _at(direction), self.low, self.high)
                style = {"color": self._colour(), "linewidth": 2, "label": label} if label else {"color": GREY}
                self.axes.plot(*zip(*ends, strict=True), **style)
            case Arrow(start, vector, label):
                self.axes.quiver(*_at(start), *_at(vector), color=self._colour(), linewidth=1.8,
                                 arrow_length_ratio=0.12, label=label or None)  # fmt: skip
            case Point(at, label):
                self.axes.scatter(*([c] for c in _at(at)), color=BLACK, s=18, depthshade=False)
                self.axes.text(*_at(at), f" {label}", fontsize=10, path_effects=self._halo, va="bottom", zorder=9)
            case Curve(points, label):
                self.axes.plot(*zip(*map(_at, points), strict=True), color=self._colour(), label=label or None)

    def _colour(self) -> str:
        self.taken += 1
        return COLOURS[(self.taken - 1) % len(COLOURS)]


def _at(point: Any) -> tuple[float, ...]:
    return tuple(float(normal(entry)) for entry in point)


def _points(picture: Picture) -> list[tuple[float, ...]]:
    found: list[tuple[float, ...]] = []
    for item in picture.items:
        match item:
            case Body(edges):
                found += [_at(end) for edge in edges for end in edge]
            case Line(point):
                found.append(_at(point))
            case Arrow(start, vector):
                found += [_at(start), tuple(a + b for a, b in zip(_at(start), _at(vector), strict=True))]
            case Point(at):
                found.append(_at(at))
            case Curve(points):
                found += map(_at, points)
    return found


def _box(picture: Picture) -> tuple[list[float], list[float]]:
    """The corners of a cube around everything, a third wider."""
    columns = list(zip(*_points(picture), strict=True))
    half = max(max(column) - min(column) for column in columns) * 2 / 3 or 1.0
    middles = [(max(column) + min(column)) / 2 for column in columns]
    return [m - half for m in middles], [m + half for m in middles]


def _clipped(point: tuple[float, ...], way: tuple[float, ...], low: list[float], high: list[float]) -> Any:
    """The two points at which the line leaves the box."""
    spans = [
        sorted(((a - p) / w, (b - p) / w)) for p, w, a, b in zip(point, way, low, high, strict=True) if abs(w) > 1e-12
    ]
    first, last = max(span[0] for span in spans), min(span[1] for span in spans)
    return [tuple(p + s * w for p, w in zip(point, way, strict=True)) for s in (first, last)]
