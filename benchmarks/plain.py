"""Each kernel beside a plain loop over its own scalar function in C, compiled with all instructions of this machine.

Run it as `python -m benchmarks.plain [--rounds N] [--sizes N ...] [--kernels NAME ...]` from the root of a checkout. It
prints how many times as fast as that loop a batch is, each with `out=`, least first. Kernels with several outputs are
left out.
"""

from __future__ import annotations

import argparse
import re
from collections.abc import Iterator
from functools import partial
from pathlib import Path
from typing import Any

from benchmarks.binding import bind
from benchmarks.formulas import Kernel, Matrix
from benchmarks.strides import batches, shapes_of
from benchmarks.timing import interleaved, ratio

from chasles import kernels

SOURCES = Path(__file__).parent.parent / "generated" / "c" / "src"
SCALAR = re.compile(r"^void chasles_((?!\w*_batchf?\()\w+)\((.*?)^\}", re.M | re.S)


def functions() -> dict[str, str]:
    """The scalar functions in C, by the names of their kernels."""
    texts = (path.read_text("utf-8") for path in sorted(SOURCES.glob("section_*.c")) if "_blocks" not in path.name)
    return {found[1]: f"static inline {found[0]}\n" for text in texts for found in SCALAR.finditer(text)}


def formula(*_: Any) -> Matrix:
    """The loop calls the kernel's own function, which is in C already."""
    raise NotImplementedError


def measured(known: dict[str, str]) -> Iterator[tuple[str, Any, Kernel]]:
    """The kernels with one output: name, ufunc, and what the loop reads and writes."""
    for name in sorted(known):
        kernel = getattr(kernels, name, None)
        given, returned = shapes_of(kernel) if kernel is not None else ([], [])
        if len(returned) == 1:
            inputs = {f"x{place}": shape for place, shape in enumerate(given)}
            yield name, kernel, Kernel(name, name, formula, inputs, returned[0])


def main() -> None:
    """Print the ratios, kernel by kernel."""
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("--rounds", type=int, default=7)
    parser.add_argument("--sizes", type=int, nargs="+", default=[100, 1_000, 10_000, 1_000_000])
    parser.add_argument("--kernels", nargs="+")
    chosen = parser.parse_args()
    known = functions()
    found = [item for item in measured(known) if chosen.kernels is None or item[0] in chosen.kernels]
    calls = {}
    for name, _, kernel in found:
        read = [name if shape else f"*{name}" for name, shape in kernel.inputs.items()]
        calls[name] = f"chasles_{name}({', '.join(read)}, y);"
    plain = bind("plain", [kernel for *_, kernel in found], "".join(known.values()), calls)
    ratios: dict[str, list[float]] = {}
    for name, ufunc, kernel in found:
        ratios[name] = []
        for count in chosen.sizes:
            given = batches(list(kernel.inputs.values()), count)
            (out,) = batches([kernel.output], count)
            pair = {"plain": partial(plain[name], *given, out=out), "chasles": partial(ufunc, *given, out=out)}
            times = interleaved(pair, chosen.rounds)
            ratios[name].append(ratio(times["plain"], times["chasles"]))
    print(f"{'items':40}", *(f"{count:9}" for count in chosen.sizes))
    for name in sorted(ratios, key=lambda each: min(ratios[each])):
        print(f"{name:40}", *(f"{each:9.2f}" for each in ratios[name]))


if __name__ == "__main__":
    main()
