"""What does rounding do to one operation, and to a choice between cases, where it may have a say in what is compared?

Intervals hold the exact values, bounds say how far computed ones are off.
"""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from chasles.bounds.functions import slope
from chasles.bounds.intervals import SAFE, Array, Interval, function_of
from chasles.bounds.model import Model
from chasles.bounds.outline import NoBound, Outline
from chasles.bounds.places import Places, Scaled, excess, half_unit, restricted, rounded
from chasles.lowering.program import Op, is_power_of_two

FUNCTIONS = (Op.SINE, Op.COSINE, Op.ARCTANGENT2, Op.FUNCTION)


class RoundedOperations:
    """The operations of steps whose operands are known; all terms are kept, those of second order too.

    `around` encloses all that is as near to an exact value as a computed one, `near` the computed values alone;
    `losses` has the error that a step adds of itself, if it rounds; `empty` says which boxes the `places` leave
    nothing of.
    """

    def __init__(self, outline: Outline, model: Model, zero: Array, places: Mapping[int, Places]) -> None:
        self.outline, self._model, self.zero, self._places = outline, model, zero, places
        self.around: dict[int, Scaled] = {}
        self.near: dict[int, Scaled] = {}
        self.losses: dict[int, Array] = {}
        self.rounded: set[int] = set()
        self.empty = np.zeros(len(zero), dtype=bool)
        self._unrounded: dict[int, Interval] = {}
        self._sides: dict[int, tuple[NDArray[np.bool_], NDArray[np.int64]]] = {}

    def lowered(self, x: Interval, power: int, to: int) -> Interval:
        """A multiple of one power of 2^-j as a multiple of a lower one."""
        return x if power == to else x.union(Interval(self.zero, self.zero))

    def _graded(
        self, number: int, power: int, value: Interval, error: Array, op: Op, raw: Interval | None = None
    ) -> Scaled:
        """The value with the operation's own rounding; `raw` encloses what is rounded."""
        self.rounded.add(number)
        own, function = self.zero, self.outline.program.steps[number].function
        if op in FUNCTIONS:
            # What is rounded is not the function's value, but something near it, in units of that value's last place.
            own = excess(value, float(self._model.excess(op, function)), op)
            error = (error + own) * SAFE
        around = value.widened(error)
        raw = around if raw is None else raw.common(around)
        places = self._places.get(number)
        if places is not None:
            value, raw, empty = restricted(value, error, raw, places)
            self.empty |= empty
        step, self._sides[number] = half_unit(raw, float(self._model.rounding(op, function)), op)
        step = np.maximum(step, np.where(raw.above == 0, 0, float(self._model.least)))
        self.losses[number] = (own + step) * SAFE
        self.near[number] = Scaled(power, rounded(raw, step, float(self._model.rounding(op, function)), places), step)
        return Scaled(power, value, (error + step) * SAFE)

    def _sum(self, number: int, x: Scaled, y: Scaled, op: Op) -> Scaled:
        power = min(x.power, y.power)
        a, b = self.lowered(x.value, x.power, power), self.lowered(y.value, y.power, power)
        # A contracted product is not rounded before it is added.
        c, d = (
            self.lowered(self._unrounded.get(k, self.near[k].value), self.near[k].power, power)
            for k in self.outline.operands(number)
        )
        value, raw = (a + b, c + d) if op is Op.ADD else (a - b, c - d)
        return self._graded(number, power, value, (x.error + y.error) * SAFE, op, raw)

    def _near(self, number: int) -> list[Scaled]:
        """What encloses the computed operands of a step."""
        return [self.near[k] for k in self.outline.operands(number)]

    def _product(self, number: int, x: Scaled, y: Scaled, operands: tuple[int, ...]) -> Scaled:
        power = x.power + y.power
        value = x.value.squared if operands[0] == operands[1] else x.value * y.value
        error = (x.value.above * y.error + y.value.above * x.error + x.error * y.error) * SAFE
        if any(self._only_scales(k) for k in operands):
            return Scaled(power, value, error)
        a, b = self._near(number)
        raw = a.value.squared if operands[0] == operands[1] else a.value * b.value
        found = self._graded(number, power, value, error, Op.MULTIPLY, raw)
        self._unrounded[number] = raw.union(self.near[number].value)
        return found

    def _only_scales(self, number: int) -> bool:
        step = self.outline.program.steps[number]
        return step.op is Op.CONSTANT and is_power_of_two(abs(step.value))

    def _quotient(self, number: int, x: Scaled, y: Scaled) -> Scaled:
        least = y.value.below * (2 - SAFE) - y.error * SAFE
        value = x.value / y.value
        error = np.where(least > 0, (x.error + value.above * y.error) / least * SAFE, np.nan)
        a, b = self._near(number)
        return self._graded(number, x.power - y.power, value, error, Op.DIVIDE, a.value / b.value)

    def _root(self, number: int, x: Scaled) -> Scaled:
        if x.power:
            raise NoBound("it takes the root of what vanishes at a singular angle")
        root = x.value.root
        least = x.value.low * (2 - SAFE) - x.error * SAFE
        carried = x.error / (root.low + np.sqrt(np.maximum(least, 0))) * SAFE
        error = np.where(x.error == 0, 0, np.where(least > 0, carried, np.nan))
        return self._graded(number, 0, root, error, Op.SQUARE_ROOT, self._near(number)[0].value.root)

    def _turn(self, number: int, x: Scaled, op: Op) -> Scaled:
        return self._graded(number, 0, function_of(op.value, x.value), x.error, op)

    def _direction(self, number: int, y: Scaled, x: Scaled, operands: tuple[int, ...]) -> Scaled:
        """The angle moves by no more than the point does, over the smallest distance from the origin."""
        near = [self.around[k].value for k in operands]
        least = (near[0].squared + near[1].squared).low
        moved = (y.error * near[1].above + x.error * near[0].above) / least * SAFE
        error = np.where((y.error == 0) & (x.error == 0), 0, moved)
        seen = function_of(Op.ARCTANGENT2.value, *near)
        value = function_of(Op.ARCTANGENT2.value, y.value, x.value)
        return self._graded(number, 0, value, error + 0 * seen.low, Op.ARCTANGENT2)

    def _of_libm(self, number: int, name: str, of: list[Scaled], operands: tuple[int, ...]) -> Scaled:
        """The value moves by no more than the steepest slope times what the operands move (mean value theorem)."""
        near = [self.around[k].value for k in operands]
        error = self.zero
        for k, x in enumerate(of):
            steepest = function_of(slope(name, k), *near).above if x.error.any() else self.zero
            error = (error + steepest * x.error) * SAFE
        seen = function_of(name, *near)
        value = function_of(name, *(x.value for x in of))
        return self._graded(number, 0, value, error + 0 * seen.low, Op.FUNCTION)


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
