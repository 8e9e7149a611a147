"""Exercises 3.3, 3.5 and 3.7: known lines are found again; contradictions and ambiguities are told."""

from __future__ import annotations

from random import Random

import pytest
import sympy as sp

from chasles.exercises.data import DataError
from chasles.exercises.solving import solve

from .known import plain, rational, same, unit, vector


def known_line(draw: Random) -> tuple[sp.Matrix, sp.Matrix]:
    """A direction and the point nearest the origin."""
    e, somewhere = unit(draw), vector(draw)
    return e, somewhere - e * somewhere.dot(e)


@pytest.mark.parametrize("seed", range(8))
def test_a_known_line_from_its_coordinates(seed: int) -> None:
    e, p = known_line(Random(seed))
    solution = solve("3.5", pi=plain(sp.Matrix([e, p.cross(e)])))
    assert solution.status == "line"
    assert same(solution.answers["p"], p)
    assert same(solution.answers["d"], sp.sqrt(p.dot(p)))


def test_the_default_line() -> None:
    assert solve("3.5").as_data()["answers"] == {"d": "sqrt(2)", "p": ["1", "0", "1"]}


@pytest.mark.parametrize(
    ("pi", "status"),
    [
        ([1, 0, 0, 1, 0, 0], "not-a-line"),
        ([0, 0, 0, 0, 1, 0], "not-a-line"),
        ([0, 0, 0, 0, 0, 0], "not-a-line"),
        ([2, 0, 0, 0, 1, 0], "not-normalised"),
        (["sqrt(2)/2", "sqrt(2)/2", 0, 0, 0, "1/10^20"], "line"),
        (["sqrt(2)/2", "sqrt(2)/2 + 1/10^20", 0, 0, 0, 1], "not-normalised"),
    ],
)
def test_what_is_no_normalised_line(pi: list, status: str) -> None:
    assert solve("3.5", pi=pi).status == status


def test_a_multiple_of_coordinates_is_of_the_same_line() -> None:
    answers = solve("3.5", pi=[3, 0, 4, 0, 10, 0]).answers
    assert (plain(answers["d"]), plain(answers["p"])) == ("2", ["-8/5", "0", "6/5"])


@pytest.mark.parametrize("seed", range(12))
def test_a_known_line_from_two_moments(seed: int) -> None:
    draw = Random(seed)
    e, p = known_line(draw)
    a, b = vector(draw), vector(draw)
    n_A, n_B = (p - a).cross(e), (p - b).cross(e)
    solution = solve("3.7", a=plain(a), b=plain(b), nA=plain(n_A), nB=plain(n_B))
    if n_A.dot(a - b) != 0:
        assert solution.status == "compatible"
        assert same(solution.answers["e"], e)
        assert same(solution.answers["p"], p)
        assert same(solution.answers["n0"], p.cross(e))
        assert same(solution.answers["d"], sp.sqrt(p.dot(p)))
    else:
        assert solution.status in ("compatible", "ambiguous")


def test_the_default_of_two_moments() -> None:
    answers = solve("3.7").as_data()["answers"]
    assert answers == {"e": ["1", "0", "0"], "p": ["0", "0", "2"], "n0": ["0", "2", "0"], "d": "2"}


@pytest.mark.parametrize("seed", range(6))
def test_two_lines_may_have_the_same_moments(seed: int) -> None:
    """If the line is in one plane with A and B, another one has the same moments about both."""
    draw = Random(seed)
    e, p = known_line(draw)
    a = vector(draw)
    b = a + (p + rational(draw) * e - a) * 3
    moments = {"nA": plain((p - a).cross(e)), "nB": plain((p - b).cross(e))}
    solution = solve("3.7", a=plain(a), b=plain(b), **moments)
    if solution.status == "ambiguous":
        candidates = list(zip(solution.answers["e_candidates"], solution.answers["p_candidates"], strict=True))
        assert any(same(one, e) and same(point, p) for one, point in candidates)
        for one, point in candidates:
            assert same((point - a).cross(one), (p - a).cross(e))
            assert same((point - b).cross(one), (p - b).cross(e))
    else:
        assert solution.status == "compatible"
        assert same(solution.answers["e"], e)


