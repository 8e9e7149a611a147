"""Practice with exercises 3.11 to 3.21: new data are solved, and their own answers are right."""

from __future__ import annotations

import pytest

from chasles.exercises.grading import grade, new_data
from chasles.exercises.solving import solve_with
from chasles.statements.exercises import exercise


@pytest.mark.sampled(3)
@pytest.mark.parametrize("seed", range(3))
@pytest.mark.parametrize("number", ["3.11", "3.13", "3.14", "3.15", "3.16", "3.20", "3.21"])
def test_its_own_answers_are_right(number: str, seed: int) -> None:
    found = exercise(number)
    data = new_data(found, seed)
    assert data == new_data(found, seed)
    solution = solve_with(number, data)
    marks = grade(found, data, solution.as_data()["answers"])
    assert marks.passed
    assert not marks.wrong


def test_the_draws_bring_both_cases() -> None:
    found = exercise("3.14")
    agreeing = {solve_with("3.14", new_data(found, seed)).answers["compatible"] for seed in range(8)}
    assert agreeing == {True, False}


def test_a_wrong_moment_is_found() -> None:
    found = exercise("3.11")
    data = new_data(found, 1)
    answers = solve_with("3.11", data).as_data()["answers"]
    assert grade(found, data, {**answers, "V": "1"}).wrong == ("V",)
