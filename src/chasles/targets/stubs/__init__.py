"""Type stubs: what a type checker and an editor are told of `chasles.kernels`, of its `one`, and of `chasles.checked`.

Each kernel has a protocol of its own, which names its inputs. `numpy.ufunc` alone would say that any call gives
anything.
"""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import dataclass
from pathlib import Path

from chasles.targets.contract import cited, contract_in_arrays
from chasles.targets.kernel import TargetKernel, signature
from chasles.targets.target import Page, Target

_REMARKS = {
    "one": ("Light", "Of one element or a contiguous batch."),
    "checked": ("Checked", "The inputs are tested."),
}
"""By file: how the names of protocols begin, and in what its functions differ from the kernels."""


@dataclass(frozen=True, slots=True)
class _Declared:
    """A kernel as the templates lay it out: its name, and that of its call, whose inputs are numbers or arrays."""

    name: str
    call: str
    numbers: str
    light: str
    out: str
    gives: str
    signature: str
    title: str
    says: str
    docstring: tuple[str, ...]


def _declared(kernel: TargetKernel) -> _Declared:
    program = kernel.program
    says, *docstring = (_quoted(line.removeprefix("  ")) for line in contract_in_arrays(kernel))
    # Without core axes it is a number or, in a batch, an array.
    gives = ["Array" if result.shape else "Any" for result in program.results]
    one_each = f"tuple[{', '.join(['Array | None'] * len(gives))}]"
    return _Declared(
        name=kernel.name,
        call="".join(word.capitalize() for word in kernel.name.split("_")),
        numbers=", ".join(f"{item.name}: Numbers" for item in program.arguments),
        light=", ".join(f"{item.name}: Light" for item in program.arguments),
        out=f"{one_each} | None" if len(gives) > 1 else f"Array | {one_each} | None",
        gives=gives[0] if len(gives) == 1 else f"tuple[{', '.join(gives)}]",
        signature=signature(program),
        title=_quoted(f"{cited(kernel.heading.number)} {kernel.heading.says}"),
        says=says,
        docstring=tuple(docstring),
    )


def _quoted(text: str) -> str:
    return text.replace('"', "'")


def _pages(kernels: tuple[TargetKernel, ...]) -> Iterator[Page]:
    values = {"declared": [_declared(kernel) for kernel in kernels]}
    for module in ("__init__", "protocols", "calls"):
        yield Page(f"{module}.pyi", f"{module}.pyi.jinja", values)
    yield Page("kernels.pyi", "kernels.pyi.jinja", {**values, "family": "Ufunc"})
    for file, (family, remark) in _REMARKS.items():
        own = {"family": family, "module": file, "remark": remark}
        yield Page(f"{file}.pyi", "functions.pyi.jinja", {**values, **own})


TARGET = Target("stubs", Path(__file__).parent, _pages)
