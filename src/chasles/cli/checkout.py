"""Where generated files are written by default, and where those of a chapter are.

The C library of a chapter is compiled where the module of its kernels looks for it.
"""

from __future__ import annotations

import tomllib
from collections.abc import Mapping, Sequence
from contextlib import suppress
from hashlib import sha256
from importlib import import_module
from importlib.util import find_spec
from pathlib import Path
from tempfile import TemporaryDirectory

from chasles import cache
from chasles.cli.failures import BAD_INPUT, Failure
from chasles.cli.files import replace_whole
from chasles.statements import Chapter
from chasles.statements.packages import BOOK, generated_package
from chasles.targets import Origin, Page, TargetKernel
from chasles.targets.emit import filled
from chasles.targets.offering import KERNELS, digest_of

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


NEW_CHAPTER = Path(__file__).parent / "new_chapter"
"""The templates of a chapter's package."""


def compiled(kernels: Sequence[TargetKernel], texts: Mapping[str, str], folder: Path) -> Path:
    """The shared object of the kernels, beside what was emitted. Raises Failure where it cannot be made."""
    # A new chapter is written without these.
    from chasles import kernels as installed
    from chasles.compiling.compiler import CompilerFailed, found
    from chasles.compiling.sources import library_of
    from chasles.kernels.chapter import COMPILED

    emitted = f"the kernels are emitted to {folder}, and not compiled"
    if installed.make_ufunc is None:
        raise Failure(f"{emitted}: this chasles has no compiled part, which makes the ufuncs; they run in NumPy")
    compiler = found(installed.instructions)
    if compiler is None:
        raise Failure(f"{emitted}: there is no C compiler, neither cc nor what $CC names; they run in NumPy")
    place = folder / COMPILED / f"{digest_of(texts)}.so"
    try:
        with TemporaryDirectory(prefix="chasles-", ignore_cleanup_errors=True) as room:
            made = compiler.shared_object(library_of(kernels, texts), Path(room)).read_bytes()
        place.parent.mkdir(exist_ok=True)
        former = [path for path in place.parent.glob("*.so") if path != place]
        replace_whole({place: made})
        for path in former:
            path.unlink()
    except (CompilerFailed, OSError) as error:
        raise Failure(f"{emitted}: {error}") from error
    return place


def offered(book: Chapter, folder: Path) -> str:
    """The package from which the kernels can be imported; the chapter gets a module `kernels` if it has none."""
    own = generated_folder(book, folder)
    if folder.resolve() != own.resolve():
        return folder.name
    module = own.parent / KERNELS
    if not module.exists():
        replace_whole({module: filled(NEW_CHAPTER, Page(KERNELS, f"{KERNELS}.jinja", {}), Origin(book.package))})
    is_ours = "from .generated.kernels import" in module.read_text("utf-8")
    return book.package if is_ours else f"{book.package}.generated"
