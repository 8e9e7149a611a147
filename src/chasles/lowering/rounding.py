"""How much does a program lose by rounding? A bound that runs with it, at points where formulas are apt to fail.

Each step adds half a unit in the last place of its value to what its operands bring along (to first order, each taken
at its worst). Compared are programs for one request: one that loses many times what another loses, at some point, does
so for no reason.
"""

from __future__ import annotations

import math
from collections.abc import Iterable, Iterator, Sequence
from dataclasses import dataclass
from fractions import Fraction
from math import prod
from typing import Any

from chasles.lowering.arithmetic import evaluated
from chasles.lowering.evaluate import Decimals, decimals
from chasles.lowering.program import Op, Program, is_power_of_two
from chasles.lowering.request import Request
from chasles.statements.kernel import places_of
from chasles.vocabulary import Node

__all__ = ["Rounded", "RunningErrors", "losses", "points_of", "stable", "steady"]

DIGITS = 80
FEW = 16
"""Roundoffs that are no loss of digits, whatever another program does."""
TIMES = 4
"""How many times the smallest of the bounds is still as good: roundings that differ, and not digits that are lost."""
NEAR = Fraction(1, 10**12)
ANGLES = (Fraction(13, 10), NEAR, "pi", "pi/2", Fraction(17, 5))
"""At large, near zero, near half a turn and near a right angle."""
SCALES = (Fraction(1), Fraction(1, 1000), Fraction(1000))
"""By how much the inputs are scaled of a program of which no more is known."""


def stable(request: Request, programs: Sequence[Program]) -> list[Program]:
    """The programs that lose nowhere much more than the best of them does there; all where there are no angles."""
    angles = [node for node in request.of if node in _angles(programs, request)]
    if not angles or len(programs) == 1:
        return list(programs)
    # An array is one of angles, or a rotation vector, whose length is one.
    ways = (True,) if all(node.is_scalar for node in angles) else (True, False)
    points = [_point(request, dict.fromkeys(angles, value), each) for value in ANGLES for each in ways]
    return steady(programs, points)


def steady(
    programs: Sequence[Program], points: Iterable[Sequence[Sequence[Any]]], stated: Program | None = None
) -> list[Program]:
    """The programs that lose at none of the points much more than the best of them does there; all if there is none.

    None of them loses much more at any point than the one `stated`, which is among the programs.
    """
    points = list(points)
    table = {program: [loss for point in points for loss in losses(program, point)] for program in programs}
    if stated is not None:
        bar = table[stated]
        table = {program: row for program, row in table.items() if _is_fair(row, bar)}
    least = [min(column) for column in zip(*table.values(), strict=True)]
    return [program for program, row in table.items() if _is_fair(row, least)] or list(table)


def _is_fair(row: Sequence[float], least: Sequence[float]) -> bool:
    return all(x <= max(FEW, TIMES * best) for x, best in zip(row, least, strict=True))


def points_of(program: Program) -> Iterator[list[list[Any]]]:
    """Inputs of a program of which no more is known: large and small ones, those of angles as formulas dislike them."""
    arithmetic = decimals(DIGITS)
    angular = _angular(program)
    sizes = [prod(argument.shape) for argument in program.arguments]
    places = [(number, entry) for number, size in enumerate(sizes) for entry in range(size)]
    for scale, angle in [*((Fraction(1), angle) for angle in ANGLES if angular), *((scale, None) for scale in SCALES)]:
        values = dict(zip(places, (arithmetic.constant(x * scale) for x in _numbers(0, len(places))), strict=True))
        if angle is not None:
            values |= dict.fromkeys(angular, _angle(angle, arithmetic))
        yield [[values[number, entry] for entry in range(size)] for number, size in enumerate(sizes)]


def losses(program: Program, inputs: Sequence[Sequence[Any]]) -> list[float]:
    """For each result a bound on its error, in roundoffs of its largest entry; infinite where it has no value.

    The running error analysis of Higham, Accuracy and Stability of Numerical Algorithms (2002), section 3.3.
    """
    arithmetic = RunningErrors(decimals(DIGITS))
    values = evaluated(program.steps, arithmetic, lambda argument, entry: Rounded(inputs[argument][entry]))
    found = []
    for result in program.results:
        size = max(abs(values[k].value) for k in result.entries)
        error = max(values[k].error for k in result.entries)
        found.append(float(error / size) if size and math.isfinite(float(error / size)) else math.inf)
    return found


@dataclass(frozen=True, slots=True)
class Rounded:
    """A value, and a bound on its error in units of the roundoff; what it `only_scales` is not rounded by it."""

    value: Any
    error: Any = 0
    only_scales: bool = False


