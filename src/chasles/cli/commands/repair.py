"""`chasles repair`: what is right instead?"""

from __future__ import annotations

import click

from chasles.cli.book import as_data, chosen, decisions, of_numbers, print_data
from chasles.cli.chosen_chapter import chapter


@click.command(
    name="repair",
    short_help="Find the nearest true equations.",
    epilog="Example: chasles repair 3.96e, or chasles repair",
)
@of_numbers
@click.option("--latex", is_flag=True, help="Show the equations in LaTeX as well.")
@as_data
def command(numbers: tuple[str, ...], latex: bool, json: bool) -> None:
    """Find what is right instead of a wrong equation: the nearest true ones, and what they change.

    Without a number, all equations that are wrong as printed are repaired. One that is right has nothing to repair,
    and for a wrong one nothing may be found: both are reported, and neither is a failure.
    """
    from chasles.decisions.recalled import retained, session_of
    from chasles.report.screen import Screen
    from chasles.report.statement_page import repair_page, repair_record

    book = chapter()
    session = session_of(book)
    decided = list(decisions(chosen(book, numbers, ()), session))
    retained(session.memory)
    shown = [(entry, found) for entry, found in decided if numbers or not found.verdict.true]
    if json:
        print_data({"statements": [repair_record(entry, found) for entry, found in shown]})
        return
    screen = Screen()
    for place, (entry, found) in enumerate(shown):
        screen.show(*([""] if place else []), *repair_page(screen, entry, found, latex))
