"""A million adversarial inputs: `python -m benchmarks.adversarial [--inputs N] [--processes N] [NAME ...]`.

Run from the root of a checkout with compiled kernels. Inputs are spread evenly over the kernels and both precisions;
figures go to `benchmarks/evidence/adversarial.json`, unless `--dry` is given or kernels are named. The exit status is 1
where a number or an infinity is wrong, or storage matters; NaN where there is a value is counted beside.
"""

from __future__ import annotations

import argparse
import json
import sys
import tempfile
from collections import Counter
from collections.abc import Sequence
from concurrent.futures import ProcessPoolExecutor
from functools import partial
from pathlib import Path
from typing import Any

import numpy as np
from benchmarks.adversarial.builds import builds
from benchmarks.adversarial.inputs import KINDS
from benchmarks.adversarial.throwing import Outcome, Tried, kernels_of, thrown
from benchmarks.kernels import machine

EVIDENCE = Path(__file__).resolve().parents[1] / "evidence" / "adversarial.json"
PRECISIONS = (np.float64, np.float32)


def main(words: Sequence[str] | None = None) -> int:
    """Throw, say what was wrong, write what was found."""
    parser = argparse.ArgumentParser(
        prog="python -m benchmarks.adversarial", description=(__doc__ or "").split("\n")[0]
    )
    parser.add_argument("names", nargs="*", metavar="NAME", help="kernels; all where none is named")
    parser.add_argument("--inputs", type=int, default=1_000_000, help="how many in all")
    parser.add_argument("--processes", type=int, default=1)
    parser.add_argument("--dry", action="store_true", help="write nothing")
    asked = parser.parse_args(words)
    tried = kernels_of(asked.names)
    each = -(-asked.inputs // (len(tried) * len(PRECISIONS)))
    with tempfile.TemporaryDirectory() as folder, ProcessPoolExecutor(asked.processes) as pool:
        names = list(builds(Path(folder)))
        outcomes = []
        for pair in pool.map(partial(_both, folder=folder, count=each), tried):
            outcomes += pair
            _say(pair)
    found = summary(outcomes, names)
    print(json.dumps({key: value for key, value in found.items() if key not in ("machine", "kinds")}, indent=1))
    if not asked.dry and not asked.names:
        EVIDENCE.write_text(json.dumps(found, indent=1) + "\n", "utf-8")
    return int(bool(found["wrong"] or found["storage"]))


def _both(tried: Tried, folder: str, count: int) -> list[Outcome]:
    made = builds(Path(folder))
    return [thrown(tried, made, dtype, count) for dtype in PRECISIONS]


def _say(outcomes: Sequence[Outcome]) -> None:
    for outcome in outcomes:
        if outcome.faults or outcome.storage or outcome.undecided:
            print(outcome.kernel, outcome.dtype, dict(outcome.faults), outcome.storage, outcome.undecided, flush=True)
        for shown in outcome.shown:
            print(*(f"    {key}: {value}" for key, value in shown.items()), sep="\n", flush=True)


def summary(outcomes: Sequence[Outcome], names: Sequence[str]) -> dict[str, Any]:
    """The figures of all kernels together."""
    wrong: Counter[str] = sum((outcome.faults for outcome in outcomes), Counter())
    lost = wrong.pop("nothing", 0)
    return {
        "machine": machine(),
        "kinds": list(KINDS),
        "builds": list(names),
        "kernels": len({outcome.kernel for outcome in outcomes}),
        "inputs": sum(outcome.inputs for outcome in outcomes),
        "results": sum(outcome.results for outcome in outcomes),
        "not a rotation": sum(outcome.not_a_rotation for outcome in outcomes),
        "undecided": sum(outcome.undecided for outcome in outcomes),
        "wrong": dict(sorted(wrong.items())),
        "NaN though there is a value": lost,
        "of these": {f"{o.kernel} {o.dtype}": o.faults["nothing"] for o in outcomes if o.faults["nothing"]},
        "storage": [f"{outcome.kernel} {outcome.dtype}: {what}" for outcome in outcomes for what in outcome.storage],
    }


if __name__ == "__main__":
    sys.exit(main())
