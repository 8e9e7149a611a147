"""Programs over any kind of number: the steps one after the other, each operation done by an arithmetic."""

from __future__ import annotations

import operator
from collections.abc import Callable, Iterable, Sequence
from fractions import Fraction
from typing import Any, Protocol, TypeVar

from chasles.lowering.program import Op, Step

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
