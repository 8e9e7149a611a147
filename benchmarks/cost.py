"""Does the cost model of `chasles.lowering.cost` say what the machine does? Operations one by one, and all kernels.

Run it as `python -m benchmarks.cost [--rounds N]` from the root of a checkout, with a C compiler at hand. It measures
how long an operation takes, alone in compiled C and in the loops that chasles compiles, compares that with the weights,
and the times of all kernels with what the weights foretell; `--dry` does not write `benchmarks/evidence/cost.json`.
"""

from __future__ import annotations

import argparse
import json
import os
import shlex
import subprocess
import sys
from collections.abc import Callable, Sequence
from ctypes import CDLL, c_double, c_long
from pathlib import Path
from statistics import median
from tempfile import TemporaryDirectory
from typing import Any

import numpy as np
from benchmarks.kernels import machine, written
from benchmarks.timing import interleaved

from chasles import kernels as shipped
from chasles.compiling.kernel import CompiledKernel, kernel_of
from chasles.decisions.session import Session
from chasles.lowering.builder import Builder
from chasles.lowering.cost import ANGLE, LATENCIES, WEIGHTS, cost, latency
from chasles.lowering.lower import lower
from chasles.lowering.program import Argument, Op, Program, Result
from chasles.statements import load

EVIDENCE = Path(__file__).resolve().parent / "evidence" / "cost.json"
TURNS = 4096
"""Operations in a chain of compiled C; eight chains side by side show the throughput."""
ITEMS = 1000
"""Elements of a batch: they fit into the nearest cache."""
LENGTHS = {"add": (64, 160), "multiply": (64, 160)}
LONG = (8, 24)
"""Operations of two programs that are compared: as many as outweigh what loads and stores hide."""
MOVED = 2
"""Additions that a number costs that goes in or comes out; programs for one request move the same."""

ALONE = {
    "add": "x + y",
    "multiply": "x * y",
    "fma": "fma(x, y, z)",
    "divide": "y / x",
    "square_root": "sqrt(x + 1)",
    "sine": "sin(x)",
    "sine and cosine": "turned(x)",
    "arctangent2": "atan2(x, y)",
}
"""What a chain of scalar C does; the root adds 1, so that its argument stays away from what it tends to."""
HEAD = """
#define _GNU_SOURCE
#include <math.h>
static inline double turned(double x) { double s, c; sincos(x, &s, &c); return s + c; }
"""
LOOP = """
double {name}_one(double x, double y, double z, long n)
{{
    (void)z;
    for (long i = 0; i < n; i++) x = {expression};
    return x;
}}
double {name}_eight(double x0, double y, double z, long n)
{{
    double chains[8] = {{x0, x0 + 1, x0 + 2, x0 + 3, x0 + 4, x0 + 5, x0 + 6, x0 + 7}};
    (void)z;
    for (long i = 0; i < n; i += 8) {{
        for (int k = 0; k < 8; k++) {{ double x = chains[k]; chains[k] = {expression}; }}
    }}
    return chains[0] + chains[1] + chains[2] + chains[3] + chains[4] + chains[5] + chains[6] + chains[7];
}}
"""


def compiled(folder: Path) -> CDLL:
    """The chains as a library; vectors are left to the batches."""
    texts = [LOOP.format(name=f"f{k}", expression=expression) for k, expression in enumerate(ALONE.values())]
    (folder / "cost.c").write_text(HEAD + "".join(texts))
    flags = ("-O2", "-mfma", "-fno-tree-vectorize", "-fno-math-errno", "-funroll-loops", "-fPIC", "-shared")
    command = [*shlex.split(os.environ.get("CC", "cc")), *flags, "cost.c", "-o", "cost.so", "-lm"]
    subprocess.run(command, cwd=folder, check=True)
    return CDLL(str(folder / "cost.so"))


def alone(rounds: int) -> dict[str, dict[str, float]]:
    """For each operation the ns until its result can be used, and the ns of one among many that do not wait."""
    with TemporaryDirectory() as folder:
        library = compiled(Path(folder))
        calls: dict[str, Callable[[], object]] = {}
        for k, name in enumerate(ALONE):
            for many in ("one", "eight"):
                function = library[f"f{k}_{many}"]
                function.restype, function.argtypes = c_double, (c_double, c_double, c_double, c_long)
                calls[f"{name} {many}"] = lambda function=function: function(0.7, 1.0 + 1e-9, 0.25, TURNS)
        times = interleaved(calls, rounds)
    return {
        name: {
            "latency": median(times[f"{name} one"]) / TURNS * 1e9,
            "throughput": median(times[f"{name} eight"]) / TURNS * 1e9,
        }
        for name in ALONE
    }


