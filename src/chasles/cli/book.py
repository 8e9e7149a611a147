"""The chapter, as the commands use it: loaded, chosen from and decided, with errors that speak to a person."""

from __future__ import annotations

import json
import sys
import traceback
from collections.abc import Callable, Iterator, Sequence
from importlib.util import find_spec
from pathlib import Path
from typing import TYPE_CHECKING, Any

import click

from chasles.cli import completing
from chasles.cli.failures import BAD_INPUT, Failure
from chasles.nearest import nearest
from chasles.report.waiting import progress
from chasles.statements import Chapter, Entry, load
from chasles.statements.citing import UnknownNumber, statements_cited
from chasles.statements.packages import BOOK, folder_of
from chasles.vocabulary import Misfit
from chasles.vocabulary.arguments import WrongArgument

if TYPE_CHECKING:
    from chasles.decisions.session import Decision, Session

PRINTED_SO = "if the book prints it so, write printed(lambda: ...) around it, and sic=True in the statement"


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


def chapter() -> Chapter:
    """The chapter of `--chapter`, or the book. Raises Failure, with the place of a declaration that is wrong."""
    package = _package()
    if package != BOOK and str(Path.cwd()) not in sys.path:
        # Last, so that no module here stands in the way of one that is installed.
        sys.path.append(str(Path.cwd()))
    try:
        return load(package)
    except WrongArgument as error:
        raise Failure(str(error), BAD_INPUT) from error
    except Exception as error:
        found = _place(error, package)
        if found is not None:
            printed_so = f" ({PRINTED_SO})" if isinstance(error, Misfit) and "sic=True" not in str(error) else ""
            raise Failure(f"{found}: {type(error).__name__}: {error}{printed_so}", BAD_INPUT) from error
        if isinstance(error, ModuleNotFoundError) and _holds(error.name, package):
            raise Failure(
                f"there is no chapter {package!r}: give the name of a package that can be imported, from {Path.cwd()} "
                "too, or the path of its folder, with a slash in it",
                BAD_INPUT,
            ) from error
        if type(error).__module__.startswith("chasles."):
            raise Failure(str(error), BAD_INPUT) from error
        raise


def place(error: Exception) -> str | None:
    """File and line of the chapter of `--chapter` in which the error arose, if it arose in one."""
    return None if _package() == BOOK else _place(error, _package())


def package_chosen() -> str:
    """The package of the chapter, which is loaded if it is not the book."""
    return BOOK if _package() == BOOK else chapter().package


def _package() -> str:
    """The package that `--chapter` names, else the book."""
    context = click.get_current_context(silent=True)
    return (context and context.find_root().params.get("chapter")) or BOOK


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


def _place(error: Exception, package: str) -> str | None:
    """File and line of the declaration in which the error arose, if it arose in one."""
    folders = _folders(package)
    if isinstance(error, SyntaxError) and error.filename:
        return f"{error.filename}, line {error.lineno}"
    for frame in reversed(traceback.extract_tb(error.__traceback__)):
        if any(Path(frame.filename).resolve().is_relative_to(folder) for folder in folders):
            return f"{frame.filename}, line {frame.lineno}"
    return None


def _folders(package: str) -> list[Path]:
    """The folders that hold the package, as far as there is one."""
    folder = folder_of(package)
    if folder is not None:
        return [folder]
    try:
        spec = find_spec(package)
    except ModuleNotFoundError:
        return []
    return [Path(place).resolve() for place in (spec.submodule_search_locations or ())] if spec else []


def _holds(name: str | None, package: str) -> bool:
    """Whether the module is the package, or one of those around it."""
    return name is not None and f"{package}.".startswith(f"{name}.")
