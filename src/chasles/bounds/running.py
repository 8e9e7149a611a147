"""How far may rounding take each step, over many boxes of inputs? Interval arithmetic along with the program.

Each step has an interval that holds its exact values, and a bound on how far the computed ones are from them. All terms
are kept, those of second order too.
"""

from __future__ import annotations

from collections.abc import Callable, Mapping
from dataclasses import dataclass
from fractions import Fraction
from typing import Any

import numpy as np
from numpy.typing import NDArray

from chasles.bounds.intervals import SAFE, Array, Interval, exactly, function_of
from chasles.bounds.model import Model
from chasles.bounds.outline import NoBound, Outline, is_power_of_two
from chasles.bounds.scaled import Scaled
from chasles.lowering.program import Op, Step

__all__ = ["Angles", "Places", "Running", "Truth"]

Places = tuple[NDArray[np.int64], NDArray[np.int64]]
"""The smallest and the largest exponent of two that a step's result may have before it is rounded."""

@dataclass(frozen=True, slots=True, eq=False)
class Truth:
    """In which boxes a comparison may hold, and in which it may not; `exact` if rounding never changes which."""

    may: NDArray[np.bool_]
    may_not: NDArray[np.bool_]
    exact: bool

    def part(self, rows: NDArray[np.bool_]) -> Truth:
        """The same in some of the boxes."""
        return Truth(self.may[rows], self.may_not[rows], self.exact)


Angles = Callable[[int, int, Fraction], tuple[Scaled, Scaled]]
"""Sine and cosine of a multiple of an argument's entry."""

TURNS = (Op.SINE, Op.COSINE)
COMPARISONS = (Op.LESS, Op.EQUAL)
FUNCTIONS = (*TURNS, Op.ARCTANGENT2)


