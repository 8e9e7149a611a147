"""How far may rounding take each step, over many boxes of inputs? Interval arithmetic along with the program.

Each step has an interval that holds its exact values, and a bound on how far the computed ones are from them. All terms
are kept, those of second order too.
"""

from __future__ import annotations

from collections.abc import Callable, Mapping
from fractions import Fraction

import numpy as np
from numpy.typing import NDArray

from chasles.bounds.choosing import ComparisonOutcome, chosen, truth
from chasles.bounds.functions import ENCLOSED, slope
from chasles.bounds.intervals import SAFE, Array, Interval, exactly, function_of
from chasles.bounds.model import Model
from chasles.bounds.outline import NoBound, Outline
from chasles.bounds.places import Places, excess, half_unit, restricted, rounded
from chasles.bounds.scaled import Scaled
from chasles.lowering.program import Op, Step, is_power_of_two

Angles = Callable[[int, int, Fraction], tuple[Scaled, Scaled]]
"""Sine and cosine of a multiple of an argument's entry."""


def no_angles(argument: int, entry: int, factor: Fraction) -> tuple[Scaled, Scaled]:
    """The angles of a program that has none apart from its other values. Raises KeyError."""
    raise KeyError((argument, entry, factor))


COMPARISONS = (Op.LESS, Op.EQUAL)
FUNCTIONS = (Op.SINE, Op.COSINE, Op.ARCTANGENT2, Op.FUNCTION)


class Running:
    """The program's steps over as many boxes as each interval of `inputs` has ends.

    `inputs` gives values to entries of arguments, `angles` sines and cosines to the outline's angles; `known` encloses
    the exact values of some steps otherwise; `places` says between which powers of two the sizes of some lie before
    they are rounded.

    `values` has each step's exact values and errors, `around` encloses all that is as near to an exact value, `near`
    the computed values alone; `losses` has the error that a step adds of itself, if it rounds. `bad` says in which
    boxes a step has no value that is known, and `why` is the first such step; `empty` which boxes the `places` leave
    nothing of; `split` is the step, and the power of two, of which both sides are possible and which matters most.
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
        self.values: dict[int, Scaled] = {}
        self.around: dict[int, Scaled] = {}
        self.near: dict[int, Scaled] = {}
        self._unrounded: dict[int, Interval] = {}
        self.losses: dict[int, Array] = {}
        self.rounded: set[int] = set()
        self.truths: dict[int, ComparisonOutcome] = {}
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
            self.truths[number] = truth(self, step.op, self.outline.operands(number))
            return
        found = self._step(number, step)
        if number in self._known:
            found = Scaled(found.power, found.value.common(self._known[number]), found.error)
        around = found.value.widened(found.error) if number in self.rounded else found.value
        near = self.near[number].value.common(around) if number in self.near else around
        self.values[number], self.around[number] = found, Scaled(found.power, around, found.error)
        self.near[number] = Scaled(found.power, near, found.error)
        lost = ~(np.isfinite(around.low) & np.isfinite(around.high)) & ~self.bad
        self.why[lost] = number
        self.bad |= lost

    def part(self, rows: NDArray[np.intp], entry: int) -> Running:
        """What the derivatives of a step depend on, in these boxes alone."""
        found: Running = object.__new__(Running)
        found.outline, found.rounded, found._model = self.outline, self.rounded, self._model
        found.zero, found._weight = self.zero[rows], self._weight[rows]
        found.split = self.split[0][rows], self.split[1][rows]
        read = self._read_by(entry)
        found.around = {k: self.around[k].part(rows) for k in read if k in self.around}
        found.losses = {k: self.losses[k][rows] for k in read if k in self.losses}
        found.truths = {k: self.truths[k].part(rows) for k in read if k in self.truths}
        found._sides = {k: (self._sides[k][0][rows], self._sides[k][1][rows]) for k in read if k in self._sides}
        return found

    def _read_by(self, entry: int) -> set[int]:
        """The steps that a step depends on, itself among them."""
        found, ahead = set[int](), [entry]
        while ahead:
            number = ahead.pop()
            if number not in found:
                found.add(number)
                ahead += () if number in self.outline.angles else self.outline.operands(number)
        return found

    def lowered(self, x: Interval, power: int, to: int) -> Interval:
        """A multiple of one power of 2^-j as a multiple of a lower one."""
        return x if power == to else x.union(Interval(self.zero, self.zero))

    def _step(self, number: int, step: Step) -> Scaled:
        if number in self.outline.angles:
            turn = self._angles(*self.outline.angles[number])[0 if step.op is Op.SINE else 1]
            return self._graded(number, turn.power, turn.value, self.zero, step.op)
        operands = self.outline.operands(number)
        if step.op is Op.SELECT:
            return self._chosen(number, operands)
        of = [self.values[k] for k in operands]
        if not self.rounded.isdisjoint(operands):
            self.rounded.add(number)
        match step.op:
            case Op.INPUT:
                given = self._inputs[step.argument, step.entry]
                if given.error.any():
                    self.rounded.add(number)
                return given
            case Op.CONSTANT:
                value = exactly(step.value, self.zero)
                if self._model.is_exact(step.value):
                    return Scaled(0, value, self.zero)
                return self._graded(number, 0, value, self.zero, step.op)
            case Op.NEGATE:
                self.near[number] = Scaled(of[0].power, -self.near[operands[0]].value, of[0].error)
                if operands[0] in self._unrounded:
                    self._unrounded[number] = -self._unrounded[operands[0]]
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
            case Op.FUNCTION if step.function == "fabs":
                self.near[number] = Scaled(of[0].power, self.near[operands[0]].value.size, of[0].error)
                return Scaled(of[0].power, of[0].value.size, of[0].error)
            case Op.FUNCTION if step.function in ENCLOSED:
                return self._of_libm(number, step.function, of, operands)
            case op:
                raise NoBound(f"no bound over a box is known of {step.function or f'the operation {op}'}")

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

    def _chosen(self, number: int, operands: tuple[int, ...]) -> Scaled:
        """The value of a choice between cases."""
        found, near, jump = chosen(self, operands)
        if jump.any() or not self.rounded.isdisjoint(operands[1:]):
            self.rounded.add(number)
        if jump.any():
            self.losses[number] = jump
            self._sides[number] = np.zeros(len(jump), dtype=bool), np.zeros(len(jump), dtype=np.int64)
        self.near[number] = Scaled(0, near, found.error)
        return found

    def weigh(self, number: int, moved: Array) -> None:
        """Choose the step to part boxes by: that whose error moves some entry most."""
        where, power = self._sides[number]
        more = where & (moved > self._weight)
        self._weight[more], self.split[0][more], self.split[1][more] = moved[more], number, power[more]

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
