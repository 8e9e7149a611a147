"""How much does a program lose by rounding? A bound that runs with it, at points where formulas are apt to fail.

Each step adds half a unit in the last place of its value to what its operands bring along (to first order, each taken
at its worst). It runs in double precision, as the analysis is meant to: where the computed value is wrong, its bound is
as large. Compared are programs for one request: one that loses many times what another loses, at some point, does
so for no reason.
"""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import dataclass
from fractions import Fraction
from math import pi, prod
from typing import Any

import numpy as np
from numpy.typing import NDArray

from chasles.lowering.arithmetic import Operators, decimals, evaluated
from chasles.lowering.functions import FUNCTIONS
from chasles.lowering.program import Op, Program, is_power_of_two

Numbers = NDArray[np.float64]
Points = Mapping[tuple[int, int], Numbers]
"""For each entry of each argument its values, one a point."""
FEW = 16
"""Roundoffs that are no loss of digits, whatever another program does."""
TIMES = 4
"""How many times the smallest of the bounds is still as good: roundings that differ, and not digits that are lost."""
HALF = 2**26
"""As many times are half of the digits."""
NEAR = 1e-12
ANGLES = (1.3, NEAR, pi - NEAR, pi / 2 - NEAR, 3.4, NEAR - pi / 2, pi / 4 - NEAR)
"""At large, near zero, near half a turn, near right angles and near half of one."""
SCALES = (1.0, 1e-3, 1e3)
"""By how much the inputs are scaled of a program of which no more is known."""


def steady(programs: Sequence[Program], points: Points, stated: Program | None = None) -> list[Program]:
    """The programs that lose at none of the points much more than the best of them does there; all if there is none.

    None of them loses much more at any point than the one `stated`, which is among them; where all that are left
    lose half of the digits that another one keeps, what is much is more (`TIMES` to the third).
    """
    table = {program: losses(program, points) for program in programs}
    least = np.min(list(table.values()), axis=0)
    found = [_steady(table, stated, times) for times in (TIMES, TIMES**3)]
    return next((kept for kept in found if any(_is_fair(table[each], least, HALF) for each in kept)), found[0])


def _steady(table: Mapping[Program, Numbers], stated: Program | None, times: int) -> list[Program]:
    rows = {p: row for p, row in table.items() if stated is None or _is_fair(row, table[stated], times)}
    least = np.min(list(rows.values()), axis=0)
    return [program for program, row in rows.items() if _is_fair(row, least, times)] or list(rows)


def _is_fair(row: Numbers, least: Numbers, times: int) -> bool:
    return bool(np.all(row <= np.maximum(FEW, times * least)))


def points_of(program: Program) -> Points:
    """Inputs of a program of which no more is known: large and small ones, those of angles as formulas dislike them."""
    angular = angular_entries(program)
    places = [(k, entry) for k, item in enumerate(program.arguments) for entry in range(prod(item.shape))]
    angles = ANGLES if angular else ()
    scales = np.array([*(1.0 for _ in angles), *SCALES])
    values = {place: float(x) * scales for place, x in zip(places, generic_numbers(0, len(places)), strict=True)}
    for place in angular:
        values[place][: len(angles)] = angles
    return values


def losses(program: Program, points: Points) -> Numbers:
    """For each result (rows) and point a bound on its error, in roundoffs of its largest entry; infinite without value.

    The running error analysis of Higham, Accuracy and Stability of Numerical Algorithms (2002), section 3.3.
    """
    count = len(next(iter(points.values()), ()))
    with np.errstate(all="ignore"):
        values = evaluated(program.steps, RunningErrors(), lambda argument, entry: Rounded(points[argument, entry]))
        found = [_loss([values[k] for k in result.entries]) for result in program.results]
        return np.array([np.broadcast_to(loss, count) for loss in found])


def _loss(entries: Sequence[Rounded]) -> Numbers:
    error = np.max(np.broadcast_arrays(*(entry.error for entry in entries)), axis=0)
    size = np.max(np.broadcast_arrays(*(np.abs(entry.value) for entry in entries)), axis=0)
    found: Numbers = np.where((size > 0) & np.isfinite(error / size), error / size, np.inf)
    return found


@dataclass(frozen=True, slots=True)
class Rounded:
    """Values, and bounds on their errors in units of the roundoff; what they `only_scale` is not rounded by them."""

    value: Any
    error: Any = 0.0
    only_scales: bool = False


