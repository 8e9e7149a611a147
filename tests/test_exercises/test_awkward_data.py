"""Data that are tiny, huge, or nearly special: each exercise answers or refuses in one line, and soon."""

from __future__ import annotations

import json
from collections.abc import Iterator
from random import Random
from typing import Any

import pytest

from chasles.decisions.decision import DoesNotStand
from chasles.exercises.data import DataError
from chasles.exercises.grading import new_data
from chasles.exercises.solving import solve_with
from chasles.statements.exercises import exercise, exercise_numbers

from ..counted import at_most
from ..sampling import sample

NUMBERS = [number for number in exercise_numbers() if exercise(number).instance is not None]
AWKWARD = (
    "0.000000002", "1/10^60", "10^60", "1/3+1/10^30", "sqrt(2)+1/10^40", "sin(0.000000002)", "cos(pi/1000003)", "pi",
    "acos(1/3)", "pi/7", "sin(1)", "sqrt(sqrt(2))", "cos(pi/97)", "tan(pi/7)", "1-1/10^50", "355/113", "asin(1/3)/3",
    "cos(1/1000)", "sqrt(3)*pi", "1/(pi+1/10^9)", "sqrt(10^40+1)", "2^63", "sqrt(2+sqrt(2+sqrt(2)))", "cos(pi/257)",
    "sin(pi/17)", "atan(10^30)", "0", "-1/10^20", "123456789/987654321",
)  # fmt: skip
ANGLES = (
    "0.000000002", "pi/7", "1", "pi/1000003", "acos(1/3)", "pi-1/10^20", "2*pi/3+1/10^40", "1/10^50", "10^30", "pi/97",
    "atan(1/2)/2", "acos(1/3)/3", "pi/17", "pi/2-1/10^30", "sqrt(2)", "3.14159265358979", "0.5235987755982989", "22/7",
)  # fmt: skip


ENDLESS = 50_000_000
"""Calls of functions: what is not bounded makes many more, what is bounded a few millions."""


def soon(number: str, data: dict[str, Any]) -> str:
    """How it ends; a defect is raised."""
    with at_most(ENDLESS):
        try:
            ended = solve_with(number, data).status
        except (DataError, DoesNotStand) as refused:
            ended = str(refused)
    assert "\n" not in ended
    return ended


def places(value: Any, at: tuple[Any, ...] = ()) -> Iterator[tuple[Any, ...]]:
    parts = enumerate(value) if isinstance(value, list) else value.items() if isinstance(value, dict) else ()
    for key, part in parts:
        yield from places(part, (*at, key))
    if isinstance(value, str | int):
        yield at


@pytest.mark.sampled(5)
@pytest.mark.parametrize(("number", "seed"), sample([(n, seed) for seed in range(30) for n in NUMBERS], 34, 5))
def test_awkward_numbers(number: str, seed: int) -> None:
    draw = Random(f"awkward {number} {seed}")
    data = json.loads(json.dumps(new_data(exercise(number), seed)))
    found = [place for place in places(data) if place[0] not in ("sequence", "factors") and place[-1] not in ("from",)]
    for place in draw.sample(found, min(len(found), draw.choice((1, 1, 2, 3)))):
        whole = data
        for key in place[:-1]:
            whole = whole[key]
        whole[place[-1]] = draw.choice(AWKWARD)
    soon(number, data)


def turned(angle: str) -> list[list[str]]:
    return [[f"cos({angle})", f"-sin({angle})", "0"], [f"sin({angle})", f"cos({angle})", "0"], ["0", "0", "1"]]


@pytest.mark.sampled(3)
@pytest.mark.parametrize("angle", sample(ANGLES, 8))
def test_awkward_angles(angle: str) -> None:
    rows = turned(angle)
    columns = dict(zip("ijk", ([row[k] for row in rows] for k in range(3)), strict=True))
    assert soon("3.6", columns) == "screw"
    assert soon("3.19", {"R": rows}) == "ok"
    corner = {"A": [1, 2, 3]}
    after = {name: [f"({x})+{at}" for x, at in zip(columns[k], (1, 2, 3), strict=True)]
             for name, k in zip("BDE", "ijk", strict=True)}  # fmt: skip
    assert soon("3.1", {"after": corner | after}) == "screw"
    soon("3.10", {"angles": [angle, "1/3", angle], "rates": [1, 2, 3]})


@pytest.mark.sampled(4)
@pytest.mark.parametrize("size", [1, 2, 3, 9, 10**4, 10**9, 10**12, 10**25, 10**40])
def test_rotations_through_tiny_angles(size: int) -> None:
    """By a quaternion (n, 0, 0, 1): an angle of about 2 / n."""
    below = size**2 + 1
    cosine, sine = f"{size**2 - 1}/{below}", f"{2 * size}/{below}"
    columns = {"i": [cosine, sine, 0], "j": [f"-{sine}", cosine, 0], "k": [0, 0, 1]}
    with at_most(ENDLESS):
        assert solve_with("3.6", columns).status == "screw"


FAR_APART = ["1268/169", "-180/169", "96/169"], ["-180/169", "749/169", "-84/169"], ["96/169", "-84/169", "856/169"]


def test_moments_that_are_far_apart_are_told_apart() -> None:
    """Eigenvalues beyond square roots, some of them 50 digits longer than the others."""
    solution = solve_with("3.16", {"I_C": FAR_APART, "m": 1, "d": [["3/13", "12/13", "10^25*sqrt(2)"]]})
    least, one, other = (moment.value.evalf(120) for moment in solution.answers["moments_P"][0])
    assert 0 < least < 10
    assert 10**49 < one < other


@pytest.mark.parametrize(
    ("number", "data"),
    [
        ("3.12", {"side": "pi^64"}),
        ("3.5", {"pi": ["-sqrt(2)/2", 0, "sqrt(2)/10^50", 0, "-sqrt(2)", 0]}),
        ("3.5", {"pi": [f"sqrt({25 * 10**98 + 1})", 0, 0, 0, 0, 0]}),
    ],
)
def test_what_grows_too_long_is_refused(number: str, data: dict[str, Any]) -> None:
    with at_most(ENDLESS), pytest.raises(DataError):
        solve_with(number, data)
