"""Practice for a course: whole tasks, many of them, graded from Python and by lines of JSON."""

from __future__ import annotations

import json
from typing import Any

import pytest

import chasles
from chasles.exercises.data import DataError
from chasles.exercises.grading import new_data
from chasles.exercises.practice import grade_lines, practice
from chasles.exercises.solving import solve_with
from chasles.statements.exercises import UnknownExercise, exercise, exercise_numbers

from ..sampling import WHOLE

NUMBERS = [number for number in exercise_numbers() if exercise(number).instance is not None]


def own(number: str, seed: int) -> dict[str, Any]:
    solution = practice(number, seed).solution
    return {"status": solution.status, **json.loads(json.dumps(solution.as_data()["answers"]))}


@pytest.mark.sampled(3)
@pytest.mark.parametrize("number", NUMBERS)
def test_a_task_is_whole(number: str) -> None:
    task = practice(number, 2)
    whole = json.loads(json.dumps(task.as_data()))
    assert solve_with(number, whole["data"]).answers == task.solution.answers
    assert list(whole["template"]) == list(whole["answers"])
    assert {"status", *task.solution.answers} <= set(whole["answers"])
    assert set(whole["data_are"]) == set(whole["data"])
    assert all(answer["is"] and answer["shape"] for answer in whole["answers"].values())
    answers = own(number, 2)
    assert task.grade(answers).passed
    assert task.grade(whole["template"] | answers).passed
    assert task.grade(answers).score == 1


def test_a_template_that_is_left_blank_answers_nothing() -> None:
    task = practice("3.5", 1)
    assert task.grade(task.template).missing == ("status",)


@pytest.mark.sampled(5)
@pytest.mark.parametrize("number", NUMBERS)
def test_there_are_a_thousand_tasks(number: str) -> None:
    seeds, least = (2000, 1000) if WHOLE else (60, 55)
    chosen = exercise(number)
    assert len({json.dumps(new_data(chosen, seed)) for seed in range(seeds)}) >= least


def test_from_python() -> None:
    task = chasles.practice("3.5", 4)
    answers = own("3.5", 4)
    wrong = task.grade({**answers, "d": f"{answers['d']}+1"})
    assert (wrong.right, wrong.wrong, wrong.score) == (("status", "p"), ("d",), 2 / 3)
    assert wrong.feedback["d"]
    near = {**answers, "p": ["0.33333", "0.66667", "0.66667"]}
    assert chasles.practice("3.5", 4) is task
    assert not task.grade(near).passed
    with pytest.raises(UnknownExercise, match=r"there is no exercise '3\.99'"):
        chasles.practice("3.99")
    for seed in (-1, True, "1"):
        with pytest.raises(DataError, match="seed: expected an integer"):
            chasles.practice("3.5", seed)
    with pytest.raises(DataError, match="no data to practise with"):
        chasles.practice("3.9")


@pytest.mark.parametrize(
    ("digits", "given", "passes"),
    [(4, "1.414", 1), (5, "1.414", 0), (4, "1.415", 0), (6, "1.41421", 1), (3, "1.41", 1), (1, "1.9", 1)],
)
def test_digits(digits: int, given: str, passes: int) -> None:
    seed = next(seed for seed in range(99) if own("3.5", seed).get("d") == "sqrt(2)")
    assert practice("3.5", seed).grade({**own("3.5", seed), "d": given}, digits=digits).passed == bool(passes)


@pytest.mark.parametrize("more", [{"digits": 0}, {"digits": 4, "rtol": 0.1}, {"digits": True}, {"rtol": "no"}])
def test_tolerances_that_are_none(more: dict[str, Any]) -> None:
    with pytest.raises(DataError, match=r"^(digits|rtol)"):
        practice("3.5", 4).grade(own("3.5", 4), **more)


def test_lines() -> None:
    right, wrong = own("3.5", 4), {**own("3.5", 4), "d": "7"}
    lines = [
        json.dumps({"id": "ann", "seed": 4, "answers": right}),
        json.dumps({"id": "bob", "seed": 4, "answers": wrong}),
        "",
        '{"id": "cat", "seed": 4, "answers": {"d": "1/0"}}',
        '{"id": "dan", "seed": "four", "answers": {}}',
        '{"id": "eve", "answers": 3}',
        '{"id": "fay", "exercise": "3.99", "answers": {}}',
        '{"id": "guy", "exercise": ["3.5"], "answers": {}}',
        "[1",
        '{"id": "hal", "exercise": "3.19", "seed": 2, "rtol": 1e-3, "answers": {}}',
    ]
    found = list(grade_lines(lines, "3.5"))
    assert json.loads(json.dumps(found)) == found
    assert [record.get("id") for record in found] == ["ann", "bob", "cat", "dan", "eve", "fay", "guy", None, "hal"]
    assert [record.get("passed") for record in found] == [True, False, *[None] * 6, False]
    assert found[1]["wrong"] == ["d"]
    assert [bool(record.get("error")) for record in found] == [False, False, *[True] * 6, False]
    assert found[2]["error"].startswith("d: '1/0': division by zero")
    assert found[8]["rtol"] == "0.001"


def test_an_answer_is_graded_alike_the_second_time() -> None:
    lines = [json.dumps({"seed": 4, "exercise": number, "answers": own(number, 4)}) for number in NUMBERS]
    for _ in range(2):
        assert all(record["passed"] for record in grade_lines(lines, "3.5"))
