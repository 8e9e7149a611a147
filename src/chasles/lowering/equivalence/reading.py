"""A program read as algebra: every step a fraction in the entries of the arguments.

A root is a norm of the request, a sine or cosine that of a sum of its angles, an arctangent one of its angles by cosine
and sine; a selection goes the way that the signs on this way through the cases say, unless it is a scale, which is read
as any positive number.
"""

from __future__ import annotations

from collections.abc import Mapping
from fractions import Fraction
from typing import Any

from chasles.algebra.localization import Ratio
from chasles.lowering.arithmetic import Operators, applied
from chasles.lowering.equivalence.algebra import Algebra
from chasles.lowering.equivalence.angles_taken import Linear, Unreadable, call_at, linear_angle
from chasles.lowering.equivalence.signs import Signs
from chasles.lowering.named_functions import ANGLE, CALLED
from chasles.lowering.program import HALF_TURN, Op, Program, Step
from chasles.lowering.request import Request
from chasles.lowering.scales import is_scale
from chasles.vocabulary import PI, Symbol, uniform

UNSETTLED = (Op.SELECT, Op.LESS, Op.EQUAL, Op.DIVIDE, Op.SQUARE_ROOT)


class Settled:
    """The steps whose values are the same however comparisons come out, and those values once they are found.

    A quotient and a root are not among them: by what is zero, or of it, they are read otherwise.
    """

    def __init__(self, program: Program) -> None:
        self.values: dict[int, Any] = {}
        self.steps: set[int] = set()
        for number, step in enumerate(program.steps):
            if step.op not in UNSETTLED and self.steps.issuperset(step.operands):
                self.steps.add(number)


class ProgramReading(Operators):
    """A program's steps as fractions on one way through its cases, read as far as they are needed.

    None is what has no value. Raises `Unreadable`, and `Fork` where a comparison is not settled.
    """

    def __init__(
        self, program: Program, request: Request, signs: Signs, settled: Settled, scales: Mapping[int, Symbol]
    ) -> None:
        self._scales = scales
        self._program = program
        self._request = request
        self._algebra: Algebra = signs.differences.algebra
        self._signs = signs
        self._settled = settled
        self._values: dict[int, Any] = {}

    def value(self, number: int) -> Any:
        """A step's fraction; of a comparison, whether it holds."""
        values = self._settled.values if number in self._settled.steps else self._values
        if number not in values:
            values[number] = self._value(number, self._program.steps[number])
        return values[number]

    def _value(self, number: int, step: Step) -> Any:
        if number in self._scales:
            return self._algebra.entry(self._scales[number])
        match step.op:
            case Op.INPUT:
                return self._input(step.argument, step.entry)
            case Op.CONSTANT if step == HALF_TURN:
                return self._algebra.entry(PI)
            case Op.SINE | Op.COSINE:
                name = "sin" if step.op is Op.SINE else "cos"
                angle = linear_angle(self._program, self._request, step.operands[0], self._length)
                return self._algebra.entry(call_at(name, angle))
            case Op.SELECT if (known := self._extreme(step)) is not None:
                return known
            case Op.SELECT:
                return self.value(step.operands[1 if self.value(step.operands[0]) else 2])
        operands = []
        for operand in step.operands:
            operands.append(self.value(operand))
            if operands[-1] is None:
                # What is not a number makes all that it enters no number, and no comparison with it holds; what it is
                # combined with need not be read.
                return None
        try:
            return applied(self, step, operands)
        except Unreadable as error:
            raise Unreadable(f"step {number} {error}") from None

    def constant(self, value: Fraction) -> Ratio:
        return self._algebra.constant(value)

    def not_a_number(self) -> None:
        return None

    def divide(self, above: Ratio, below: Ratio) -> Ratio | None:
        if self._signs.is_zero(below):
            return None
        quotient = self._algebra.quotient(above, below)
        if quotient is None:
            raise Unreadable("divides by what can be zero where the formula has a value")
        return quotient

    def square_root(self, square: Ratio) -> Ratio:
        if self._signs.is_zero(square):
            return self._algebra.constant(Fraction(0))
        root = self._algebra.root(square)
        if root is None:
            raise Unreadable("takes a root that is no norm of the formula")
        return root

    def arctangent2(self, sine: Ratio, cosine: Ratio) -> Ratio:
        entry, vanishes = self._algebra.entry, self._algebra.vanishes
        for symbol, angle in self._request.angles:
            if vanishes(entry(angle.sine) - sine) and vanishes(entry(angle.cosine) - cosine):
                return entry(symbol) * self._algebra.constant(1 / angle.times)
        known = self._named("atan2", sine, cosine)
        if known is None:
            raise Unreadable("measures an angle that is none of the formula's")
        return known

    def function(self, name: str, *operands: Ratio) -> Ratio:
        function = next((each for each, call in CALLED.items() if call == name), "")
        known = self._named(function, *operands)
        if known is None:
            raise Unreadable(f"takes {name} of what the formula does not")
        return known

    def _named(self, function: str, *operands: Any) -> Ratio | None:
        """The symbol of the formula that stands for a function of these numbers; None if none does."""
        for known in self._request.functions if None not in operands else ():
            if known.function == function:
                pairs = zip(operands, map(self._algebra.entry, known.arguments), strict=True)
                if all(self._algebra.vanishes(one - other) for one, other in pairs):
                    return self._algebra.entry(known.symbol)
        return None

    def _extreme(self, step: Step) -> Ratio | None:
        """The larger or the smaller of two numbers, where the formula takes that of them."""
        compared = self._program.steps[step.operands[0]]
        kind = {compared.operands: "min", compared.operands[::-1]: "max"}.get(step.operands[1:], "")
        if compared.op is not Op.LESS or not any(known.function == kind for known in self._request.functions):
            return None
        return self._named(kind, *map(self.value, compared.operands))

    def less(self, left: Ratio, right: Ratio) -> bool:  # type: ignore[override]
        return self._signs.truth("less", left - right)

    def equal(self, left: Ratio, right: Ratio) -> bool:  # type: ignore[override]
        return self._signs.truth("equal", left - right)

    def _length(self, number: int) -> Linear:
        """A step as a multiple of the length of a rotation vector; empty where it is not seen to be one."""
        value = self.value(number)
        for node in self._algebra.turning if isinstance(value, Ratio) else ():
            times = self._algebra.multiple(value, self._algebra.entry(node))
            if times is not None:
                return {node: times}
        for known in self._request.functions if isinstance(value, Ratio) else ():
            angle = known.arguments[0] if known.function == ANGLE else known.symbol
            times = self._algebra.multiple(value, self._algebra.entry(angle))
            if times is not None:
                return {known.symbol: times}
        return {}

    def _input(self, argument: int, entry: int) -> Ratio:
        node, row, column = self._request.place(argument, entry)
        try:
            return self._algebra.entry(node, row, column)
        except KeyError:
            raise Unreadable(f"it reads {node}, of which the formula has only the cosine and sine") from None


def scale_symbols(program: Program) -> dict[int, Symbol]:
    """A symbol for each step that is a scale: whatever positive number it stands for, the program is to be right."""
    numbers = (k for k in range(len(program.steps)) if is_scale(program.steps, k))
    return {k: Symbol(f"scale {k}", "", uniform((1, 1))) for k in numbers}
