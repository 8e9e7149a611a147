"""`chasles practice`: new data for an exercise, and the grade of an answer."""

from __future__ import annotations

import json
from pathlib import Path

import pytest

from chasles.exact.grading import new_data
from chasles.exact.solving import solve_with
from chasles.statements.exercises import exercise

DATA = new_data(exercise("3.5"), 4)


def test_new_data_are_those_of_the_seed(run) -> None:
    task = run("practice", "3.5", "--seed", "4", "--json")
    assert (task.exit_code, json.loads(task.stdout)["data"]) == (0, DATA)
    assert (
        "Check an answer:\n  chasles practice 3.5 --seed 4 --check answer.json\n"
        in run("practice", "3.5", "--seed", "4").stdout
    )


def test_a_right_answer_passes(run, tmp_path: Path) -> None:
    answers = tmp_path / "answer.json"
    answers.write_text(json.dumps(solve_with("3.5", DATA).as_data()), "utf-8")
    graded = run("practice", "3.5", "--seed", "4", "--check", str(answers))
    assert (graded.exit_code, graded.stdout) == (0, "right: d, p\n")


def test_a_wrong_answer_does_not(run, tmp_path: Path) -> None:
    answers = tmp_path / "answer.json"
    answers.write_text(json.dumps({"p": [7, 0, 0]}), "utf-8")
    graded = run("practice", "3.5", "--seed", "4", "--check", str(answers), "--json")
    found = json.loads(graded.stdout)
    assert (graded.exit_code, found["passed"], found["wrong"], found["missing"]) == (1, False, ["p"], ["d"])
    assert "P* lies on the line." in found["violated"]


@pytest.mark.parametrize(
    ("words", "match"),
    [
        (["3.9"], "exercise 3.9 has no data to practise with"),
        (["3.99"], "there is no exercise '3.99'"),
        (["3.5", "--seed", "-1"], "-1 is not in the range"),
        (["3.5", "--check", "/no/such/file"], "cannot read /no/such/file"),
    ],
)
def test_bad_usage(run, words: list[str], match: str) -> None:
    done = run("practice", *words)
    assert (done.exit_code, done.stderr.count("\n")) == (2, 1)
    assert match in done.stderr


def test_malformed_answers(run, tmp_path: Path) -> None:
    answers = tmp_path / "answer.json"
    answers.write_text('{"d": "exit()"}', "utf-8")
    done = run("practice", "3.5", "--check", str(answers))
    assert (done.exit_code, done.stdout) == (2, "")
    assert "d: 'exit()': 'exit' is not known here" in done.stderr
