"""`chasles practice EX`."""

from __future__ import annotations

from collections.abc import Iterator
from json import dumps
from pathlib import Path
from typing import Any

import click

from chasles.cli import completing
from chasles.cli.book import as_data, print_data
from chasles.cli.chosen_chapter import chapter_named, package_chosen
from chasles.cli.failures import BAD_INPUT, FAILED, Failure
from chasles.cli.files import text_of_file


@click.command(
    "practice", short_help="New data for an exercise; grade an answer.", epilog="Example: chasles practice 3.7 --seed 4"
)
@click.argument("exercise", metavar="EX", shell_complete=completing.exercises)
@click.option("--seed", type=click.IntRange(0, 10**9), default=1, show_default=True, help="Which data are drawn.")
@click.option("--check", type=click.Path(path_type=Path), metavar="FILE", help="JSON with answers to grade; '-' reads.")
@click.option("--rtol", metavar="R", help="Numbers are right within R times the largest of the answer, as in 0.001.")
@click.option("--digits", type=click.IntRange(1, 30), metavar="D", help="The same by so many digits: R = 5/10^D.")
@click.option("--batch", type=click.Path(path_type=Path), metavar="FILE", help="JSON lines to grade; '-' reads.")
@as_data
def command(
    exercise: str, seed: int, check: Path | None, rtol: str | None, digits: int | None, batch: Path | None, json: bool
) -> int:
    """Draw new data for an exercise, with nice numbers; with `--check`, grade an answer for these data.

    An answer is right in any form that is exactly equal, and up to what the exercise leaves open, such as the sense of
    an axis. A decimal is exactly what it shows; with --rtol or --digits it is right if it is near enough. The exit
    status is 1 if a part of the answer is wrong, missing or undecided, and 2 if one is malformed.

    With `--batch`, each line of JSON has answers, and perhaps a seed, an exercise and a tolerance, as in {"id": "ann",
    "seed": 4, "answers": {...}}; a line with the grade is printed for each, or with its error, and then the status is
    2.
    """
    from chasles.decisions.decision import DoesNotStand
    from chasles.exercises.data import DataError, read_json
    from chasles.exercises.practice import grade_lines, practice
    from chasles.statements.exercises import UnknownExercise

    package_chosen()
    chapter = chapter_named()
    try:
        if batch is not None:
            return _graded_lines(grade_lines(text_of_file(batch).splitlines(), exercise, chapter))
        task = practice(exercise, seed, chapter)
        marks = None if check is None else task.grade(_answers(read_json(text_of_file(check))), rtol, digits)
    except (DataError, UnknownExercise) as error:
        raise Failure(str(error.args[0]), BAD_INPUT) from error
    except DoesNotStand as error:
        raise Failure(f"answers to exercise {exercise} cannot be graded: {error}") from error
    if json:
        print_data(task.as_data() | ({} if marks is None else marks.as_data()))
    else:
        from rich.text import Text

        from chasles.report.screen import Screen

        lines = (task if marks is None else marks).in_words
        Screen().show(*(Text(line, overflow="fold") for line in lines))
    return 0 if marks is None or marks.passed else FAILED


def _graded_lines(records: Iterator[dict[str, Any]]) -> int:
    status = 0
    for record in records:
        click.echo(dumps(record))
        status = BAD_INPUT if "error" in record else status
    return status


def _answers(read: dict[str, Any]) -> dict[str, Any]:
    """The answers, alone or as `chasles solve --json` prints them."""
    inner = read.get("answers")
    return inner if isinstance(inner, dict) else read
