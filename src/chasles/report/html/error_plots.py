"""Errors over the angle, drawn: a kernel's and those of its formula typed as printed, near zero and near pi."""

from __future__ import annotations

from collections.abc import Sequence
from math import inf, log10
from typing import Any

from markupsafe import Markup

from chasles.exercises.drawing import blank_figure
from chasles.report.html.measured import ErrorAtAngle, ErrorCurve
from chasles.report.html.pictures import drawn, inline

MOST, LEAST = 53 * log10(2), -1.0
"""With 2^53 roundoffs no digit is right: errors that are larger are drawn there; those below a tenth, at a tenth."""
SMALLEST = 1e-20
"""Nearer than that, nothing changes."""
BLUE, RED = "#0072B2", "#D55E00"
SUPERSCRIPTS = str.maketrans("-0123456789", "⁻⁰¹²³⁴⁵⁶⁷⁸⁹")


def plotted(curves: Sequence[ErrorCurve]) -> tuple[list[tuple[Markup, str]], str]:
    """For each curve a drawing and what is said below it; without matplotlib none, and what to install."""
    try:
        return list(map(_plot, curves)), ""
    except ImportError as error:
        return [], str(error)


def _plot(curve: ErrorCurve) -> tuple[Markup, str]:
    words = _in_words(curve)
    place = f"errors-{curve.kernel.replace('_', '-')}"
    title = f"Errors of {curve.kernel} over the angle"
    return drawn(curve, place, lambda: inline(_figure(curve), place, title, words)), words


def _in_words(curve: ErrorCurve) -> str:
    """The largest errors of the two, said."""
    ours, typed = ([(getattr(place, name), place) for place in curve.places] for name in ("ours", "typed"))
    return f"{curve.title}: {_largest(ours)} as emitted, {_largest(typed)} by the formula as typed."


def _largest(errors: Sequence[tuple[float, ErrorAtAngle]]) -> str:
    lost = [place for error, place in errors if error >= 2**53]
    if not lost:
        return f"at most {max(error for error, _ in errors):.3g} u"
    at = max(lost, key=lambda place: place.small)
    small = f"{at.small:.3g}".replace("-", "\N{NON-BREAKING HYPHEN}")
    return f"no digit is right at φ = {'π − ' if at.near_pi else ''}{small}"


def _figure(curve: ErrorCurve) -> Any:
    figure = blank_figure("plots", (5.2, 2.6))
    sides = [side for side in (False, True) if any(place.near_pi is side for place in curve.places)]
    panels = figure.subplots(1, len(sides), sharey=True, squeeze=False)[0]
    for axes, side in zip(panels, sides, strict=True):
        _panel(axes, [place for place in curve.places if place.near_pi is side and place.small >= SMALLEST])
        axes.set_xlabel("π − φ" if side else "φ")
        if side:
            axes.invert_xaxis()
    panels[0].set_ylabel("error in u")
    panels[0].legend(fontsize=8, loc="best")
    return figure


def _panel(axes: Any, places: Sequence[ErrorAtAngle]) -> None:
    """Both errors over the distance from where the formula is singular, by their decimal logarithms."""
    rows = sorted(places, key=lambda place: place.small)
    distances = [log10(place.small) for place in rows]
    ours, typed = ([_height(getattr(place, name)) for place in rows] for name in ("ours", "typed"))
    for label, heights, colour, style in (("as emitted", ours, BLUE, "-"), ("as typed", typed, RED, "--")):
        axes.plot(distances, heights, style, color=colour, label=label, linewidth=1.4, marker=".", markersize=3)
    axes.set_ylim(LEAST - 0.5, MOST + 0.7)
    axes.set_yticks([0, 4, 8, 12, 16], [_power(k) for k in (0, 4, 8, 12, 16)])
    axes.grid(color="#DDDDDD")
    if rows:
        axes.xaxis.get_major_locator().set_params(integer=True, nbins=6)
        ticks = [tick for tick in axes.get_xticks() if distances[0] <= tick <= distances[-1]]
        axes.set_xticks(ticks, [_power(round(tick)) for tick in ticks])


def _height(error: float) -> float:
    return MOST if error == inf else min(MOST, max(LEAST, log10(error) if error > 0 else LEAST))


def _power(exponent: int) -> str:
    return {0: "1", 1: "10"}.get(exponent, f"10{str(exponent).translate(SUPERSCRIPTS)}")
