"""Where generated files are written by default, and where those of a chapter are.

The book's go into `generated/` of the checkout around the current folder, those of another chapter into `generated/` in
its own package. Where a chapter's were written elsewhere, the cache keeps the place.
"""

from __future__ import annotations

import tomllib
from contextlib import suppress
from hashlib import sha256
from importlib import import_module
from importlib.util import find_spec
from pathlib import Path

from chasles import cache
from chasles.cli.failures import BAD_INPUT, Failure
from chasles.statements import Chapter
from chasles.statements.packages import BOOK, generated_package

GENERATED = "generated"
DERIVATIONS = "derivations"


def installed_folder(book: Chapter) -> Path | None:
    """Where what was emitted last of a chapter is; None where nothing is."""
    from chasles.targets import MANIFEST

    if book.package == BOOK:
        with suppress(ModuleNotFoundError):
            return Path(next(iter(import_module(generated_package(BOOK)).__path__)))
        return None
    places = [_folder_of(book) / GENERATED]
    with suppress(OSError):
        places.insert(0, Path(_note(book).read_text("utf-8")))
    return next((place for place in places if (place / MANIFEST).is_file()), None)


def manifest(book: Chapter) -> str:
    """The manifest of the emitted kernels; nothing where nothing was emitted. Raises Failure where it is damaged."""
    from chasles.targets import MANIFEST

    folder = installed_folder(book)
    if folder is None or not (folder / MANIFEST).exists():
        return ""
    try:
        text = (folder / MANIFEST).read_text("utf-8")
        tomllib.loads(text)
    except (OSError, ValueError) as error:
        raise Failure(f"{folder.name}/{MANIFEST} cannot be read ({error}): `chasles emit` writes it anew") from error
    return text


def remember(book: Chapter, folder: Path) -> None:
    """Note where a chapter's files were written last. A cache that cannot be written is none: nothing is said."""
    if book.package != BOOK and cache.folder() is not None:
        with suppress(OSError):
            _note(book).parent.mkdir(parents=True, exist_ok=True)
            cache.keep(_note(book), str(folder.resolve()).encode())


def generated_folder(book: Chapter, start: Path) -> Path:
    """The folder `generated` of the checkout that holds `start`, for another chapter than the book that in its package.

    Raises Failure outside every checkout, and in one whose declarations are not those that are loaded: another
    checkout's chapter must not be written into this one.
    """
    if book.package != BOOK:
        return _folder_of(book) / GENERATED
    start = start.resolve()
    for folder in (start, *start.parents):
        if (folder / DERIVATIONS / "__init__.py").is_file() and (folder / "pyproject.toml").is_file():
            _require_loaded(folder / DERIVATIONS)
            return folder / GENERATED
    raise Failure(
        f"{start} is in no checkout: run this below the folder that holds {DERIVATIONS}/, or name a folder with --out",
        BAD_INPUT,
    )


def _folder_of(book: Chapter) -> Path:
    return Path(next(iter(import_module(book.package).__path__))).resolve()


def _note(book: Chapter) -> Path:
    """The file that holds the place. Raises OSError where nothing is cached."""
    folder = cache.folder()
    if folder is None:
        raise FileNotFoundError("there is no cache")
    return folder / "written" / sha256(str(_folder_of(book)).encode()).hexdigest()


def _require_loaded(declarations: Path) -> None:
    spec = find_spec(BOOK)
    loaded = [Path(place).resolve() for place in (spec.submodule_search_locations or ())] if spec else []
    if declarations.resolve() not in loaded:
        raise Failure(
            f"this chasles reads {loaded[0] if loaded else 'no declarations'}, not {declarations}: "
            "run the one that `make` installs here (.venv/bin/chasles), or name a folder with --out",
            BAD_INPUT,
        )
