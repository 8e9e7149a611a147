"""wrenfold: `generate_function` with its C++ generator, a scalar argument for each entry."""

from __future__ import annotations

import inspect
from collections.abc import Sequence
from time import perf_counter
from typing import Any

from benchmarks.binding import bind, entries, operations
from benchmarks.formulas import Kernel
from benchmarks.peers import Made
from wrenfold import code_generation, sym, type_annotations

TITLE = "wrenfold C++"


def text_of(kernel: Kernel) -> str:
    """A C++ template of the kernel's entries and references to the results."""
    groups = kernel.symbols(str)

    def formula(**scalars: Any) -> list[code_generation.OutputArg]:
        given = iter(scalars.values())
        values = kernel.of(sym, *([next(given) for _ in group] for group in groups))
        return [code_generation.OutputArg(value, name=f"y{i}") for i, value in enumerate(values)]

    scalar, kind = type_annotations.FloatScalar, inspect.Parameter.POSITIONAL_OR_KEYWORD
    names = [name for group in groups for name in group]
    formula.__annotations__ = dict.fromkeys(names, scalar)
    formula.__signature__ = inspect.Signature(  # type: ignore[attr-defined]
        [inspect.Parameter(name, kind, annotation=scalar) for name in names]
    )
    generator = code_generation.CppGenerator()
    return str(code_generation.generate_function(formula, generator, name=f"{kernel.name}_one"))


def make(kernels: Sequence[Kernel]) -> dict[str, Made]:
    """Compiled functions for all kernels."""
    texts, seconds, calls = {}, {}, {}
    for kernel in kernels:
        started = perf_counter()
        texts[kernel.name] = text_of(kernel)
        seconds[kernel.name] = perf_counter() - started
        outputs = [f"y[{i}]" for i in range(kernel.size)]
        calls[kernel.name] = f"{kernel.name}_one<double>({', '.join([*entries(kernel), *outputs])});"
    bound = bind("wrenfold_cpp", kernels, "\n".join(texts.values()), calls, cxx=True)
    return {name: Made(call, operations(texts[name]), seconds[name]) for name, call in bound.items()}