@dataclass(frozen=True, slots=True)
class RunningErrors:
    """Numbers with bounds on their errors: what operands bring along to first order, and half a unit of the result."""

    numbers: Decimals

    def constant(self, value: Fraction) -> Rounded:
        """A constant counts as exact."""
        return Rounded(self.numbers.constant(value), only_scales=is_power_of_two(value))

    def not_a_number(self) -> Rounded:
        """What has no value has lost all digits."""
        return Rounded(self.numbers.not_a_number(), math.inf)

    def add(self, x: Rounded, y: Rounded) -> Rounded:
        return self._rounded(x.value + y.value, x.error + y.error)

    def subtract(self, x: Rounded, y: Rounded) -> Rounded:
        return self._rounded(x.value - y.value, x.error + y.error)

    def negate(self, x: Rounded) -> Rounded:
        return Rounded(-x.value, x.error)

    def multiply(self, x: Rounded, y: Rounded) -> Rounded:
        """The product; that with a power of two is not rounded."""
        if x.only_scales:
            return Rounded(x.value * y.value, abs(x.value) * y.error)
        return self._rounded(x.value * y.value, abs(x.value) * y.error + abs(y.value) * x.error)

    def divide(self, x: Rounded, y: Rounded) -> Rounded:
        value = self.numbers.divide(x.value, y.value)
        return self._rounded(value, (x.error + abs(value) * y.error) / abs(y.value) if y.value else math.inf)

    def square_root(self, x: Rounded) -> Rounded:
        value = self.numbers.square_root(x.value)
        return self._rounded(value, x.error / (2 * value) if value else math.inf)

    def sine(self, x: Rounded) -> Rounded:
        return self._rounded(self.numbers.sine(x.value), abs(self.numbers.cosine(x.value)) * x.error)

    def cosine(self, x: Rounded) -> Rounded:
        return self._rounded(self.numbers.cosine(x.value), abs(self.numbers.sine(x.value)) * x.error)

    def arctangent2(self, y: Rounded, x: Rounded) -> Rounded:
        square = x.value * x.value + y.value * y.value
        carried = (abs(x.value) * y.error + abs(y.value) * x.error) / square if square else math.inf
        return self._rounded(self.numbers.arctangent2(y.value, x.value), carried)

    def less(self, x: Rounded, y: Rounded) -> Rounded:
        return Rounded(x.value < y.value)

    def equal(self, x: Rounded, y: Rounded) -> Rounded:
        return Rounded(x.value == y.value)

    def select(self, condition: Rounded, if_true: Rounded, if_false: Rounded) -> Rounded:
        return if_true if condition.value else if_false

    def _rounded(self, value: Any, carried: Any) -> Rounded:
        return Rounded(value, carried + abs(value))


def _angles(programs: Sequence[Program], request: Request) -> set[Node]:
    """The arguments of which some program takes a cosine or sine."""
    return {request.place(*place)[0] for program in programs for place in _angular(program)}


def _angular(program: Program) -> set[tuple[int, int]]:
    """The arguments and entries of which the program takes a cosine or sine."""
    found: set[tuple[int, int]] = set()
    below = {step.operands[0] for step in program.steps if step.op in (Op.SINE, Op.COSINE)}
    for number in reversed(range(len(program.steps))):
        step = program.steps[number]
        if number in below:
            below.update(step.operands)
            if step.op is Op.INPUT:
                found.add((step.argument, step.entry))
    return found


def _point(request: Request, angles: dict[Node, Any], each: bool) -> list[list[Any]]:
    """Values of the arguments: the angles as given, unit vectors of unit length, the rest at large.

    In an array of angles `each` entry is as given, or the length is.
    """
    arithmetic = decimals(DIGITS)
    units = {h.subjects[0] for h in request.hypotheses if h.kind == "unit"}
    values: dict[Node, list[Any]] = {}
    drawn = 0
    for node in request.of:
        size = node.shape[0] * node.shape[1]
        numbers = _numbers(drawn, size)
        drawn += size
        values[node] = [arithmetic.constant(x) for x in numbers]
        if node in units or (node in angles and not each):
            length = arithmetic.square_root(arithmetic.constant(sum((x * x for x in numbers), Fraction(0))))
            values[node] = [x / length for x in values[node]]
        if node in angles:
            angle = _angle(angles[node], arithmetic)
            values[node] = [angle if each else angle * x for x in values[node]]
    return [[values[node][i * node.shape[1] + j] for node, i, j in places_of(a)] for a in request.arguments]


def _numbers(start: int, count: int) -> list[Fraction]:
    """Numbers of no particular kind, always the same."""
    return [Fraction((7 * k * k + 5 * k) % 31 - 15, 11) + Fraction(1, 7) for k in range(start, start + count)]


def _angle(value: Fraction | str, arithmetic: Decimals) -> Any:
    if isinstance(value, Fraction):
        return arithmetic.constant(value)
    half_turn = arithmetic.arctangent2(arithmetic.constant(Fraction(0)), arithmetic.constant(Fraction(-1)))
    return (half_turn if value == "pi" else half_turn / 2) - arithmetic.constant(NEAR)
