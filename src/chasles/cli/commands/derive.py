"""`chasles derive N`."""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from typing import TYPE_CHECKING

import click

from chasles.cli.book import as_data, of_numbers, print_data
from chasles.cli.chosen_chapter import chapter
from chasles.cli.failures import complain

if TYPE_CHECKING:
    from chasles.deriving import CheckedDerivation


@click.command("derive", short_help="Derive an equation step by step.", epilog="Example: chasles derive 3.18")
@of_numbers
@click.option("--latex", is_flag=True, help="Show the equations in LaTeX as well.")
@as_data
def command(numbers: tuple[str, ...], latex: bool, json: bool) -> int:
    """Derive an equation: the result of each step is computed and decided, the last is compared with the printed one.

    Without a number, all derivations are checked, and listed on a line each. The exit status is 1 if a step does not
    hold.
    """
    from chasles.cli.answers import chosen_derivations
    from chasles.decisions.recalled import retained, session_of
    from chasles.deriving import walk
    from chasles.report.derivation_page import derivation_line, derivation_page, derivation_record
    from chasles.report.screen import Screen
    from chasles.report.waiting import progress

    book = chapter()
    chosen, session = chosen_derivations(book, numbers), session_of(book)
    walked = {name: walk(one, session) for name, one in progress(iter(chosen.items()), len(chosen), "Deriving")}
    retained(session.memory)
    if json:
        print_data({"roads": [derivation_record(name, checked) for name, checked in walked.items()]})
    else:
        screen = Screen()
        for place, (name, checked) in enumerate(walked.items()):
            page = derivation_page(screen, name, checked, latex) if numbers else derivation_line(screen, name, checked)
            screen.show(*([""] if place and numbers else []), *page)
    return complain(_failures(list(walked.items())))


def _failures(walked: Sequence[tuple[str, CheckedDerivation]]) -> Iterator[str]:
    """A line for each derivation that is not complete."""
    for name, checked in walked:
        if not checked.arrives:
            last = checked.steps[-1]
            yield f"{name} stops at step {len(checked.steps)}, {last.kind}: {last.reason}"
