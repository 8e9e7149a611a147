"""The C library of a chapter compiled, where the module of its kernels looks for it."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from pathlib import Path
from tempfile import TemporaryDirectory

from chasles.cli.checkout import generated_folder
from chasles.cli.failures import Failure, failing
from chasles.cli.files import replace_whole
from chasles.statements import Chapter
from chasles.targets import Origin, Page, TargetKernel
from chasles.targets.emit import filled
from chasles.targets.offering import KERNELS, digest_of

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
    with failing(CompilerFailed, OSError, before=f"{emitted}: "):
        with TemporaryDirectory(prefix="chasles-", ignore_cleanup_errors=True) as room:
            made = compiler.shared_object(library_of(kernels, texts), Path(room)).read_bytes()
        place.parent.mkdir(exist_ok=True)
        former = [path for path in place.parent.glob("*.so") if path != place]
        replace_whole({place: made})
        for path in former:
            path.unlink()
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
