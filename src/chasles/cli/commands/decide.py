"""`chasles decide [NUMBER ...]`."""

from __future__ import annotations

from importlib import import_module
from pathlib import Path
from typing import TYPE_CHECKING

import click

from chasles.cli.book import as_data, chosen, of_numbers, of_sections, print_data
from chasles.cli.chosen_chapter import chapter
from chasles.cli.failures import complain

if TYPE_CHECKING:
    from chasles.cli.outcome import Outcome


@click.command(
    "decide",
    short_help="Decide whether equations are right.",
    epilog="Example: chasles decide 3.16 3.18, or chasles decide --section 3.2",
)
@of_numbers
@of_sections
@as_data
@click.option("--brief", is_flag=True, help="Show findings and totals only.")
@click.option("--recheck/--no-recheck", default=True, help="Check the verdicts again without the prover (default).")
@click.option(
    "--coq",
    type=click.Path(path_type=Path, file_okay=False),
    metavar="FOLDER",
    help="Write verdicts as theorems for Coq to this folder; where Coq is installed, it checks them.",
)
@click.option(
    "--anew",
    is_flag=True,
    help="Search for all proofs again, and let Coq check them again; do not check what is known.",
)
def command(
    numbers: tuple[str, ...],
    sections: tuple[str, ...],
    json: bool,
    brief: bool,
    recheck: bool,
    coq: Path | None,
    anew: bool,
) -> int:
    """Decide whether equations are right: all of them, or those named.

    Verdicts that come with the chapter, or that an earlier run found, are checked; new ones are searched for. An
    equation that is wrong in the book is a finding, not a failure. Status 1 means that something could not be decided,
    that a declared correction is not proved, or that a verdict was rejected when it was checked again.
    """
    from chasles.cli.hint import say_once_what_is_faster
    from chasles.cli.outcome import decide
    from chasles.report.records import record
    from chasles.statements.loading import unlisted

    book = chapter()
    outcome, session = decide(chosen(book, numbers, sections), book, recheck=recheck, anew=anew)
    theorems = None
    if coq is not None:
        from chasles.cli.theorems import written

        theorems = written(coq, outcome.decided, session.decide, anew)
    if json:
        records = [record(entry, decision) for entry, decision in outcome.decided]
        print_data({"statements": records} | ({"coq": theorems.record} if theorems else {}))
    else:
        _show(outcome, brief)
        for line in theorems.in_words if theorems else ():
            click.echo(line)
    if left_out := unlisted(import_module(book.package)):
        click.echo(f"hint: not among the SECTIONS of {book.package}, and left out: {', '.join(left_out)}", err=True)
    say_once_what_is_faster()
    return complain(outcome.failures)


def _show(outcome: Outcome, brief: bool) -> None:
    from rich.text import Text

    from chasles.report.decisions import findings, verdict_table
    from chasles.report.screen import Screen

    screen = Screen()
    if not brief:
        screen.show(*verdict_table(screen, outcome.decided))
    screen.show(*findings(screen, outcome.decided))
    screen.show("", *(Text(line) for line in outcome.in_words))