@pytest.mark.parametrize(
    ("data", "violated"),
    [
        ({"nB": [0, 1, 3]}, "moments_share_a_component"),
        ({"nB": [0, 2, 0]}, "direction_is_unit"),
        ({"a": [0, 0, 0], "b": [0, 0, 1], "nA": [1, 0, 0], "nB": [1, "1/2", 0]}, "moment_is_normal"),
        ({"a": [0, 0, 0], "b": [0, 0, 1], "nA": [1, 0, 0], "nB": [1, 2, 0]}, "moment_is_normal"),
        ({"b": [1, 0, 0]}, "moments_about_two_points"),
        ({"a": [0, 0, 0], "b": [0, 0, 1], "nA": [0, 0, 0], "nB": [2, 0, 0]}, "direction_is_unit"),
    ],
)
def test_moments_that_contradict_each_other(data: dict, violated: str) -> None:
    solution = solve("3.7", **data)
    assert solution.status == "incompatible"
    assert solution.answers["violated"] == [violated]


def test_moments_about_one_point_leave_the_direction_open() -> None:
    solution = solve("3.7", a=[1, 0, 0], b=[1, 0, 0], nB=[0, 2, 0])
    assert solution.status == "ambiguous"
    assert "normal to n_A" in solution.answers["e_candidates"]


def ruling(draw: Random) -> tuple[list, sp.Matrix, sp.Matrix]:
    """Three lines of one hyperboloid, in an affine frame: the frame's matrix and its origin."""
    while True:
        frame, origin = sp.Matrix(3, 3, lambda i, j: draw.randint(-2, 2)), vector(draw)
        if frame.det() != 0:
            break
    turns = [(1, 0), (sp.Rational(3, 5), sp.Rational(4, 5)), (0, -1)]
    lines = []
    for c, s in turns:
        size = draw.choice([1, 2, -1])
        lines.append([plain(origin + frame * sp.Matrix([c, s, 0])), plain(size * frame * sp.Matrix([-s, c, 1]))])
    return lines, frame, origin


@pytest.mark.sampled(3)
@pytest.mark.parametrize("seed", range(6))
def test_a_known_hyperboloid(seed: int) -> None:
    draw = Random(seed)
    lines, frame, origin = ruling(draw)
    solution = solve("3.3", lines=lines)
    answers = solution.answers
    assert (solution.status, answers["kind"]) == ("quadric", "one-sheet hyperboloid")
    assert same(answers["centre"], origin)
    x = frame.inv().T * sp.diag(1, 1, -1) * frame.inv()
    factor = next(answers["M"][k] / x[k] for k in range(9) if x[k] != 0)
    assert same(answers["M"], x * factor)
    assert same(answers["f_centre"], -factor)
    assert same(answers["signature_M"], [2, 1] if factor > 0 else [1, 2])
    assert same(answers["det_M"], sp.Matrix(answers["M"]).det())
    assert answers["wording"]["det(M) < 0"] == bool(answers["det_M"] < 0)


X, Y, Z = [1, 0, 0], [0, 1, 0], [0, 0, 1]
O = [0, 0, 0]


@pytest.mark.parametrize(
    ("lines", "status", "kind"),
    [
        ([[[k, 0, 0], [0, 1, k]] for k in (0, 1, 3)], "quadric", "hyperbolic paraboloid"),
        ([[O, X], [O, Y], [Z, [1, 1, 0]]], "degenerate", "two intersecting planes"),
        ([[O, X], [O, Y], [[5, 5, 1], [0, 1, 1]]], "degenerate", "two intersecting planes"),
        ([[O, X], [Y, X], [Z, Y]], "degenerate", "two parallel planes"),
        ([[O, X], [O, Y], [O, Z]], "degenerate", "all of space"),
        ([[O, X], [Y, X], [Z, X]], "degenerate", "all of space"),
        ([[O, X], [X, Y], [Y, [1, 1, 0]]], "degenerate", "one plane, counted twice"),
        ([[O, X], [[2, 0, 0], [3, 0, 0]], [Z, Y]], "degenerate", "all of space"),
    ],
)
def test_kinds_of_surfaces(lines: list, status: str, kind: str) -> None:
    solution = solve("3.3", lines=lines)
    assert (solution.status, solution.answers["kind"]) == (status, kind)


def test_malformed_lines() -> None:
    with pytest.raises(DataError, match=r"lines\[2\], direction: expected a vector other than zero"):
        solve("3.3", lines=[[[0, 0, 0], [1, 0, 0]], [[0, 0, 0], [0, 0, 0]], [[0, 0, 0], [1, 0, 1]]])
    with pytest.raises(DataError, match="lines: expected 3 entries, and got 1"):
        solve("3.3", lines=[[[0, 0, 0], [1, 0, 0]]])
