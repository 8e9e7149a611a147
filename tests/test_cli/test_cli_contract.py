"""What `chasles solve` takes and prints is fixed: data keys, statuses, names of answers, exit statuses."""

from __future__ import annotations

import json
import tomllib
from pathlib import Path

import pytest

from chasles.statements.exercises import exercise, exercise_numbers

TABLE = {entry["number"]: entry for entry in tomllib.loads(
    (Path(__file__).parents[1] / "exercises.toml").read_text(encoding="utf-8"))["exercise"]}  # fmt: skip
CASES = [(number, status) for number, entry in TABLE.items() for status in entry["cases"]]
FIRST_KEYS = [(number, entry["given"][0]) for number, entry in TABLE.items() if entry["given"]]


def test_the_table_has_every_exercise() -> None:
    assert set(exercise_numbers()) == set(TABLE) == {f"3.{place}" for place in range(1, 22)}


@pytest.mark.parametrize("number", TABLE)
def test_data_keys_and_statuses(number: str) -> None:
    entry, found = TABLE[number], exercise(number)
    assert found.keys == tuple(entry["given"])
    assert set(found.statuses) == set(entry["statuses"]) == set(entry["answers"]) == set(entry["cases"])


@pytest.mark.parametrize(("number", "status"), CASES)
def test_what_is_printed(run, tmp_path: Path, number: str, status: str) -> None:
    data = tmp_path / "data.json"
    data.write_text(TABLE[number]["cases"][status], encoding="utf-8")
    done = run("solve", number, "--data", str(data), "--json")
    assert done.exit_code == 0, done.stderr
    printed = json.loads(done.stdout)
    assert list(printed) == ["exercise", "status", "answers", "assumptions", "steps"]
    assert (printed["exercise"], printed["status"]) == (number, status)
    assert set(printed["answers"]) == set(TABLE[number]["answers"][status])
    assert all(isinstance(text, str) for text in printed["assumptions"])
    assert isinstance(printed["steps"], int)


@pytest.mark.parametrize(("number", "key"), FIRST_KEYS)
@pytest.mark.parametrize("value", ['"?"', "[[]]", "true"])
def test_malformed_data_end_with_two_and_one_line(run, tmp_path: Path, number: str, key: str, value: str) -> None:
    data = tmp_path / "data.json"
    data.write_text(f'{{"{key}": {value}}}', encoding="utf-8")
    done = run("solve", number, "--data", str(data), "--json")
    assert (done.exit_code, done.stdout) == (2, "")
    assert len(done.stderr.splitlines()) == 1
    assert key in done.stderr
