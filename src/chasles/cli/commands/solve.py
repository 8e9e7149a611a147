"""`chasles solve EX`."""

from __future__ import annotations

from pathlib import Path

import click

from chasles.cli import completing
from chasles.cli.book import as_data, print_data
from chasles.cli.chosen_chapter import package_chosen
from chasles.cli.failures import BAD_INPUT, Failure
from chasles.cli.files import text_of_file, write_whole
from chasles.cli.quiet import is_quiet


@click.command("solve", short_help="Work an exercise.", epilog="Example: chasles solve 3.7 --data my.json")
@click.argument("exercise", metavar="EX", shell_complete=completing.exercises)
@click.option("--data", type=click.Path(path_type=Path), metavar="FILE", help="JSON with other data; '-' reads them.")
@click.option("--html", type=click.Path(path_type=Path), metavar="FILE", help="Write a page with formulas and picture.")
@click.option("--hint", type=click.IntRange(1), metavar="N", help="Say the first N steps, without their values.")
@as_data
def command(exercise: str, data: Path | None, html: Path | None, hint: int | None, json: bool) -> None:
    """Work an exercise of the chapter for its own data or for others, step by step, exactly.

    Data that contradict themselves are answered as such and are no error. Data that are malformed are: exit status 2.
    """
    from chasles.decisions.decision import DoesNotStand
    from chasles.exercises.data import DataError, read_json
    from chasles.exercises.solving import solve_with
    from chasles.report.screen import Screen
    from chasles.report.worked_page import hints_page, worked_page
    from chasles.statements.exercises import UnknownExercise

    package = package_chosen()
    try:
        given = read_json(text_of_file(data)) if data is not None else {}
        solution = solve_with(exercise.removeprefix("Ex").strip(), given, package)
    except (DataError, UnknownExercise) as error:
        raise Failure(str(error.args[0]), BAD_INPUT) from error
    except DoesNotStand as error:
        raise Failure(f"exercise {exercise} is not solved: {error}") from error
    if html is not None:
        from chasles.report.notebook.html import worked

        write_whole(html, worked(solution, whole=True))
    if hint is not None and json:
        print_data({"exercise": solution.exercise, "hints": solution.hints[:hint], "of": len(solution.hints)})
    elif hint is not None:
        Screen().show(*hints_page(solution, hint))
    elif json:
        print_data(solution.as_data())
    elif html is None:
        screen = Screen()
        screen.show(*worked_page(solution, screen.signs))
    elif not is_quiet():
        click.echo(f"wrote {html}", err=True)
