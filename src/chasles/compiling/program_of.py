"""From SymPy expressions to a straight-line program, derivatives among its results where they are wanted."""

from __future__ import annotations

import math
from collections.abc import Iterator, Sequence
from dataclasses import replace as with_fields

import sympy

from chasles.compiling.derivatives import derivatives
from chasles.compiling.operands import Input, Output
from chasles.compiling.scalars import Scalars
from chasles.lowering.builder import Builder
from chasles.lowering.cost import cost
from chasles.lowering.passes.guard import guarded
from chasles.lowering.passes.prune import pruned
from chasles.lowering.program import Program, Result

__all__ = ["program_of"]


def program_of(name: str, inputs: Sequence[Input], outputs: Sequence[Output], *, jacobian: bool) -> Program:
    """The cheaper of the expressions as they stand and what SymPy's common subexpressions make of them.

    NaN where a divisor is zero. Raises `LoweringError` for what no program computes.
    """
    candidates = [_program(name, inputs, outputs, common=common, jacobian=jacobian) for common in (False, True)]
    return guarded(min(candidates, key=cost))


def _program(name: str, inputs: Sequence[Input], outputs: Sequence[Output], *, common: bool, jacobian: bool) -> Program:
    build = Builder()
    places = {
        symbol: build.input(place, entry)
        for place, item in enumerate(inputs)
        for entry, symbol in enumerate(item.symbols)
    }
    scalars = Scalars(build, places)
    entries = [entry for output in outputs for entry in output.entries]
    if common:
        replacements, entries = sympy.cse(entries, symbols=sympy.numbered_symbols("common_", cls=sympy.Dummy))
        for symbol, meaning in replacements:
            scalars.define(symbol, meaning)
    numbers = iter([scalars.of(entry) for entry in entries])
    results = [
        Result(output.name, output.shape, f"output {place}", tuple(next(numbers) for _ in output.entries))
        for place, output in enumerate(outputs, 1)
    ]
    if jacobian:
        results += list(_jacobians(build, inputs, results))
    return pruned(Program(name, tuple(item.argument for item in inputs), build.steps, tuple(results)))


def _jacobians(build: Builder, inputs: Sequence[Input], results: Sequence[Result]) -> Iterator[Result]:
    """For each result its derivatives, the entries of the result by those of all inputs."""
    numbers = [entry for result in results for entry in result.entries]
    variables = [(place, entry) for place, item in enumerate(inputs) for entry in range(len(item.entries))]
    columns = [derivatives(build, numbers, *variable) for variable in variables]
    alone = len(inputs) == 1 and not inputs[0].argument.shape
    start = 0
    for result in results:
        count = len(result.entries)
        entries = tuple(column[k] for k in range(start, start + count) for column in columns)
        rows = () if not result.shape else (math.prod(result.shape),)
        shape = rows if alone else (*rows, len(variables))
        yield with_fields(
            result,
            name=f"{result.name}_jacobian",
            shape=shape,
            meaning=f"the derivatives of {result.name} by all numbers that go in, in their order",
            entries=entries,
        )
        start += count
