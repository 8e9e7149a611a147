"""Array-API Python: readable functions that run on any array library, and are used where nothing was compiled."""

from __future__ import annotations

import builtins
import keyword
from collections.abc import Iterator, Mapping
from dataclasses import dataclass
from pathlib import Path

from chasles.lowering.program import Argument, Op, Program, Result
from chasles.targets.constants import DOUBLE, literals
from chasles.targets.contract import contract
from chasles.targets.dialect import ARITHMETIC, Dialect, Level, Phrase, Shape, call
from chasles.targets.kernel import TargetKernel, signature
from chasles.targets.layout import listed
from chasles.targets.numpy.hypotheses import divisors, rows
from chasles.targets.spelling import Spelled, spelled
from chasles.targets.target import Page, Target

__all__ = ["TARGET"]

_SPELL: Mapping[Op, Phrase] = {
    **ARITHMETIC,
    Op.SQUARE_ROOT: call("xp.sqrt"),
    Op.SINE: call("xp.sin"),
    Op.COSINE: call("xp.cos"),
    Op.ARCTANGENT2: call("xp.atan2", 2),
    Op.SELECT: call("xp.where", 3),
    Op.NOT_A_NUMBER: Phrase("batch.number(xp.nan)", Level.ATOM, ()),
}
_USED = ("xp", "batch", "out", "prepared", "delivered", "Any")
_RESERVED = frozenset({*keyword.kwlist, *keyword.softkwlist, *dir(builtins), *_USED})


def _component(name: str, shape: Shape, entry: int) -> str:
    """The entry of nested tuples, as `prepared` hands them over."""
    places: list[int] = []
    for extent in reversed(shape):
        entry, place = divmod(entry, extent)
        places.insert(0, place)
    return name + "".join(f"[{place}]" for place in places)


_DIALECT = Dialect(
    spell=_SPELL,
    constant=literals(DOUBLE),
    component=_component,
    declare=lambda name, text, truth: f"{name} = {text}",
    reserved=_RESERVED,
    lift="batch.number({})",
    name_entries=False,
    width=80,
)


@dataclass(frozen=True, slots=True)
class _Function:
    """A Python function as the template lays it out."""

    name: str
    says: str
    docstring: tuple[str, ...]
    parameters: str
    lines: tuple[str, ...]


def _function(kernel: TargetKernel) -> _Function:
    program = kernel.program
    text = spelled(program, _DIALECT)
    given = [_shown(name, item) for name, item in zip(text.arguments, program.arguments, strict=True)]
    returned = [_shown(name, item) for name, item in zip(text.results, program.results, strict=True)]
    says, *docstring = _docstring((*contract(kernel, given, returned), f"  {'signature':<12}{signature(program)}"))
    return _Function(
        name=kernel.name,
        says=says,
        docstring=tuple(docstring),
        parameters=", ".join(f"{name}: Any" for name in text.arguments),
        lines=(*_opening(kernel.name, kernel.program, text), *text.lines, *_closing(kernel, text)),
    )


def _divisor(name: str, program: Program) -> Iterator[str]:
    """The lines of a function of one number."""
    text = spelled(program, _DIALECT)
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


def _closing(kernel: TargetKernel, text: Spelled) -> Iterator[str]:
    """The lines that put the results together."""
    for name, result, entries in zip(text.results, kernel.program.results, text.entries, strict=True):
        yield from listed(f"{name} = batch.array(", [str(result.shape), *entries], ")", closing_line=True)
    yield f"return delivered(out, {', '.join(text.results)})"


def _shown(name: str, item: Argument | Result) -> str:
    """The name with its core shape; batch axes come before."""
    return f"{name} ({', '.join(map(str, item.shape))})" if item.shape else name


def _docstring(lines: tuple[str, ...]) -> tuple[str, ...]:
    return tuple(line.removeprefix("  ").replace('"', "'") for line in lines)


def _pages(kernels: tuple[TargetKernel, ...]) -> Iterator[Page]:
    values = {"functions": [_function(kernel) for kernel in kernels]}
    yield Page("kernels.py", "kernels.py.jinja", values)
    functions = divisors(kernels, _divisor)
    table = {"divisors": [*functions.values()], "rows": [*rows(kernels, functions)]}
    yield Page("hypotheses.py", "hypotheses.py.jinja", table)
    yield Page("batches.py", "batches.py.jinja", {})
    yield Page("__init__.py", "__init__.py.jinja", {})


TARGET = Target("numpy", Path(__file__).parent, _pages)
