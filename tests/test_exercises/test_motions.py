"""Exercises 3.1 and 3.6: known screws are found again, and what is no motion is said to be none."""

from __future__ import annotations

from random import Random

import pytest
import sympy as sp

from chasles.exercises.data import DataError
from chasles.exercises.solving import solve

from .known import Motion, motion, plain, rational, same, vector

CORNERS = {"A": (0, 0, 0), "B": (1, 0, 0), "D": (0, 1, 0), "E": (0, 0, 1)}


def cube(draw: Random) -> dict[str, sp.Matrix]:
    """A cube of any size, turned and moved anyhow."""
    placed, size = motion(draw), abs(rational(draw)) + 1
    return {name: placed.moved(size * sp.Matrix(at)) for name, at in CORNERS.items()}


def data(corners: dict[str, sp.Matrix]) -> dict[str, object]:
    return {name: plain(at) for name, at in corners.items()}


def is_found(answers: dict, known: Motion) -> None:
    assert same(answers["Q"], known.Q)
    assert same(answers["e"], known.e)
    assert same(sp.cos(answers["phi"]), known.cosine)
    assert same(answers["p0"], known.p0)
    assert same(answers["n"], known.p0.cross(known.e))
    assert same(answers["d0"], known.d0)
    assert same(answers["pitch"] * answers["phi"], known.d0)


@pytest.mark.sampled(3)
@pytest.mark.parametrize("half_turn", [False, True])
@pytest.mark.parametrize("seed", range(6))
def test_a_known_screw_of_a_cube(seed: int, half_turn: bool) -> None:
    draw = Random(seed)
    before, known = cube(draw), motion(draw, half_turn)
    after = {name: known.moved(at) for name, at in before.items()}
    solution = solve("3.1", before=data(before), after=data(after))
    assert solution.status == "screw"
    is_found(solution.answers, known)
    for k, plane in enumerate(("X=0", "Y=0", "Z=0")):
        hit = solution.answers["hits"][plane]
        if known.e[k] == 0:
            assert hit == ("contained" if known.p0[k] == 0 else "parallel")
        else:
            assert hit[k] == 0
            assert same((hit - known.p0).cross(known.e), sp.zeros(3, 1))


def test_the_default_of_the_cube() -> None:
    answers = solve("3.1").as_data()["answers"]
    assert answers["phi"] == "2*pi/3"
    assert answers["p0"] == ["2/3", "0", "-2/3"]
    assert answers["d0"] == "2*sqrt(3)/3"
    assert answers["hits"] == {"X=0": ["0", "-2/3", "-4/3"], "Y=0": ["2/3", "0", "-2/3"], "Z=0": ["4/3", "2/3", "0"]}


@pytest.mark.parametrize("seed", range(3))
def test_a_translation_has_no_axis(seed: int) -> None:
    draw = Random(seed)
    before, way = cube(draw), vector(draw) * int(seed > 0)
    solution = solve("3.1", before=data(before), after=data({name: at + way for name, at in before.items()}))
    assert solution.status == "pure-translation"
    assert solution.answers["phi"] == 0
    assert solution.answers["e"] is None


@pytest.mark.parametrize("change", [sp.diag(1, 1, -1), sp.diag(2, 2, 2), sp.Matrix([[1, 1, 0], [0, 1, 0], [0, 0, 1]])])
def test_what_is_no_rotation_is_told(change: sp.Matrix) -> None:
    known = motion(Random(3))
    after = {name: known.moved(change * sp.Matrix(at)) for name, at in CORNERS.items()}
    solution = solve("3.1", before=data({k: sp.Matrix(v) for k, v in CORNERS.items()}), after=data(after))
    assert solution.status == "not-a-rotation"
    assert same(solution.answers["Q"], known.Q * change)


def test_a_flat_corner_is_malformed() -> None:
    flat = {"A": [0, 0, 0], "B": [1, 0, 0], "D": [0, 1, 0], "E": [1, 1, 0]}
    with pytest.raises(DataError, match="before: expected a corner with three edges in space"):
        solve("3.1", before=flat)
    with pytest.raises(DataError, match="before: E is missing"):
        solve("3.1", before={"A": [0, 0, 0], "B": [1, 0, 0], "D": [0, 1, 0]})


def gripper(known: Motion, point: sp.Matrix) -> dict[str, object]:
    axes = {name: plain(known.Q[:, k]) for k, name in enumerate("ijk")}
    return axes | {"p": plain(point), "c": plain(known.moved(point))}


@pytest.mark.sampled(3)
@pytest.mark.parametrize("half_turn", [False, True])
@pytest.mark.parametrize("seed", range(6))
def test_a_known_screw_of_a_gripper(seed: int, half_turn: bool) -> None:
    draw = Random(seed)
    known = motion(draw, half_turn)
    solution = solve("3.6", **gripper(known, vector(draw)))
    assert solution.status == "screw"
    is_found(solution.answers, known)


def test_the_default_of_the_gripper() -> None:
    solution = solve("3.6")
    Q = solution.answers["Q"]
    assert all(entry > 0 for entry in Q[:, 0])
    assert Q[2, 1] > 0
    assert same(Q[:, 1].dot(sp.Matrix([1, -1, 1])), 0)
    assert abs(sp.N(solution.answers["phi"]) - 1.578) < 1e-3
    assert any("(1, 1, 1)" in text for text in solution.assumptions)


def test_other_cases_of_the_gripper() -> None:
    assert solve("3.6", i=[1, 0, 0], j=[0, 1, 0], k=[0, 0, 1]).status == "pure-translation"
    assert solve("3.6", i=[0, 1, 0], j=[1, 0, 0], k=[0, 0, 1]).status == "not-a-rotation"
    assert solve("3.6", i=[1, 0, 0], j=[1, 0, 0], k=[0, 0, 1]).status == "not-a-rotation"
    with pytest.raises(DataError, match="i: expected a list of 3 numbers"):
        solve("3.6", i=[1, 0])
