"""`chasles summary`."""

from __future__ import annotations

from itertools import chain
from typing import TYPE_CHECKING, Any

import click

from chasles.cli.book import as_data, chosen, of_sections, print_data
from chasles.cli.chosen_chapter import chapter
from chasles.cli.failures import complain

if TYPE_CHECKING:
    from chasles.cli.comparison import Verification
    from chasles.cli.outcome import Outcome


@click.command("summary", short_help="Decide and compare; sum up by section.", epilog="Example: chasles summary")
@of_sections
@click.option("--samples", type=click.IntRange(min=1), default=100, show_default=True, help="Points for each kernel.")
@as_data
def command(sections: tuple[str, ...], samples: int, json: bool) -> int:
    """Decide the chapter, check the certificates again, compare the kernels with 50 digits; sum up by section.

    The exit status is 1 where that of `decide` or of `verify` is.
    """
    from chasles.cli.comparison import installed_kernels, verified
    from chasles.cli.outcome import decide

    book = chapter()
    entries = chosen(book, (), sections)
    outcome, session = decide(entries, book)
    asking = [(entry, kernel) for entry in entries for kernel in entry.kernels]
    verification = verified(asking, installed_kernels(book), ("generic",), samples, session)
    if json:
        print_data(_data(outcome, verification))
    else:
        _show(outcome, verification)
    return complain(chain(outcome.failures, verification.failures(strict=False)))


def _data(outcome: Outcome, verification: Verification) -> dict[str, Any]:
    from chasles.report.decisions import tallies

    again = outcome.rechecked
    assert again is not None
    return {
        "sections": [tally.as_json() for tally in tallies(outcome.decided)],
        "decided": {"statements": len(outcome.decided), "seconds": round(outcome.deciding, 3)},
        "rechecked": {
            "certificates": again.certificates,
            "counterexamples": again.counterexamples,
            "seconds": round(again.seconds, 3),
            "rejected": [entry.number for entry, _ in again.rejected],
        },
        "kernels": verification.as_json(),
    }


def _show(outcome: Outcome, verification: Verification) -> None:
    from chasles.report.decisions import summary_table, tallies, wrong_as_printed
    from chasles.report.screen import Screen

    screen = Screen()
    screen.show(*summary_table(screen, tallies(outcome.decided)), "")
    screen.show(*outcome.in_words, *wrong_as_printed(outcome.decided), "")
    screen.show(*verification.in_words)
