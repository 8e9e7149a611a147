"""Which value does a choice between cases take, where rounding may have a say in what is compared?"""

from __future__ import annotations

from dataclasses import dataclass
from typing import TYPE_CHECKING

import numpy as np
from numpy.typing import NDArray

from chasles.bounds.intervals import SAFE, Array, Interval
from chasles.bounds.scaled import Scaled
from chasles.lowering.program import Op

if TYPE_CHECKING:
    from chasles.bounds.running import Running


@dataclass(frozen=True, slots=True, eq=False)
class ComparisonOutcome:
    """In which boxes a comparison may hold, and in which it may not; `exact` if rounding never changes which."""

    may: NDArray[np.bool_]
    may_not: NDArray[np.bool_]
    exact: bool

    def part(self, rows: NDArray[np.intp]) -> ComparisonOutcome:
        """What is known in these boxes alone."""
        return ComparisonOutcome(self.may[rows], self.may_not[rows], self.exact)


def truth(running: Running, op: Op, operands: tuple[int, ...]) -> ComparisonOutcome:
    """What is known of a comparison, of exact and of computed values."""
    a, b = (running.around[k].value for k in operands)
    exact = running.rounded.isdisjoint(operands) or _has_right_sign(running, operands)
    if op is Op.LESS:
        return ComparisonOutcome(a.low < b.high, a.high >= b.low, exact)
    same = (a.low == a.high) & (b.low == b.high) & (a.low == b.low)
    return ComparisonOutcome((a.low <= b.high) & (b.low <= a.high), ~same, exact)


def chosen(running: Running, operands: tuple[int, ...]) -> tuple[Scaled, Interval, Array]:
    """Either value where both may be, what is computed, and how far rounding may have taken it to the other one."""
    found, values, near = running.truths[operands[0]], running.values, running.near
    both = found.may & found.may_not
    x, y = values[operands[1]], values[operands[2]]

    def either(a: Interval, b: Interval) -> Interval:
        whole = a.union(b)
        low = np.where(both, whole.low, np.where(found.may, a.low, b.low))
        return Interval(low, np.where(both, whole.high, np.where(found.may, a.high, b.high)))

    error = np.where(both, np.maximum(x.error, y.error), np.where(found.may, x.error, y.error))
    around = either(running.around[operands[1]].value, running.around[operands[2]].value)
    jump = running.zero
    if not found.exact and not _is_continuous(running, operands):
        jump = np.where(both, (around - around).above, 0.0)
    value = Scaled(0, either(x.value, y.value), (error + jump) * SAFE)
    return value, either(near[operands[1]].value, near[operands[2]].value), jump


def _has_right_sign(running: Running, operands: tuple[int, ...]) -> bool:
    """Whether zero is compared with a sum of two exact values, whose sign rounding leaves as it is."""
    steps = running.outline.program.steps
    zero = [steps[k].op is Op.CONSTANT and steps[k].value == 0 for k in operands]
    if not any(zero):
        return False
    other = operands[zero.index(True) - 1]
    while steps[other].op is Op.NEGATE:
        (other,) = running.outline.operands(other)
    exact = running.rounded.isdisjoint(running.outline.operands(other))
    return steps[other].op in (Op.ADD, Op.SUBTRACT) and exact


def _is_continuous(running: Running, operands: tuple[int, ...]) -> bool:
    """Whether what is chosen from is what is compared, or is opposite and compared with zero."""
    steps = running.outline.program.steps
    compared, options = running.outline.operands(operands[0]), operands[1:]
    if sorted(compared) == sorted(options):
        return True
    opposite = any(steps[k].op is Op.NEGATE and running.outline.operands(k)[0] in options for k in options)
    zero = any(steps[k].op is Op.CONSTANT and steps[k].value == 0 for k in compared)
    return opposite and zero and any(k in options for k in compared)
