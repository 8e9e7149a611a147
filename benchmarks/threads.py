"""How much sooner is a batch done by several threads of one Python? `python -m benchmarks.threads`.

The batch is cut into as many pieces as there are threads; each thread computes its piece into its part of one array.
Times are by the clock on the wall, the least of the rounds: what disturbs the machine only makes them longer. Beside
each kernel stands NumPy's own `matmul` of the same number of rotations, to show what the machine gives.
"""

from __future__ import annotations

import json
import os
import platform
import sys
from collections.abc import Callable
from concurrent.futures import ThreadPoolExecutor
from pathlib import Path
from time import perf_counter

import numpy as np

from chasles import kernels

EVIDENCE = Path(__file__).parent / "evidence" / "threads.json"
ITEMS = (10_000, 100_000, 1_000_000)
ROUNDS = 15
Call = Callable[[slice], object]


def calls(items: int) -> dict[str, Call]:
    """What is timed, each on a slice of a batch of so many items."""
    random = np.random.default_rng(0)
    e, phi = np.tile([0.6, 0.0, 0.8], (items, 1)), random.uniform(-3, 3, items)
    a, b = random.standard_normal((2, items, 3))
    twist, rate = random.standard_normal((2, items, 6))
    Q, other = np.empty((2, items, 3, 3))
    point, wrench = np.empty((items, 3)), np.empty((items, 6))
    inertia = np.diag([1.0, 2.0, 3.0])
    kernels.rotation_from_axis_angle(e, phi, out=other)
    return {
        "rotation_from_axis_angle": lambda s: kernels.rotation_from_axis_angle(e[s], phi[s], out=Q[s]),
        "screw_axis_point": lambda s: kernels.screw_axis_point(e[s], phi[s], a[s], b[s], out=point[s]),
        "newton_euler_wrench": lambda s: kernels.newton_euler_wrench(inertia, 2.0, twist[s], rate[s], out=wrench[s]),
        "matmul of NumPy": lambda s: np.matmul(other[s], other[s], out=Q[s]),
    }


def fastest(call: Call, items: int, threads: int, pool: ThreadPoolExecutor) -> float:
    """The seconds of the fastest round."""
    edges = np.linspace(0, items, threads + 1, dtype=int)
    pieces = [slice(*map(int, pair)) for pair in zip(edges, edges[1:], strict=False)]
    times = []
    for _ in range(ROUNDS):
        started = perf_counter()
        if threads == 1:
            call(pieces[0])
        else:
            list(pool.map(call, pieces))
        times.append(perf_counter() - started)
    return min(times)


def measured(most: int) -> dict[str, dict[str, dict[str, float]]]:
    """Kernel -> items -> threads -> nanoseconds an item."""
    found: dict[str, dict[str, dict[str, float]]] = {}
    with ThreadPoolExecutor(most) as pool:
        for items in ITEMS:
            for name, call in calls(items).items():
                row = found.setdefault(name, {}).setdefault(str(items), {})
                for threads in range(1, most + 1):
                    row[str(threads)] = round(fastest(call, items, threads, pool) / items * 1e9, 3)
    return found


def main() -> None:
    """Measure, print the table, keep the evidence."""
    processors = len(os.sched_getaffinity(0)) if hasattr(os, "sched_getaffinity") else os.cpu_count() or 1
    most = min(processors, 8)
    load = os.getloadavg()[0] if hasattr(os, "getloadavg") else float("nan")
    found = measured(most)
    machine = {"processors": processors, "load before": round(load, 2), "instructions": kernels.instructions}
    evidence = {"machine": {**machine, "python": platform.python_version()}, "ns per item": found}
    EVIDENCE.write_text(json.dumps(evidence, indent=1) + "\n", "utf-8")
    print(f"{processors} processors, load {load:.2f} before; ns an item, and how many times faster than one thread")
    for name, rows in found.items():
        for items, row in rows.items():
            shown = (f"{threads}: {ns:7.2f} ({row['1'] / ns:.2f} x)" for threads, ns in row.items())
            print(f"{name:26} n = {int(items):>9,}  {'   '.join(shown)}")


if __name__ == "__main__":
    sys.exit(main())
