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

from chasles.lowering.evaluate import Arithmetic, decimals
from chasles.lowering.program import Op, Program, Step
from chasles.lowering.request import Request
from chasles.statements.kernel import places_of
from chasles.vocabulary import Node

__all__ = ["losses", "points_of", "stable", "steady"]

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
    return steady(programs, [_point(request, dict.fromkeys(angles, value)) for value in ANGLES])


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
    """For each result a bound on its error, in roundoffs of its largest entry; infinite where it has no value."""
    arithmetic = decimals(DIGITS)
    running = _Running(arithmetic, inputs)
    values: list[_Rounded] = []
    for step in program.steps:
        if step.op is Op.INPUT:
            values.append(_Rounded(running.inputs[step.argument][step.entry], 0))
        elif step.op is Op.CONSTANT:
            values.append(_Rounded(arithmetic.constant(step.value), 0))
        elif step.op is Op.MULTIPLY and _is_power_of_two(program.steps[step.operands[0]]):
            factor, other = (values[k] for k in step.operands)
            values.append(_Rounded(factor.value * other.value, abs(factor.value) * other.error))
        else:
            values.append(running.step(step.op, [values[k] for k in step.operands]))
    found = []
    for result in program.results:
        size = max(abs(values[k].value) for k in result.entries)
        error = max(values[k].error for k in result.entries)
        found.append(float(error / size) if size and math.isfinite(float(error / size)) else math.inf)
    return found


def _is_power_of_two(step: Step) -> bool:
    if step.op is not Op.CONSTANT:
        return False
    above, below = step.value.numerator, step.value.denominator
    return above > 0 and above & (above - 1) == 0 and below & (below - 1) == 0


@dataclass(frozen=True, slots=True)
class _Rounded:
    """A value, and a bound on its error in units of the roundoff."""

    value: Any
    error: Any


class _Running:
    """Steps on values with their bounds."""

    def __init__(self, arithmetic: Arithmetic, inputs: Sequence[Sequence[Any]]) -> None:
        self.arithmetic = arithmetic
        self.inputs = inputs

    def step(self, op: Op, of: list[_Rounded]) -> _Rounded:
        """One step; a comparison and a selection round nothing."""
        match op:
            case Op.NOT_A_NUMBER:
                return _Rounded(self.arithmetic.nan, math.inf)
            case Op.LESS:
                return _Rounded(of[0].value < of[1].value, 0)
            case Op.EQUAL:
                return _Rounded(of[0].value == of[1].value, 0)
            case Op.SELECT:
                return of[1] if of[0].value else of[2]
            case Op.NEGATE:
                return _Rounded(-of[0].value, of[0].error)
            case Op.ADD | Op.SUBTRACT:
                value = of[0].value + of[1].value if op is Op.ADD else of[0].value - of[1].value
                return _Rounded(value, of[0].error + of[1].error + abs(value))
            case Op.MULTIPLY:
                x, y = of
                value = x.value * y.value
                return _Rounded(value, abs(x.value) * y.error + abs(y.value) * x.error + abs(value))
            case Op.DIVIDE:
                return self._quotient(of[0], of[1])
            case _:
                return self._function(op, of)

    def _quotient(self, x: _Rounded, y: _Rounded) -> _Rounded:
        value = self.arithmetic.divide(x.value, y.value)
        if not y.value:
            return _Rounded(value, math.inf)
        return _Rounded(value, (x.error + abs(value) * y.error) / abs(y.value) + abs(value))

    def _function(self, op: Op, of: list[_Rounded]) -> _Rounded:
        value = getattr(self.arithmetic, op.value)(*(x.value for x in of))
        match op:
            case Op.SQUARE_ROOT:
                carried = of[0].error / (2 * value) if value else math.inf
            case Op.SINE:
                carried = abs(self.arithmetic.cosine(of[0].value)) * of[0].error
            case Op.COSINE:
                carried = abs(self.arithmetic.sine(of[0].value)) * of[0].error
            case _:
                y, x = of
                square = x.value * x.value + y.value * y.value
                carried = (abs(x.value) * y.error + abs(y.value) * x.error) / square if square else math.inf
        return _Rounded(value, carried + abs(value))


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


def _point(request: Request, angles: dict[Node, Any]) -> list[list[Any]]:
    """Values of the arguments: the angles as given, unit vectors of unit length, the rest at large."""
    arithmetic = decimals(DIGITS)
    units = {h.subjects[0] for h in request.hypotheses if h.kind == "unit"}
    values: dict[Node, list[Any]] = {}
    drawn = 0
    for node in request.of:
        size = node.shape[0] * node.shape[1]
        numbers = _numbers(drawn, size)
        drawn += size
        if node in angles:
            values[node] = [_angle(angles[node], arithmetic)]
        elif node in units:
            length = arithmetic.square_root(arithmetic.constant(sum((x * x for x in numbers), Fraction(0))))
            values[node] = [arithmetic.constant(x) / length for x in numbers]
        else:
            values[node] = [arithmetic.constant(x) for x in numbers]
    return [[values[node][i * node.shape[1] + j] for node, i, j in places_of(a)] for a in request.arguments]


def _numbers(start: int, count: int) -> list[Fraction]:
    """Numbers of no particular kind, always the same."""
    return [Fraction((7 * k * k + 5 * k) % 31 - 15, 11) + Fraction(1, 7) for k in range(start, start + count)]


def _angle(value: Fraction | str, arithmetic: Arithmetic) -> Any:
    if isinstance(value, Fraction):
        return arithmetic.constant(value)
    half_turn = arithmetic.arctangent2(arithmetic.constant(Fraction(0)), arithmetic.constant(Fraction(-1)))
    return (half_turn if value == "pi" else half_turn / 2) - arithmetic.constant(NEAR)
