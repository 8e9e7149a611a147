"""Is a result right? Decided for each entry of a result at one input, against the program's exact value there.

A number is right if it differs from the exact value by no more than the proved bound allows: so many roundoffs of the
largest sum of terms' sizes among the entries of one physical dimension. Below the smallest normal number floats have no
digits: what moving every entry of the input, and the result, by a few of the smallest numbers changes is allowed too,
and for a result that lies there what moving the steps that do changes. Where a choice between cases rests on rounded
values, what the input lacks of being a rotation counts as well; and where the C library's own sine or cosine of the
input is off by more than the model of the bounds has it, that does. What is no rotation there by far is set aside.

NaN and infinities are right where a step of the formula is out of range, or has no value; where a step has no value,
and where a NaN enters, nothing but NaN is right. Where an infinity goes in, a number is right if it is the limit, the
exact value for any number as large in its place.
"""

from __future__ import annotations

import math
from collections.abc import Iterator, Sequence
from dataclasses import dataclass
from typing import Any

import numpy as np
from benchmarks.adversarial.exact import Exact, Undecided, Value, roundings
from chasles.generated.numpy.hypotheses import KERNELS
from flint import arb

from chasles.bounds.outline import NoBound, outlined
from chasles.lowering.program import Op, Program
from chasles.targets import TargetKernel

__all__ = ["Fault", "Judge", "Judged"]

STEPS = 4
"""By how many of the smallest numbers inputs may be moved."""
DEFECT = 1e-3
"""What is no rotation to this much is the caller's affair where a choice of cases rests on its being one."""
POWERS = ((6000, 9000, 7000, 8000), (8500, 6500, 9500, 7500))
"""Powers of two that stand for infinities, one after the other."""
FAR = arb(2) ** 3000
"""Larger than the size of any term into which no infinity went."""


@dataclass(frozen=True, slots=True)
class Fault:
    """What is wrong with an entry: a "number", an "infinity", or "nothing" where there is a value."""

    what: str
    result: int
    entry: int
    found: float
    exact: float


@dataclass(frozen=True, slots=True)
class Judged:
    """An input, flat and argument by argument, with the exact values: one set, or two where infinities go in."""

    inputs: list[list[Any]]
    values: list[list[list[Value]]]
    limits: bool


