"""SymPy: `ufuncify` with the NumPy backend, a ufunc of all entries that stores them as columns."""

from __future__ import annotations

from collections.abc import Sequence
from time import perf_counter
from typing import Any

import numpy as np
import setuptools  # noqa: F401  # what the build needs
import sympy
from benchmarks.formulas import Kernel
from benchmarks.peers import Made, columns, filled
from sympy.utilities.autowrap import ufuncify

TITLE = "SymPy ufuncify"


def made(kernel: Kernel) -> Made:
    """One kernel; the seconds include its compilation."""
    started = perf_counter()
    symbols = kernel.symbols(lambda name: sympy.Symbol(name, real=True))
    names = [symbol for group in symbols for symbol in group]
    ufunc = ufuncify(names, kernel.of(sympy, *symbols), backend="numpy")
    seconds = perf_counter() - started

    def call(*inputs: Any, out: np.ndarray | None = None) -> np.ndarray:
        given = columns(kernel, inputs)
        out = filled(kernel, out, given[0].shape)
        ufunc(*given, out=tuple(out[..., *index] for index in np.ndindex(kernel.output)))
        return out

    return Made(call, seconds=seconds)


def make(kernels: Sequence[Kernel]) -> dict[str, Made]:
    """All kernels."""
    return {kernel.name: made(kernel) for kernel in kernels}