class RunningErrors:
    """Numbers with bounds on their errors: what operands bring along to first order, and half a unit of the result."""

    def constant(self, value: Fraction) -> Rounded:
        """A constant counts as exact."""
        return Rounded(np.float64(value), only_scales=is_power_of_two(value))

    def not_a_number(self) -> Rounded:
        """What has no value has lost all digits."""
        return Rounded(np.float64(np.nan), np.inf)

    def add(self, x: Rounded, y: Rounded) -> Rounded:
        return _rounded(x.value + y.value, x.error + y.error)

    def subtract(self, x: Rounded, y: Rounded) -> Rounded:
        return _rounded(x.value - y.value, x.error + y.error)

    def negate(self, x: Rounded) -> Rounded:
        return Rounded(-x.value, x.error)

    def multiply(self, x: Rounded, y: Rounded) -> Rounded:
        """The product; that with a power of two is not rounded."""
        if x.only_scales:
            return Rounded(x.value * y.value, np.abs(x.value) * y.error)
        return _rounded(x.value * y.value, np.abs(x.value) * y.error + np.abs(y.value) * x.error)

    def divide(self, x: Rounded, y: Rounded) -> Rounded:
        value = x.value / y.value
        return _rounded(value, (x.error + np.abs(value) * y.error) / np.abs(y.value))

    def square_root(self, x: Rounded) -> Rounded:
        value = np.sqrt(x.value)
        return _rounded(value, np.where(value > 0, x.error / (2 * value), np.inf))

    def sine(self, x: Rounded) -> Rounded:
        return _rounded(np.sin(x.value), np.abs(np.cos(x.value)) * x.error)

    def cosine(self, x: Rounded) -> Rounded:
        return _rounded(np.cos(x.value), np.abs(np.sin(x.value)) * x.error)

    def arctangent2(self, y: Rounded, x: Rounded) -> Rounded:
        carried = (np.abs(x.value) * y.error + np.abs(y.value) * x.error) / (x.value**2 + y.value**2)
        return _rounded(np.arctan2(y.value, x.value), np.where(np.isnan(carried), np.inf, carried))

    def less(self, x: Rounded, y: Rounded) -> Rounded:
        return Rounded(x.value < y.value)

    def equal(self, x: Rounded, y: Rounded) -> Rounded:
        return Rounded(x.value == y.value)

    def select(self, condition: Rounded, if_true: Rounded, if_false: Rounded) -> Rounded:
        chosen = (np.where(condition.value, a, b) for a, b in zip(_parts(if_true), _parts(if_false), strict=True))
        return Rounded(*chosen)

    def function(self, name: str, *operands: Rounded) -> Rounded:
        """The value of a function, and the errors of its operands times its rates."""
        numbers, plain, known = [x.value for x in operands], _Doubles(), FUNCTIONS[name].rates
        value = plain.function(name, *numbers)
        slopes = (np.inf,) * len(operands) if known is None else known(plain, value, *numbers)
        carried = sum(np.where(x.error, np.abs(s) * x.error, 0) for s, x in zip(slopes, operands, strict=True))
        return Rounded(value, carried) if FUNCTIONS[name].exact else _rounded(value, carried + np.abs(value))


class _Doubles(Operators):
    """Numbers without bounds, in which rates are evaluated."""

    constant = staticmethod(np.float64)
    square_root = staticmethod(np.sqrt)
    sine = staticmethod(np.sin)
    cosine = staticmethod(np.cos)
    arctangent2 = staticmethod(np.arctan2)
    select = staticmethod(np.where)  # type: ignore[assignment]

    def not_a_number(self) -> Any:
        return np.float64(np.nan)

    def function(self, name: str, *operands: Any) -> Any:
        """The values of a function of the table, NaN where it has none."""
        exact = decimals(15)

        def at(*numbers: float) -> float:
            return float(exact.function(name, *map(exact.context.mpf, numbers)))

        return np.vectorize(at, otypes=[float])(*operands)


def _parts(x: Rounded) -> tuple[Any, Any]:
    return x.value, x.error


def _rounded(value: Any, carried: Any) -> Rounded:
    return Rounded(value, carried + np.abs(value))


def angular_entries(program: Program) -> set[tuple[int, int]]:
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


def generic_numbers(start: int, count: int) -> list[Fraction]:
    """Numbers of no particular kind, always the same."""
    return [Fraction((7 * k * k + 5 * k) % 31 - 15, 11) + Fraction(1, 7) for k in range(start, start + count)]
