"""C99: one header, a file for every section of the book, batches, and a self-test that needs no Python.

A kernel's program becomes text twice, by the same writer: once on numbers, as the function for one item, and once on
registers, each of which holds one number of several items, as the block of a batch. The second is compiled for each set
of instructions (a level) and one of the results is taken when the program runs; nothing is to be linked.

- `batches.c` knows no kernel and no instructions. It cuts a batch into blocks of 64 items. Operands that a block cannot
  load as they lie (a few items, outputs over inputs) it copies to a small store and back, so that
  a block has one path and an item's result never depends on where the item lies.
- A block (`blocks.py`, its loads and stores in `moves.py`) loads the items of a register's lanes and transposes them
  between registers, since items are arrays of structures and memory is the bottleneck; it computes, transposes and
  stores. What lies the other way, each number of all items side by side, as in Fortran order, it loads and stores
  without; what lies otherwise, number by number. Before that it finds the sines and cosines of all 64 items
  (`sincos.py`), in a loop of their own.
- A program of many steps is cut into parts (`parts.py`), functions that leave what others need in an array.
- `trigonometry_blocks.c` holds those: no branch for angles below 1.6e6, libm beyond. In single precision they are
  computed in double, which is hardly slower and right to the last digit.
- Nothing in a block branches, so both sides of every choice are computed, in lanes for which they mean nothing too. The
  flags that this raises are dropped: `batches.c` masks and clears the floating-point state around a batch, looks after
  each block whether `invalid` came up, and only then at the numbers: it is raised if a result is NaN and no input was.
- The blocks of x86-64-v4 take items that lie one after the other and nothing else, whatever else comes goes to those of
  x86-64-v3, which give the same bits. So their strides are constants: with others the addresses of 8 items fill more
  registers than there are, and up to half of what registers of 64 bytes win is lost. Compiled alone, for an expression,
  they take all, so that a compiler has half to do. They ask for memory ahead of time, also for what they will write: a
  third is won by that as soon as a batch is not in the innermost cache.
- Results too many for the cache, if more is written than read, go around it. A block writes them to one half of the
  store; with each group of the next block, in both its loops, a few lines go to their place. So memory is never idle
  while something is computed, nor the other way round.
"""

from __future__ import annotations

import math
from collections.abc import Iterator, Sequence
from pathlib import Path
from typing import Any

from chasles.lowering.program import MOST_OPERANDS
from chasles.targets.c.alone import alone
from chasles.targets.c.blocks import block, block_name, loop_name
from chasles.targets.c.core_shapes import loop
from chasles.targets.c.functions import PRECISIONS, Function, batch, in_short, precisions_of, single
from chasles.targets.c.self_test import vectors
from chasles.targets.constants import Precision
from chasles.targets.kernel import EmissionError, TargetKernel
from chasles.targets.target import Page, Target

_FEW_ENTRIES = 512
"""Of a group of items with no more the store of most kernels has room, whatever the registers."""


def pages(kernels: tuple[TargetKernel, ...], on_registers: Sequence[Precision] = PRECISIONS) -> Iterator[Page]:
    """The files of a library; it has blocks `on_registers` in these precisions, and others come from elsewhere."""
    functions = {kernel.name: _functions(kernel) for kernel in kernels}
    pairs = [(kernel, precision) for kernel in kernels for precision in PRECISIONS]
    inner = [name(*pair) for pair in pairs for name in (loop_name, block_name)]
    _require_distinct([*inner, *(function.name for group in functions.values() for function in group)])
    groups = [{"comment": in_short(kernel), "functions": functions[kernel.name]} for kernel in kernels]
    yield Page("include/chasles.h", "chasles.h.jinja", {"groups": groups})
    for section in dict.fromkeys(kernel.heading.section for kernel in kernels):
        members = [kernel for kernel in kernels if kernel.heading.section == section]
        bodies = [function for kernel in members for function in functions[kernel.name]]
        loops = [
            loop(kernel, precision, gaps=precision not in on_registers)
            for kernel in members
            for precision in PRECISIONS
        ]
        values = {"section": section, "functions": bodies, "loops": loops}
        yield Page(f"src/{section}.c", "section.c.jinja", values)
        blocks = [
            block(kernel, precision)
            for kernel in members
            for precision in precisions_of(kernel)
            if precision in on_registers
        ]
        steps = [step for kernel in members for step in kernel.program.steps if step.function]
        called = sorted({f"CHASLES_LANEWISE_{len(step.operands)}({step.function})" for step in steps})
        values = {"section": section, "blocks": blocks, "functions": called}
        yield Page(f"src/{section}_blocks.c", "blocks.c.jinja", values)
    yield from _batches(kernels)
    checks = [check for kernel in kernels for check in vectors(kernel)]
    yield Page("test/self_test.c", "self_test.c.jinja", {"checks": checks, "precisions": list(map(_words, PRECISIONS))})


def _batches(kernels: tuple[TargetKernel, ...]) -> Iterator[Page]:
    """What all blocks have in common: `loops.h` alone knows their names."""
    pairs = [(kernel, precision) for kernel in kernels for precision in PRECISIONS]
    names = {"loops": [loop_name(*pair) for pair in pairs], "blocks": [block_name(*pair) for pair in pairs]}
    yield Page("src/loops.h", "loops.h.jinja", names)
    entries = max((sum(math.prod(item.shape) for item in kernel.program.parameters) for kernel in kernels), default=0)
    many = 2 ** (entries - 1).bit_length()
    store = f"({many} * (16 << (CHASLES_LEVELS - 1)))" if entries > _FEW_ENTRIES else "32768"
    yield Page("src/batches.h", "batches.h.jinja", {"operands": MOST_OPERANDS, "store": store})
    values = {"precisions": list(map(_words, PRECISIONS)), "circular": ("sine", "cosine")}
    for name in ("batches.c", "vectors.h", "trigonometry_blocks.c"):
        yield Page(f"src/{name}", f"{name}.jinja", values)


def _words(precision: Precision) -> dict[str, Any]:
    """How the two precisions differ in what is said once of both."""
    suffix = precision.suffix
    pasted, widened = (f"##{suffix}", "(double)") if suffix else ("", "")
    return {"name": precision.name, "suffix": suffix, "mark": suffix.upper(), "pasted": pasted, "widened": widened}


def _functions(kernel: TargetKernel) -> tuple[Function, ...]:
    """The functions of a kernel: one item, then a batch, each in both precisions."""
    return tuple(make(kernel, precision) for make in (single, batch) for precision in precisions_of(kernel))


def _require_distinct(names: list[str]) -> None:
    twice = sorted({name for name in names if names.count(name) > 1})
    if twice:
        raise EmissionError(f"several functions would be called {', '.join(twice)}; rename a kernel")


TARGET = Target("c", Path(__file__).parent, pages, alone)
