"""`chasles verify [NAME ...]`."""

from __future__ import annotations

import click

from chasles.cli import completing
from chasles.cli.book import as_data, print_data
from chasles.cli.chosen_chapter import chapter
from chasles.cli.failures import complain

STRATEGIES = ("generic", "near", "simple")


@click.command(
    "verify",
    short_help="Compare kernels with 50 digits.",
    epilog="Example: chasles verify screw_axis_point --points generic --points near",
)
@click.argument("names", nargs=-1, metavar="[NAME]...", shell_complete=completing.kernels)
@click.option(
    "--points",
    type=click.Choice(STRATEGIES),
    multiple=True,
    default=STRATEGIES[:1],
    show_default=True,
    help="Where: at large, near the singular set, or at simple values; may be repeated.",
)
@click.option("--samples", type=click.IntRange(min=1), default=100, show_default=True, help="How many of each.")
@click.option("--strict", is_flag=True, help="A kernel that loses digits anywhere fails.")
@as_data
def command(names: tuple[str, ...], points: tuple[str, ...], samples: int, strict: bool, json: bool) -> int:
    """Compare the kernels installed here with 50-digit values of their statements, in float64 and float32.

    Errors are in units of the roundoff, relative to the size of the result; a kernel loses digits where its error is
    larger than its inputs explain. Near a singular set the formula of the book may lose digits itself: that is a
    finding. Status 1 means that a kernel loses digits elsewhere. With names, the proved error bounds are shown too.
    """
    from chasles.cli.checkout import manifest
    from chasles.cli.comparison import asking, installed_kernels, verified
    from chasles.decisions.recalled import session_of
    from chasles.report.emission_records import emitted_kernels, proved
    from chasles.report.evidence import evidence_table, losses
    from chasles.report.screen import Screen

    book = chapter()
    asked = asking(book, names)
    found = verified(asked, installed_kernels(book), tuple(dict.fromkeys(points)), samples, session_of(book))
    emitted = emitted_kernels(manifest(book))
    recorded = {kernel.name: emitted[kernel.name] for _, kernel in asked if kernel.name in emitted}
    if json:
        print_data(found.as_json() | {"proved": {name: record["bound"] for name, record in recorded.items()}})
    else:
        screen = Screen()
        # Of all kernels together the bounds would be more than is read: `chasles show` has them.
        bounds = [f"{name}, proved: {line}" for name, record in recorded.items() for line in proved(record)]
        lines = ["", *bounds] if names and bounds else []
        screen.show(*evidence_table(screen, found.evidence), *losses(found.evidence), *lines, "", *found.in_words)
    return complain(found.failures(strict))
