"""C99: one header, a file for every section of the book, and a self-test that needs no Python."""

from __future__ import annotations

from collections.abc import Iterator
from pathlib import Path

from chasles.targets.c.blocks import MOST_OPERANDS, block, block_name, loop_name
from chasles.targets.c.functions import PRECISIONS, Function, batch, single
from chasles.targets.c.loops import loop
from chasles.targets.c.vectors import vectors
from chasles.targets.kernel import EmissionError, Kernel
from chasles.targets.target import COMMAND, Page, Target

__all__ = ["TARGET"]


def _pages(kernels: tuple[Kernel, ...]) -> Iterator[Page]:
    functions = {kernel.name: _functions(kernel) for kernel in kernels}
    pairs = [(kernel, precision) for kernel in kernels for precision in PRECISIONS]
    inner = [name(*pair) for pair in pairs for name in (loop_name, block_name)]
    _require_distinct([*inner, *(function.name for group in functions.values() for function in group)])
    groups = [{"comment": group[0].comment, "functions": group} for group in functions.values()]
    yield Page("include/chasles.h", "chasles.h.jinja", {"command": COMMAND, "groups": groups})
    for section in dict.fromkeys(kernel.heading.section for kernel in kernels):
        members = [kernel for kernel in kernels if kernel.heading.section == section]
        bodies = [function for kernel in members for function in functions[kernel.name]]
        loops = [loop(kernel, precision) for kernel in members for precision in PRECISIONS]
        values = {"command": COMMAND, "section": section, "functions": bodies, "loops": loops}
        yield Page(f"src/{section}.c", "section.c.jinja", values)
        blocks = [block(kernel, precision) for kernel in members for precision in PRECISIONS]
        values = {"command": COMMAND, "section": section, "blocks": blocks}
        yield Page(f"src/{section}_blocks.c", "blocks.c.jinja", values)
    yield from _batches(kernels)
    checks = [check for kernel in kernels for check in vectors(kernel)]
    yield Page("test/self_test.c", "self_test.c.jinja", {"command": COMMAND, "checks": checks})


def _batches(kernels: tuple[Kernel, ...]) -> Iterator[Page]:
    """What all blocks have in common."""
    pairs = [(kernel, precision) for kernel in kernels for precision in PRECISIONS]
    values = {
        "command": COMMAND,
        "operands": MOST_OPERANDS,
        "loops": [loop_name(*pair) for pair in pairs],
        "blocks": [block_name(*pair) for pair in pairs],
    }
    yield Page("src/batches.h", "batches.h.jinja", values)
    for name in ("batches.c", "vectors.h", "trigonometry_blocks.c"):
        yield Page(f"src/{name}", f"{name}.jinja", {"command": COMMAND})


def _functions(kernel: Kernel) -> tuple[Function, ...]:
    """The functions of a kernel: one item, then a batch, each in both precisions."""
    return tuple(make(kernel, precision) for make in (single, batch) for precision in PRECISIONS)


def _require_distinct(names: list[str]) -> None:
    twice = sorted({name for name in names if names.count(name) > 1})
    if twice:
        raise EmissionError(f"several functions would be called {', '.join(twice)}; rename a kernel")


TARGET = Target("c", Path(__file__).parent, _pages)
