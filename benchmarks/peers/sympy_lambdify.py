"""SymPy: `lambdify` with `cse=True` for NumPy, called with columns and stored entry by entry."""

from __future__ import annotations

from collections.abc import Sequence
from time import perf_counter
from typing import Any

import numpy as np
import sympy
from benchmarks.formulas import Kernel
from benchmarks.peers import Made, columns, filled

TITLE = "SymPy lambdify"


def made(kernel: Kernel) -> Made:
    """One kernel; entries that are constant come back as scalars, hence the storing into an array."""
    started = perf_counter()
    symbols = kernel.symbols(lambda name: sympy.Symbol(name, real=True))
    names = [symbol for group in symbols for symbol in group]
    written = sympy.lambdify(names, kernel.of(sympy, *symbols), "numpy", cse=True)
    seconds = perf_counter() - started

    def call(*inputs: Any, out: np.ndarray | None = None) -> np.ndarray:
        given = columns(kernel, inputs)
        out = filled(kernel, out, given[0].shape)
        for index, value in zip(np.ndindex(kernel.output), written(*given), strict=True):
            out[..., *index] = value
        return out

    return Made(call, seconds=seconds)


def make(kernels: Sequence[Kernel]) -> dict[str, Made]:
    """All kernels."""
    return {kernel.name: made(kernel) for kernel in kernels}
