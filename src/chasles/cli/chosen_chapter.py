"""The chapter of `--chapter`, loaded, with the places of declarations that are wrong."""

from __future__ import annotations

import sys
import traceback
from importlib.util import find_spec
from pathlib import Path

import click

from chasles.cli.failures import BAD_INPUT, Failure
from chasles.statements import Chapter, load
from chasles.statements.packages import BOOK, folder_of
from chasles.vocabulary import Misfit
from chasles.vocabulary.arguments import WrongArgument

PRINTED_SO = "if the book prints it so, write printed(lambda: ...) around it, and sic=True in the statement"


def chapter() -> Chapter:
    """The chapter of `--chapter`, or the book. Raises Failure, with the place of a declaration that is wrong."""
    package = chapter_named()
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
    return None if chapter_named() == BOOK else _place(error, chapter_named())


def package_chosen() -> str:
    """The package of the chapter, which is loaded if it is not the book."""
    return BOOK if chapter_named() == BOOK else chapter().package


def chapter_named() -> str:
    """What `--chapter` names, a package or a folder, else the book."""
    context = click.get_current_context(silent=True)
    return (context and context.find_root().params.get("chapter")) or BOOK


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