class Judge:
    """Decides on the results of one kernel in one precision; `groups` are its entries of one physical dimension."""

    def __init__(
        self, kernel: TargetKernel, groups: Sequence[Sequence[Sequence[int]]], dtype: type[np.floating[Any]]
    ) -> None:
        program, bound = kernel.program, kernel.bound
        assert bound is not None
        self.exact, self.groups = Exact(program), groups
        limits = np.finfo(dtype)
        self.unit, self.least, self.most = float(limits.eps) / 2, float(limits.smallest_subnormal), float(limits.max)
        self.normal = float(limits.smallest_normal)
        counted = roundings(program)
        proved = {guarantee.result: float(guarantee.units) for guarantee in bound.guarantees}
        self.units = [proved.get(r.name, max(counted[k] for k in r.entries)) for r in program.results]
        self.rotations = _rotations(kernel) if _chooses(program) else []
        self.turning = {
            (program.steps[k].argument, program.steps[k].entry)
            for step in program.steps
            if step.op in (Op.SINE, Op.COSINE)
            for k in (step.operands[0], *program.steps[step.operands[0]].operands)
            if program.steps[k].op is Op.INPUT
        }

    def judged(self, inputs: Sequence[Sequence[float]]) -> Judged | None:
        """The exact values at an input; None where the kernel promises nothing. Raises Undecided."""
        if any(self._defect(inputs[k]) > DEFECT for k in self.rotations):
            return None
        if not any(math.isinf(x) for values in inputs for x in values):
            given = [[None if math.isnan(x) else x for x in values] for values in inputs]
            return Judged(given, [self.exact(given)], False)
        sets = [self._large(inputs, powers) for powers in POWERS]
        return Judged(sets[0], [self.exact(given) for given in sets], True)

    @staticmethod
    def _large(inputs: Sequence[Sequence[float]], powers: Sequence[int]) -> list[list[Any]]:
        """The input with large numbers in the place of infinities, and None in that of NaN."""
        given: list[list[Any]] = []
        count = 0
        for values in inputs:
            given.append([])
            for x in values:
                if math.isinf(x):
                    given[-1].append(arb(2) ** powers[count % len(powers)] * math.copysign(1, x))
                    count += 1
                else:
                    given[-1].append(None if math.isnan(x) else x)
        return given

    @staticmethod
    def _defect(entries: Sequence[float]) -> float:
        """What nine numbers lack of being a rotation."""
        q = np.array(entries, np.longdouble).reshape(3, 3)
        if not np.all(np.isfinite(q)):
            return 0.0
        if np.max(np.abs(q)) > 2:
            return math.inf
        return float(max(np.max(np.abs(q.T @ q - np.eye(3))), abs(np.dot(np.cross(q[0], q[1]), q[2]) - 1)))

    def faults(self, judged: Judged, found: Sequence[Sequence[float]]) -> Iterator[Fault]:
        """What is wrong with the results, flat, one after the other."""
        for values in judged.values:
            faults = [
                fault
                for r, groups in enumerate(self.groups)
                for group in groups
                for fault in self._of_group(judged, values, r, group, found[r])
            ]
            if faults:
                yield from faults
                return

    def _of_group(
        self, judged: Judged, values: list[list[Value]], r: int, group: Sequence[int], found: Sequence[float]
    ) -> Iterator[Fault]:
        # Into what is larger an infinity went: it is compared with its limit for what that is.
        sizes = [_upper(value[1]) for k in group if (value := values[r][k]) is not None and value[1] < FAR]
        allowed = self.units[r] * self.unit * max(sizes, default=0.0) + STEPS * self.least
        for k in group:
            value, y = values[r][k], found[k]
            if value is None:
                if not math.isnan(y):
                    yield Fault(_named(y), r, k, y, math.nan)
                continue
            gap = abs(value[0] - arb(y)) if math.isfinite(y) else arb("inf")
            if _upper(gap) <= allowed:
                continue
            if math.isfinite(y):
                allowed_too = self._leeway(judged, values, r, group, max(sizes, default=0.0))
                if abs(value[0]) < self.normal:
                    allowed_too += self._vanishing(judged, r, k)
                wrong = _upper(gap) > allowed + allowed_too
            elif judged.limits:
                wrong = (
                    math.isinf(y) and not value[0] * math.copysign(1, y) > self.most and not self._leaves_range(judged)
                )
            else:
                wrong = not self._leaves_range(judged)
            if wrong:
                yield Fault(_named(y), r, k, y, float(value[0]))

    def _leaves_range(self, judged: Judged) -> bool:
        """Whether a step of the formula is out of range, or has no value."""
        return any(
            value is None or (isinstance(value, tuple) and FAR > value[1] * (1 + 1e-6) > self.most)
            for value in self.exact.steps(judged.inputs)
        )

    def _leeway(self, judged: Judged, values: list[list[Value]], r: int, group: Sequence[int], size: float) -> float:
        """What is allowed beside the bound for rounding."""
        lost = sum(self._defect(judged.inputs[k]) for k in self.rotations if not judged.limits)
        excess = max((self._excess(judged.inputs[i][j]) for i, j in self.turning), default=0.0)
        return (4 * lost + 2 * excess) * size + self._moved(judged, values, r, group)

    def _excess(self, angle: Any) -> float:
        """By how much more than one unit the C library's sine and cosine are off, relatively; 0 in single precision."""
        if not isinstance(angle, float) or self.unit > 1e-10:
            return 0.0
        errors = [0.0]
        for x in (angle, angle / 2):
            for computed, exact in ((math.sin(x), arb(x).sin()), (math.cos(x), arb(x).cos())):
                errors.append(_upper(abs((arb(computed) - exact) / exact)) if computed else 0.0)
        return max(0.0, max(errors) - 2 * self.unit)

    def _moved(self, judged: Judged, values: list[list[Value]], r: int, group: Sequence[int]) -> float:
        """How far entries move where every entry of the input moves by a few of the smallest numbers."""
        total = 0.0
        for i, entries in enumerate(judged.inputs):
            for j, x in enumerate(entries):
                if not isinstance(x, float):
                    continue
                most = 0.0
                for step in (STEPS * self.least, -STEPS * self.least):
                    moved = [list(given) for given in judged.inputs]
                    moved[i][j] = arb(x) + arb(step)
                    most = max(most, self._change(moved, values, r, group))
                total += most
        return total

    def _vanishing(self, judged: Judged, r: int, k: int) -> float:
        """How far an entry moves where each step that has no digits moves by one of the smallest numbers."""
        program, total = self.exact.program, 0.0
        entry = program.results[r].entries[k]
        steps = self.exact.steps(judged.inputs)
        for number, step in enumerate(program.steps):
            if (
                step.op in (Op.MULTIPLY, Op.DIVIDE)
                and steps[number] is not None
                and abs(steps[number][0]) < self.normal
            ):
                moved = self.exact.steps(judged.inputs, {number: arb(self.least)})[entry]
                total += _upper(abs(moved[0] - steps[entry][0])) if moved is not None else 0.0
        return total

    def _change(self, moved: list[list[Any]], values: list[list[Value]], r: int, group: Sequence[int]) -> float:
        try:
            beside = self.exact(moved)[r]
        except Undecided:
            return 0.0
        changes = [0.0]
        for k in group:
            before, after = values[r][k], beside[k]
            if before is not None:
                changes.append(_upper(abs(after[0] - before[0])) if after is not None else math.inf)
        return max(changes)


def _rotations(kernel: TargetKernel) -> list[int]:
    """The places of the arguments that are to be rotations."""
    _, demands = KERNELS[kernel.name]
    names = {name for kind, _, about, _ in demands if kind == "rotation" for name in about}
    return [place for place, argument in enumerate(kernel.program.arguments) if argument.name in names]


def _chooses(program: Program) -> bool:
    """Whether the program chooses between cases by values that are rounded."""
    try:
        outlined(program)
    except NoBound:
        return True
    return False


def _named(found: float) -> str:
    return "number" if math.isfinite(found) else "infinity" if math.isinf(found) else "nothing"


def _upper(ball: Any) -> float:
    return float(ball.upper()) if ball.is_finite() else math.inf
