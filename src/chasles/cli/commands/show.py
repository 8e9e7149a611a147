"""`chasles show N`."""

from __future__ import annotations

import click

from chasles.cli import completing
from chasles.cli.book import as_data, chosen, decisions, print_data
from chasles.cli.chosen_chapter import chapter


@click.command("show", short_help="Show an equation and its verdict.", epilog="Example: chasles show 3.16 --latex")
@click.argument("numbers", nargs=-1, required=True, metavar="NUMBER...", shell_complete=completing.numbers)
@click.option("--latex", is_flag=True, help="Show the equation in LaTeX as well.")
@as_data
def command(numbers: tuple[str, ...], latex: bool, json: bool) -> None:
    """Show an equation, what it rests on, its verdict and its certificate or counterexample.

    For each of its kernels, the expression it is made from and its proved error bound, with the rounding model.
    """
    from chasles.cli.checkout import manifest
    from chasles.decisions.recalled import session_of
    from chasles.report.emission_records import emitted_kernels
    from chasles.report.records import described, record
    from chasles.report.screen import Screen
    from chasles.report.statement_page import statement_page

    book = chapter()
    # The parts of a number stand in the order of the proofs; here they are read in the book's.
    entries = sorted(chosen(book, numbers, ()), key=lambda e: (book.numbers.index(e.number), e.statement.part))
    decided = list(decisions(entries, session_of(book)))
    emitted = emitted_kernels(manifest(book))
    if json:
        found = [described(entry, emitted) | record(entry, decision) for entry, decision in decided]
        print_data({"statements": found})
        return
    screen = Screen()
    for place, (entry, decision) in enumerate(decided):
        screen.show(*([""] if place else []), *statement_page(screen, entry, decision, latex, emitted))
