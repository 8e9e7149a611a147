"""Array-API Python: readable functions that run on any array library, and are used where nothing was compiled."""

from __future__ import annotations

import builtins
import keyword
from collections.abc import Iterator, Mapping
from dataclasses import dataclass
from pathlib import Path

from chasles.lowering.program import Op, Program
from chasles.targets.constants import DOUBLE, literals
from chasles.targets.contract import contract_in_arrays
from chasles.targets.dialect import ARITHMETIC, Dialect, Level, Phrase, call, nested
from chasles.targets.kernel import TargetKernel
from chasles.targets.layout import listed
from chasles.targets.numpy.hypotheses import divisors, rows
from chasles.targets.spelling import Spelled, spelled
from chasles.targets.target import Page, Target

_SPELL: Mapping[Op, Phrase] = {
    **ARITHMETIC,
    Op.SQUARE_ROOT: call("xp.sqrt"),
    Op.SINE: call("xp.sin"),
    Op.COSINE: call("xp.cos"),
    Op.ARCTANGENT2: call("xp.atan2", 2),
    Op.SELECT: call("xp.where", 3),
    Op.NOT_A_NUMBER: Phrase("batch.number(xp.nan)", Level.ATOM, ()),
}
NAMES = {
    "fabs": "abs",
    "fmod": "remainder",
    "pow": "pow",
    **{name: name for name in ("floor", "exp", "expm1", "log", "log1p", "sinh", "cosh", "tanh")},
    **{name: name for name in ("asinh", "acosh", "atanh")},
}
"""Functions of the array API by their C names; the others are those of SciPy, in each library's own place."""
_USED = ("xp", "batch", "out", "prepared", "delivered", "Any")
_RESERVED = frozenset({*keyword.kwlist, *keyword.softkwlist, *dir(builtins), *_USED})


def _function_phrase(name: str, operands: int) -> Phrase:
    """The function of the array library; of the library's special functions, where it is none."""
    if name in NAMES:
        return call(f"xp.{NAMES[name]}", operands)
    return Phrase(f'batch.special("{name}", {", ".join(["{}"] * operands)})', Level.ATOM, (Level.CHOICE,) * operands)


DIALECT = Dialect(
    spell=_SPELL,
    constant=literals(DOUBLE),
    component=nested,
    declare=lambda name, text, truth: f"{name} = {text}",
    reserved=_RESERVED,
    lift="batch.number({})",
    name_entries=False,
    width=80,
    function=_function_phrase,
    special=True,
)


@dataclass(frozen=True, slots=True)
class _Function:
    """A Python function as the template lays it out."""

    name: str
    says: str
    docstring: tuple[str, ...]
    parameters: str
    lines: tuple[str, ...]


def function(kernel: TargetKernel, end: str = "return delivered(out, {})", dialect: Dialect = DIALECT) -> _Function:
    """The function of a kernel, which `end`s by handing over its results."""
    program = kernel.program
    text = spelled(program, dialect)
    says, *docstring = _docstring(contract_in_arrays(kernel, (*text.arguments, *text.results)))
    return _Function(
        name=kernel.name,
        says=says,
        docstring=tuple(docstring),
        parameters=", ".join(f"{name}: Any" for name in text.arguments),
        lines=(*_opening(kernel.name, kernel.program, text), *text.lines, *_closing(kernel, text, end)),
    )


def _divisor(name: str, program: Program) -> Iterator[str]:
    """The lines of a function of one number."""
    text = spelled(program, DIALECT)
    yield from (*_opening(name, program, text), *text.lines)
    ((value,),) = text.entries
    yield f"return batch.array((), {value})"


def _opening(kernel: str, program: Program, text: Spelled) -> Iterator[str]:
    """The lines that prepare the inputs."""
    arguments = zip(text.arguments, program.arguments, strict=True)
    inputs = [f'"{kernel}"', *(f'("{name}", {name}, {item.shape})' for name, item in arguments)]
    yield from listed(f"batch, {', '.join(text.arguments)} = prepared(", inputs, ")", closing_line=True)
    entries = [entry for group in text.entries for entry in group]
    if any("xp." in line for line in (*text.lines, *entries)):
        yield "xp = batch.xp"


def _closing(kernel: TargetKernel, text: Spelled, end: str) -> Iterator[str]:
    """The lines that put the results together."""
    for name, result, entries in zip(text.results, kernel.program.results, text.entries, strict=True):
        yield from listed(f"{name} = batch.array(", [str(result.shape), *entries], ")", closing_line=True)
    yield end.format(", ".join(text.results))


def _docstring(lines: tuple[str, ...]) -> tuple[str, ...]:
    return tuple(line.removeprefix("  ").replace('"', "'") for line in lines)


def _pages(kernels: tuple[TargetKernel, ...]) -> Iterator[Page]:
    values = {"functions": [function(kernel) for kernel in kernels]}
    yield Page("kernels.py", "kernels.py.jinja", values)
    functions = divisors(kernels, _divisor)
    table = {"divisors": [*functions.values()], "rows": [*rows(kernels, functions)]}
    yield Page("hypotheses.py", "hypotheses.py.jinja", table)
    yield Page("batches.py", "batches.py.jinja", {})
    yield Page("__init__.py", "__init__.py.jinja", {})


TARGET = Target("numpy", Path(__file__).parent, _pages)
