"""Which texts does an expression become? The functions to read, and the files that are compiled."""

from __future__ import annotations

from collections.abc import Iterable, Iterator, Mapping
from dataclasses import dataclass
from dataclasses import replace as with_fields
from pathlib import Path

from chasles.lowering.refusal import LoweringError
from chasles.targets import EmissionError, Page, Target, TargetKernel, render
from chasles.targets.c import TARGET as C
from chasles.targets.c.blocks import loop_name
from chasles.targets.c.functions import PRECISIONS, single
from chasles.targets.constants import DOUBLE, SINGLE
from chasles.targets.numpy import TARGET as NUMPY

__all__ = ["BLOCKS", "INCLUDES", "SOURCES", "Sources", "sources_of"]

COMMAND = "chasles.compile"
_HERE = Path(__file__).parent

SOURCES = ("src/expression.c", "src/batches.c", "src/entry.c")
"""What is compiled once; in `TargetKernel` the section is `expression`."""
BLOCKS = ("src/expression_blocks.c", "src/trigonometry_blocks.c")
"""What is compiled for each set of instructions."""
INCLUDES = ("include", "src")


@dataclass(frozen=True, slots=True)
class Sources:
    """The C and NumPy functions as text, and the `files` that a compiler takes, by path."""

    c: str
    numpy: str
    files: Mapping[str, str]


def sources_of(kernel: TargetKernel) -> Sources:
    """The texts of a kernel. Raises `LoweringError` where no target can spell it."""
    try:
        compiled = render([kernel], [Target("c", C.templates, _compiled), Target("shown", _HERE, _shown)], head=())
    except EmissionError as error:
        raise LoweringError(str(error)) from None
    files = {path.removeprefix("c/"): text for path, text in compiled.items() if path.startswith("c/")}
    files["src/entry.c"] = compiled["shown/entry.c"]
    return Sources(compiled["shown/function.c"], compiled["shown/function.py"], files)


def _compiled(kernels: tuple[TargetKernel, ...]) -> Iterator[Page]:
    """The pages of the C library without its self-test."""
    for page in C.pages(kernels):
        if not page.path.startswith("test/"):
            yield _signed(page)


def _shown(kernels: tuple[TargetKernel, ...]) -> Iterator[Page]:
    """The functions alone, and the loop that a ufunc calls."""
    [kernel] = kernels
    functions: Iterable[object] = [single(kernel, precision) for precision in PRECISIONS]
    yield _signed(Page("function.c", "function.c.jinja", {"functions": functions}))
    loops = {"twofold": loop_name(kernel, DOUBLE), "single": loop_name(kernel, SINGLE)}
    yield _signed(Page("entry.c", "entry.c.jinja", loops))
    for page in NUMPY.pages(kernels):
        if page.path == "kernels.py":
            yield _signed(with_fields(page, path="function.py", template="function.py.jinja"))


def _signed(page: Page) -> Page:
    return with_fields(page, values={**page.values, "command": COMMAND})
