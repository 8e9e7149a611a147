"""`chasles practice`: new data for an exercise, and the grade of an answer."""

from __future__ import annotations

import json
import shlex
import sys
from pathlib import Path

import pytest

from chasles.exercises.grading import new_data
from chasles.exercises.solving import solve_with
from chasles.statements.exercises import exercise

DATA = new_data(exercise("3.5"), 4)


def test_new_data_are_those_of_the_seed(run) -> None:
    task = run("practice", "3.5", "--seed", "4", "--json")
    assert (task.exit_code, json.loads(task.stdout)["data"]) == (0, DATA)
    assert (
        "Check an answer:\n  chasles practice 3.5 --seed 4 --check answer.json\n"
        in run("practice", "3.5", "--seed", "4").stdout
    )


@pytest.mark.parametrize("called", ["./asked_here", "{here}/my own/asked_elsewhere", "asked_by_name"])
def test_the_command_that_checks_names_the_chapter_as_it_was_named(run, tmp_path: Path, monkeypatch, called) -> None:
    monkeypatch.setattr(sys, "path", [*sys.path])
    (tmp_path / "my own").mkdir()
    monkeypatch.chdir(tmp_path / "my own")
    named = called.format(here=tmp_path)
    assert run("new", Path(named).name).exit_code == 0
    *_, command = run("--chapter", named, "practice", "1").stdout.splitlines()
    assert shlex.split(command)[:4] == ["chasles", "--chapter", named, "practice"]


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


def test_null_and_a_word_are_malformed(run, tmp_path: Path) -> None:
    answers = tmp_path / "answer.json"
    for text in ('{"d": null}', '{"d": true}', '{"p": "x"}', '{"d": 5, "e_candidates": 5}', '{"d": {}}', "null", "3"):
        answers.write_text(text, "utf-8")
        done = run("practice", "3.5", "--check", str(answers))
        assert (done.exit_code, done.stdout, done.stderr.count("\n")) == (2, "", 1)
        assert "defect" not in done.stderr


def test_a_task_in_the_terminal_is_whole(run) -> None:
    task = run("practice", "3.1", "--seed", "2").stdout
    assert '  before = {"A": ["0", "0", "0"]' in task
    assert '  after = {"A": [' in task
    assert "  phi: its angle in radians, in [0, pi]" in task
    assert ' "e": ["?", "?", "?"],' in task
    assert "points = " in run("practice", "3.2").stdout


def test_decimals_with_a_tolerance(run, tmp_path: Path) -> None:
    right = solve_with("3.5", DATA).as_data()["answers"]
    answers = tmp_path / "answer.json"
    answers.write_text(json.dumps(right | {"d": f"({right['d']})*1.0001"}), "utf-8")
    command = ("practice", "3.5", "--seed", "4", "--check", str(answers))
    assert run(*command).exit_code == 1
    assert run(*command, "--rtol", "0.001").exit_code == 0
    assert run(*command, "--digits", "3").exit_code == 0
    assert run(*command, "--digits", "9").exit_code == 1
    both = run(*command, "--digits", "9", "--rtol", "0.1")
    assert (both.exit_code, both.stderr.count("\n")) == (2, 1)


def test_a_batch(run, tmp_path: Path) -> None:
    right = solve_with("3.5", DATA).as_data()["answers"]
    lines = tmp_path / "answers.jsonl"
    lines.write_text(f"{json.dumps({'id': 1, 'seed': 4, 'answers': right})}\n", "utf-8")
    done = run("practice", "3.5", "--batch", str(lines))
    assert (done.exit_code, done.stdout.count("\n")) == (0, 1)
    assert json.loads(done.stdout)["score"] == 1
    lines.write_text('{"id": 2, "answers": {"d": true}}\n{"answers": {}}\n', "utf-8")
    done = run("practice", "3.5", "--batch", str(lines))
    assert (done.exit_code, done.stdout.count("\n"), done.stderr) == (2, 2, "")
    assert json.loads(done.stdout.splitlines()[0]) == {"id": 2, "error": "d: expected a number, and got True"}


def test_hints(run) -> None:
    two = run("solve", "3.7", "--hint", "2").stdout
    assert two.splitlines()[0] == "Exercise 3.7, 2 of 7 steps"
    assert "(3.32)" in two
    assert "=" not in two
    found = json.loads(run("solve", "3.7", "--hint", "99", "--json").stdout)
    assert (len(found["hints"]), found["of"]) == (7, 7)
    assert run("solve", "3.7", "--hint", "0").exit_code == 2
