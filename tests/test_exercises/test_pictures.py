"""Pictures: where one helps there is one, with labelled axes, at one scale, with names apart; the same each time."""

from __future__ import annotations

from itertools import combinations

import pytest
from sympy import Rational

pytest.importorskip("matplotlib")

from chasles.exact.drawing import drawn
from chasles.exact.evaluate import column_of
from chasles.exact.picture import Picture, Point
from chasles.exact.sheet_html import as_html
from chasles.exact.solving import solve_with

WITH_PICTURE = ["3.1", "3.2", "3.3", "3.4", "3.5", "3.6", "3.7", "3.10", "3.11", "3.12", "3.15", "3.16", "3.19", "3.20"]


@pytest.mark.sampled(3)
@pytest.mark.parametrize("number", WITH_PICTURE)
def test_labelled_axes_at_one_scale_and_names_apart(number: str) -> None:
    figure = solve_with(number, {}).figure()
    (axes,) = figure.axes
    assert axes.get_title()
    assert axes.get_xlabel()
    assert axes.get_ylabel()
    if not hasattr(axes, "get_zlim"):
        return
    assert axes.get_zlabel()
    spans = [high - low for low, high in (axes.get_xlim(), axes.get_ylim(), axes.get_zlim())]
    sides = axes._box_aspect
    assert max(d / s for d, s in zip(sides, spans, strict=True)) == pytest.approx(
        min(d / s for d, s in zip(sides, spans, strict=True))
    )
    figure.canvas.draw()
    boxes = [text.get_window_extent() for text in axes.texts]
    assert not [pair for pair in combinations(boxes, 2) if pair[0].overlaps(pair[1])]
    assert all(figure.bbox.contains(*corner) for box in boxes for corner in (box.min, box.max))


@pytest.mark.parametrize("number", ["3.1", "3.10", "3.12"])
def test_the_same_page_each_time(number: str) -> None:
    page = as_html(solve_with(number, {}))
    assert "<svg" in page
    assert as_html(solve_with(number, {})) == page


def test_names_of_near_points_stand_apart() -> None:
    places = {"A": (0, 0, 0), "B": (0, "1/40", 0), "C": (1, 1, 1)}
    points = (Point(column_of(*map(Rational, place)), name) for name, place in places.items())
    figure = drawn(Picture("Near points", tuple(points)))
    figure.canvas.draw()
    boxes = [text.get_window_extent() for text in figure.axes[0].texts]
    assert len(boxes) == 3
    assert not [pair for pair in combinations(boxes, 2) if pair[0].overlaps(pair[1])]
