"""The kernels and their peers, side by side in one run: operations, times, errors, the time to generate.

Run it as `python -m benchmarks.kernels [--rounds N] [--sizes N ...]` from the root of a checkout, in an environment
with the extra `bench`; `make bench` does. It prints the tables and writes the first of them to `benchmarks/README.md`,
the figures to `benchmarks/evidence/kernels.json`, and a picture beside it where matplotlib is installed. `--dry`
writes nothing.
"""

from __future__ import annotations

import argparse
import json
import os
import platform
import shlex
import subprocess
import sys
from collections.abc import Callable, Sequence
from datetime import UTC, datetime
from functools import partial
from importlib import metadata
from pathlib import Path
from statistics import median
from typing import Any

import numpy as np
from benchmarks.formulas import KERNELS, Kernel
from benchmarks.peers import GENERATED, OURS, Made, importable
from benchmarks.picture import draw
from benchmarks.points import NEAR_PI, NEAR_ZERO, batch, condition, largest_error, near, references
from benchmarks.tables import details, summary
from benchmarks.timing import interleaved, ratio

from chasles import kernels as shipped

HERE = Path(__file__).resolve().parent
EVIDENCE = HERE / "evidence" / "kernels.json"
PACKAGES = ("chasles", "numpy", "sympy", "casadi", "symforce", "wrenfold", "numba", "scipy", "mpmath", "cython")
REGIONS: dict[str, tuple[float, ...] | None] = (
    {"0.1 to 3": None}
    | {f"{x:g}": (x,) for x in NEAR_ZERO}
    | {f"pi - {np.pi - x:.0e}".removesuffix(" - 0e+00"): (x,) for x in NEAR_PI}
)


def machine() -> dict[str, Any]:
    """The processor, its load, the compiler and the versions of all that takes part."""
    info = Path("/proc/cpuinfo")
    models = (
        [line.partition(":")[2].strip() for line in info.read_text().splitlines() if "model name" in line]
        if (info.exists())
        else []
    )
    compiler = shlex.split(os.environ.get("CC", "cc"))
    said = subprocess.run([*compiler, "--version"], capture_output=True, text=True, check=False).stdout
    versions = {}
    for name in PACKAGES:
        try:
            versions[name] = metadata.version(name)
        except metadata.PackageNotFoundError:
            continue
    return {
        "date": datetime.now(UTC).strftime("%Y-%m-%d %H:%M UTC"),
        "processor": models[0] if models else platform.processor() or platform.machine(),
        "cores": os.cpu_count(),
        "load": round(os.getloadavg()[0], 2),
        "compiler": said.partition("\n")[0],
        "python": platform.python_version(),
        "backend": shipped.backend,
        "instructions": shipped.instructions,
        "versions": versions,
    }


def calls_at(kernel: Kernel, made: dict[str, Made], n: int, given: bool) -> dict[str, Callable[[], object]]:
    """What is timed for n elements, with the output given or allocated; one element has no batch axis."""
    inputs = batch(kernel, n)
    if n == 1:
        inputs = tuple(x[0] for x in inputs)
    out = np.empty(((n,) if n > 1 else ()) + kernel.output)
    out.fill(0)
    keywords = {"out": out} if given else {}
    calls = {name: partial(each.call, *inputs, **keywords) for name, each in made.items() if n == 1 or each.batched}
    if shipped.backend == "c":
        calls["one"] = partial(getattr(shipped.one, kernel.name), *inputs, **keywords)
    return calls


def timed(kernel: Kernel, made: dict[str, Made], sizes: Sequence[int], rounds: int) -> dict[str, Any]:
    """The median ns per element of each peer, and how many times faster than the best generated peer chasles is."""
    found: dict[str, Any] = {"ns": {}, "times_faster": {}, "one_by_ufunc": {}}
    for n in sizes:
        for given in (False, True):
            times = interleaved(calls_at(kernel, made, n, given), rounds)
            where = f"{n}{' out=' if given else ''}"
            found["ns"][where] = {name: round(1e9 * median(values) / n, 2) for name, values in times.items()}
            ratios = {name: ratio(times[name], times[OURS]) for name in GENERATED if name in times}
            if ratios:
                best = min(ratios, key=lambda name: ratios[name])
                found["times_faster"][where] = {"than": best, "ratio": round(ratios[best], 2)}
            if "one" in times:
                found["one_by_ufunc"][where] = round(ratio(times["one"], times[OURS]), 3)
    return found


