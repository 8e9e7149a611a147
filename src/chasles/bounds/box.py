"""What is proved of a program's errors over a box of inputs? For any program, choices between cases among its steps.

The box is halved where its bound is much larger than at a point. What a range holds that the program has no value for,
as a divisor that is zero, is an error that names the range.
"""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass
from math import prod
from typing import Any

import numpy as np

from chasles.bounds.intervals import SAFE, Array, Interval, below, halves
from chasles.bounds.model import Model, precision
from chasles.bounds.outline import NoBound, Outline, with_cases
from chasles.bounds.places import Scaled
from chasles.bounds.running import Running, no_angles
from chasles.bounds.sensitivity import entry_error
from chasles.lowering.passes.series import expanded_in_series
from chasles.lowering.program import Op, Program

BOXES = 4000
CLOSE = 1.1
"""How much larger than at a point the bound over all boxes may be, as long as there are boxes left."""
WHY = {
    Op.DIVIDE: "it divides by what may be zero",
    Op.SQUARE_ROOT: "it takes the root of what may be zero or negative",
    Op.ARCTANGENT2: "it takes the angle of a point that may be the origin, or where the angle jumps",
    Op.FUNCTION: "it takes a function where that may have no value, or changes without bound",
}


@dataclass(frozen=True, slots=True, eq=False)
class ResultBound:
    """The computed entries of a result are within `absolute` of the exact ones, entry by entry.

    And within `units` roundoffs of the largest entry; infinite where all entries may be zero.
    """

    name: str
    absolute: Array
    units: float


@dataclass(frozen=True, slots=True)
class BoxBound:
    """What is proved for all inputs of the `box`, one bound a result; `roundoff` is that of the precision."""

    results: tuple[ResultBound, ...]
    box: str
    roundoff: float

    def __getitem__(self, name: str) -> ResultBound:
        """The bound of a result. Raises KeyError for a name that none has."""
        for result in self.results:
            if result.name == name:
                return result
        raise KeyError(f"there is no result {name!r}: the results are {', '.join(r.name for r in self.results)}")

    def __str__(self) -> str:
        lines = []
        for result in self.results:
            relative = f", {result.units:.4g} u of its largest entry" if np.isfinite(result.units) else ""
            lines.append(f"{result.name}: within {result.absolute.max():.4g} of the exact value{relative}")
        return "\n".join([*lines, f"for {self.box}; u = 2^{round(np.log2(self.roundoff))}"])


def bound_of_program(
    program: Program, box: Mapping[str, Any], dtype: Any = np.float64, *, in_numpy: bool = False
) -> BoxBound:
    """How far the program's results are from their exact values for all floats of a box, in float64 or float32.

    The box gives each argument, by name, a number or a pair (low, high); the ends of an array's entries are numbers or
    arrays of its shape. The rounding model is that of `chasles.bounds`, with gradual underflow. Where results are not a
    number nothing is said. Functions are those of the C library, or what is in NumPy.

    Raises:
        ValueError: for a box that does not fit the program (NoBound where no bound can be proved over it: a divisor
            that may be zero, a root of what may be negative, numbers beyond the precision).
        ModuleNotFoundError: for a program with sines, cosines, arctangents or functions of libm, without python-flint.
    """
    model, largest = precision(dtype, in_numpy=in_numpy)
    low, high = _ends(program, box)
    program = expanded_in_series(program, most=2)
    try:
        outline = with_cases(program)
        errors, units = _Search(outline, model, largest).run(low, high)
    except NoBound as reason:
        raise NoBound(f"{program.name}: no error bound is proved for {_said(program, box)}: {reason}") from None
    results, place = [], 0
    for k, result in enumerate(program.results):
        size = len(result.entries)
        results.append(ResultBound(result.name, errors[place : place + size].reshape(result.shape), float(units[k])))
        place += size
    return BoxBound(tuple(results), _said(program, box), float(model.roundoff))


def _ends(program: Program, box: Mapping[str, Any]) -> tuple[Array, Array]:
    """The ends of all numbers that go in, in their order."""
    names = [argument.name for argument in program.arguments]
    strange = [name for name in box if name not in names]
    missing = [name for name in names if name not in box]
    if strange or missing:
        said = f"it lacks {', '.join(missing)}" if missing else f"there is no argument {strange[0]!r}"
        raise ValueError(f"{program.name}: the box must give a range to each of {', '.join(names)}; {said}")
    lows, highs = [], []
    for argument in program.arguments:
        given = box[argument.name]
        pair = given if isinstance(given, tuple) else (given, given)
        try:
            low, high = (np.broadcast_to(np.asarray(end, float), argument.shape).ravel() for end in pair)
        except (TypeError, ValueError):
            wanted = f"numbers or arrays of shape {argument.shape}" if argument.shape else "numbers"
            raise ValueError(f"{program.name}: {argument.name} must be a pair (low, high) of {wanted}") from None
        if not (np.isfinite(low) & np.isfinite(high) & (low <= high)).all():
            raise ValueError(f"{program.name}: {argument.name} must have finite ends, the lower one first, not {given}")
        lows.append(low)
        highs.append(high)
    return np.concatenate(lows), np.concatenate(highs)


