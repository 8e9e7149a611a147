"""The table of what each kernel takes and what must hold of it, and functions for what must not vanish."""

from __future__ import annotations

from collections.abc import Callable, Iterable, Iterator, Sequence
from dataclasses import dataclass

from chasles.lowering.program import Argument, Program
from chasles.targets.kernel import Demand, TargetKernel

Body = Callable[[str, Program], Iterable[str]]


@dataclass(frozen=True, slots=True)
class DivisorFunction:
    """A function of some arguments whose value must not be zero."""

    name: str
    says: str
    parameters: str
    lines: tuple[str, ...]


@dataclass(frozen=True, slots=True)
class Row:
    """A kernel in the table."""

    name: str
    lines: tuple[str, ...]


def divisors(kernels: Iterable[TargetKernel], body: Body) -> dict[tuple[object, ...], DivisorFunction]:
    """A function for each thing that must not vanish, by what it computes; `body` writes its lines."""
    found: dict[tuple[object, ...], DivisorFunction] = {}
    for kernel in kernels:
        for demand in kernel.demands:
            if demand.divisor is not None and _key(demand.divisor) not in found:
                name = f"divisor_{len(found) + 1}"
                parameters = ", ".join(f"{argument.name}: Any" for argument in demand.divisor.arguments)
                lines = tuple(body(name, demand.divisor))
                found[_key(demand.divisor)] = DivisorFunction(
                    name, f"It vanishes where this is broken: {demand.text}.", parameters, lines
                )
    return found


def rows(kernels: Iterable[TargetKernel], functions: dict[tuple[object, ...], DivisorFunction]) -> Iterator[Row]:
    """The lines of the table."""
    for kernel in kernels:
        inputs = _tuple([_input(argument) for argument in kernel.program.arguments])
        demands = [f"    {_tuple(_demand(demand, functions))}," for demand in kernel.demands]
        yield Row(kernel.name, (f"{inputs},", *(("(", *demands, "),") if demands else ("(),",))))


def _key(program: Program) -> tuple[object, ...]:
    """What makes two programs one function: everything but the name."""
    return program.arguments, program.steps, program.results


def _demand(demand: Demand, functions: dict[tuple[object, ...], DivisorFunction]) -> list[str]:
    divisor = functions[_key(demand.divisor)].name if demand.divisor else "None"
    return [_quoted(demand.kind), _quoted(demand.text), _tuple([_quoted(name) for name in demand.arguments]), divisor]


def _input(argument: Argument) -> str:
    return f"({_quoted(argument.name)}, {_tuple([str(extent) for extent in argument.shape])})"


def _quoted(text: str) -> str:
    return '"' + text.replace('"', "'") + '"'


def _tuple(items: Sequence[str]) -> str:
    return f"({', '.join(items)}{',' if len(items) == 1 else ''})"
