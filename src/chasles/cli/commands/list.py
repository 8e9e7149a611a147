"""`chasles list`."""

from __future__ import annotations

import click

from chasles.cli.book import as_data, chosen, of_sections, print_data
from chasles.cli.chosen_chapter import chapter


@click.command("list", short_help="List the numbers of the book.", epilog="Example: chasles list --section 3.2")
@of_sections
@as_data
def command(sections: tuple[str, ...], json: bool) -> None:
    """List the numbers of the book and what each says."""
    entries = chosen(chapter(), (), sections)
    if json:
        from chasles.report.records import described

        print_data({"statements": [described(entry) for entry in entries]})
    else:
        from chasles.report.decisions import contents
        from chasles.report.screen import Screen

        screen = Screen()
        screen.show(*contents(screen, entries))
