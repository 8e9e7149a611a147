"""Steps as they are asked for: equal steps are one, constants are folded exactly, signs are pulled to the outside.

Nothing is rounded here and nothing is guessed: a product with a constant zero is zero because the zero is structural,
as on the diagonal of a cross-product matrix; x - x is left to the machine, where it is NaN if x is. Compilers know this
as value numbering and constant folding (Muchnick, Advanced Compiler Design and Implementation, 1997, chapter 12).
"""

from __future__ import annotations

from collections.abc import Sequence
from fractions import Fraction
from math import isqrt

from chasles.lowering.arithmetic import applied
from chasles.lowering.functions import FUNCTIONS
from chasles.lowering.program import HALF_TURN, Op, Step, is_power_of_two
from chasles.lowering.refusal import LoweringError

_COSTLY = (Op.DIVIDE, Op.SQUARE_ROOT)
"""Of two of these of which one is thrown away, only one is made."""


class Builder:
    """A growing list of steps; each operation returns the number of the step that holds its result."""

    def __init__(self) -> None:
        self._numbers: dict[Step, int] = {}
        self._steps: list[Step] = []
        self._foldable: set[int] = set()
        self.slopes: dict[int, tuple[tuple[int, int], ...]] = {}
        self.zero = self.constant(0)
        self.one = self.constant(1)

    @property
    def steps(self) -> tuple[Step, ...]:
        """All steps so far, in the order in which they were first asked for."""
        return tuple(self._steps)

    def step(self, number: int) -> Step:
        """One of the steps."""
        return self._steps[number]

    def is_choice(self, number: int) -> bool:
        """Whether a step changes as one of two others does."""
        return self._steps[number].op is Op.SELECT and number not in self.slopes

    def changes_with(self, number: int) -> tuple[int, ...]:
        """The steps by whose rates that of a step is told: its operands, unless slopes are told of it."""
        return tuple(k for k, _ in self.slopes[number]) if number in self.slopes else self._steps[number].operands

    def rate_by(self, number: int, *slopes: tuple[int, int]) -> int:
        """A step of which it is told by which earlier steps it changes, and how fast: what its own rate loses."""
        self.slopes[number] = slopes
        return number

    def held(self, number: int) -> int:
        """A step of the same value that counts as a constant where derivatives are formed."""
        self._steps.append(self._steps[number])
        self.slopes[len(self._steps) - 1] = ()
        return len(self._steps) - 1

    def like(self, step: Step, operands: Sequence[int]) -> int:
        """The step that does to the operands what another one does to its own."""
        if step == HALF_TURN:
            return self.half_turn()
        return self.input(step.argument, step.entry) if step.op is Op.INPUT else applied(self, step, operands)

    def copied(self, step: Step, operands: Sequence[int]) -> int:
        """A step that a builder made, on copies of its operands: there is nothing to fold."""
        if step.op is Op.ADD or step.op is Op.EQUAL or (step.op is Op.MULTIPLY and operands[0] not in self._foldable):
            operands = sorted(operands)
        return self._add(step.on(tuple(operands)))

    def value(self, number: int) -> Fraction | None:
        """The exact value of a constant step, else None."""
        step = self._steps[number]
        if step.op is Op.NEGATE:
            inner = self._steps[step.operands[0]]
            return -inner.value if inner.op is Op.CONSTANT else None
        return step.value if step.is_number else None

    def constant(self, value: Fraction | int) -> int:
        """An exact number."""
        size = self._add(Step(Op.CONSTANT, value=abs(Fraction(value))))
        return self.negate(size) if value < 0 else size

    def half_turn(self) -> int:
        """The number pi, which is folded with no other: what a program means by it is seen."""
        return self._add(HALF_TURN)

    def input(self, argument: int, entry: int) -> int:
        """An entry of an argument."""
        return self._add(Step(Op.INPUT, argument=argument, entry=entry))

    def not_a_number(self) -> int:
        """What has no value."""
        return self._add(Step(Op.NOT_A_NUMBER))

    def add(self, a: int, b: int) -> int:
        """The sum a + b."""
        if a not in self._foldable and b not in self._foldable:
            return self._commuting(Op.ADD, a, b)
        (x, y), (inner_a, inner_b) = (self.value(a), self.value(b)), (self._opposite(a), self._opposite(b))
        if x is not None and y is not None:
            return self.constant(x + y)
        if x == 0 or y == 0:
            return b if x == 0 else a
        if inner_b is not None:
            return self.subtract(a, inner_b)
        return self.subtract(b, inner_a) if inner_a is not None else self._commuting(Op.ADD, a, b)

    def subtract(self, a: int, b: int) -> int:
        """The difference a - b."""
        (x, y), (inner_a, inner_b) = (self.value(a), self.value(b)), (self._opposite(a), self._opposite(b))
        if x is not None and y is not None:
            return self.constant(x - y)
        if y == 0:
            return a
        if x == 0:
            return self.negate(b)
        if inner_b is not None:
            return self.add(a, inner_b)
        if inner_a is not None:
            return self.negate(self.add(inner_a, b))
        reverse = self._numbers.get(Step(Op.SUBTRACT, (b, a)))
        return self.negate(reverse) if reverse is not None else self._add(Step(Op.SUBTRACT, (a, b)))

    def negate(self, a: int) -> int:
        """The opposite -a; no step of its own is made for -0 and -(-a)."""
        inner = self._opposite(a)
        if inner is not None:
            return inner
        return a if self.value(a) == 0 else self._add(Step(Op.NEGATE, (a,)))

    def multiply(self, a: int, b: int) -> int:
        """The product a b."""
        if a not in self._foldable and b not in self._foldable:
            return self._commuting(Op.MULTIPLY, a, b)
        (x, y), (inner_a, inner_b) = (self.value(a), self.value(b)), (self._opposite(a), self._opposite(b))
        if x is not None and y is not None:
            return self.constant(x * y)
        if x == 0 or y == 0:
            return self.zero
        if inner_a is not None or inner_b is not None:
            product = self.multiply(a if inner_a is None else inner_a, b if inner_b is None else inner_b)
            return product if inner_a is not None and inner_b is not None else self.negate(product)
        if x == 1 or y == 1:
            return b if x == 1 else a
        if y is not None:
            a, b, x = b, a, y
        return self._scaled(x, a, b) if x is not None else self._commuting(Op.MULTIPLY, a, b)

    def divide(self, a: int, b: int) -> int:
        """The quotient a / b; a division by a power of two is a multiplication, which rounds alike."""
        (x, y), (inner_a, inner_b) = (self.value(a), self.value(b)), (self._opposite(a), self._opposite(b))
        if y == 0:
            raise LoweringError("a formula divides by an expression that is zero by construction")
        if x is not None and y is not None:
            return self.constant(x / y)
        if x == 0:
            return self.zero
        if inner_a is not None or inner_b is not None:
            quotient = self.divide(a if inner_a is None else inner_a, b if inner_b is None else inner_b)
            return quotient if inner_a is not None and inner_b is not None else self.negate(quotient)
        if y is not None and is_power_of_two(abs(y)):
            return self.multiply(self.constant(1 / y), a)
        above, below = self._steps[a], self._steps[b]
        if above.op is below.op is Op.DIVIDE and above.operands[1] == below.operands[1]:
            return self.divide(above.operands[0], below.operands[0])
        return self._add(Step(Op.DIVIDE, (a, b)))

    def square_root(self, a: int) -> int:
        """The nonnegative root of a."""
        value = self.value(a)
        if value is not None and value >= 0:
            above, below = isqrt(value.numerator), isqrt(value.denominator)
            if Fraction(above, below) ** 2 == value:
                return self.constant(Fraction(above, below))
        return self._add(Step(Op.SQUARE_ROOT, (a,)))

    def sine(self, a: int) -> int:
        """The sine of a, an odd function."""
        inner = self._opposite(a)
        if inner is not None:
            return self.negate(self.sine(inner))
        return self.zero if self.value(a) == 0 else self._add(Step(Op.SINE, (a,)))

    def cosine(self, a: int) -> int:
        """The cosine of a, an even function."""
        inner = self._opposite(a)
        if inner is not None:
            return self.cosine(inner)
        return self.one if self.value(a) == 0 else self._add(Step(Op.COSINE, (a,)))

    def arctangent2(self, y: int, x: int) -> int:
        """The angle of the point (x, y), in (-pi, pi]."""
        return self._add(Step(Op.ARCTANGENT2, (y, x)))

    def less(self, a: int, b: int) -> int:
        """Whether a < b."""
        return self._add(Step(Op.LESS, (a, b)))

    def equal(self, a: int, b: int) -> int:
        """Whether a = b."""
        return self._commuting(Op.EQUAL, a, b)

    def select(self, condition: int, if_true: int, if_false: int) -> int:
        """One of two steps, by a condition; of two quotients or two roots, that of the operands selected."""
        if if_true == if_false:
            return if_true
        one, other = self._steps[if_true], self._steps[if_false]
        if one.op in _COSTLY and one.op is other.op:
            operands = (self.select(condition, a, b) for a, b in zip(one.operands, other.operands, strict=True))
            return self._add(Step(one.op, tuple(operands)))
        if one.op in _COSTLY and other.op is Op.NOT_A_NUMBER:
            return self._add(Step(one.op, (self.select(condition, one.operands[0], if_false), *one.operands[1:])))
        if other.op in _COSTLY and one.op is Op.NOT_A_NUMBER:
            return self._add(Step(other.op, (self.select(condition, if_true, other.operands[0]), *other.operands[1:])))
        return self._add(Step(Op.SELECT, (condition, if_true, if_false)))

    def function(self, name: str, *operands: int) -> int:
        """A function of the table; an even one of -a is that of a, and Stumpff's first is the cosine.

        Raises `LoweringError` where it is not one of so many numbers.
        """
        if name == "stumpff" and self.value(operands[0]) == 0:
            return self.cosine(operands[1])
        if len(operands) != (many := FUNCTIONS[name].operands):
            raise LoweringError(f"{name} is computed of {many} number{'s' * (many > 1)}, not of {len(operands)}")
        if name == "stumpff" and (inner := self._opposite(operands[1])) is not None:
            return self.function(name, operands[0], inner)
        if name == "fabs":
            inner, value = self._opposite(operands[0]), self.value(operands[0])
            if inner is not None or value is not None:
                return self.function(name, inner) if inner is not None else operands[0]
        return self._add(Step(Op.FUNCTION, operands, function=name))

    def _scaled(self, factor: Fraction, constant: int, b: int) -> int:
        """A constant times b; constants that meet are multiplied exactly."""
        step = self._steps[b]
        if step.op is Op.MULTIPLY:
            inner = self.value(step.operands[0])
            if inner is not None:
                return self.multiply(self.constant(factor * inner), step.operands[1])
        return self._add(Step(Op.MULTIPLY, (constant, b)))

    def _opposite(self, number: int) -> int | None:
        """The step of which this one is the negative, if it is one."""
        step = self._steps[number]
        return step.operands[0] if step.op is Op.NEGATE else None

    def _commuting(self, op: Op, a: int, b: int) -> int:
        return self._add(Step(op, (a, b) if a <= b else (b, a)))

    def _add(self, step: Step) -> int:
        number = self._numbers.get(step)
        if number is None:
            number = self._numbers[step] = len(self._steps)
            self._steps.append(step)
            if step.op is Op.CONSTANT or step.op is Op.NEGATE:
                self._foldable.add(number)
        return number