def erring(kernel: Kernel, made: dict[str, Made]) -> dict[str, Any]:
    """The largest error of each peer in each region of the angle; of chasles' p0 by its condition number too."""
    found: dict[str, Any] = {}
    for region, angles in REGIONS.items():
        if angles and not kernel.singular:
            continue
        inputs = near(kernel, angles) if angles else batch(kernel, 100)
        if not angles and kernel.singular:
            inputs = near(kernel, tuple(np.linspace(0.1, 3.0, 40)), 3)
        right = references(kernel, inputs)
        found[region] = {
            name: None if error is None else round(error, 2)
            for name, each in made.items()
            for error in [largest_error(each.call, inputs, right)]
        }
        if kernel.name == "screw_axis_point" and not (angles and angles[0] < 1e-20):
            ours = [
                (largest_error(made[OURS].call, tuple(x[i : i + 1] for x in inputs), right[i : i + 1]) or 0.0)
                / condition(kernel, inputs, i)
                for i in range(len(right))
            ]
            found[region]["chasles by condition"] = round(max(ours), 2)
    return found


def emitting() -> float:
    """Seconds of `chasles emit --check`: the text of all kernels for all targets."""
    usage = os.times()
    command = [sys.executable, "-m", "chasles", "emit", "--check"]
    subprocess.run(command, cwd=HERE.parent, capture_output=True, check=False)
    after = os.times()
    return round(after.children_user + after.children_system - usage.children_user - usage.children_system, 2)


def measured(options: argparse.Namespace) -> dict[str, Any]:
    """All figures."""
    peers, skipped = {}, []
    for name, module in importable():
        if isinstance(module, str):
            skipped.append(module)
            print(module)
        elif name in options.without:
            skipped.append(f"{name} is left out of this run")
        else:
            print(f"{name} ...", flush=True)
            try:
                peers[name] = (module.TITLE, module.make(KERNELS))
            except Exception as error:  # whatever a peer fails with, the others are measured
                if name == OURS:
                    raise
                skipped.append(f"{name} is left out: it failed with {type(error).__name__}")
                print(f"{skipped[-1]}: {error}")
    evidence: dict[str, Any] = {
        "machine": machine(),
        "rounds": options.rounds,
        "peers": {name: title for name, (title, _) in peers.items()},
        "skipped": skipped,
        "emit_seconds": emitting(),
        "kernels": {},
    }
    for kernel in KERNELS:
        print(f"{kernel.title} ...", flush=True)
        made = {name: each[kernel.name] for name, (_, each) in peers.items() if kernel.name in each}
        evidence["kernels"][kernel.name] = {
            "title": kernel.title,
            "operations": {name: each.operations for name, each in made.items() if each.operations is not None},
            "generation_seconds": {name: round(m.seconds, 4) for name, m in made.items() if m.seconds is not None},
            **timed(kernel, made, options.sizes, options.rounds),
            "errors": erring(kernel, made),
        }
    evidence["machine"]["load_after"] = round(os.getloadavg()[0], 2)
    return evidence


def written(path: Path, text: str) -> None:
    """The text in the file, whole or not at all."""
    path.parent.mkdir(exist_ok=True)
    beside = path.with_suffix(path.suffix + ".new")
    beside.write_text(text, "utf-8")
    beside.replace(path)


def main() -> None:
    """Measure, print, write."""
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--rounds", type=int, default=9, help="interleaved rounds; ratios are medians over them")
    parser.add_argument("--sizes", type=int, nargs="+", default=[1, 100, 10_000, 1_000_000], help="elements of a batch")
    parser.add_argument("--without", nargs="+", default=[], help="peers to leave out, by the name of their module")
    parser.add_argument("--dry", action="store_true", help="write no files")
    options = parser.parse_args()
    evidence = measured(options)
    if not options.dry:
        written(EVIDENCE, json.dumps(evidence, indent=1) + "\n")
        written(HERE / "README.md", summary(evidence))
        draw(evidence, EVIDENCE.with_suffix(".svg"))
    print(summary(evidence), details(evidence), sep="\n")


if __name__ == "__main__":
    main()
