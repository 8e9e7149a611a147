"""The text of every generated file, from the statements that ask for kernels."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from importlib import import_module
from pathlib import Path
from typing import NamedTuple

from chasles.bounds.bound import Bound
from chasles.bounds.proving import bound_of, key_of, remembered
from chasles.cli.answers import answers
from chasles.cli.book import decisions
from chasles.cli.checkout import installed_folder
from chasles.cli.failures import BAD_INPUT, Failure, complain, failing
from chasles.decisions.prediction import predict
from chasles.decisions.processes import spread
from chasles.decisions.recalled import session_of
from chasles.decisions.session import Session
from chasles.lowering.program import Program
from chasles.lowering.request import Request
from chasles.report.verdict_page import pages
from chasles.statements import Chapter, Entry
from chasles.statements import Kernel as Asked
from chasles.statements.packages import BOOK
from chasles.targets import MANIFEST, EmissionError, Origin, TargetKernel, discover, render, spelled_out
from chasles.targets.commission import kernel_of
from chasles.targets.kernel import require_plain

A_KERNEL = 0.025
"""About how many seconds it takes to make a kernel and to prove it equal to its statement."""


class Commissioned(NamedTuple):
    """The kernels that were made, and of each of the others where it is declared, its name, and why it is refused."""

    kernels: tuple[TargetKernel, ...] = ()
    refused: tuple[str, ...] = ()

    def complained(self) -> int:
        """The exit status, once each kernel that was refused is told on a line of standard error."""
        return complain(f"refused: {why}" for why in self.refused)


def everything(book: Chapter, folder: Path, anew: bool) -> tuple[Commissioned, dict[str, str]]:
    """The kernels of a chapter, and the text of each file that belongs into the folder. Raises Failure."""
    session = session_of(book, anew)
    made = commissioned(book.entries, session, installed_folder(book), folder)
    return made, emitted(book, made.kernels, pages(book, session) | answers(book, session))


def in_languages(book: Chapter, names: Sequence[str], anew: bool) -> tuple[Commissioned, dict[str, str]]:
    """The kernels of a chapter, and the text of each file in the languages of these names. Raises Failure."""
    with failing(EmissionError, status=BAD_INPUT):
        targets = discover(named=names)
    made = commissioned(book.entries, session_of(book, anew), installed_folder(book))
    with failing(EmissionError, before="nothing was emitted: "):
        return made, spelled_out(made.kernels, targets, origin=_origin(book))


def commissioned(entries: Sequence[Entry], session: Session, *folders: Path | None) -> Commissioned:
    """The kernels of all statements that ask for some; error bounds that a manifest in `folders` has are taken over.

    Raises Failure where all are refused, and where a bound has to be proved without python-flint.
    """
    # In a checkout what is installed is what is written to: its manifest is read once.
    manifests = dict.fromkeys(folder.resolve() / MANIFEST for folder in folders if folder)
    known = {key: bound for manifest in manifests for key, bound in _known(manifest).items()}

    def prove(program: Program, request: Request) -> Bound:
        return known.get(key_of(program, request)) or _proved(program, request)

    def made(asked: tuple[Entry, Asked]) -> TargetKernel | str:
        """The kernel, or why it is refused."""
        try:
            return kernel_of(asked[0], session.decide, asked[1], prove)
        except EmissionError as error:
            return f"{asked[0].place}{error}"

    asking = [(entry, kernel) for entry in entries for kernel in entry.kernels]
    # All is decided before the work is spread, so that nothing is decided twice.
    predict(session, [entry.statement for entry in entries])
    list(decisions(entries, session))
    found = spread(made, asking, A_KERNEL)
    refused = tuple(why for why in found if isinstance(why, str))
    if refused and len(refused) == len(asking):
        raise Failure(f"nothing was emitted, all kernels are refused: {'; '.join(refused)}")
    return Commissioned(tuple(kernel for kernel in found if isinstance(kernel, TargetKernel)), refused)


def _known(manifest: Path) -> Mapping[str, Bound]:
    """What was proved before; nothing where there is no manifest that can be read."""
    try:
        return remembered(manifest.read_text("utf-8"))
    except (OSError, UnicodeDecodeError):
        return {}


def _proved(program: Program, request: Request) -> Bound:
    try:
        return bound_of(program, request)
    except ModuleNotFoundError as error:
        if error.name != "flint":
            raise
        raise Failure(
            f"nothing was emitted: the error bound of {program.name} is not known yet, and its proof needs "
            "python-flint; install it with: pip install 'chasles[fast]'"
        ) from error


def emitted(book: Chapter, kernels: tuple[TargetKernel, ...], beside: Mapping[str, str]) -> dict[str, str]:
    """The text of each file by its path: the kernels in all languages, and what stands beside.

    Raises Failure where a language cannot spell a kernel.
    """
    # The ufuncs of another chapter are made when they are imported, of its C library: no extension module is built.
    targets = [target for target in discover() if book.package == BOOK or target.name != "gufunc"]
    with failing(EmissionError, before="nothing was emitted: "):
        return render(kernels, targets, beside, origin=_origin(book))


def _origin(book: Chapter) -> Origin:
    """What the files say of the chapter. Raises Failure for conventions that are no texts of one line."""
    conventions = getattr(import_module(book.package), "CONVENTIONS", ())
    if not isinstance(conventions, tuple) or not all(isinstance(said, str) for said in conventions):
        raise Failure(f"the CONVENTIONS of {book.package} must be a tuple of texts, not {conventions!r}", BAD_INPUT)
    with failing(ValueError, status=BAD_INPUT):
        for said in conventions:
            require_plain(said, f"the CONVENTIONS of {book.package}")
    return Origin("" if book.package == BOOK else book.package, conventions)
