"""SymPy: `cse` over all entries, each printed with `ccode`."""

from __future__ import annotations

from collections.abc import Sequence
from time import perf_counter

import sympy
from benchmarks.binding import bind, entries, operations
from benchmarks.formulas import Kernel
from benchmarks.peers import Made

TITLE = "SymPy cse, C"


def text_of(kernel: Kernel) -> str:
    """A C function of the kernel's entries and `y`."""
    symbols = kernel.symbols(lambda name: sympy.Symbol(name, real=True))
    names = [symbol for group in symbols for symbol in group]
    shared, results = sympy.cse(kernel.of(sympy, *symbols))
    lines = [f"const double {sympy.ccode(name)} = {sympy.ccode(value)};" for name, value in shared]
    lines += [f"y[{i}] = {sympy.ccode(value)};" for i, value in enumerate(results)]
    arguments = ", ".join(f"double {name}" for name in names)
    return (
        f"static inline void {kernel.name}_one({arguments}, double *__restrict__ y) {{\n" + "\n".join(lines) + "\n}\n"
    )


def make(kernels: Sequence[Kernel]) -> dict[str, Made]:
    """Compiled functions for all kernels."""
    texts, seconds = {}, {}
    for kernel in kernels:
        started = perf_counter()
        texts[kernel.name] = text_of(kernel)
        seconds[kernel.name] = perf_counter() - started
    calls = {kernel.name: f"{kernel.name}_one({', '.join(entries(kernel))}, y);" for kernel in kernels}
    bound = bind("sympy_cse_c", kernels, "".join(texts.values()), calls)
    return {name: Made(call, operations(texts[name]), seconds[name]) for name, call in bound.items()}
