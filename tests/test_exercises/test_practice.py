"""New data for every exercise with numbers, solved and substituted back; answers graded part by part."""

from __future__ import annotations

import json
import os

import pytest

from chasles.exercises.data import DataError
from chasles.exercises.grading import grade, new_data
from chasles.exercises.solving import solve_with
from chasles.statements.exercises import exercise, exercise_numbers

from ..sampling import WHOLE

INSTANCES = int(os.environ.get("CHASLES_INSTANCES", "6" if WHOLE else "2"))
"""How many for each exercise; a nightly run sets 56, which makes a thousand."""
WITH_NUMBERS = [number for number in exercise_numbers() if exercise(number).instance is not None]
REFUSED = ("incompatible", "not-a-rotation", "not-a-line")


@pytest.mark.sampled(5)
@pytest.mark.parametrize("seed", range(INSTANCES))
@pytest.mark.parametrize("number", WITH_NUMBERS)
def test_new_data_are_solved_and_substituted_back(number: str, seed: int) -> None:
    chosen = exercise(number)
    data = new_data(chosen, seed)
    assert data == new_data(chosen, seed) == json.loads(json.dumps(data))
    solution = solve_with(number, data)
    assert solution.checks or solution.status in (*REFUSED, "pure-couple")
    answers = json.loads(json.dumps(solution.as_data()["answers"]))
    assert grade(chosen, data, answers).passed


def test_seeds_give_different_data() -> None:
    drawn = [json.dumps(new_data(exercise("3.7"), seed)) for seed in range(20)]
    assert len(set(drawn)) == 20


CUBE = exercise("3.1")
RIGHT = {
    "Q": [[0, 0, 1], [1, 0, 0], [0, 1, 0]],
    "phi": "2*pi/3",
    "e": ["1/sqrt(3)", "1/sqrt(3)", "sqrt(3)/3"],
    "p0": ["2/3", 0, "-2/3"],
    "n": ["2/(3*sqrt(3))", "-4*sqrt(3)/9", "2*sqrt(3)/9"],
    "d0": "2/sqrt(3)",
    "pitch": "sqrt(3)/pi",
    "hits": {"X=0": [0, "-2/3", "-4/3"], "Y=0": ["2/3", 0, "-2/3"], "Z=0": ["4/3", "2/3", 0]},
}
REVERSED = {
    "phi": "-2*pi/3",
    "e": ["-1/sqrt(3)"] * 3,
    "n": ["-2/(3*sqrt(3))", "4*sqrt(3)/9", "-2*sqrt(3)/9"],
    "d0": "-2/sqrt(3)",
}


@pytest.mark.parametrize("change", [{}, REVERSED, REVERSED | {"phi": "4*pi/3"}, {"phi": "8*pi/3"}])
def test_right_in_any_form_and_with_either_sign(change: dict) -> None:
    marks = grade(CUBE, {}, RIGHT | change)
    assert marks.passed, marks


@pytest.mark.parametrize(
    ("change", "wrong", "violated"),
    [
        ({"p0": ["2/3", 0, "2/3"]}, ["p0"], ["foot of the perpendicular", "displaced along the axis"]),
        ({"p0": ["4/3", "2/3", 0]}, ["p0"], ["foot of the perpendicular"]),
        ({"phi": "-2*pi/3"}, ["phi"], ["give the rotation back"]),
        ({"e": ["-1/sqrt(3)"] * 3}, ["e"], ["give the rotation back"]),
        ({"d0": 1}, ["d0"], []),
        ({"hits": RIGHT["hits"] | {"X=0": "parallel"}}, ["hits"], []),
        ({"phi": "2.0943951"}, ["phi"], ["give the rotation back"]),
    ],
)
def test_what_is_wrong_is_named_with_what_it_violates(change: dict, wrong: list, violated: list) -> None:
    marks = grade(CUBE, {}, RIGHT | change)
    assert list(marks.wrong) == wrong
    assert not marks.passed
    for says in violated:
        assert any(says in text for text in marks.violated), (says, marks.violated)


def test_a_wrong_number_is_named_with_the_step_that_gives_it() -> None:
    answers = json.loads(json.dumps(solve_with("3.7", {}).as_data()["answers"]))
    marks = grade(exercise("3.7"), {}, answers | {"d": f"1 + {answers['d']}"})
    assert marks.wrong == ("d",)
    assert any("distance from the origin" in text for text in marks.violated)


def test_what_is_missing_is_named() -> None:
    marks = grade(CUBE, {}, {name: value for name, value in RIGHT.items() if name != "pitch"})
    assert (marks.missing, marks.passed) == (("pitch",), False)


@pytest.mark.sampled(3)
@pytest.mark.parametrize(
    ("change", "match"),
    [
        ({"omega": 1}, "'omega' is no answer of exercise 3.1"),
        ({"phi": "exit()"}, "phi: .*'exit' is not known"),
        ({"e": [1, 2]}, "e: expected a list of 3 numbers, and got 2 of them"),
        ({"e": "up"}, "e: expected a list of 3 numbers, and got 'up'"),
        ({"e": 5}, "e: expected a list of 3 numbers, and got 5"),
        ({"phi": [1]}, "phi: expected a number"),
        ({"phi": None}, "phi: expected a number, and got None"),
        ({"phi": True}, "phi: expected a number, and got True"),
        ({"phi": {"a": 1}}, "phi: expected a number"),
        ({"phi": {"root_of": [1, 0, 1], "index": 0}}, "phi: index: the polynomial has no real root"),
        ({"phi": "("}, "phi: '\\(': expected a number, a function"),
        ({"phi": "1/(acos(1/3)+asin(1/3)-pi/2)"}, "phi: .*division by zero"),
        ({"Q": 1}, "Q: expected 3 rows of 3 numbers, and got 1"),
        ({"Q": None}, "Q: expected 3 rows of 3 numbers, and got None"),
        ({"Q": [[1, 0, 0], [0, 1, 0], [0, 0, True]]}, r"Q\[3\]\[3\]: expected a number, and got True"),
        ({"hits": []}, "hits: expected an object with X=0, Y=0, Z=0"),
        ({"hits": RIGHT["hits"] | {"X=0": "away"}}, "hits.X=0: expected one of parallel, contained, and got 'away'"),
        ({"hits": {"X=0": "parallel"}}, "hits: Y=0 is missing"),
        ({"status": "srew"}, "status: expected one of screw, pure-translation, not-a-rotation, and got 'srew'"),
        ({"status": None}, "status: expected one of"),
    ],
)
def test_malformed_answers(change: dict, match: str) -> None:
    with pytest.raises(DataError, match=match):
        grade(CUBE, {}, RIGHT | change)
