"""Which texts does an expression become? The functions to read, and the files that are compiled."""

from __future__ import annotations

from collections.abc import Iterable, Iterator, Mapping, Sequence
from dataclasses import dataclass
from dataclasses import replace as with_fields
from pathlib import Path

from chasles.lowering.refusal import LoweringError
from chasles.targets import EmissionError, Origin, Page, Target, TargetKernel, render
from chasles.targets.c import TARGET as C
from chasles.targets.c.blocks import loop_name
from chasles.targets.c.functions import PRECISIONS, single
from chasles.targets.constants import DOUBLE, SINGLE
from chasles.targets.emit import filled
from chasles.targets.numpy import TARGET as NUMPY
from chasles.targets.offering import c_sources

__all__ = ["Sources", "library_of", "sources_of"]

_HERE = Path(__file__).parent
ORIGIN = Origin(command="chasles.compile")


@dataclass(frozen=True, slots=True)
class Sources:
    """The C and NumPy functions as text, and the `files` that a compiler takes, by path."""

    c: str
    numpy: str
    files: Mapping[str, str]


def sources_of(kernel: TargetKernel) -> Sources:
    """The texts of a kernel. Raises `LoweringError` where no target can spell it."""
    try:
        compiled = render([kernel], [C, Target("shown", _HERE, _shown)], head=(), origin=ORIGIN)
    except EmissionError as error:
        raise LoweringError(str(error)) from None
    return Sources(compiled["shown/function.c"], compiled["shown/function.py"], library_of([kernel], compiled))


def library_of(kernels: Sequence[TargetKernel], texts: Mapping[str, str]) -> dict[str, str]:
    """The files of a shared object, of the emitted `texts`: the C library and what a ufunc calls."""
    loops = [loop_name(kernel, precision) for kernel in kernels for precision in (SINGLE, DOUBLE)]
    page = Page("entry.c", "entry.c.jinja", {"loops": loops})
    return {**c_sources(texts), "src/entry.c": filled(_HERE, page, ORIGIN)}


def _shown(kernels: tuple[TargetKernel, ...]) -> Iterator[Page]:
    """The functions alone."""
    [kernel] = kernels
    functions: Iterable[object] = [single(kernel, precision) for precision in PRECISIONS]
    yield Page("function.c", "function.c.jinja", {"functions": functions})
    for page in NUMPY.pages(kernels):
        if page.path == "kernels.py":
            yield with_fields(page, path="function.py", template="function.py.jinja")
