"""How far may rounding take each step, over many boxes of inputs? Interval arithmetic along with the program.

Each step has an interval that holds its exact values, and a bound on how far the computed ones are from them. All terms
are kept, those of second order too.
"""

from __future__ import annotations

from collections.abc import Callable, Mapping
from fractions import Fraction
from operator import attrgetter, neg

import numpy as np
from numpy.typing import NDArray

from chasles.bounds.choosing import Choices
from chasles.bounds.functions import ENCLOSED
from chasles.bounds.intervals import Array, Interval, exactly
from chasles.bounds.model import Model
from chasles.bounds.outline import NoBound, Outline, reached
from chasles.bounds.places import Places, Scaled
from chasles.lowering.program import Op, Step

Angles = Callable[[int, int, Fraction], tuple[Scaled, Scaled]]
"""Sine and cosine of a multiple of an argument's entry."""
COMPARISONS = (Op.LESS, Op.EQUAL)


def no_angles(argument: int, entry: int, factor: Fraction) -> tuple[Scaled, Scaled]:
    """The angles of a program that has none apart from its other values. Raises KeyError."""
    raise KeyError((argument, entry, factor))


class Running(Choices):
    """The program's steps over as many boxes as each interval of `inputs` has ends.

    `inputs` gives values to entries of arguments, `angles` sines and cosines to the outline's angles; `known` encloses
    the exact values of some steps otherwise; `places` says between which powers of two the sizes of some lie before
    they are rounded.

    `values` has each step's exact values and errors; `bad` says in which boxes a step has no value that is known, and
    `why` is the first such step; `split` is the step, and the power of two, of which both sides are possible and which
    matters most.
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
        super().__init__(outline, model, np.zeros(count), places or {})
        self._inputs, self._angles, self._known = inputs, angles, known or {}
        self.bad = np.zeros(count, dtype=bool)
        self.why = np.full(count, -1)
        self.split = np.full(count, -1), np.zeros(count, dtype=np.int64)
        self._weight = np.zeros(count)
        with np.errstate(all="ignore"):
            for number in outline.needed:
                self._run(number, outline.program.steps[number])

    def _run(self, number: int, step: Step) -> None:
        if step.op in COMPARISONS:
            self.truths[number] = self.truth(step.op, self.outline.operands(number))
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
        angles, operands = self.outline.angles, self.outline.operands
        return reached([entry], lambda number: () if number in angles else operands(number))

    def _step(self, number: int, step: Step) -> Scaled:
        if number in self.outline.angles:
            turn = self._angles(*self.outline.angles[number])[0 if step.op is Op.SINE else 1]
            return self._graded(number, turn.power, turn.value, self.zero, step.op)
        operands = self.outline.operands(number)
        if step.op is Op.SELECT:
            return self.chosen(number, operands)
        of = [self.values[k] for k in operands]
        self.rounded |= {number} if self.rounded.intersection(operands) else set()
        match step.op:
            case Op.INPUT:
                given = self._inputs[step.argument, step.entry]
                self.rounded |= {number} if given.error.any() else set()
                return given
            case Op.CONSTANT:
                value = exactly(step.value, self.zero)
                exact = self._model.is_exact(step.value)
                return Scaled(0, value, self.zero) if exact else self._graded(number, 0, value, self.zero, step.op)
            case Op.NEGATE:
                if operands[0] in self._unrounded:
                    self._unrounded[number] = -self._unrounded[operands[0]]
                return self._exactly(number, neg, of[0], operands[0])
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
                return self._exactly(number, attrgetter("size"), of[0], operands[0])
            case Op.FUNCTION if step.function in ENCLOSED:
                return self._of_libm(number, step.function, of, operands)
            case op:
                raise NoBound(f"no bound over a box is known of {step.function or f'the operation {op}'}")

    def _exactly(self, number: int, operation: Callable[[Interval], Interval], x: Scaled, operand: int) -> Scaled:
        """What an operation makes of a step that rounds nothing."""
        self.near[number] = Scaled(x.power, operation(self.near[operand].value), x.error)
        return Scaled(x.power, operation(x.value), x.error)

    def weigh(self, number: int, moved: Array) -> None:
        """Choose the step to part boxes by: that whose error moves some entry most."""
        where, power = self._sides[number]
        more = where & (moved > self._weight)
        self._weight[more], self.split[0][more], self.split[1][more] = moved[more], number, power[more]
