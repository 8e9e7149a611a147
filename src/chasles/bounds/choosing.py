"""Which value does a choice between cases take, where rounding may have a say in what is compared?"""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from chasles.bounds.intervals import SAFE, Array, Interval
from chasles.bounds.model import Model
from chasles.bounds.outline import Outline
from chasles.bounds.places import Places, Scaled
from chasles.bounds.rounded_operations import RoundedOperations
from chasles.lowering.program import Op


@dataclass(frozen=True, slots=True, eq=False)
class ComparisonOutcome:
    """In which boxes a comparison may hold, and in which it may not; `exact` if rounding never changes which."""

    may: NDArray[np.bool_]
    may_not: NDArray[np.bool_]
    exact: bool

    def part(self, rows: NDArray[np.intp]) -> ComparisonOutcome:
        """What is known in these boxes alone."""
        return ComparisonOutcome(self.may[rows], self.may_not[rows], self.exact)


class Choices(RoundedOperations):
    """What compares and chooses: `values` are those of steps so far, `truths` what is known of comparisons."""

    def __init__(self, outline: Outline, model: Model, zero: Array, places: Mapping[int, Places]) -> None:
        super().__init__(outline, model, zero, places)
        self.values: dict[int, Scaled] = {}
        self.truths: dict[int, ComparisonOutcome] = {}

    def truth(self, op: Op, operands: tuple[int, ...]) -> ComparisonOutcome:
        """What is known of a comparison, of exact and of computed values."""
        a, b = (self.around[k].value for k in operands)
        exact = self.rounded.isdisjoint(operands) or self._has_right_sign(operands)
        if op is Op.LESS:
            return ComparisonOutcome(a.low < b.high, a.high >= b.low, exact)
        same = (a.low == a.high) & (b.low == b.high) & (a.low == b.low)
        return ComparisonOutcome((a.low <= b.high) & (b.low <= a.high), ~same, exact)

    def chosen(self, number: int, operands: tuple[int, ...]) -> Scaled:
        """The value of a choice: either one where both may be, and how far rounding may have taken it to the other."""
        found, values, near = self.truths[operands[0]], self.values, self.near
        both = found.may & found.may_not
        x, y = values[operands[1]], values[operands[2]]

        def either(a: Interval, b: Interval) -> Interval:
            whole = a.union(b)
            low = np.where(both, whole.low, np.where(found.may, a.low, b.low))
            return Interval(low, np.where(both, whole.high, np.where(found.may, a.high, b.high)))

        error = np.where(both, np.maximum(x.error, y.error), np.where(found.may, x.error, y.error))
        around = either(self.around[operands[1]].value, self.around[operands[2]].value)
        jump = self.zero
        if not found.exact and not self._is_continuous(operands):
            jump = np.where(both, (around - around).above, 0.0)
        if jump.any() or not self.rounded.isdisjoint(operands[1:]):
            self.rounded.add(number)
        if jump.any():
            self.losses[number] = jump
            self._sides[number] = np.zeros(len(jump), dtype=bool), np.zeros(len(jump), dtype=np.int64)
        value = Scaled(0, either(x.value, y.value), (error + jump) * SAFE)
        self.near[number] = Scaled(0, either(near[operands[1]].value, near[operands[2]].value), value.error)
        return value

    def _has_right_sign(self, operands: tuple[int, ...]) -> bool:
        """Whether zero is compared with a sum of two exact values, whose sign rounding leaves as it is."""
        steps = self.outline.program.steps
        zero = [steps[k].op is Op.CONSTANT and steps[k].value == 0 for k in operands]
        if not any(zero):
            return False
        other = operands[zero.index(True) - 1]
        while steps[other].op is Op.NEGATE:
            (other,) = self.outline.operands(other)
        exact = self.rounded.isdisjoint(self.outline.operands(other))
        return steps[other].op in (Op.ADD, Op.SUBTRACT) and exact

    def _is_continuous(self, operands: tuple[int, ...]) -> bool:
        """Whether what is chosen from is what is compared, or is opposite and compared with zero."""
        steps = self.outline.program.steps
        compared, options = self.outline.operands(operands[0]), operands[1:]
        if sorted(compared) == sorted(options):
            return True
        opposite = any(steps[k].op is Op.NEGATE and self.outline.operands(k)[0] in options for k in options)
        zero = any(steps[k].op is Op.CONSTANT and steps[k].value == 0 for k in compared)
        return opposite and zero and any(k in options for k in compared)
