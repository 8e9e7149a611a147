"""Which values does a kernel's self-test know? Plain inputs, and the results to twenty digits.

That the program is right is proved; these values show that a compiler and a machine make of it what it says.
"""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from fractions import Fraction
from itertools import chain, cycle, islice
from math import prod
from typing import Any

from chasles.lowering.arithmetic import decimals, run
from chasles.lowering.program import Argument, Program
from chasles.lowering.request import Request
from chasles.statements import Packed, Stack
from chasles.targets.kernel import Check, Exact

DIGITS = 20
GUARDS = 20
"""Digits that the evaluation has beyond those that are shown."""
Point = tuple[tuple[Fraction, ...], ...]

UNITS = ((1, 2, 2, 3), (0, 3, 4, 5))
"""Unit vectors: three entries, each over the fourth number. Others come from stereographic projection."""
ROTATIONS = ((2, -1, 2, 2, 2, -1, -1, 2, 2, 3), (3, -4, 0, 4, 3, 0, 0, 0, 5, 5))
"""Rotations: nine entries, row-major, each over the tenth number."""
NUMBERS = tuple(Fraction(quarters, 4) for quarters in (5, 2, -3, 8, -6, 1, 7, -2, 3, -5, 6))
"""What other entries are filled with; floats hold them exactly."""


def checks_of(request: Request, program: Program) -> tuple[Check, ...]:
    """Two points that satisfy what is said of units and rotations, and one where all else is zero if it is singular."""
    made = [_check(program, point) for point in (*_points(request, program.arguments), _at_zero(request, program))]
    return tuple(check for k, check in enumerate(made) if check is not None and (k < 2 or _is_singular(check)))


def _points(request: Request, arguments: Sequence[Argument]) -> Iterator[Point]:
    kinds = _kinds(request)
    for k in range(2):
        numbers = islice(cycle(NUMBERS), 3 * k, None)
        yield tuple(
            _special(kinds[place], place + k, prod(argument.shape)) or tuple(islice(numbers, prod(argument.shape)))
            for place, argument in enumerate(arguments)
        )


def _at_zero(request: Request, program: Program) -> Point:
    kinds = _kinds(request)
    return tuple(
        _special(kinds[place], place, prod(argument.shape)) or (Fraction(0),) * prod(argument.shape)
        for place, argument in enumerate(program.arguments)
    )


def _kinds(request: Request) -> list[str]:
    """For each argument whether it is a unit vector, a rotation, or anything else: ''."""
    said = {subject: h.kind for h in request.hypotheses for subject in h.subjects if h.kind == "unit"}
    return [
        "" if isinstance(item, Stack | Packed) else "rotation" if item.shape == (3, 3) else said.get(item, "")
        for item in request.arguments
    ]


def _special(kind: str, choice: int, size: int) -> tuple[Fraction, ...]:
    """A unit column or a rotation; nothing for another kind."""
    if kind == "unit" and size != 3:
        plane = NUMBERS[choice % len(UNITS) :][: size - 1]
        square = sum((entry * entry for entry in plane), Fraction(0))
        return (*(2 * entry / (1 + square) for entry in plane), (square - 1) / (square + 1))
    table = {"unit": UNITS, "rotation": ROTATIONS}.get(kind)
    if table is None:
        return ()
    *entries, divisor = table[choice % len(table)]
    return tuple(Fraction(entry, divisor) for entry in entries)


def _check(program: Program, point: Point) -> Check | None:
    """The results at the point; none where one is infinite."""
    arithmetic = decimals(DIGITS + GUARDS)
    inputs = [[arithmetic.constant(entry) for entry in entries] for entries in point]
    results = run(program, inputs, arithmetic)
    if any(abs(entry) == arithmetic.infinity for entry in chain.from_iterable(results)):
        return None
    return Check(point, tuple(tuple(map(_shown, entries)) for entries in results))


def _shown(value: Any) -> Exact:
    """A number of many digits as a numeral; NaN is the one number that differs from itself."""
    return "nan" if value != value else str(value.context.nstr(value, DIGITS))


def _is_singular(check: Check) -> bool:
    return any("nan" in entries for entries in check.outputs)
