"""Where generated files are written by default.

The book's go into `generated/` of the checkout around the current folder, those of another chapter into `generated/` in
its own package.
"""

from __future__ import annotations

from importlib import import_module
from importlib.util import find_spec
from pathlib import Path

from chasles.cli.book import BOOK
from chasles.cli.failures import BAD_INPUT, Failure
from chasles.statements import Chapter
from chasles.statements.packages import generated_package

__all__ = ["GENERATED", "generated_folder", "installed_folders"]

GENERATED = "generated"
DERIVATIONS = "derivations"


def installed_folders(book: Chapter) -> tuple[Path, ...]:
    """Where what was emitted of a chapter is imported from; none where nothing was."""
    try:
        return tuple(map(Path, import_module(generated_package(book.package)).__path__))
    except ModuleNotFoundError:
        return ()


def generated_folder(book: Chapter, start: Path) -> Path:
    """The folder `generated` of the checkout that holds `start`, for another chapter than the book that in its package.

    Raises Failure outside every checkout, and in one whose declarations are not those that are loaded: another
    checkout's chapter must not be written into this one.
    """
    if book.package != BOOK:
        return Path(next(iter(import_module(book.package).__path__))) / GENERATED
    start = start.resolve()
    for folder in (start, *start.parents):
        if (folder / DERIVATIONS / "__init__.py").is_file() and (folder / "pyproject.toml").is_file():
            _require_loaded(folder / DERIVATIONS)
            return folder / GENERATED
    raise Failure(
        f"{start} is in no checkout: run this below the folder that holds {DERIVATIONS}/, or name a folder with --out",
        BAD_INPUT,
    )


def _require_loaded(declarations: Path) -> None:
    spec = find_spec(BOOK)
    loaded = [Path(place).resolve() for place in (spec.submodule_search_locations or ())] if spec else []
    if declarations.resolve() not in loaded:
        raise Failure(
            f"this chasles reads {loaded[0] if loaded else 'no declarations'}, not {declarations}: "
            "run the one that `make` installs here (.venv/bin/chasles), or name a folder with --out",
            BAD_INPUT,
        )
