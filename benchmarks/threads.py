"""How much sooner is a batch done by several threads of one Python? `python -m benchmarks.threads`.

The batch is cut into as many pieces as there are threads; each thread computes its piece into its part of one array.
Two figures, each the best of the rounds. By the clock: how many times sooner the batch is done, which is less on a
machine that has other things to do. By the processors: the same if each thread had a processor to itself, from the
processor time that the pieces take together; what the threads lose to the memory that they share is in it. Beside the
kernels stands NumPy's own `matmul` of as many rotations.
"""

from __future__ import annotations

import json
import os
import platform
from collections.abc import Callable, Iterator
from concurrent.futures import ThreadPoolExecutor
from itertools import pairwise
from pathlib import Path
from time import perf_counter, thread_time

import numpy as np

from chasles import kernels

EVIDENCE = Path(__file__).parent / "evidence" / "threads.json"
ITEMS = (10_000, 100_000, 1_000_000)
ROUNDS = 25
MOST = 8
Call = Callable[[slice], object]


def calls(items: int) -> dict[str, Call]:
    """What is timed, each on a slice of a batch of so many items."""
    random = np.random.default_rng(0)
    e, phi = np.tile([0.6, 0.0, 0.8], (items, 1)), random.uniform(-3, 3, items)
    a, b = random.standard_normal((2, items, 3))
    twist, rate = random.standard_normal((2, items, 6))
    inertia = np.diag([1.0, 2.0, 3.0])
    Q, other = np.empty((2, items, 3, 3))
    point, wrench = np.empty((items, 3)), np.empty((items, 6))
    kernels.rotation_from_axis_angle(e, phi, out=other)
    return {
        "rotation_from_axis_angle": lambda s: kernels.rotation_from_axis_angle(e[s], phi[s], out=Q[s]),
        "screw_axis_point": lambda s: kernels.screw_axis_point(e[s], phi[s], a[s], b[s], out=point[s]),
        "newton_euler_wrench": lambda s: kernels.newton_euler_wrench(inertia, 2.0, twist[s], rate[s], out=wrench[s]),
        "matmul of NumPy": lambda s: np.matmul(other[s], other[s], out=Q[s]),
    }


def rounds(call: Call, items: int, threads: int, pool: ThreadPoolExecutor) -> Iterator[tuple[float, float]]:
    """For each round the seconds by the clock, and the processor time of all pieces."""
    edges = [items * k // threads for k in range(threads + 1)]
    pieces = [slice(first, last) for first, last in pairwise(edges)]

    def timed(piece: slice) -> float:
        started = thread_time()
        call(piece)
        return thread_time() - started

    for _ in range(ROUNDS):
        started = perf_counter()
        processors = [timed(pieces[0])] if threads == 1 else list(pool.map(timed, pieces))
        yield perf_counter() - started, sum(processors)


def measured(most: int) -> dict[str, dict[str, dict[str, list[float]]]]:
    """Kernel -> items -> threads -> nanoseconds an item: by the clock, and of processor time."""
    found: dict[str, dict[str, dict[str, list[float]]]] = {}
    with ThreadPoolExecutor(most) as pool:
        for items in ITEMS:
            for name, call in calls(items).items():
                row = found.setdefault(name, {}).setdefault(str(items), {})
                for threads in range(1, most + 1):
                    times = zip(*rounds(call, items, threads, pool), strict=True)
                    row[str(threads)] = [round(min(each) / items * 1e9, 3) for each in times]
    return found


def lines(found: dict[str, dict[str, dict[str, list[float]]]]) -> Iterator[str]:
    """The table."""
    for name, rows in found.items():
        for items, row in rows.items():
            alone = row["1"]
            shown = f"{name:26} n = {int(items):>9,}  1 thread: {alone[0]:6.2f} ns"
            for threads in range(2, len(row) + 1):
                clock, processors = row[str(threads)]
                sooner = alone[0] / clock, threads * alone[1] / processors
                shown += f"   {threads}: {sooner[0]:.2f} x by the clock, {sooner[1]:.2f} x by the processors"
            yield shown


def main() -> None:
    """Measure, keep the evidence, print the table."""
    available = len(os.sched_getaffinity(0)) if hasattr(os, "sched_getaffinity") else os.cpu_count() or 1
    load = round(os.getloadavg()[0], 2) if hasattr(os, "getloadavg") else None
    found = measured(min(available, MOST))
    machine = {
        "processors": available,
        "load before": load,
        "instructions": kernels.instructions,
        "python": platform.python_version(),
        "numpy": np.__version__,
    }
    evidence = {"machine": machine, "ns an item, by the clock and of processor time": found}
    EVIDENCE.write_text(json.dumps(evidence, indent=1) + "\n", "utf-8")
    print(", ".join(f"{name}: {value}" for name, value in machine.items()))
    print("\n".join(lines(found)))


if __name__ == "__main__":
    main()
