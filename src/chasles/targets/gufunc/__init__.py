"""Generalised ufuncs: one CPython extension module over the C kernels, with a loop for float64 and one for float32."""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import dataclass
from pathlib import Path
from textwrap import wrap

from chasles.lowering.program import Argument, Result
from chasles.targets.c.functions import public_name
from chasles.targets.constants import DOUBLE, SINGLE, Precision
from chasles.targets.contract import contract, summary
from chasles.targets.gufunc.text import c_string
from chasles.targets.kernel import EmissionError, Kernel, signature
from chasles.targets.target import COMMAND, Page, Target

__all__ = ["TARGET"]

_WIDTH = 100
# The order in which NumPy looks for a loop: the first that takes the inputs without loss.
_LOOPS = ((SINGLE, "f", "NPY_FLOAT"), (DOUBLE, "d", "NPY_DOUBLE"))


@dataclass(frozen=True, slots=True)
class _Loop:
    """An inner loop as the template lays it out."""

    name: str
    buffers: tuple[str, ...]
    gathers: tuple[str, ...]
    call: str
    scatters: tuple[str, ...]


@dataclass(frozen=True, slots=True)
class _Ufunc:
    """A kernel as the template lays it out."""

    name: str
    comment: tuple[str, ...]
    loops: tuple[_Loop, ...]
    types: tuple[str, ...]
    inputs: int
    outputs: int
    operands: int
    docstring: tuple[str, ...]
    signature: str


def _loop(kernel: Kernel, precision: Precision, letter: str) -> _Loop:
    """The loop that gathers an item, calls the C kernel and scatters what it gives."""
    program = kernel.program
    operands = program.parameters
    buffers = tuple(f"{precision.name} x{place}[{_size(item)}];" for place, item in enumerate(operands))
    # A loop's steps: one from item to item for each operand, then one for each core axis of each operand.
    moves, axis = [], len(operands)
    for place, item in enumerate(operands):
        moves.append(_moved(place, item, axis, letter))
        axis += len(item.shape)
    passed = [f"x{place}" if item.shape else f"*x{place}" for place, item in enumerate(program.arguments)]
    passed += [f"x{place}" for place in range(len(program.arguments), len(operands))]
    inputs = len(program.arguments)
    return _Loop(
        name=f"{kernel.name}_{letter}",
        buffers=buffers,
        gathers=tuple(f"gather_{move}" for move in moves[:inputs]),
        call=f"{public_name(kernel, precision)}({', '.join(passed)});",
        scatters=tuple(f"scatter_{move}" for move in moves[inputs:]),
    )


def _moved(place: int, item: Argument | Result, axis: int, letter: str) -> str:
    """The call that moves an operand's entries between its strided place and the buffer."""
    shape = item.shape
    if len(shape) > 2:
        raise EmissionError(f"{item.name} has {len(shape)} core axes; the loops know none, one or two")
    rows, columns = (1, 1, *shape)[-2:]
    down = f"steps[{axis}]" if len(shape) == 2 else "0"
    across = f"steps[{axis + len(shape) - 1}]" if shape else "0"
    return f"{letter}(x{place}, at[{place}], {rows}, {columns}, {down}, {across});"


def _size(item: Argument | Result) -> int:
    rows, columns = (1, 1, *item.shape)[-2:]
    return rows * columns


def _ufunc(kernel: Kernel) -> _Ufunc:
    program = kernel.program
    operands = len(program.parameters)
    given = [_shown(item) for item in program.arguments]
    returned = [_shown(item) for item in program.results]
    text = (*contract(kernel, given, returned), f"  {'signature':<12}{signature(program)}")
    return _Ufunc(
        name=kernel.name,
        comment=tuple(
            line.replace("*/", "* /").replace("/*", "/ *") for line in summary(kernel, f"The loops of {kernel.name}.")
        ),
        loops=tuple(_loop(kernel, precision, letter) for precision, letter, _ in _LOOPS),
        types=tuple(wrap(", ".join(number for _, _, number in _LOOPS for _ in range(operands)), _WIDTH)),
        inputs=len(program.arguments),
        outputs=len(program.results),
        operands=operands,
        docstring=tuple(c_string(f"{line}\n") for line in text),
        signature=c_string(signature(program)),
    )


def _shown(item: Argument | Result) -> str:
    return f"{item.name} ({', '.join(map(str, item.shape))})" if item.shape else item.name


def _pages(kernels: tuple[Kernel, ...]) -> Iterator[Page]:
    kinds = [{"letter": letter, "number": precision.name} for precision, letter, _ in _LOOPS]
    ufuncs = [_ufunc(kernel) for kernel in kernels]
    values = {"command": COMMAND, "kinds": kinds, "loops": len(_LOOPS), "ufuncs": ufuncs}
    yield Page("_kernels.c", "_kernels.c.jinja", values)


TARGET = Target("gufunc", Path(__file__).parent, _pages)
