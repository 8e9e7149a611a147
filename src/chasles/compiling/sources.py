"""Which texts does an expression become? The functions to read, and the files that are compiled."""

from __future__ import annotations

from collections.abc import Iterable, Iterator, Mapping, Sequence
from dataclasses import replace as with_fields
from functools import partial
from hashlib import sha256
from pathlib import Path

from chasles.compiling.packing import packing_of
from chasles.compiling.recall import Sources
from chasles.lowering.functions import FUNCTIONS
from chasles.lowering.passes.series import expanded_in_series
from chasles.lowering.program import Program
from chasles.lowering.refusal import LoweringError
from chasles.targets import EmissionError, Origin, Page, Target, TargetKernel, spelled_out
from chasles.targets.c import TARGET as C
from chasles.targets.c import pages
from chasles.targets.c.blocks import block_name, loop_name
from chasles.targets.c.functions import precisions_of, single
from chasles.targets.constants import DOUBLE, SINGLE
from chasles.targets.emit import filled
from chasles.targets.kernel import Heading, signature
from chasles.targets.numpy import TARGET as NUMPY
from chasles.targets.offering import c_sources

_HERE = Path(__file__).parent
ORIGIN = Origin(command="chasles.compile")


def target_kernel(program: Program) -> TargetKernel:
    """What the targets spell: the program in operations that every language has, and what is said of it."""
    digest = sha256(repr(program).encode()).hexdigest()
    heading = Heading("Expression", "given to chasles.compile.", "nothing is claimed", (), digest, section="expression")
    return TargetKernel(expanded_in_series(program), heading)


def sources_of(program: Program, *, narrowed: bool = True) -> tuple[Sources, dict[str, str]]:
    """The texts of a program, and the files for a compiler, in which single precision may be `narrowed` from double.

    Raises `LoweringError` where no target can spell it.
    """
    kernel = target_kernel(program)
    narrowed = narrowed or SINGLE not in precisions_of(kernel)
    is_special = any(FUNCTIONS[step.function].special for step in kernel.program.steps if step.function)
    shown = Target("shown", _HERE, _in_python if is_special else _shown)
    try:
        compiled = spelled_out([kernel], [shown], head=(), origin=ORIGIN)
        packing = packing_of(kernel.program)
        inner = kernel if packing is None else with_fields(kernel, program=packing.program)
        library = with_fields(C, pages=partial(_library, narrowed=narrowed))
        files = {} if is_special else library_of([inner], spelled_out([inner], [library]), narrowed=narrowed)
    except EmissionError as error:
        raise LoweringError(str(error.__cause__ or error)) from None
    digest = sha256(repr(sorted(files.items())).encode()).hexdigest()
    texts = compiled.get("shown/function.c", ""), compiled["shown/function.py"]
    shapes = signature(program), signature(inner.program)
    return Sources(*texts, *shapes, tuple(sorted(files)), digest), files


def library_of(kernels: Sequence[TargetKernel], texts: Mapping[str, str], *, narrowed: bool = False) -> dict[str, str]:
    """The files of a shared object, of the emitted `texts`: the C library and what a ufunc calls.

    Blocks in single precision that are not in the texts are `narrowed` from those in double.
    """
    loops = [loop_name(kernel, precision) for kernel in kernels for precision in (SINGLE, DOUBLE)]
    from_double = [(block_name(kernel, SINGLE), loop_name(kernel, DOUBLE)) for kernel in kernels if narrowed]
    page = Page("entry.c", "entry.c.jinja", {"loops": loops, "narrowed": from_double})
    return {**c_sources(texts), "src/entry.c": filled(_HERE, page, ORIGIN)}


def _library(kernels: tuple[TargetKernel, ...], *, narrowed: bool) -> Iterator[Page]:
    """The files that are compiled; each block takes a compiler its time."""
    found = pages(kernels, (DOUBLE,)) if narrowed else pages(kernels)
    return (page for page in found if not page.path.startswith("test/"))


def _shown(kernels: tuple[TargetKernel, ...]) -> Iterator[Page]:
    """The functions alone."""
    [kernel] = kernels
    functions: Iterable[object] = [single(kernel, precision) for precision in precisions_of(kernel)]
    yield Page("function.c", "function.c.jinja", {"functions": functions})
    yield from _in_python(kernels)


def _in_python(kernels: tuple[TargetKernel, ...]) -> Iterator[Page]:
    for page in NUMPY.pages(kernels):
        if page.path == "kernels.py":
            yield with_fields(page, path="function.py", template="function.py.jinja")
