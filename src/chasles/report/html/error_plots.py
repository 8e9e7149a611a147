"""Errors over the angle, drawn: a kernel's and those of its formula as printed, near zero and near pi."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass
from math import inf, log10, pi
from typing import Any

from markupsafe import Markup

from chasles.report.html.measured import Curve
from chasles.report.html.pictures import inline

__all__ = ["ErrorPlot", "Plotted", "plotted"]

MOST, LEAST = 53 * log10(2), -1.0
"""With 2^53 roundoffs no digit is right: errors that are larger are drawn there; those below a tenth, at a tenth."""
FINE = 0.05
"""Points as near to pi as this are worth a panel of their own."""
BLUE, RED = "#0072B2", "#D55E00"
SUPERSCRIPTS = str.maketrans("-0123456789", "⁻⁰¹²³⁴⁵⁶⁷⁸⁹")


@dataclass(frozen=True, slots=True)
class ErrorPlot:
    """A drawing and what is said below it."""

    drawing: Markup
    caption: str


@dataclass(frozen=True, slots=True)
class Plotted:
    """Drawings, and why there are none where there should be."""

    plots: tuple[ErrorPlot, ...]
    without: tuple[str, ...]


def plotted(curves: Sequence[Curve]) -> Plotted:
    """A drawing for each curve; none where matplotlib is missing, and what to install."""
    try:
        return Plotted(tuple(map(_plot, curves)), ())
    except ImportError as error:
        return Plotted((), (str(error),))


def _plot(curve: Curve) -> ErrorPlot:
    words = _in_words(curve)
    place = f"errors-{curve.kernel.replace('_', '-')}"
    return ErrorPlot(inline(_figure(curve), place, f"Errors of {curve.kernel} over the angle", words), words)


def _in_words(curve: Curve) -> str:
    """The largest errors of the two, said."""
    return (
        f"{curve.kernel}: {_largest(curve, curve.ours)} as emitted, "
        f"{_largest(curve, curve.printed)} by the formula as printed."
    )


def _largest(curve: Curve, errors: Sequence[float]) -> str:
    worst, at = max(zip(errors, curve.phi, strict=True))
    if worst == inf or worst >= 2**53:
        return f"no digit is right at φ = {at:.3g}"
    return f"at most {worst:.3g} u"


def _figure(curve: Curve) -> Any:
    try:
        from matplotlib.backends.backend_agg import FigureCanvasAgg
        from matplotlib.figure import Figure
    except ImportError as error:
        raise ImportError("plots are drawn by matplotlib: pip install 'chasles[plots]'") from error
    near_pi = any(0 < pi - phi < FINE for phi in curve.phi)
    figure = Figure(figsize=(5.2, 2.6), layout="constrained")
    FigureCanvasAgg(figure)
    panels = figure.subplots(1, 1 + near_pi, sharey=True, squeeze=False)[0]
    rows = sorted(zip(curve.phi, curve.ours, curve.printed, strict=True))
    _panel(panels[0], [row for row in rows if 0 < row[0] <= pi / 2 or (row[0] > 0 and not near_pi)], "φ")
    if near_pi:
        _panel(panels[1], [(pi - phi, *errors) for phi, *errors in rows if pi / 2 < phi < pi], "π − φ")
        panels[1].invert_xaxis()
    panels[0].set_ylabel("error in u")
    panels[0].legend(fontsize=8, loc="best")
    return figure


def _panel(axes: Any, rows: Sequence[tuple[float, ...]], name: str) -> None:
    """Both errors over the distance from where the formula is singular, by their decimal logarithms."""
    places = [log10(row[0]) for row in rows]
    for k, (label, colour, style) in enumerate((("as emitted", BLUE, "-"), ("as printed", RED, "--")), 1):
        heights = [_height(row[k]) for row in rows]
        axes.plot(places, heights, style, color=colour, label=label, linewidth=1.4, marker=".", markersize=3)
    axes.set_xlabel(name)
    axes.set_ylim(LEAST - 0.5, MOST + 0.7)
    axes.set_yticks([0, 4, 8, 12, 16], [_power(k) for k in (0, 4, 8, 12, 16)])
    axes.grid(color="#DDDDDD")
    if places:
        axes.xaxis.get_major_locator().set_params(integer=True, nbins=6)
        ticks = [tick for tick in axes.get_xticks() if min(places) <= tick <= max(places)]
        axes.set_xticks(ticks, [_power(round(tick)) for tick in ticks])


def _height(error: float) -> float:
    return MOST if error == inf else min(MOST, max(LEAST, log10(error) if error > 0 else LEAST))


def _power(exponent: int) -> str:
    return {0: "1", 1: "10"}.get(exponent, f"10{str(exponent).translate(SUPERSCRIPTS)}")