def chained(op: str, length: int) -> CompiledKernel:
    """A kernel of four numbers with so many operations of a kind, in four chains."""
    build = Builder()
    numbers = [build.input(k, 0) for k in range(5)]
    ends = numbers[:4]
    for turn in range(length // 4):
        for k in range(4):
            match op:
                case "divide":
                    ends[k] = build.divide(numbers[4], ends[k])
                case "square_root":
                    ends[k] = build.square_root(ends[k])
                case "arctangent2":
                    ends[k] = build.arctangent2(ends[k], numbers[4])
                case "sine" | "sine and cosine":
                    angle = build.multiply(build.constant(turn + 2), numbers[k])
                    found = [build.sine(angle), *([build.cosine(angle)] if "cosine" in op else [])]
                    ends[k] = build.add(ends[k], build.add(*found) if len(found) == 2 else found[0])
                case _:
                    ends[k] = getattr(build, op)(ends[k], numbers[4])
    arguments = tuple(Argument(f"x{k}", (), "a number") for k in range(5))
    name = op.replace(" ", "_") + f"_{length}"
    return kernel_of(Program(name, arguments, build.steps, (Result("result", (4,), "the ends", tuple(ends)),)))


def in_batches(rounds: int) -> dict[str, float]:
    """For each operation the ns that it takes of an element in a compiled loop."""
    draw = np.random.default_rng(5)
    inputs = [draw.uniform(0.5, 1.5, ITEMS) for _ in range(5)]
    out = np.empty((ITEMS, 4))
    kinds = [name for name in ALONE if name != "fma"]
    calls: dict[str, Callable[[], object]] = {}
    for op in kinds:
        for length in LENGTHS.get(op, LONG):
            kernel = chained(op, length)
            calls[f"{op} {length}"] = lambda kernel=kernel: kernel(*inputs, out=out)
    times = interleaved(calls, rounds)
    found = {}
    for op in kinds:
        short, long = LENGTHS.get(op, LONG)
        pairs = zip(times[f"{op} {long}"], times[f"{op} {short}"], strict=False)
        found[op] = median(more - less for more, less in pairs) / (long - short) / ITEMS * 1e9
    # An angle is multiplied, and what is found of it added.
    for op, besides in (("sine", 2), ("sine and cosine", 3)):
        found[op] -= besides * found["add"]
    return found


def model() -> dict[str, dict[str, float]]:
    """The weights of the model, in additions, but of functions of libm, each of which takes another time."""
    weights = {op.value: float(weight) for op, weight in WEIGHTS.items() if op is not Op.FUNCTION}
    weights["sine"] += ANGLE
    weights["sine and cosine"] = weights["sine"] + WEIGHTS[Op.COSINE]
    return {
        "weights": weights,
        "latencies": {op.value: float(time) for op, time in LATENCIES.items() if op is not Op.FUNCTION},
    }


def programs() -> dict[str, Program]:
    """The program of every kernel."""
    book = load()
    judge = Session(book=book)
    lowered = (lower(entry, judge.decide, kernel) for entry in book.entries for kernel in entry.kernels)
    return {program.name: program for program in lowered}


def foretold(rounds: int) -> dict[str, dict[str, float]]:
    """For each kernel what the model says of it, how many numbers go in and out, and the ns of an element."""
    draw = np.random.default_rng(7)
    batches: dict[str, Callable[[], object]] = {}
    found: dict[str, dict[str, float]] = {}
    for name, program in programs().items():
        inputs = [draw.uniform(0.3, 1.3, (ITEMS, *argument.shape)) for argument in program.arguments]
        out = tuple(np.empty((ITEMS, *result.shape)) for result in program.results)
        kernel = getattr(shipped, name)
        batches[name] = lambda kernel=kernel, inputs=inputs, out=out: kernel(*inputs, out=out)
        entries = sum(array[0].size for array in (*inputs, *out))
        found[name] = {"cost": cost(program), "latency": latency(program), "entries": entries}
    with np.errstate(all="ignore"):
        times = interleaved(batches, rounds)
    for name in found:
        found[name]["ns"] = median(times[name]) / ITEMS * 1e9
    return found


def rank_correlation(one: Sequence[float], other: Sequence[float]) -> float:
    """Spearman's: the correlation of the ranks, those of equal values being their mean."""

    def ranks(values: Sequence[float]) -> np.ndarray:
        array = np.asarray(values)
        return np.array([(array < x).sum() + ((array == x).sum() - 1) / 2 for x in array])

    return float(np.corrcoef(ranks(one), ranks(other))[0, 1])


def measured(rounds: int) -> dict[str, Any]:
    """Operations, kernels, and how well the model ranks these."""
    scalar, batch, kernels = alone(rounds), in_batches(rounds), foretold(rounds)
    rows = list(kernels.values())
    ns, costs = [row["ns"] for row in rows], [row["cost"] for row in rows]
    moved = [row["cost"] + MOVED * row["entries"] for row in rows]
    return {
        "machine": machine(),
        "ns of an operation": {
            name: scalar[name] | ({"in batches": batch[name]} if name in batch else {}) for name in scalar
        },
        "in additions": {name: value / batch["add"] for name, value in batch.items()},
        "model": model(),
        "rank correlation": {"cost": rank_correlation(costs, ns), "cost and entries": rank_correlation(moved, ns)},
        "kernels": kernels,
    }


def shown(found: dict[str, Any]) -> str:
    """The operations as a table, and the correlation."""
    weights, additions = found["model"]["weights"], found["in additions"]
    lines = [f"{'':16} {'latency':>8} {'throughput':>10} {'in batches':>10} {'additions':>9} {'model':>6}"]
    for name, row in found["ns of an operation"].items():
        last = []
        if name in weights:
            last = [f"{row['in batches']:10.3f}", f"{additions[name]:9.1f}", f"{weights[name]:6.0f}"]
        lines.append(" ".join([f"{name:16} {row['latency']:8.2f} {row['throughput']:10.2f}", *last]))
    ranked = ", ".join(f"{name} {value:.2f}" for name, value in found["rank correlation"].items())
    return "\n".join([*lines, f"rank correlation of {len(found['kernels'])} kernels' ns with: {ranked}"])


def main() -> None:
    """Print the table and write the evidence."""
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--rounds", type=int, default=9)
    parser.add_argument("--dry", action="store_true", help="write nothing")
    options = parser.parse_args()
    if shipped.backend != "c":
        sys.exit("benchmarks.cost: needs the compiled kernels and a C compiler")
    found = measured(options.rounds)
    print(shown(found))
    if not options.dry:
        written(EVIDENCE, json.dumps(found, indent=1) + "\n")


if __name__ == "__main__":
    main()
