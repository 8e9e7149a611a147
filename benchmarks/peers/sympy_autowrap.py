"""SymPy: `autowrap` with the Cython backend: a function of one element."""

from __future__ import annotations

from collections.abc import Sequence
from time import perf_counter
from typing import Any

import Cython  # noqa: F401  # what the backend needs
import numpy as np
import setuptools  # noqa: F401  # what the build needs
import sympy
from benchmarks.formulas import Kernel
from benchmarks.peers import Made, filled
from sympy.utilities.autowrap import autowrap

TITLE = "SymPy autowrap"


def made(kernel: Kernel) -> Made:
    """One kernel; the seconds include its compilation."""
    started = perf_counter()
    symbols = kernel.symbols(lambda name: sympy.Symbol(name, real=True))
    names = [symbol for group in symbols for symbol in group]
    matrix = sympy.Matrix(kernel.of(sympy, *symbols)).reshape(kernel.output[0], int(np.prod(kernel.output[1:])))
    wrapped = autowrap(matrix, args=names, backend="cython")
    seconds = perf_counter() - started

    def call(*inputs: Any, out: np.ndarray | None = None) -> np.ndarray:
        out = filled(kernel, out, ())
        out[...] = wrapped(*(float(x) for value in inputs for x in np.ravel(value))).reshape(kernel.output)
        return out

    return Made(call, seconds=seconds, batched=False)


def make(kernels: Sequence[Kernel]) -> dict[str, Made]:
    """All kernels."""
    return {kernel.name: made(kernel) for kernel in kernels}