def _said(program: Program, box: Mapping[str, Any]) -> str:
    parts = []
    for argument in program.arguments:
        given = box[argument.name]
        ranged = isinstance(given, tuple)
        parts.append(f"{argument.name} in [{given[0]}, {given[1]}]" if ranged else f"{argument.name} = {given}")
    return ", ".join(parts)


class _Search:
    """The boxes, a row each, halved until the bounds of all entries are near those at points."""

    def __init__(self, outline: Outline, model: Model, largest: float) -> None:
        self._outline, self._model, self._largest = outline, model, largest
        shapes = [prod(argument.shape) for argument in outline.program.arguments]
        self._places = [(k, entry) for k, size in enumerate(shapes) for entry in range(size)]

    def run(self, low: Array, high: Array) -> tuple[Array, Array]:
        """The largest error of each entry, and of each result in roundoffs of its largest entry."""
        whole = np.where(high > low, high - low, 1.0)
        lows, highs, spent, found = low[None, :], high[None, :], 0, None
        reached = np.zeros(1)
        while True:
            bounds, _ = self._bounds(lows, highs)
            spent += len(lows)
            middle = (lows + highs) / 2
            points, _ = self._bounds(middle, middle)
            reached = np.maximum(reached, np.where(np.isfinite(points), points, 0).max(axis=0))
            narrow = (highs - lows <= 2**-40 * whole).all(axis=1)
            done = (bounds <= CLOSE * reached).all(axis=1) | narrow
            if spent > BOXES or (spent > BOXES / 8 and self._settled(bounds, reached)):
                done[:] = True
            most = np.max(bounds[done], axis=0, initial=0.0)
            found = most if found is None else np.maximum(found, most)
            if done.all():
                break
            lows, highs = lows[~done], highs[~done]
            lows, highs = halves(lows, highs, (highs - lows) / whole)
        entries = sum(len(result.entries) for result in self._outline.program.results)
        if not np.isfinite(found[:entries]).all():
            raise NoBound(self._why(low, high, whole))
        return found[:entries], found[entries:]

    def _settled(self, bounds: Array, reached: Array) -> bool:
        """Whether all that is not known well is beyond being known: relative errors of what may be zero."""
        wide = (bounds > CLOSE * reached) & np.isfinite(bounds)
        return not wide.any() and bool(np.isinf(bounds).any())

    def _running(self, lows: Array, highs: Array) -> Running:
        zero = np.zeros(len(lows))
        inputs = {
            place: Scaled(0, Interval(lows[:, k].copy(), highs[:, k].copy()), zero)
            for k, place in enumerate(self._places)
        }
        return Running(self._outline, self._model, inputs, no_angles, len(lows))

    def _bounds(self, lows: Array, highs: Array) -> tuple[Array, Running]:
        """A row for each box: the errors of all entries, then the relative ones of results."""
        running = self._running(lows, highs)
        bad = running.bad.copy()
        known: dict[int, Array] = {}
        columns, relative = [], []
        with np.errstate(all="ignore"):
            for near in running.around.values():
                bad |= near.value.above > self._largest
            for k in range(len(self._outline.program.results)):
                numbers = self._outline.entries(k)
                for number in numbers:
                    if number not in known:
                        coarse = running.values[number].error
                        fine = entry_error(running, number, 0) if number in running.rounded else running.zero
                        known[number] = np.where(bad | np.isnan(coarse), np.inf, np.fmin(coarse, fine))
                    columns.append(known[number])
                size = below(np.max([running.values[number].value.below for number in numbers], axis=0))
                error = np.max([known[number] for number in numbers], axis=0)
                ratio = np.where(error == 0, 0, error / size) / float(self._model.roundoff) * SAFE
                relative.append(np.where(np.isnan(ratio), np.inf, ratio))
        return np.stack([*columns, *relative], axis=1), running

    def _why(self, low: Array, high: Array, whole: Array) -> str:
        """What is the matter, and about where."""
        lows, highs = low[None, :], high[None, :]
        for _ in range(40 * len(low)):
            bounds, running = self._bounds(lows, highs)
            wrong = np.flatnonzero(running.bad)
            rows = wrong if len(wrong) else np.flatnonzero(~np.isfinite(bounds).all(axis=1))
            if not len(rows):
                break
            last = lows[rows[0]], highs[rows[0]], int(running.why[rows[0]])
            lows, highs = lows[rows[:1]], highs[rows[:1]]
            lows, highs = halves(lows, highs, (highs - lows) / whole)
        steps, names = self._outline.program.steps, self._outline.program.arguments
        why = WHY.get(steps[last[2]].op, "numbers are too large") if last[2] >= 0 else "numbers are too large"
        where = [
            f"{names[a].name}{f'[{entry}]' if names[a].shape else ''} near {(x + y) / 2:.4g}"
            for (a, entry), x, y in zip(self._places, *last[:2], strict=True)
        ]
        return f"{why}, {', '.join(where)}"
