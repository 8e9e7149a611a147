"""`chasles practice EX`."""

from __future__ import annotations

from collections.abc import Iterator
from pathlib import Path
from typing import TYPE_CHECKING, Any

import click

from chasles.cli import completing
from chasles.cli.book import as_data, only_of_the_book
from chasles.cli.failures import BAD_INPUT, FAILED, Failure
from chasles.cli.files import text_of_file

if TYPE_CHECKING:
    from chasles.exact.grading import Grade
    from chasles.statements.exercise import Exercise

__all__ = ["command"]


@click.command(
    "practice", short_help="New data for an exercise; grade an answer.", epilog="Example: chasles practice 3.7 --seed 4"
)
@click.argument("exercise", metavar="EX", shell_complete=completing.exercises)
@click.option("--seed", type=click.IntRange(0, 10**9), default=1, show_default=True, help="Which data are drawn.")
@click.option("--check", type=click.Path(path_type=Path), metavar="FILE", help="JSON with answers to grade; '-' reads.")
@as_data
def command(exercise: str, seed: int, check: Path | None, json: bool) -> int:
    """Draw new data for an exercise, with nice numbers; with `--check`, grade an answer for these data.

    An answer is right in any form that is exactly equal, also with the axis reversed where all else is. The exit
    status is 1 if a part of the answer is wrong or missing.
    """
    from chasles.exact.data import DataError, read_json
    from chasles.exact.grading import grade, new_data
    from chasles.proof.decision import DoesNotStand
    from chasles.report.records import as_json
    from chasles.statements.exercises import UnknownExercise
    from chasles.statements.exercises import exercise as find_exercise

    only_of_the_book("the exercises")
    try:
        chosen = find_exercise(exercise)
        data = new_data(chosen, seed)
        marks = None if check is None else grade(chosen, data, _answers(read_json(text_of_file(check))))
    except (DataError, UnknownExercise) as error:
        raise Failure(str(error.args[0]), BAD_INPUT) from error
    except DoesNotStand as error:
        raise Failure(f"answers to exercise {exercise} cannot be graded: {error}") from error
    if json:
        click.echo(as_json({"exercise": chosen.number, "seed": seed, "data": data} | _record(marks)))
    else:
        from rich.text import Text

        from chasles.report.screen import Screen

        lines = _task(chosen, seed, data) if marks is None else _marks(marks)
        Screen().show(*(Text(line, overflow="fold") for line in lines))
    return 0 if marks is None or marks.passed else FAILED


def _answers(read: dict[str, Any]) -> dict[str, Any]:
    """The answers, alone or as `chasles solve --json` prints them."""
    inner = read.get("answers")
    return inner if isinstance(inner, dict) else read


def _record(marks: Grade | None) -> dict[str, Any]:
    if marks is None:
        return {}
    return {
        "passed": marks.passed,
        "right": list(marks.right),
        "wrong": list(marks.wrong),
        "missing": list(marks.missing),
        "violated": list(marks.violated),
    }


def _task(exercise: Exercise, seed: int, data: dict[str, Any]) -> Iterator[str]:
    from chasles.report.records import as_json

    yield f"Exercise {exercise.number}  {exercise.title}, new data {seed}"
    for text in exercise.asked:
        yield f"  - {text}"
    yield as_json(data)
    yield "Check an answer:"
    yield f"  chasles practice {exercise.number} --seed {seed} --check answer.json"


def _marks(marks: Grade) -> Iterator[str]:
    for word, names in (("right", marks.right), ("wrong", marks.wrong), ("missing", marks.missing)):
        if names:
            yield f"{word}: {', '.join(names)}"
    yield from (f"not satisfied: {says}" for says in marks.violated)
