"""Type stubs: what a type checker and an editor are told of `chasles.kernels`, of its `one`, and of `chasles.checked`.

There is a protocol for each number of inputs and results, generic in what a call gives. `numpy.ufunc` alone would say
that any call gives anything.
"""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import dataclass
from pathlib import Path

from chasles.lowering.program import Argument, Result
from chasles.targets.contract import contract
from chasles.targets.kernel import Kernel, signature
from chasles.targets.target import COMMAND, Page, Target

__all__ = ["TARGET"]

_FAMILIES = {"kernels": "Ufunc", "one": "Light", "checked": "Checked"}
"""The module of each kind of function, and how its protocols' names begin."""


@dataclass(frozen=True, slots=True)
class _Arity:
    """A number of inputs and results: how it ends a protocol's name, and how a call of it is declared."""

    name: str
    numbers: str
    light: str
    out: str
    inputs: int
    results: int


@dataclass(frozen=True, slots=True)
class _Declared:
    """A kernel as the template lays it out."""

    name: str
    arity: str
    gives: str
    signature: str
    says: str
    docstring: tuple[str, ...]


def _arity(inputs: int, results: int) -> _Arity:
    def parameters(kind: str) -> str:
        return ", ".join(f"x{number}: {kind}" for number in range(1, inputs + 1))

    one_each = ", ".join(["Array | None"] * results)
    return _Arity(
        name=f"{inputs}x{results}",
        numbers=parameters("Numbers"),
        light=parameters("float | Array"),
        out=f"Array | tuple[{one_each}] | None" if results == 1 else f"tuple[{one_each}] | None",
        inputs=inputs,
        results=results,
    )


def _declared(kernel: Kernel) -> _Declared:
    program = kernel.program
    given = [_shown(item) for item in program.arguments]
    returned = [_shown(item) for item in program.results]
    lines = (*contract(kernel, given, returned), f"  {'signature':<12}{signature(program)}")
    says, *docstring = (line.replace('"', "'") for line in lines)
    gives = [_type_of(result) for result in program.results]
    return _Declared(
        name=kernel.name,
        arity=_name_of(kernel),
        gives=gives[0] if len(gives) == 1 else f"tuple[{', '.join(gives)}]",
        signature=signature(program),
        says=says,
        docstring=tuple(line.removeprefix("  ") for line in docstring),
    )


def _name_of(kernel: Kernel) -> str:
    return f"{len(kernel.program.arguments)}x{len(kernel.program.results)}"


def _type_of(result: Result) -> str:
    """What is known of the type of a result: without core axes it is a number or, in a batch, an array."""
    return "Array" if result.shape else "Any"


def _shown(item: Argument | Result) -> str:
    return f"{item.name} ({', '.join(map(str, item.shape))})" if item.shape else item.name


def _pages(kernels: tuple[Kernel, ...]) -> Iterator[Page]:
    declared = [_declared(kernel) for kernel in kernels]
    sizes = sorted({(len(kernel.program.arguments), len(kernel.program.results)) for kernel in kernels})
    arities = [_arity(*size) for size in sizes]
    yield Page("__init__.pyi", "__init__.pyi.jinja", {"command": COMMAND})
    yield Page("protocols.pyi", "protocols.pyi.jinja", {"command": COMMAND, "arities": arities})
    for module, family in _FAMILIES.items():
        used = [f"{family}{arity.name}" for arity in arities]
        values = {"command": COMMAND, "declared": declared, "used": used, "family": family}
        yield Page(f"{module}.pyi", f"{module}.pyi.jinja", values)


TARGET = Target("stubs", Path(__file__).parent, _pages)
