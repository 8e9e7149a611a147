"""CasADi: `cse` on scalar expressions (SX), then its C code generator."""

from __future__ import annotations

from collections.abc import Sequence
from time import perf_counter

import casadi
from benchmarks.binding import bind, operations
from benchmarks.formulas import Kernel
from benchmarks.peers import Made

TITLE = "CasADi C"


def text_of(kernels: Sequence[Kernel]) -> str:
    """The C file with a function for each kernel: flat inputs, one flat output."""
    generator = casadi.CodeGenerator("peer.c")
    for kernel in kernels:
        symbols = kernel.symbols(casadi.SX.sym)
        inputs = [casadi.vertcat(*group) for group in symbols]
        output = casadi.cse(casadi.vertcat(*kernel.of(casadi, *symbols)))
        generator.add(casadi.Function(f"{kernel.name}_one", inputs, [output]))
    return str(generator.dump())


def make(kernels: Sequence[Kernel]) -> dict[str, Made]:
    """Compiled functions for all kernels; its functions are made local to the file, so that they can be inlined."""
    counts, seconds = {}, {}
    for kernel in kernels:
        started = perf_counter()
        text = text_of([kernel])
        seconds[kernel.name] = perf_counter() - started
        start = text.index("static int casadi_f0")
        counts[kernel.name] = operations(text[start : text.index("CASADI_SYMBOL_EXPORT", start)])
    calls = {}
    for kernel in kernels:
        arrays = ", ".join(f"x{i}" for i in range(len(kernel.inputs)))
        pointers = f"const double *arg[] = {{{arrays}}}; double *res[] = {{y}};"
        calls[kernel.name] = f"{pointers} {kernel.name}_one(arg, res, 0, 0, 0);"
    bound = bind("casadi_c", kernels, "#define CASADI_SYMBOL_EXPORT static inline\n" + text_of(kernels), calls)
    return {name: Made(call, counts[name], seconds[name]) for name, call in bound.items()}
