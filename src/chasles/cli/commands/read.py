"""`chasles read PAGE`: the equations of a page, read and decided."""

from __future__ import annotations

from collections.abc import Callable, Iterator, Sequence
from contextlib import suppress
from pathlib import Path
from time import sleep
from typing import TYPE_CHECKING

import click

from chasles.cli.book import as_data, print_data
from chasles.cli.failures import BAD_INPUT, FAILED, Failure, complain
from chasles.cli.files import text_of_file, write_whole
from chasles.cli.quiet import is_quiet

if TYPE_CHECKING:
    from chasles.cli.page_reading import PageMatch
    from chasles.pages.page import ReadPage
    from chasles.reading.printed import PrintedPage

MOST_NAMED = 8
POLLED = 0.5
"""Seconds between two looks at the files that are watched."""


@click.command(
    "read",
    short_help="Read a page and decide its equations.",
    epilog="Example: chasles read paper.tex --notation paper.toml",
)
@click.argument("pages", metavar="PAGE...", nargs=-1, required=True, type=click.Path(path_type=Path))
@click.option("--notation", metavar="FILE", help="What the letters are: a TOML file, a module, a chapter.")
@click.option(
    "--macros", type=click.Path(path_type=Path), help="A file with LaTeX or MathJax macros that the page uses."
)
@click.option("--inline", is_flag=True, help="Read the equations between single dollars too.")
@click.option("--input", "follow", is_flag=True, help="Read the files that the page names with \\input too.")
@click.option("--propose", is_flag=True, help="Print a first notation for the letters of the page instead.")
@click.option(
    "--out", type=click.Path(path_type=Path), help="A folder for a chapter of what is read, and what is asked of you."
)
@click.option("-q", "--quiet", is_flag=True, help="Show only what is wrong, open, ambiguous or unread.")
@click.option("--github", is_flag=True, help="Show what is wrong, open, ambiguous or unread as annotations of GitHub.")
@click.option(
    "--html", metavar="FILE", type=click.Path(path_type=Path), help="Write what is found beside each equation."
)
@click.option("--strict", is_flag=True, help="Status 1 for a wrong equation too.")
@click.option("--watch", is_flag=True, help="Read again whenever a page, its macros or the notation changes.")
@as_data
def command(
    pages: tuple[Path, ...],
    notation: str | None,
    macros: Path | None,
    inline: bool,
    follow: bool,
    propose: bool,
    out: Path | None,
    quiet: bool,
    github: bool,
    html: Path | None,
    strict: bool,
    watch: bool,
    json: bool,
) -> int:
    """Read the displayed equations of a page (LaTeX, Markdown, reStructuredText, HTML, a notebook) and decide them.

    Each finding is a line, FILE:LINE: (NUMBER) verdict: reason. A wrong equation is a finding, not a failure, unless
    --strict is given; status 1 means that something is open, ambiguous or unread. With --out, questions.toml asks for
    the role of what is open: fill it in, and run the command again. With --watch, Control-C ends it.
    """
    from chasles.cli.page_reading import printed_on, read
    from chasles.pages.findings_told import is_fine
    from chasles.pages.folder import QUESTIONS
    from chasles.pages.known_answers import recalled, retained

    if propose:
        return _propose([printed_on(page, macros, inline, follow) for page in pages])
    notation = _required(notation, pages, html, out, watch)
    known = recalled()

    def once() -> int:
        found = [read(page, printed_on(page, macros, inline, follow).equations, notation, out, known) for page in pages]
        retained(known)
        _tell(found, notation, html, quiet or github or is_quiet(), github, json)
        equations = [each for one in found for each in one.page.equations]
        return 0 if all(is_fine(each) if strict else each.is_decided for each in equations) else FAILED

    files = [*pages, *filter(None, [macros, Path(notation), out and out / QUESTIONS])]
    return _whenever_changed(files, once) if watch else once()


def _required(notation: str | None, pages: Sequence[Path], html: Path | None, out: Path | None, watch: bool) -> str:
    """The notation that was given. A page that is not there is told before what is missing besides."""
    if html and len(pages) > 1:
        raise Failure("--html writes the findings on one page: name one page", BAD_INPUT)
    if notation is None:
        for page in pages:
            if str(page) != "-":
                text_of_file(page)
        raise click.UsageError("say what the letters are with --notation; --propose prints a first notation")
    if out is not None and len(pages) > 1:
        raise click.UsageError("--out takes one page at a time")
    if watch and Path("-") in pages:
        raise click.UsageError("--watch takes files: what is piped in is read once")
    return notation


def _whenever_changed(files: Sequence[Path], once: Callable[[], int]) -> int:
    """Do it whenever one of the files changes, until interrupted; what fails is told."""
    for _ in changes(files, sleep):
        try:
            once()
        except Failure as failure:
            complain([str(failure)])
    return 0


def changes(files: Sequence[Path], wait: Callable[[float], None]) -> Iterator[None]:
    """Something to do now, and again whenever one of the files was written, made or removed, until interrupted."""
    before: list[int] | None = None
    with suppress(KeyboardInterrupt):
        while True:
            now = [each.stat().st_mtime_ns if each.exists() else 0 for each in files]
            if now != before:
                yield
            before = now
            wait(POLLED)


def _tell(
    read: Sequence[PageMatch], notation: str, html: Path | None, is_short: bool, github: bool, json: bool
) -> None:
    """Tell the findings, and which entries of the notation are of no page."""
    found = [each.page for each in read]
    _tell_unmatched(f"{notation}: no letter of the page matches", [each.entries for each in read])
    _tell_unmatched(f"{notation}: the page has no equation with the number", [each.numbers for each in read])
    empty = [page.file for page in found if not page.equations]
    if empty and not is_quiet():
        more = "--inline reads those between single dollars, --macros FILE those that macros of a style file open"
        complain([f"{file}: no displayed equation; {more}" for file in empty])
    if html:
        from chasles.report.read_page import read_page_as_html

        write_whole(html, read_page_as_html(found[0]))
    _show(found, is_short, github, json)


def _tell_unmatched(said: str, entries: Sequence[Sequence[str]]) -> None:
    """Say which entries of a notation nothing on any of the pages matches."""
    unmatched = [entry for entry in entries[0] if all(entry in others for others in entries)]
    if unmatched and not is_quiet():
        shown = [f"'{entry}'" for entry in unmatched[:MOST_NAMED]]
        more = [f"{len(unmatched) - MOST_NAMED} more"] if len(unmatched) > MOST_NAMED else []
        complain([f"{said} {', '.join(shown + more)}"])


def _show(found: Sequence[ReadPage], is_short: bool, github: bool, json: bool) -> None:
    from chasles.pages.findings_told import annotation_of, is_fine, line_of, records_of

    if json:
        records = [records_of(page) for page in found]
        print_data(records[0] if len(records) == 1 else records)
    for page in () if json else found:
        for each in page.equations:
            if not is_short or not is_fine(each):
                click.echo((annotation_of if github else line_of)(each, page.file))
        if not is_short:
            click.echo(page.summary)


def _propose(printed: Sequence[PrintedPage]) -> int:
    from chasles.reading.proposal import proposed

    equations = [each for page in printed for each in page.equations]
    click.echo(proposed(equations, [each for page in printed for each in page.remarks]), nl=False)
    return 0
