"""numba: `njit` of a loop around Python text that SymPy prints after `cse`.

`guvectorize` takes no size that does not come in with an input, such as the 4 rows of N.
"""

from __future__ import annotations

import math
from collections.abc import Sequence
from time import perf_counter
from typing import Any

import numpy as np
import sympy
from benchmarks.formulas import Kernel
from benchmarks.peers import Made, filled
from numba import float64, njit, types

TITLE = "numba"


def text_of(kernel: Kernel) -> str:
    """The loop over the elements of a batch."""
    symbols = kernel.symbols(lambda name: sympy.Symbol(name, real=True))
    shared, results = sympy.cse(kernel.of(sympy, *symbols))
    lines = []
    for (name, shape), group in zip(kernel.inputs.items(), symbols, strict=True):
        lines += [f"{x} = in_{name}[{place(i)}]" for x, i in zip(group, np.ndindex(shape), strict=True)]
    lines += [f"{name} = {sympy.pycode(value)}" for name, value in shared]
    indices = np.ndindex(kernel.output)
    lines += [f"out[{place(i)}] = {sympy.pycode(value)}" for i, value in zip(indices, results, strict=True)]
    names = ", ".join(f"in_{name}" for name in kernel.inputs)
    return "\n        ".join([f"def formula({names}, out):\n    for n in range(len(out)):", *lines])


def place(index: tuple[int, ...]) -> str:
    """The entry of the n-th element."""
    return ", ".join(["n", *map(str, index)])


def made(kernel: Kernel) -> Made:
    """One kernel; the seconds include its compilation."""
    started = perf_counter()
    names: dict[str, Any] = {"math": math}
    exec(text_of(kernel), names)
    shapes = (*kernel.inputs.values(), kernel.output)
    arguments = tuple(types.Array(float64, 1 + len(shape), "C") for shape in shapes)
    compiled = njit([arguments])(names["formula"])
    seconds = perf_counter() - started

    def call(*inputs: Any, out: np.ndarray | None = None) -> np.ndarray:
        batch = np.shape(inputs[0])[: -len(shapes[0])]
        out = filled(kernel, out, batch)
        shaped = (np.reshape(x, (-1, *shape)) for x, shape in zip((*inputs, out), shapes, strict=True))
        compiled(*shaped)
        return out

    return Made(call, seconds=seconds)


def make(kernels: Sequence[Kernel]) -> dict[str, Made]:
    """All kernels."""
    return {kernel.name: made(kernel) for kernel in kernels}
