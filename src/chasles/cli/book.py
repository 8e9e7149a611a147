"""What commands share: options that choose statements, the statements chosen, their decisions, output as data."""

from __future__ import annotations

import json
from collections.abc import Callable, Iterator, Sequence
from typing import TYPE_CHECKING, Any

import click

from chasles.cli import completing
from chasles.cli.failures import BAD_INPUT, Failure
from chasles.nearest import nearest
from chasles.report.waiting import progress
from chasles.statements import Chapter, Entry
from chasles.statements.citing import UnknownNumber, statements_cited

if TYPE_CHECKING:
    from chasles.decisions.session import Decision, Session


def of_numbers(command: Callable[..., Any]) -> Callable[..., Any]:
    """Give a command the argument `numbers`."""
    offer = completing.numbers
    return click.argument("numbers", nargs=-1, metavar="[NUMBER]...", shell_complete=offer)(command)


def of_sections(command: Callable[..., Any]) -> Callable[..., Any]:
    """Give a command the option `--section`."""
    return click.option(
        "--section",
        "sections",
        multiple=True,
        metavar="S",
        help="A section with all below it; may be repeated.",
        shell_complete=completing.sections,
    )(command)


def as_data(command: Callable[..., Any]) -> Callable[..., Any]:
    """Give a command the option `--json`."""
    return click.option("--json", "json", is_flag=True, help="Print JSON for a program to read.")(command)


def print_data(value: object) -> None:
    """Print the value as JSON for people and machines: indented, ASCII only, so that every terminal can show it."""
    click.echo(json.dumps(value, indent=2))


def chosen(book: Chapter, numbers: Sequence[str], sections: Sequence[str]) -> tuple[Entry, ...]:
    """The statements with one of the numbers (or names), or of one of the sections; all without either.

    Raises Failure naming the number or section that the book does not have, and those near it.
    """
    for section in sections:
        known = [known.number for known in book.sections]
        if not any(number == section or number.startswith(f"{section}.") for number in known):
            raise Failure(f"the book has no section {section!r}{nearest(section, known)}", BAD_INPUT)
    if not numbers:
        return book.select((), sections)
    try:
        cited = {entry.name for entry in statements_cited(book, numbers)}
    except UnknownNumber as error:
        raise Failure(f"{error}; `chasles list` shows all", BAD_INPUT) from error
    return book.select(tuple(cited), sections)


def decisions(entries: Sequence[Entry], session: Session) -> Iterator[tuple[Entry, Decision]]:
    """The decision on each statement, with a progress bar where it takes long."""
    return progress(session.decide_all(entries), len(entries), "Deciding")
