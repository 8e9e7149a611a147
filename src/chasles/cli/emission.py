"""The text of every generated file, from the statements that ask for kernels."""

from __future__ import annotations

from collections.abc import Iterable, Mapping
from pathlib import Path

from chasles.bounds import Bound, bound_of, key_of, remembered
from chasles.cli.failures import Failure
from chasles.lowering.program import Program
from chasles.lowering.request import Request
from chasles.proof.judge import Judge
from chasles.report.waiting import watched
from chasles.statements import Entry
from chasles.targets import MANIFEST, EmissionError, Kernel, discover, render
from chasles.targets.commission import kernel_of

__all__ = ["commissioned", "emitted"]


def commissioned(entries: Iterable[Entry], judge: Judge, folder: Path) -> tuple[Kernel, ...]:
    """The kernels of all statements that ask for some; error bounds that the manifest in `folder` has are taken over.

    Raises Failure with a line for each kernel that is refused, and where a bound has to be proved without python-flint.
    """
    known = _known(folder / MANIFEST)

    def prove(program: Program, request: Request) -> Bound:
        return known.get(key_of(program, request)) or _proved(program, request)

    asking = [(entry, kernel) for entry in entries for kernel in entry.kernels]
    kernels, refused = [], []
    for entry, kernel in watched(asking, len(asking), "Lowering"):
        try:
            kernels.append(kernel_of(entry, judge.decide, kernel, prove))
        except EmissionError as error:
            refused.append(str(error))
    if refused:
        raise Failure(f"nothing was emitted; {len(refused)} of {len(asking)} kernels refused: {'; '.join(refused)}")
    return tuple(kernels)


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


def emitted(kernels: tuple[Kernel, ...], beside: Mapping[str, str]) -> dict[str, str]:
    """The text of each file by its path, pages `beside` the kernels among them.

    Raises Failure where a language cannot spell a kernel.
    """
    try:
        return render(kernels, discover(), beside)
    except EmissionError as error:
        raise Failure(f"nothing was emitted: {error}") from error
