"""More operands than a batch takes: scalars are packed into one array before they go in, and taken out of one."""

from __future__ import annotations

from collections.abc import Callable, Sequence
from dataclasses import dataclass
from dataclasses import replace as with_fields
from typing import Any

import numpy

from chasles.lowering.names import Names
from chasles.lowering.program import MOST_OPERANDS, Argument, Op, Program, Result


@dataclass(frozen=True, slots=True)
class Packing:
    """A program whose scalar arguments at `taken` are one array, its first; and so, after the others, its results."""

    program: Program
    taken: tuple[int, ...]
    given: tuple[int, ...]

    def around(self, function: Callable[..., Any]) -> Callable[..., Any]:
        """The function of all arguments, and of all results, by that of the packed ones."""
        name, count = self.program.name, len(self.program.results) - bool(self.given) + len(self.given)
        taken, given = set(self.taken), set(self.given)

        def called(*inputs: Any, **options: Any) -> Any:
            if "out" in options and given:
                raise ValueError(f"{name} has so many results that none can be written to `out`")
            numbers = [inputs[place] for place in self.taken]
            others = [value for place, value in enumerate(inputs) if place not in taken]
            found = function(_side_by_side(numbers), *others, **options) if taken else function(*others, **options)
            if not given:
                return found
            *alone, last = found if isinstance(found, tuple) else (found,)
            scalars, arrays = iter(numpy.moveaxis(last, -1, 0)), iter(alone)
            return tuple(next(scalars) if place in given else next(arrays) for place in range(count))

        return called


def _side_by_side(numbers: Sequence[Any]) -> Any:
    """The numbers along a last axis, in their common precision."""
    if all(isinstance(number, float) for number in numbers):
        return numpy.array(numbers)
    kind = numpy.result_type(
        *(number if isinstance(number, int | float) else numpy.asarray(number) for number in numbers)
    )
    return numpy.stack(numpy.broadcast_arrays(*(numpy.asarray(number, dtype=kind) for number in numbers)), axis=-1)


def packing_of(program: Program) -> Packing | None:
    """How the operands of a program are packed; None where they are few enough as they are."""
    if len(program.parameters) <= MOST_OPERANDS:
        return None
    names = Names({item.name for item in program.parameters})
    taken = tuple(place for place, item in enumerate(program.arguments) if not item.shape)
    given: tuple[int, ...] = ()
    if len(program.parameters) - len(taken) + 1 > MOST_OPERANDS:
        given = tuple(place for place, item in enumerate(program.results) if not item.shape)
    results = _results(program, given, names.take("results"))
    if not taken:
        return Packing(with_fields(program, results=results), taken, given) if given else None
    arguments, move = _arguments(program.arguments, taken, names.take("inputs"))
    steps = tuple(
        with_fields(step, argument=move[step.argument][0], entry=step.entry + move[step.argument][1])
        if step.op is Op.INPUT
        else step
        for step in program.steps
    )
    return Packing(with_fields(program, arguments=arguments, steps=steps, results=results), taken, given)


def _arguments(
    arguments: Sequence[Argument], taken: Sequence[int], name: str
) -> tuple[tuple[Argument, ...], dict[int, tuple[int, int]]]:
    """The arguments with one array for those taken, and where each has gone: which argument, from which entry on."""
    others = [place for place in range(len(arguments)) if place not in taken]
    packed = Argument(name, (len(taken),), "the scalars, in their order")
    move = {place: (0, entry) for entry, place in enumerate(taken)}
    move |= {place: (number, 0) for number, place in enumerate(others, 1)}
    return (packed, *(arguments[place] for place in others)), move


def _results(program: Program, given: Sequence[int], name: str) -> tuple[Result, ...]:
    if not given:
        return program.results
    entries = tuple(program.results[place].entries[0] for place in given)
    others = (result for place, result in enumerate(program.results) if place not in given)
    return (*others, Result(name, (len(given),), "the scalar results, in their order", entries))
