"""The peers: a module each that says how the printed formulas are given to one tool, and what it makes of them.

A module has a `TITLE` and a function `make(kernels)`, which returns, by the kernel's name, what is called. A kernel
that the tool does not have is left out. Importing the module raises ImportError where the tool is not installed.
"""

from __future__ import annotations

from collections.abc import Callable, Iterator
from dataclasses import dataclass
from importlib import import_module
from types import ModuleType
from typing import Any

import numpy as np
from benchmarks.formulas import Kernel

GENERATED = ("sympy_codegen_c", "sympy_cse_c", "casadi_c", "symforce_cpp", "wrenfold_cpp")
"""The peers that write C or C++ from a formula; all are compiled and bound in the same way."""
PEERS = (
    *GENERATED,
    "numpy_by_hand",
    "sympy_lambdify",
    "sympy_ufuncify",
    "sympy_autowrap",
    "numba_jit",
    "scipy_rotation",
)
OURS = "chasles_kernels"


@dataclass(frozen=True)
class Made:
    """What a peer offers for a kernel: `call(*inputs, out=None)`, its text's operations, seconds to make the text."""

    call: Callable[..., Any]
    operations: int | None = None
    seconds: float | None = None
    batched: bool = True


def importable() -> Iterator[tuple[str, ModuleType | str]]:
    """Each peer's module, or the line that says why it is left out; chasles comes first."""
    for name in (OURS, *PEERS):
        try:
            yield name, import_module(f"benchmarks.peers.{name}")
        except ImportError as error:
            yield name, f"{name} is left out: {error}"


def filled(kernel: Kernel, out: np.ndarray | None, batch: tuple[int, ...]) -> np.ndarray:
    """The array given, or a new one."""
    return np.empty(batch + kernel.output) if out is None else out


def columns(kernel: Kernel, inputs: tuple[Any, ...]) -> list[np.ndarray]:
    """An array for each entry of each input: views along the batch."""
    found = []
    for value, shape in zip(inputs, kernel.inputs.values(), strict=True):
        found += [np.asarray(value)[..., *index] for index in np.ndindex(shape)]
    return found
