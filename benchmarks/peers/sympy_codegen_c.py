"""SymPy: `codegen` in C99, an output argument for each entry."""

from __future__ import annotations

import re
from collections.abc import Sequence
from time import perf_counter

import sympy
from benchmarks.binding import bind, entries, operations
from benchmarks.formulas import Kernel
from benchmarks.peers import Made
from sympy.utilities.codegen import codegen

TITLE = "SymPy codegen, C"


def text_of(kernel: Kernel) -> str:
    """A C function of the kernel's entries and pointers to the results."""
    symbols = kernel.symbols(lambda name: sympy.Symbol(name, real=True))
    inputs = [symbol for group in symbols for symbol in group]
    values = kernel.of(sympy, *symbols)
    outputs = [sympy.Symbol(f"y_{i}", real=True) for i in range(len(values))]
    equations = [sympy.Eq(output, value, evaluate=False) for output, value in zip(outputs, values, strict=True)]
    order = [*inputs, *outputs]
    (_, text), _ = codegen((f"{kernel.name}_one", equations), "C99", header=False, argument_sequence=order)
    return "static inline " + re.sub(r"#include[^\n]*\n", "", text).lstrip()


def make(kernels: Sequence[Kernel]) -> dict[str, Made]:
    """Compiled functions for all kernels."""
    texts, seconds, calls = {}, {}, {}
    for kernel in kernels:
        started = perf_counter()
        texts[kernel.name] = text_of(kernel)
        seconds[kernel.name] = perf_counter() - started
        outputs = [f"&y[{i}]" for i in range(kernel.size)]
        calls[kernel.name] = f"{kernel.name}_one({', '.join([*entries(kernel), *outputs])});"
    bound = bind("sympy_codegen_c", kernels, "\n".join(texts.values()), calls)
    counted = {name: operations(re.sub(r"\(\*y_\d+\)", "y", each)) for name, each in texts.items()}
    return {name: Made(call, counted[name], seconds[name]) for name, call in bound.items()}
