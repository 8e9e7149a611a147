"""The largest errors found, kernel by kernel, beside what is proved, and how errors grow towards phi = 0 and pi.

Run it as `python -m benchmarks.errors [--inputs N] [NAME ...]` from the root of a checkout. It writes
`benchmarks/evidence/errors.json` and the table `benchmarks/ERRORS.md`, unless kernels are named.

Compared is with the exact value of the emitted program, in ball arithmetic with 57 digits and more; that program is
proved equal to the statement. Inputs are drawn at large and towards every singular set, at 1e-300, 1e-12, 1e-8, 1e-4
from it and at every power of ten between; what takes a step out of the normal range of the floats is left out, as it
is by the model of the bounds.
"""

from __future__ import annotations

import argparse
import json
import math
import sys
from collections.abc import Iterable, Mapping, Sequence
from dataclasses import replace as with_fields
from pathlib import Path
from typing import Any

import numpy as np
from benchmarks.adversarial.exact import Exact, Undecided, Value
from benchmarks.adversarial.inputs import towards
from benchmarks.adversarial.throwing import Tried, kernels_of
from benchmarks.curves import curves
from benchmarks.error_table import page
from benchmarks.kernels import machine
from flint import arb

from chasles import kernels as shipped
from chasles.bounds.cases import CaseOutline, cases
from chasles.lowering.program import Op, Step

HERE = Path(__file__).resolve().parent
EVIDENCE, PAGE = HERE / "evidence" / "errors.json", HERE / "ERRORS.md"
PRECISIONS = (np.float64, np.float32)
INPUTS = 400
FIGURES = 3

Entries = list[list[float]]
Errors = dict[tuple[str, str], float]
"""By result and measure."""


def main(words: Sequence[str] | None = None) -> int:
    """Measure, and write what was found."""
    parser = argparse.ArgumentParser(prog="python -m benchmarks.errors", description=(__doc__ or "").split("\n")[0])
    parser.add_argument("names", nargs="*", metavar="NAME", help="kernels; all where none is named")
    parser.add_argument("--inputs", type=int, default=INPUTS, help="of each kernel in each precision")
    asked = parser.parse_args(words)
    tried = kernels_of(asked.names)
    found = {one.kernel.name: measured(one, asked.inputs) for one in tried}
    if asked.names:
        print(json.dumps(found, indent=1))
        return 0
    evidence = {"machine": machine(), "inputs": asked.inputs, "kernels": found, "curves": curves(tried)}
    EVIDENCE.write_text(json.dumps(evidence, indent=1) + "\n", "utf-8")
    PAGE.write_text(page(evidence), "utf-8")
    return 0


def measured(tried: Tried, count: int) -> dict[str, Any]:
    """What is proved of each result; by precision its largest error in that measure and normwise, with the input."""
    assert tried.kernel.bound is not None
    known = {g.result: {"units": g.units, "against": g.against} for g in tried.kernel.bound.guarantees}
    proved = {result.name: known.get(result.name) for result in tried.kernel.program.results}
    return {"proved": proved} | {np.dtype(dtype).name: _in_precision(tried, dtype, count) for dtype in PRECISIONS}


def _in_precision(tried: Tried, dtype: type[np.floating[Any]], count: int) -> dict[str, Any]:
    program = tried.kernel.program
    inputs = towards(program.name, program.arguments, dtype, count)
    with np.errstate(all="ignore"):
        got = getattr(shipped, program.name)(*inputs)
    outs = [np.asarray(x).reshape(count, -1) for x in (got if isinstance(got, tuple) else (got,))]
    limits, exact = np.finfo(dtype), Exact(program, least=2.0**-110)
    different = _cases(tried)
    worst: dict[str, dict[str, Any]] = {}
    for i in range(count):
        at = [np.ravel(x[i]).astype(float).tolist() for x in inputs]
        values = _values(exact, at, limits)
        if values is None:
            continue
        computed = [out[i].astype(float).tolist() for out in outs]
        found = _errors(tried, values, computed)
        if different:
            found = {key: error for key, error in found.items() if key[1] != "proved"}
            found |= _beside_nearest(tried, different, at, computed, limits)
        for (result, measure), error in found.items():
            held, units = worst.setdefault(result, {}).get(measure), error * 2 / float(limits.eps)
            if held is None or units > held["units"]:
                worst[result][measure] = {"units": units, "at": dict(zip(_names(tried), at, strict=True))}
    for held in worst.values():
        for finding in held.values():
            finding["units"] = float(f"{finding['units']:.{FIGURES}g}")
    return worst


