"""JAX: a module that needs nothing else, whose functions JAX may trace, compile, map and differentiate.

The functions are those for NumPy; what prepares their inputs and puts their results together is said in the module, in
few words, since the library is known. PyTorch's module is the same in its words.
"""

from __future__ import annotations

from collections.abc import Iterator, Mapping
from dataclasses import dataclass, replace
from pathlib import Path

from chasles.targets.dialect import Phrase, call
from chasles.targets.kernel import EmissionError, TargetKernel
from chasles.targets.numpy import DIALECT, NAMES, function
from chasles.targets.target import Page, Target

_TAKEN = ("Any", "Batch", "NamedTuple", "jax", "prepared", "reduce", "special", "xp")


@dataclass(frozen=True, slots=True)
class Library:
    """The words in which array libraries differ: of an `array`, of a `dtype`, of the `inputs` of a call."""

    title: str
    imports: str
    kind: str
    is_complex: str
    is_floating: str
    changed: str
    device: str
    functions: Mapping[str, str]
    """The names, or texts, of functions of C that the array API has not."""


def target(name: str, library: Library) -> Target:
    """The target of a library: one module for all kernels, or one for each kernel to be taken away."""
    said = {name: f"xp.{said}" for name, said in NAMES.items()} | {"fmod": "xp.fmod"} | {**library.functions}

    def phrase(name: str, operands: int) -> Phrase:
        if name not in said:
            raise EmissionError(f"{library.title} has no function {name}")
        text = said[name]
        return replace(call(text, operands), text=text) if "{" in text else call(text, operands)

    dialect = replace(DIALECT, function=phrase)

    def page(path: str, kernels: tuple[TargetKernel, ...]) -> Page:
        taken = [kernel.name for kernel in kernels if kernel.name in _TAKEN]
        if taken:
            raise EmissionError(f"a kernel may not be called {taken[0]}: its module calls something else so")
        functions = [function(kernel, "return {}", dialect) for kernel in kernels]
        return Page(path, "module.py.jinja", {"library": library, "functions": functions})

    def pages(kernels: tuple[TargetKernel, ...]) -> Iterator[Page]:
        yield page("kernels.py", kernels)

    def alone(kernels: tuple[TargetKernel, ...]) -> Iterator[Page]:
        for kernel in kernels:
            yield page(f"{kernel.name}_{name}.py", (kernel,))

    return Target(name, Path(__file__).parent, pages, alone, by_default=False)


_JAX = Library(
    title="JAX",
    imports="import jax\nimport jax.numpy as xp\nfrom jax.scipy import special",
    kind="jax.Array",
    is_complex="xp.iscomplexobj(array)",
    is_floating="xp.issubdtype(array.dtype, xp.floating)",
    changed="array.astype(dtype)",
    device="None",
    functions={
        "cbrt": "xp.cbrt",
        "erf": "special.erf",
        "erfc": "special.erfc",
        "tgamma": "special.gamma",
        "lgamma": "special.gammaln",
        "digamma": "special.digamma",
    },
)
TARGET = target("jax", _JAX)
