"""The sample course: a notebook for nbgrader, executed cell by cell, and a question called as PrairieLearn does."""

from __future__ import annotations

import json
from base64 import b64encode
from pathlib import Path
from runpy import run_path
from typing import Any

import pytest

import chasles
from chasles.exact.spelling import as_data

COURSE = Path(__file__).resolve().parents[1] / "examples" / "course"
pytestmark = pytest.mark.skipif(not COURSE.exists(), reason="needs the checkout")
TASKS = ("3.5:1", "3.7:4", "3.4:2")


@pytest.fixture(scope="module")
def notebook(tmp_path_factory: pytest.TempPathFactory) -> dict[str, Any]:
    folder = tmp_path_factory.mktemp("course")
    run_path(str(COURSE / "make_assignment.py"))["main"](str(folder), "wrenches", *TASKS)
    return json.loads((folder / "source" / "wrenches" / "wrenches.ipynb").read_text("utf-8"))


@pytest.mark.parametrize("solved", [True, False])
def test_the_notebook_grades_itself(notebook: dict[str, Any], solved: bool) -> None:
    known: dict[str, Any] = {}
    for cell in notebook["cells"]:
        marks = cell["metadata"].get("nbgrader", {})
        if marks.get("solution"):
            exec(cell["source"] if solved else cell["source"].partition("### BEGIN SOLUTION")[0], known)
        elif marks.get("grade"):
            *lines, last = cell["source"].rstrip().splitlines()
            exec("\n".join(lines), known)
            assert eval(last, known) == (marks["points"] if solved else 0)


def test_cells_have_names_of_their_own(notebook: dict[str, Any]) -> None:
    names = [cell["id"] for cell in notebook["cells"]]
    assert len(names) == len(set(names)) == 3 * len(TASKS)


def test_a_question_of_prairielearn() -> None:
    server = run_path(str(COURSE / "prairielearn" / "line_from_moments" / "server.py"))
    assert json.loads((COURSE / "prairielearn" / "line_from_moments" / "info.json").read_text("utf-8"))["type"] == "v3"
    data: dict[str, Any] = {"variant_seed": "3", "format_errors": {}, "feedback": {}}
    server["generate"](data)
    assert json.loads(json.dumps(data["params"])) == data["params"]
    right = chasles.practice("3.7", 3).solution

    def submit(answers: Any) -> None:
        text = json.dumps(answers).encode()
        data["submitted_answers"] = {"_files": [{"name": "answer.json", "contents": b64encode(text).decode()}]}
        server["parse"](data)

    submit({"status": right.status, **as_data(right.answers)})
    server["grade"](data)
    assert (data["format_errors"], data["score"]) == ({}, 1)
    submit(json.loads(data["params"]["template"]) | {"status": right.status, "d": 7})
    server["grade"](data)
    assert data["partial_scores"]["d"] == {"score": 0}
    assert 0 < data["score"] < 1
    assert data["feedback"]["parts"][0]["name"] == "d"
    submit({"d": None})
    assert "d: expected a number, and got None" in data["format_errors"]["answer.json"]
    data |= {"format_errors": {"_files": ["No submitted answer for answer.json"]}, "submitted_answers": {}}
    server["parse"](data)
    assert list(data["format_errors"]) == ["_files"]
