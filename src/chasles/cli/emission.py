"""The text of every generated file, from the statements that ask for kernels."""

from __future__ import annotations

from collections.abc import Iterable, Mapping

from chasles.cli.failures import Failure
from chasles.proof.judge import Judge
from chasles.report.waiting import watched
from chasles.statements import Entry
from chasles.targets import EmissionError, Kernel, discover, render
from chasles.targets.commission import kernel_of

__all__ = ["commissioned", "emitted"]


def commissioned(entries: Iterable[Entry], judge: Judge) -> tuple[Kernel, ...]:
    """The kernels of all statements that ask for some. Raises Failure with a line for each that is refused."""
    asking = [(entry, kernel) for entry in entries for kernel in entry.kernels]
    kernels, refused = [], []
    for entry, kernel in watched(asking, len(asking), "Lowering"):
        try:
            kernels.append(kernel_of(entry, judge.decide, kernel))
        except EmissionError as error:
            refused.append(str(error))
    if refused:
        raise Failure(f"nothing was emitted; {len(refused)} of {len(asking)} kernels refused: {'; '.join(refused)}")
    return tuple(kernels)


def emitted(kernels: tuple[Kernel, ...], beside: Mapping[str, str]) -> dict[str, str]:
    """The text of each file by its path, pages `beside` the kernels among them.

    Raises Failure where a language cannot spell a kernel.
    """
    try:
        return render(kernels, discover(), beside)
    except EmissionError as error:
        raise Failure(f"nothing was emitted: {error}") from error
