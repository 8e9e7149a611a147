"""Pictures: where one helps there is one, with labelled axes, at one scale, with names apart; the same each time."""

from __future__ import annotations

from itertools import combinations

import pytest
from sympy import Rational, simplify

pytest.importorskip("matplotlib")

from chasles.exact.evaluate import column_of
from chasles.exercises.drawing import drawn
from chasles.exercises.picture import Arrow, Picture, Point
from chasles.exercises.solving import solve_with
from chasles.report.notebook.html import worked
from chasles.statements.exercises import exercise_numbers

WITHOUT = ("3.8", "3.13")
WITH_PICTURE = [number for number in exercise_numbers() if number not in WITHOUT]


@pytest.mark.sampled(11)
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


@pytest.mark.sampled(3)
@pytest.mark.parametrize("number", ["3.1", "3.10", "3.12"])
def test_the_same_page_each_time(number: str) -> None:
    page = worked(solve_with(number, {}))
    assert "<svg" in page
    assert worked(solve_with(number, {})) == page


def test_the_hits_and_the_moment_are_drawn() -> None:
    solution = solve_with("3.1", {})
    dots = [item.at for item in solution.picture.items if isinstance(item, Point) and not item.label]
    assert dots == [hit for hit in solution.answers["hits"].values() if not isinstance(hit, str)]
    assert len(dots) == 3
    assert "n" in {getattr(item, "label", "") for item in solve_with("3.5", {}).picture.items}
    through = {"pi": [1, 0, 0, 0, 0, 0]}
    assert not any(isinstance(item, Arrow) for item in solve_with("3.5", through).picture.items)


@pytest.mark.parametrize(("number", "same"), [("3.17", (1, 2)), ("3.18", (0, 1))])
def test_curves_that_lie_upon_each_other(number: str, same: tuple[int, int]) -> None:
    (graph,) = solve_with(number, {}).picture.items
    one, other = (graph.curves[place][1] for place in same)
    assert simplify(one - other) == 0
    assert simplify(one) != 0


def test_names_of_near_points_stand_apart() -> None:
    places = {"A": (0, 0, 0), "B": (0, "1/40", 0), "C": (1, 1, 1)}
    points = (Point(column_of(*map(Rational, place)), name) for name, place in places.items())
    figure = drawn(Picture("Near points", tuple(points)))
    figure.canvas.draw()
    boxes = [text.get_window_extent() for text in figure.axes[0].texts]
    assert len(boxes) == 3
    assert not [pair for pair in combinations(boxes, 2) if pair[0].overlaps(pair[1])]
