"""How far may rounding take each step, over a whole box of inputs? Ball arithmetic along with the program.

Each step has a ball that holds its exact values, and a bound on how far the computed ones are from them. All terms are
kept, those of second order too.
"""

from __future__ import annotations

import math
from collections.abc import Callable, Mapping
from fractions import Fraction
from typing import Any

from chasles.bounds.model import Model
from chasles.bounds.outline import NoBound, Outline, is_power_of_two
from chasles.bounds.scaled import Scaled, exactly
from chasles.lowering.program import Op, Step

__all__ = ["SAFE", "Running"]

SAFE = 1e-12
"""By how much a float is moved outwards that stands for the end of a ball: thousands of its own roundings."""


class Running:
    """The program's steps over one box.

    `inputs` gives values to entries of arguments, `angles` sine and cosine of multiples of an argument's entry; `small`
    is what t runs over. `values` has each step's exact values and errors, `near` encloses its computed values.
    `rounded` are the steps behind which something is rounded, and `losses` says of those that round themselves how
    much: relative to the value, or absolutely (True) where the value's size is known. Raises ZeroDivisionError where
    the box is so large that a divisor may be zero.
    """

    def __init__(
        self,
        outline: Outline,
        model: Model,
        inputs: Mapping[tuple[int, int], Scaled],
        angles: Callable[[int, int, Fraction], tuple[Scaled, Scaled]],
        small: tuple[float, float],
    ) -> None:
        from flint import arb

        self.outline, self._model, self._inputs, self._angles = outline, model, inputs, angles
        self.zero = arb(0)
        self._unit, self._function = exactly(model.roundoff), exactly(model.loss(Op.SINE))
        # What a derivative changes by where the step's own rounding is taken into account.
        self.wobble = arb(1, 2 * float(max(model.roundoff, model.loss(Op.SINE))))
        self._small = arb(small[0]), arb(small[1])
        self.values: dict[int, Scaled] = {}
        self.near: dict[int, Scaled] = {}
        self.rounded: set[int] = set()
        self.losses: dict[int, tuple[Any, bool]] = {}
        for number in outline.needed:
            found = self.values[number] = self._step(number, outline.program.steps[number])
            self.near[number] = found
            if number in self.rounded:
                self.near[number] = Scaled(found.power, found.value + arb(0, found.error.abs_upper()), found.error)

    def lowered(self, x: Any, power: int, to: int) -> Any:
        """A multiple of one power of t as a multiple of a lower one."""
        if power == to:
            return x
        low, high = self._small
        return x * (low ** (power - to)).union(high ** (power - to))

    def _step(self, number: int, step: Step) -> Scaled:
        if number in self.outline.angles:
            value = self._angles(*self.outline.angles[number])[0 if step.op is Op.SINE else 1]
            return self._graded(number, value.power, value.value, self.zero, self._function)
        operands = self.outline.operands(number)
        of = [self.values[k] for k in operands]
        if not self.rounded.isdisjoint(operands):
            self.rounded.add(number)
        match step.op:
            case Op.INPUT:
                return self._inputs[step.argument, step.entry]
            case Op.CONSTANT:
                value = exactly(step.value)
                if self._model.is_exact(step.value):
                    return Scaled(0, value, self.zero)
                return self._graded(number, 0, value, self.zero, self._unit)
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
            case op:
                raise NoBound(f"no bound over a box is known of the operation {op}")

    def _graded(self, number: int, power: int, value: Any, error: Any, loss: Any) -> Scaled:
        """The value with the operation's own rounding.

        Half a unit in the last place is the roundoff times the largest power of two that is not above the value's size.
        The unit that a function is measured in is that of its exact value, which is below 1.
        """
        self.rounded.add(number)
        size = abs(value) + error
        if power:
            self.losses[number] = loss, False
            return Scaled(power, value, error + size * loss)
        most = float(size.abs_upper()) * (1 + SAFE)
        place = min(math.frexp(most)[1] - 1, -1 if loss is self._function else math.inf)
        step = loss * 2.0**place if most else self.zero
        self.losses[number] = step, True
        return Scaled(0, value, error + step)

    def _sum(self, number: int, x: Scaled, y: Scaled, op: Op) -> Scaled:
        power = min(x.power, y.power)
        a, b = self.lowered(x.value, x.power, power), self.lowered(y.value, y.power, power)
        error = self.lowered(x.error, x.power, power) + self.lowered(y.error, y.power, power)
        return self._graded(number, power, a + b if op is Op.ADD else a - b, error, self._unit)

    def _product(self, number: int, x: Scaled, y: Scaled, operands: tuple[int, ...]) -> Scaled:
        power = x.power + y.power
        value = x.value**2 if operands[0] == operands[1] else x.value * y.value
        error = abs(x.value) * y.error + abs(y.value) * x.error + x.error * y.error
        if any(self._only_scales(k) for k in operands):
            return Scaled(power, value, error)
        return self._graded(number, power, value, error, self._unit)

    def _only_scales(self, number: int) -> bool:
        step = self.outline.program.steps[number]
        return step.op is Op.CONSTANT and is_power_of_two(step.value)

    def _quotient(self, number: int, x: Scaled, y: Scaled) -> Scaled:
        least = (y.value.abs_lower() - y.error).lower()
        if not least > 0:
            raise ZeroDivisionError
        value = x.value / y.value
        error = (x.error + abs(value) * y.error) / least
        return self._graded(number, x.power - y.power, value, error, self._unit)

    def _root(self, number: int, x: Scaled) -> Scaled:
        least = (x.value.lower() - x.error).lower()
        if x.power or not least > 0:
            raise ZeroDivisionError
        error = x.error / (x.value.lower().sqrt() + least.sqrt())
        return self._graded(number, 0, x.value.sqrt(), error, self._unit)
