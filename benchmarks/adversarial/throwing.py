"""A kernel under adversarial inputs: every build's results decided, and counted by what was thrown."""

from __future__ import annotations

from collections import Counter
from collections.abc import Iterable, Sequence
from dataclasses import dataclass, field
from pathlib import Path
from typing import Any

import numpy as np
from benchmarks.adversarial.builds import Build, modules
from benchmarks.adversarial.exact import Undecided
from benchmarks.adversarial.inputs import KINDS, drawn
from benchmarks.adversarial.layouts import unlike
from benchmarks.adversarial.verdicts import Judge

from chasles import generated
from chasles.cli.emission import commissioned
from chasles.decisions.session import Session as Prover
from chasles.lowering.declaration import requested
from chasles.lowering.request import Request
from chasles.statements import load
from chasles.targets import TargetKernel
from chasles.vocabulary.nodes import measured

__all__ = ["Outcome", "Tried", "kernels_of", "thrown"]

SHOWN = 3
Groups = list[list[list[int]]]


@dataclass(frozen=True, slots=True)
class Tried:
    """A kernel as emitted, with its entries of one physical dimension, result by result."""

    kernel: TargetKernel
    groups: Groups


@dataclass(slots=True)
class Outcome:
    """What became of one kernel in one precision: inputs decided, set aside, and what was wrong, by what it was."""

    kernel: str
    dtype: str
    inputs: int = 0
    results: int = 0
    not_a_rotation: int = 0
    undecided: int = 0
    faults: Counter[str] = field(default_factory=Counter)
    storage: list[str] = field(default_factory=list)
    shown: list[dict[str, Any]] = field(default_factory=list)


def kernels_of(names: Iterable[str] = ()) -> list[Tried]:
    """The kernels of these names, or all, lowered from the book; bounds that the manifest has are taken over."""
    wanted, prover, folder = set(names), Prover(), Path(generated.__file__).parent
    found = []
    for entry in load():
        for kernel in entry.kernels:
            request = requested(entry, prover.decide, kernel)
            if not wanted or request.name in wanted:
                found.append((entry, request))
    entries = {id(entry): entry for entry, _ in found}
    made = {kernel.name: kernel for kernel in commissioned(entries.values(), prover, folder).kernels}
    return [Tried(made[request.name], _groups(request)) for _, request in found]


def _groups(request: Request) -> Groups:
    found: Groups = []
    for output in request.outputs:
        alike: dict[str, list[int]] = {}
        grid = measured(output.value).grid
        for place, (_, row, column) in enumerate(output.places):
            alike.setdefault(repr(grid[row][column]), []).append(place)
        found.append(list(alike.values()))
    return found


def thrown(tried: Tried, builds: dict[str, Build], dtype: type[np.floating[Any]], count: int) -> Outcome:
    """So many inputs, thrown at every build."""
    program = tried.kernel.program
    outcome = Outcome(program.name, np.dtype(dtype).name)
    inputs = drawn(program.name, program.arguments, dtype, count)
    outcome.storage += unlike(program, modules(builds), inputs)
    results = {name: [_flat(x) for x in build(program, inputs)] for name, build in builds.items()}
    judge = Judge(tried.kernel, tried.groups, dtype)
    for i, given in enumerate(zip(*map(_flat, inputs), strict=True)):
        _decide(judge, given, {name: [x[i] for x in found] for name, found in results.items()}, i, outcome)
    return outcome


def _decide(
    judge: Judge, given: Sequence[list[float]], results: dict[str, list[list[float]]], i: int, outcome: Outcome
) -> None:
    """One input; results of the same bits are decided once."""
    outcome.inputs += 1
    try:
        judged = judge.judged(given)
        if judged is None:
            outcome.not_a_rotation += 1
            return
        known: dict[str, list[Any]] = {}
        for build, found in results.items():
            outcome.results += 1
            key = repr(found)
            if key not in known:
                known[key] = list(judge.faults(judged, found))
            for what in sorted({fault.what for fault in known[key]}):
                outcome.faults[what] += 1
                if len(outcome.shown) < SHOWN:
                    fault = next(fault for fault in known[key] if fault.what == what)
                    kind = list(KINDS)[i % len(KINDS)]
                    outcome.shown.append({"kind": kind, "build": build, "at": given, "found": found, "fault": fault})
    except Undecided:
        outcome.undecided += 1


def _flat(array: np.ndarray[Any, Any]) -> list[list[float]]:
    return [[float(x) for x in row] for row in array.reshape(len(array), -1).tolist()]
