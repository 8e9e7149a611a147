"""SymForce: `Codegen` with the C++ backend, a scalar argument for each entry."""

from __future__ import annotations

import logging
import tempfile
from collections.abc import Sequence
from pathlib import Path
from time import perf_counter

logging.disable(logging.WARNING)  # it warns of singularities: what the printed formulas have, and what is measured here
import symforce.symbolic as sf  # noqa: E402
from symforce import codegen  # noqa: E402
from symforce.values import Values  # noqa: E402

logging.disable(logging.NOTSET)

from benchmarks.binding import bind, entries, operations  # noqa: E402
from benchmarks.formulas import Kernel  # noqa: E402
from benchmarks.peers import Made  # noqa: E402

TITLE = "SymForce C++"


def text_of(kernel: Kernel) -> str:
    """A C++ template without the include of Eigen, which scalars do not need."""
    symbols = kernel.symbols(sf.Symbol)
    inputs = Values({str(symbol): symbol for group in symbols for symbol in group})
    outputs = Values({f"y{i}": sf.S(value) for i, value in enumerate(kernel.of(sf, *symbols))})
    logging.disable(logging.WARNING)
    made = codegen.Codegen(inputs=inputs, outputs=outputs, config=codegen.CppConfig(), name=f"{kernel.name}_one")
    with tempfile.TemporaryDirectory() as folder:
        (file,) = made.generate_function(output_dir=Path(folder)).generated_files
        text = Path(file).read_text("utf-8")
    logging.disable(logging.NOTSET)
    return text.replace("#include <Eigen/Core>", "").replace("#pragma once", "")


def make(kernels: Sequence[Kernel]) -> dict[str, Made]:
    """Compiled functions for all kernels."""
    texts, seconds, calls = {}, {}, {}
    for kernel in kernels:
        started = perf_counter()
        texts[kernel.name] = text = text_of(kernel)
        seconds[kernel.name] = perf_counter() - started
        name = text.partition("void ")[2].partition("(")[0]
        outputs = [f"&y[{i}]" for i in range(kernel.size)]
        calls[kernel.name] = f"sym::{name}<double>({', '.join([*entries(kernel), *outputs])});"
    bound = bind("symforce_cpp", kernels, "".join(texts.values()), calls, cxx=True)
    return {name: Made(call, operations(texts[name]), seconds[name]) for name, call in bound.items()}
