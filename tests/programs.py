"""Programs run on floats and on exact fractions, in which a wrong digit is a wrong result, and programs built anew."""

from __future__ import annotations

import math
from collections.abc import Callable, Sequence
from dataclasses import replace
from fractions import Fraction
from typing import Any

from chasles.lowering import arithmetic as programs_on_numbers
from chasles.lowering.arithmetic import Operators, evaluated
from chasles.lowering.builder import Builder
from chasles.lowering.program import Program

__all__ = ["FLOATS", "fractions", "run", "shared"]


class Floats(Operators):
    """Python's floats, with the infinities and NaN of IEEE 754."""

    constant, sine, cosine, arctangent2 = float, math.sin, math.cos, math.atan2

    def not_a_number(self) -> float:
        return math.nan

    def function(self, name: str, *operands: float) -> float:
        value: float = getattr(math, name)(*operands)
        return value

    def square_root(self, value: float) -> float:
        return math.sqrt(value) if value >= 0 else math.nan

    def divide(self, a: float, b: float) -> float:
        if b != 0:
            return a / b
        return math.nan if a == 0 or a != a else math.copysign(math.inf, a)


FLOATS: Any = Floats()


class Fractions(Operators):
    """Exact numbers; `circle` gives the rational cosine and sine of an angle that has such.

    Raises ValueError for a root that is not rational, and for an angle whose cosine and sine are not known.
    """

    constant = Fraction

    def function(self, name: str, *operands: Fraction) -> Fraction:
        raise ValueError(f"{name} of {operands} is not known to be rational")

    def __init__(self, circle: Callable[[Fraction], tuple[Fraction, Fraction]] | None) -> None:
        self.circle = circle

    def not_a_number(self) -> float:
        return math.nan

    def square_root(self, value: Fraction) -> Fraction:
        root = Fraction(math.isqrt(value.numerator), math.isqrt(value.denominator))
        if root * root != value:
            raise ValueError(f"the square root of {value} is not rational")
        return root

    def divide(self, a: Fraction, b: Fraction) -> Any:
        return a / b if b else math.nan if a == 0 else math.copysign(math.inf, a)

    def turn(self, angle: Fraction) -> tuple[Fraction, Fraction]:
        if self.circle is None:
            raise ValueError(f"the cosine and sine of {angle} are not rational: pass `circle` to say what they are")
        return self.circle(angle)

    def cosine(self, angle: Fraction) -> Fraction:
        return self.turn(angle)[0]

    def sine(self, angle: Fraction) -> Fraction:
        return self.turn(angle)[1]

    def arctangent2(self, y: Fraction, x: Fraction) -> Fraction:
        raise ValueError(f"the angle of the point ({x}, {y}) is not rational")


def fractions(circle: Callable[[Fraction], tuple[Fraction, Fraction]] | None = None) -> Any:
    return Fractions(circle)


def run(program: Program, inputs: Sequence[Any], arithmetic: Any = FLOATS) -> tuple[tuple[Any, ...], ...]:
    return programs_on_numbers.run(program, inputs, arithmetic)


def shared(program: Program) -> Program:
    """The same program asked for anew: common subexpressions computed once, constants folded, signs absorbed."""
    build = Builder()
    place = evaluated(program.steps, build, build.input)
    results = tuple(replace(r, entries=tuple(place[k] for k in r.entries)) for r in program.results)
    return replace(program, steps=build.steps, results=results)