def _names(tried: Tried) -> list[str]:
    return [argument.name for argument in tried.kernel.program.arguments]


def _values(exact: Exact, at: list[list[float]], limits: Any) -> list[list[Value]] | None:
    """The exact values; None where a result has none, or a step is out of the normal range."""
    try:
        steps = exact.steps(at)
    except Undecided:
        return None
    values = [[steps[k] for k in result.entries] for result in exact.program.results]
    if any(value is None for entries in values for value in entries):
        return None
    # Where cases are chosen between, steps of the others may be as small as they like.
    if any(k.op is Op.NOT_A_NUMBER for k in exact.program.steps) or _in_range(steps, limits):
        return values
    return None


def _in_range(steps: Iterable[Any], limits: Any) -> bool:
    """Whether all numbers are zero or normal."""
    least, most = float(limits.tiny), float(limits.max)
    numbers = [step for step in steps if isinstance(step, tuple)]
    return all(x == 0 or (abs(x) >= least and size <= most) for x, size in numbers)


def _cases(tried: Tried) -> list[tuple[Exact, CaseOutline]]:
    """The program with each outcome of what cases are chosen by; none where there is but one, or nothing is proved."""
    program, bound = tried.kernel.program, tried.kernel.bound
    if bound is None or not bound.guarantees:
        return []
    zero = next((k for k, step in enumerate(program.steps) if step == Step(Op.CONSTANT)), 0)
    found = []
    for case in cases(program):
        steps = tuple(_decided(k, step, case.truths[0], zero) for k, step in enumerate(program.steps))
        found.append((Exact(with_fields(program, steps=steps), least=2.0**-110), case))
    return found if len(found) > 1 else []


def _decided(number: int, step: Step, truths: Mapping[int, bool], zero: int) -> Step:
    """The comparison 0 = 0 or 0 < 0 in the place of one whose outcome is given."""
    if number not in truths:
        return step
    return with_fields(step, op=Op.EQUAL if truths[number] else Op.LESS, operands=(zero, zero))


def _beside_nearest(
    tried: Tried, different: list[tuple[Exact, CaseOutline]], at: Entries, got: Entries, limits: Any
) -> Errors:
    """The errors against what is proved, beside the case to which the results are nearest.

    Which case the machine takes is not seen from outside; near where two meet it need not be the exact one. None where
    a step of some case is out of the normal range.
    """
    found: list[Errors] = []
    for exact, case in different:
        try:
            steps = exact.steps(at)
        except Undecided:
            return {}
        values = [[steps[k] for k in result.entries] for result in exact.program.results]
        if not _in_range((steps[k] for k in case.outline.needed), limits):
            return {}
        if all(value is not None for entries in values for value in entries):
            errors = _errors(tried, values, got)
            found.append({key: error for key, error in errors.items() if key[1] == "proved"})
    return min(found, key=lambda each: max(each.values()), default={})


def _errors(tried: Tried, values: list[list[Any]], got: list[list[float]]) -> Errors:
    """The relative errors: against the measure of what is proved, and of a group's largest entry."""
    bound = tried.kernel.bound
    assert bound is not None
    found: Errors = {}

    def meet(result: str, measure: str, error: float) -> None:
        found[result, measure] = max(error, found.get((result, measure), 0.0))

    for r, result in enumerate(tried.kernel.program.results):
        against = next((g.against for g in bound.guarantees if g.result == result.name), "")
        for group in tried.groups[r]:
            exact, seen = values[r], got[r]
            gaps = {k: abs(exact[k][0] - arb(seen[k])) if math.isfinite(seen[k]) else arb("inf") for k in group}
            largest = max((abs(exact[k][0]) for k in group), key=float)
            normwise = _ratio(max(gaps.values(), key=float), largest)
            meet(result.name, "normwise", normwise)
            if against == "largest":
                meet(result.name, "proved", normwise)
            elif against:
                sizes = {k: abs(exact[k][0]) if against == "itself" else exact[k][1] for k in group}
                meet(result.name, "proved", max(_ratio(gaps[k], sizes[k]) for k in group))
    return found


def _ratio(gap: Any, size: Any) -> float:
    return 0.0 if gap == 0 else float(gap / size) if size > 0 else math.inf


if __name__ == "__main__":
    sys.exit(main())