class Running:
    """The program's steps over as many boxes as each interval of `inputs` has ends.

    `inputs` gives values to entries of arguments, `angles` sines and cosines to the outline's angles; `values` has each step's exact values and errors, `near` encloses its
    computed values, and `losses` has the error that a step adds of itself; what rounds nothing has none. `bad` says in
    which boxes a step has no value that is known, and `why` is the first such step.
    """

    def __init__(
        self,
        outline: Outline,
        model: Model,
        inputs: Mapping[tuple[int, int], Scaled],
        angles: Angles,
        count: int,
        places: Mapping[int, Places] | None = None,
        known: Mapping[int, Interval] | None = None,
    ) -> None:
        self.outline, self._model, self._inputs, self._angles = outline, model, inputs, angles
        self._places, self._known = places or {}, known or {}
        self.zero = np.zeros(count)
        self._unit = float(model.roundoff)
        self.values: dict[int, Scaled] = {}
        self.near: dict[int, Scaled] = {}
        self.losses: dict[int, Array] = {}
        self.rounded: set[int] = set()
        self.truths: dict[int, Truth] = {}
        self.bad = np.zeros(count, dtype=bool)
        self.why = np.full(count, -1)
        self.empty = np.zeros(count, dtype=bool)
        self.split = np.full(count, -1), np.zeros(count, dtype=np.int64)
        self._weight = np.zeros(count)
        self._sides: dict[int, tuple[NDArray[np.bool_], NDArray[np.int64]]] = {}
        with np.errstate(all="ignore"):
            for number in outline.needed:
                self._run(number, outline.program.steps[number])

    def _run(self, number: int, step: Step) -> None:
        if step.op in COMPARISONS:
            self.truths[number] = self._truth(step.op, self.outline.operands(number))
            return
        found = self._step(number, step)
        if number in self._known:
            found = Scaled(found.power, found.value.common(self._known[number]), found.error)
        self.values[number] = found
        if number in self._known and number in self.near:
            near = self.near[number].value.common(found.value.widened(found.error))
            self.near[number] = Scaled(found.power, near, found.error)
        if number not in self.near:
            near = found.value.widened(found.error) if number in self.rounded else found.value
            self.near[number] = Scaled(found.power, near, found.error)
        near = self.near[number].value
        lost = ~(np.isfinite(near.low) & np.isfinite(near.high)) & ~self.bad
        self.why[lost] = number
        self.bad |= lost

    def part(self, rows: NDArray[np.bool_]) -> Running:
        """The same in some of the boxes."""
        found: Running = object.__new__(Running)
        found.outline, found.rounded, found._model = self.outline, self.rounded, self._model
        found.zero, found._weight = self.zero[rows], self._weight[rows]
        found.split = self.split[0][rows], self.split[1][rows]
        found.values = {k: x.part(rows) for k, x in self.values.items()}
        found.near = {k: x.part(rows) for k, x in self.near.items()}
        found.losses = {k: x[rows] for k, x in self.losses.items()}
        found.truths = {k: x.part(rows) for k, x in self.truths.items()}
        found._sides = {k: (x[rows], y[rows]) for k, (x, y) in self._sides.items()}
        return found

    def lowered(self, x: Interval, power: int, to: int) -> Interval:
        """A multiple of one power of 2^-j as a multiple of a lower one."""
        return x if power == to else x.union(Interval(self.zero, self.zero))

    def _step(self, number: int, step: Step) -> Scaled:
        if number in self.outline.angles:
            value = self._angles(*self.outline.angles[number])[0 if step.op is Op.SINE else 1]
            return self._graded(number, value.power, value.value, self.zero, step.op)
        operands = self.outline.operands(number)
        if step.op is Op.SELECT:
            return self._chosen(number, operands)
        of = [self.values[k] for k in operands]
        if not self.rounded.isdisjoint(operands):
            self.rounded.add(number)
        match step.op:
            case Op.INPUT:
                found = self._inputs[step.argument, step.entry]
                if found.error.any():
                    self.rounded.add(number)
                return found
            case Op.CONSTANT:
                value = exactly(step.value, self.zero)
                if self._model.is_exact(step.value):
                    return Scaled(0, value, self.zero)
                return self._graded(number, 0, value, self.zero, step.op)
            case Op.NEGATE:
                return Scaled(of[0].power, -of[0].value, of[0].error)
            case Op.ADD | Op.SUBTRACT:
                return self._sum(number, of[0], of[1], step.op)
            case Op.MULTIPLY:
                return self._product(number, of[0], of[1], operands)
            case Op.DIVIDE:
                return self._quotient(number, of[0], of[1])
            case Op.SQUARE_ROOT:
                return self._root(number, of[0])
            case Op.SINE | Op.COSINE:
                return self._turn(number, of[0], step.op)
            case Op.ARCTANGENT2:
                return self._direction(number, of[0], of[1], operands)
            case op:
                raise NoBound(f"no bound over a box is known of the operation {op}")

    def _graded(
        self, number: int, power: int, value: Interval, error: Array, op: Op, raw: Interval | None = None
    ) -> Scaled:
        """The value with the operation's own rounding; `raw` encloses what is rounded.

        Half a unit in the last place is the roundoff times the largest power of two that is not above the size of what
        is rounded; and a power of two is not rounded, so that what is hardly above one is hardly rounded either. Sine
        and cosine are at most 1.
        """
        self.rounded.add(number)
        own, loss = self.zero, self._unit
        if op in FUNCTIONS:
            # What is rounded is not the function's value, but something near it, in units of that value's last place.
            loss = float(self._model.rounding(op))
            place = np.frexp(value.above)[1] - 1
            own = np.ldexp(float(self._model.excess(op)), np.minimum(place, -1) if op in TURNS else place)
            own = np.where(value.above == 0, 0, own)
            error = (error + own) * SAFE
        around = value.widened(error)
        raw = around if raw is None else raw.common(around)
        if number in self._places:
            value, raw = self._restricted(value, error, raw, self._places[number])
        most = np.frexp(raw.above)[1] - 1
        least = np.frexp(raw.below)[1] - 1
        if op in TURNS:
            most = np.minimum(most, -1)
        self._sides[number] = most == least + 1, most
        power_of_two = np.ldexp(1.0, most)
        half = np.minimum(loss * power_of_two, np.maximum(raw.above - power_of_two, loss / 2 * power_of_two))
        half = np.where(least == most, np.minimum(loss * power_of_two, raw.above - power_of_two), half)
        half = np.where(raw.above < power_of_two, loss * power_of_two, half)
        step = np.where(raw.above == 0, 0, np.maximum(half * SAFE, float(self._model.least)))
        self.losses[number] = (own + step) * SAFE
        near = raw.widened(step)
        if loss == self._unit or op in TURNS:
            near = near.common(_snapped(near, raw, self._unit))
        if number in self._places:
            near = near.common(_powers(raw, self._places[number]))
        self.near[number] = Scaled(power, near, step)
        return Scaled(power, value, (error + step) * SAFE)

    def _restricted(self, value: Interval, error: Array, raw: Interval, places: Places) -> tuple[Interval, Interval]:
        """What of the exact values may come out between the powers of two, and what of those that are rounded."""
        least, most = np.ldexp(1.0, places[0]), np.ldexp(1.0, places[1] + 1)
        outer = Interval(np.maximum(least - error * SAFE, 0), (most + error) * SAFE)
        parts = [x.sized(size) for x, size in ((value, outer), (raw, Interval(least, most)))]
        for x in parts:
            self.empty |= x.low > x.high
        first, second = (Interval(np.minimum(x.low, x.high), np.maximum(x.low, x.high)) for x in parts)
        return first, second

    def weigh(self, number: int, moved: Array) -> None:
        """Choose the step to part boxes by: that whose error moves some entry most."""
        where, power = self._sides[number]
        more = where & (moved > self._weight)
        self._weight[more], self.split[0][more], self.split[1][more] = moved[more], number, power[more]

    def _sum(self, number: int, x: Scaled, y: Scaled, op: Op) -> Scaled:
        power = min(x.power, y.power)
        a, b = self.lowered(x.value, x.power, power), self.lowered(y.value, y.power, power)
        c, d = (self.lowered(near.value, near.power, power) for near in self._near(number))
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
        return self._graded(number, power, value, error, Op.MULTIPLY, raw)

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
        near = [self.near[k].value for k in operands]
        least = (near[0].squared + near[1].squared).low
        moved = (y.error * near[1].above + x.error * near[0].above) / least * SAFE
        error = np.where((y.error == 0) & (x.error == 0), 0, moved)
        seen = function_of(Op.ARCTANGENT2.value, *near)
        value = function_of(Op.ARCTANGENT2.value, y.value, x.value)
        return self._graded(number, 0, value, error + 0 * seen.low, Op.ARCTANGENT2)

    def _truth(self, op: Op, operands: tuple[int, ...]) -> Truth:
        a, b = (self.near[k].value for k in operands)
        exact = self.rounded.isdisjoint(operands) or self._has_right_sign(operands)
        if op is Op.LESS:
            return Truth(a.low < b.high, a.high >= b.low, exact)
        same = (a.low == a.high) & (b.low == b.high) & (a.low == b.low)
        return Truth((a.low <= b.high) & (b.low <= a.high), ~same, exact)

    def _has_right_sign(self, operands: tuple[int, ...]) -> bool:
        """Whether zero is compared with a sum of two exact values, whose sign rounding leaves as it is."""
        steps = self.outline.program.steps
        zero = [steps[k].op is Op.CONSTANT and steps[k].value == 0 for k in operands]
        if not any(zero):
            return False
        other = operands[zero.index(True) - 1]
        while steps[other].op is Op.NEGATE:
            (other,) = self.outline.operands(other)
        return steps[other].op in (Op.ADD, Op.SUBTRACT) and self.rounded.isdisjoint(self.outline.operands(other))

    def _chosen(self, number: int, operands: tuple[int, ...]) -> Scaled:
        """Either value where both may be; and how far they are apart where rounding may have chosen the other one."""
        truth, x, y = self.truths[operands[0]], self.values[operands[1]], self.values[operands[2]]
        both = truth.may & truth.may_not

        def either(a: Interval, b: Interval) -> Interval:
            whole = a.union(b)
            low = np.where(both, whole.low, np.where(truth.may, a.low, b.low))
            return Interval(low, np.where(both, whole.high, np.where(truth.may, a.high, b.high)))

        near = either(self.near[operands[1]].value, self.near[operands[2]].value)
        error = np.where(both, np.maximum(x.error, y.error), np.where(truth.may, x.error, y.error))
        jump = self.zero
        if not truth.exact and not self._is_continuous(operands):
            jump = np.where(both, (near - near).above, 0.0)
        if jump.any() or not self.rounded.isdisjoint(operands[1:]):
            self.rounded.add(number)
        if jump.any():
            self.losses[number] = jump
            self._sides[number] = np.zeros(len(jump), dtype=bool), np.zeros(len(jump), dtype=np.int64)
        self.near[number] = Scaled(0, near, error)
        return Scaled(0, either(x.value, y.value), (error + jump) * SAFE)

    def _is_continuous(self, operands: tuple[int, ...]) -> bool:
        """Whether what is chosen from is what is compared, or is opposite and compared with zero."""
        steps = self.outline.program.steps
        compared, chosen = self.outline.operands(operands[0]), operands[1:]
        if sorted(compared) == sorted(chosen):
            return True
        opposite = [k for k in chosen if steps[k].op is Op.NEGATE and self.outline.operands(k)[0] in chosen]
        return bool(opposite) and any(k in chosen for k in compared) and any(
            steps[k].op is Op.CONSTANT and steps[k].value == 0 for k in compared
        )


def _powers(raw: Interval, places: Places) -> Interval:
    """The powers of two that rounding does not pass, on the side of zero on which the values are."""
    least, most = np.ldexp(1.0, places[0]), np.ldexp(1.0, places[1] + 1)
    low = np.where(raw.low > 0, least, -most)
    high = np.where(raw.high < 0, -least, most)
    return Interval(low, high)


def _snapped(near: Interval, raw: Interval, unit: float) -> Interval:
    """What is above a power of two by less than half the distance to the next number is rounded to that power."""
    ends = []
    for end, far in ((-raw.low, -near.low), (raw.high, near.high)):
        power = np.ldexp(1.0, np.frexp(end)[1] - 1)
        ends.append(np.where((end >= power) & (end - power < unit / 2 * power), power, far))
    return Interval(-ends[0], ends[1])
