"""Running a program in Python: on floats, on decimals of any precision, on exact fractions."""

from __future__ import annotations

import math
from collections.abc import Callable, Iterable, Iterator, Sequence
from dataclasses import dataclass
from fractions import Fraction
from functools import cache
from typing import Any

import mpmath

from chasles.lowering.program import Op, Program

__all__ = ["FLOATS", "Arithmetic", "decimals", "fractions", "run"]

Value = Any


@dataclass(frozen=True, slots=True)
class Arithmetic:
    """A kind of number: how an exact number becomes one, and the functions on it.

    Sums, products and comparisons are those of Python's operators; x / 0 is infinite, 0 / 0 is `nan`.
    """

    constant: Callable[[Fraction], Value]
    square_root: Callable[[Value], Value]
    sine: Callable[[Value], Value]
    cosine: Callable[[Value], Value]
    arctangent2: Callable[[Value, Value], Value]
    nan: Value = math.nan
    infinity: Value = math.inf

    def divide(self, a: Value, b: Value) -> Value:
        """The quotient a / b, with the infinities and NaN of IEEE 754."""
        if b != 0:
            return a / b
        return self.nan if a == 0 or a != a else self.infinity if a > 0 else -self.infinity


FLOATS = Arithmetic(float, lambda x: math.sqrt(x) if x >= 0 else math.nan, math.sin, math.cos, math.atan2)
"""Python's floats."""


@cache
def decimals(digits: int) -> Arithmetic:
    """Floating-point numbers of so many decimal digits."""
    context = mpmath.MPContext()
    context.dps = digits

    def constant(value: Fraction) -> Value:
        return context.mpf(value.numerator) / value.denominator

    def square_root(value: Value) -> Value:
        return context.sqrt(value) if value >= 0 else context.nan

    return Arithmetic(constant, square_root, context.sin, context.cos, context.atan2, context.nan, context.inf)


def fractions(circle: Callable[[Fraction], tuple[Fraction, Fraction]] | None = None) -> Arithmetic:
    """Exact numbers; `circle` gives the rational cosine and sine of an angle that has such.

    Running raises ValueError for a root that is not rational, and for an angle whose cosine and sine are not known.
    """

    def square_root(value: Fraction) -> Fraction:
        root = Fraction(math.isqrt(value.numerator), math.isqrt(value.denominator))
        if root * root != value:
            raise ValueError(f"the square root of {value} is not rational")
        return root

    def turn(angle: Fraction) -> tuple[Fraction, Fraction]:
        if circle is None:
            raise ValueError(f"the cosine and sine of {angle} are not rational: pass `circle` to say what they are")
        return circle(angle)

    def arctangent2(y: Fraction, x: Fraction) -> Fraction:
        raise ValueError(f"the angle of the point ({x}, {y}) is not rational")

    return Arithmetic(Fraction, square_root, lambda a: turn(a)[1], lambda a: turn(a)[0], arctangent2)


def run(program: Program, inputs: Sequence[Any], arithmetic: Arithmetic = FLOATS) -> tuple[tuple[Value, ...], ...]:
    """The entries of each result, row-major, for inputs in the order of the arguments; an array may be nested or flat.

    Raises ValueError where the inputs are not as many as the arguments have entries.
    """
    entries = [list(_flat(value)) for value in inputs]
    sizes = [math.prod(argument.shape) for argument in program.arguments]
    if [len(values) for values in entries] != sizes:
        found = ", ".join(str(len(values)) for values in entries)
        raise ValueError(f"{program.name} takes arguments of {', '.join(map(str, sizes))} entries, not {found}")
    values: list[Value] = []
    for step in program.steps:
        if step.op is Op.INPUT:
            values.append(entries[step.argument][step.entry])
        elif step.op is Op.CONSTANT:
            values.append(arithmetic.constant(step.value))
        else:
            values.append(_apply(arithmetic, step.op, [values[k] for k in step.operands]))
    return tuple(tuple(values[entry] for entry in result.entries) for result in program.results)


def _apply(arithmetic: Arithmetic, op: Op, of: list[Value]) -> Value:
    match op:
        case Op.NOT_A_NUMBER:
            return arithmetic.nan
        case Op.ADD:
            return of[0] + of[1]
        case Op.SUBTRACT:
            return of[0] - of[1]
        case Op.MULTIPLY:
            return of[0] * of[1]
        case Op.DIVIDE:
            return arithmetic.divide(*of)
        case Op.NEGATE:
            return -of[0]
        case Op.LESS:
            return of[0] < of[1]
        case Op.EQUAL:
            return of[0] == of[1]
        case Op.SELECT:
            return of[1] if of[0] else of[2]
        case _:
            return getattr(arithmetic, op.value)(*of)


def _flat(value: Any) -> Iterator[Any]:
    if isinstance(value, Iterable):
        for part in value:
            yield from _flat(part)
    else:
        yield value
