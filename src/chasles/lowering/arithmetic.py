"""Programs over any kind of number: the steps one after the other, each operation done by an arithmetic."""

from __future__ import annotations

import math
import operator
from collections.abc import Callable, Iterable, Iterator, Sequence
from dataclasses import dataclass
from fractions import Fraction
from functools import cache
from typing import Any, Protocol, TypeVar

import mpmath

from chasles.lowering.functions import FUNCTIONS
from chasles.lowering.program import Op, Program, Step

Value = TypeVar("Value")


class Arithmetic(Protocol[Value]):
    """The operations of a program on one kind of number, each under the name that it has in `Op`."""

    def constant(self, value: Fraction, /) -> Value: ...
    def not_a_number(self) -> Value: ...
    def add(self, a: Value, b: Value, /) -> Value: ...
    def subtract(self, a: Value, b: Value, /) -> Value: ...
    def multiply(self, a: Value, b: Value, /) -> Value: ...
    def divide(self, a: Value, b: Value, /) -> Value: ...
    def negate(self, a: Value, /) -> Value: ...
    def square_root(self, a: Value, /) -> Value: ...
    def sine(self, a: Value, /) -> Value: ...
    def cosine(self, a: Value, /) -> Value: ...
    def arctangent2(self, y: Value, x: Value, /) -> Value: ...
    def less(self, a: Value, b: Value, /) -> Value: ...
    def equal(self, a: Value, b: Value, /) -> Value: ...
    def select(self, condition: Value, if_true: Value, if_false: Value, /) -> Value: ...
    def function(self, name: str, /, *operands: Value) -> Value: ...


class Operators:
    """What an arithmetic takes from Python's operators."""

    add = staticmethod(operator.add)
    subtract = staticmethod(operator.sub)
    multiply = staticmethod(operator.mul)
    divide = staticmethod(operator.truediv)
    negate = staticmethod(operator.neg)
    less = staticmethod(operator.lt)
    equal = staticmethod(operator.eq)

    @staticmethod
    def select(condition: Any, if_true: Any, if_false: Any) -> Any:
        """One of two values, by a truth value."""
        return if_true if condition else if_false


def applied(arithmetic: Arithmetic[Value] | Operators, step: Step, operands: Iterable[Value]) -> Value:
    """What a step that reads no argument comes to."""
    operation: Callable[..., Value] = getattr(arithmetic, step.op.value)
    if step.op is Op.FUNCTION:
        return operation(step.function, *operands)
    return operation(step.value) if step.op is Op.CONSTANT else operation(*operands)


def evaluated(steps: Sequence[Step], arithmetic: Arithmetic[Value], entry: Callable[[int, int], Value]) -> list[Value]:
    """The value of every step; `entry` gives that of an argument's entry."""
    values: list[Value] = []
    for step in steps:
        if step.op is Op.INPUT:
            values.append(entry(step.argument, step.entry))
        else:
            values.append(applied(arithmetic, step, [values[k] for k in step.operands]))
    return values


@dataclass(frozen=True, slots=True)
class Decimals(Operators):
    """The numbers of a context of mpmath, with the infinities and NaN of IEEE 754."""

    context: Any

    @property
    def infinity(self) -> Any:
        """The number that is larger than all others."""
        return self.context.inf

    def constant(self, value: Fraction) -> Any:
        """The number of the context that is nearest to an exact one."""
        return self.context.mpf(value.numerator) / value.denominator

    def not_a_number(self) -> Any:
        """NaN."""
        return self.context.nan

    def divide(self, a: Any, b: Any) -> Any:
        """The quotient a / b; x / 0 is infinite, 0 / 0 is NaN."""
        if b != 0:
            return a / b
        return self.context.nan if a == 0 or a != a else self.infinity if a > 0 else -self.infinity

    def square_root(self, value: Any) -> Any:
        """The nonnegative root; NaN for a negative number."""
        return self.context.sqrt(value) if value >= 0 else self.context.nan

    def sine(self, angle: Any) -> Any:
        """The sine of an angle in radians."""
        return self.context.sin(angle)

    def cosine(self, angle: Any) -> Any:
        """The cosine of an angle in radians."""
        return self.context.cos(angle)

    def arctangent2(self, y: Any, x: Any) -> Any:
        """The angle of the point (x, y), in (-pi, pi]."""
        return self.context.atan2(y, x)

    def function(self, name: str, *operands: Any) -> Any:
        """The value of a function of the table; NaN where it has none that is real, or none at all."""
        try:
            value = FUNCTIONS[name].value(self.context, *operands)
        except (ValueError, ZeroDivisionError, OverflowError):
            return self.context.nan
        return self.context.nan if isinstance(value, self.context.mpc) else value


@cache
def decimals(digits: int) -> Decimals:
    """Floating-point numbers of so many decimal digits."""
    context = mpmath.MPContext()
    context.dps = digits
    return Decimals(context)


def run(program: Program, inputs: Sequence[Any], arithmetic: Arithmetic[Any]) -> tuple[tuple[Any, ...], ...]:
    """The entries of each result, row-major, for inputs in the order of the arguments; an array may be nested or flat.

    Raises ValueError where the inputs are not as many as the arguments have entries.
    """
    entries = [list(_flat(value)) for value in inputs]
    sizes = [math.prod(argument.shape) for argument in program.arguments]
    if [len(values) for values in entries] != sizes:
        found = ", ".join(str(len(values)) for values in entries)
        raise ValueError(f"{program.name} takes arguments of {', '.join(map(str, sizes))} entries, not {found}")
    values = evaluated(program.steps, arithmetic, lambda argument, entry: entries[argument][entry])
    return tuple(tuple(values[entry] for entry in result.entries) for result in program.results)


def _flat(value: Any) -> Iterator[Any]:
    if isinstance(value, Iterable):
        for part in value:
            yield from _flat(part)
    else:
        yield value
