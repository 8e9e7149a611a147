"""A notebook for nbgrader from tasks of chasles: `python make_assignment.py FOLDER wrenches 3.5:1 3.7:3`.

Writes FOLDER/source/wrenches/wrenches.ipynb. Each task has a cell with the task, one for the answers, which holds the
right ones as nbgrader's solution and a template for the students, and one that grades them, worth one point for each
right part.
"""

from __future__ import annotations

import json
import sys
from pathlib import Path
from pprint import pformat
from typing import Any

import chasles
from chasles.exact.spelling import as_data

SOLUTION = """\
# Numbers are exact, as "1/3" or "sqrt(2)/2", or decimals of four digits. Leave out what does not apply.
{name} = {template}
### BEGIN SOLUTION
{name} = {right}
### END SOLUTION
"""
GRADE = """\
import chasles

grade = chasles.practice("{exercise}", seed={seed}).grade({name}, digits=4)
print(grade.feedback or grade.missing or "all is right")
round({points} * grade.score, 2)
"""


def cells(exercise: str, seed: int) -> list[dict[str, Any]]:
    """The task, the place for its answers, and their grade."""
    task = chasles.practice(exercise, seed)
    whole, name = task.as_data(), f"answers_{exercise.replace('.', '_')}_{seed}"
    right = {"status": task.solution.status, **as_data(task.solution.answers)}
    lines = [f"## Exercise {exercise}: {whole['title']}", *(f"- {text}" for text in whole["asked"]), "", "Data:", ""]
    lines += [f"- `{key} = {json.dumps(value)}`: {whole['data_are'][key]}" for key, value in whole["data"].items()]
    lines += ["", "Answers:", ""]
    lines += [f"- `{key}`: {answer['is']} ({answer['shape']})" for key, answer in whole["answers"].items()]
    answer = SOLUTION.format(name=name, template=_written(task.template), right=_written(right))
    grade = GRADE.format(exercise=exercise, seed=seed, name=name, points=len(right))
    return [
        {"cell_type": "markdown", "id": f"task-{name}", "metadata": {}, "source": "\n".join(lines)},
        _code(f"answer-{name}", answer, solution=True),
        _code(f"grade-{name}", grade, grade=True, locked=True, points=len(right)),
    ]


def _written(value: Any) -> str:
    return pformat(value, width=110, sort_dicts=False)


def _code(name: str, source: str, **marks: Any) -> dict[str, Any]:
    kind = {"grade": False, "solution": False, "locked": False, "task": False, "schema_version": 3, "grade_id": name}
    return {
        "cell_type": "code",
        "id": name,
        "metadata": {"nbgrader": kind | marks},
        "source": source,
        "outputs": [],
        "execution_count": None,
    }


def main(folder: str, assignment: str, *tasks: str) -> None:
    """Write the notebook; tasks are exercises with their seeds."""
    found = [cell for task in tasks for cell in cells(task.partition(":")[0], int(task.partition(":")[2] or 1))]
    kernel = {"kernelspec": {"name": "python3", "display_name": "Python 3", "language": "python"}}
    notebook = {"cells": found, "metadata": kernel, "nbformat": 4, "nbformat_minor": 5}
    place = Path(folder) / "source" / assignment
    place.mkdir(parents=True, exist_ok=True)
    (place / f"{assignment}.ipynb").write_text(json.dumps(notebook, indent=1), "utf-8")


if __name__ == "__main__":
    main(*sys.argv[1:])
