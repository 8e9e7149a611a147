"""How much does each rounding move an entry? Derivatives backwards through the program, over many boxes of inputs.

An entry differs from its exact value by the sum, over all operations, of the operation's error times the entry's
derivative by it, taken somewhere between (mean value theorem). The derivative is enclosed over the box and over all
values that rounding can lead to, so that the sum of sizes is a bound without any remainder. Errors that cancel in an
entry, as those of a cosine that enters twice, are seen to; but a product that enters several sums may be rounded for
one of them and contracted with another, so that its errors there count one by one.

The derivatives are those of the reverse mode: Griewank and Walther, Evaluating Derivatives, 2008, section 3.2.
"""

from __future__ import annotations

from collections.abc import Callable, Iterator, Sequence
from dataclasses import dataclass
from fractions import Fraction
from functools import partial

import numpy as np

from chasles.bounds.functions import slope as slope_name
from chasles.bounds.intervals import SAFE, Array, Interval, below, function_of
from chasles.bounds.running import Running
from chasles.lowering.program import Op, Step

Group = tuple[int, ...]
"""Steps that hold the entries of one result and one physical dimension."""


@dataclass(frozen=True, slots=True, eq=False)
class _Slope:
    """A derivative: a power of t times an interval; `contracted` where it is by way of a sum that may take it up."""

    power: int
    value: Interval
    contracted: bool = False


def entry_error(running: Running, entry: int, power: int) -> Array:
    """A bound on the error of the entry that a step holds, as a multiple of a power of t.

    Not a number where the error grows faster than that power.
    """
    total = running.zero
    one = running.zero + 1
    slopes: dict[int, list[_Slope]] = {entry: [_Slope(0, Interval(one, one))]}
    with np.errstate(all="ignore"):
        for number in reversed(running.outline.needed):
            if number not in slopes:
                continue
            found = slopes.pop(number)
            if number in running.losses:
                moved = _moved(running, number, found, power)
                running.weigh(number, moved)
                total = (total + moved) * SAFE
            for operand, given in _passed_on(running, number, found):
                if operand in running.rounded:
                    slopes.setdefault(operand, []).append(given)
    return total


def _moved(running: Running, number: int, found: list[_Slope], power: int) -> Array:
    """How far the step's own error moves the entry."""
    slope = _sum(running, found)
    grown = slope.power + running.around[number].power
    if grown < power:
        return running.zero + np.nan
    size = slope.value.above
    if running.outline.program.steps[number].op is Op.MULTIPLY and len(found) > 1:
        apart = [given for given in found if not given.contracted]
        sizes = [_sum(running, apart)] if apart else []
        sizes += [given for given in found if given.contracted]
        size = sum((s.value.above for s in sizes), running.zero) * SAFE
    return size * running.losses[number] * SAFE


def _sum(running: Running, found: list[_Slope]) -> _Slope:
    power = min(slope.power for slope in found)
    total = running.lowered(found[0].value, found[0].power, power)
    for slope in found[1:]:
        total = total + running.lowered(slope.value, slope.power, power)
    return _Slope(power, total)


def _passed_on(running: Running, number: int, found: list[_Slope]) -> Iterator[tuple[int, _Slope]]:
    """The derivatives by the operands."""
    step = running.outline.program.steps[number]
    op, operands = step.op, running.outline.operands(number)
    if number in running.outline.angles or running.rounded.isdisjoint(operands):
        return
    if op is Op.NEGATE:
        yield from ((operands[0], _Slope(s.power, -s.value, s.contracted)) for s in found)
        return
    slope = _sum(running, found)
    if op is Op.SELECT:
        yield from _to_chosen(running, operands, slope)
        return
    near = [running.around[k] for k in operands]
    match op:
        case Op.ADD | Op.SUBTRACT:
            yield operands[0], _Slope(slope.power, slope.value, contracted=True)
            second = slope.value if op is Op.ADD else -slope.value
            yield operands[1], _Slope(slope.power, second, contracted=True)
        case Op.MULTIPLY:
            for k, other in zip(operands, near[::-1], strict=True):
                yield k, _Slope(slope.power + other.power, slope.value * other.value)
        case Op.DIVIDE:
            above, below = near
            shared = _Slope(slope.power - below.power, slope.value / below.value)
            yield operands[0], shared
            yield (
                operands[1],
                _Slope(shared.power + above.power - below.power, shared.value * -(above.value / below.value)),
            )
        case Op.SQUARE_ROOT:
            yield operands[0], _Slope(slope.power, slope.value / near[0].value.root.times(2.0))
        case _:
            values = [value.value for value in near]
            for operand, by in zip(operands, _slopes(step, values), strict=True):
                if operand in running.rounded:
                    yield operand, _Slope(slope.power, slope.value * by())


def _to_chosen(running: Running, operands: tuple[int, ...], slope: _Slope) -> Iterator[tuple[int, _Slope]]:
    """The derivatives by the two values of a choice."""
    truth, nothing = running.truths[operands[0]], Interval(running.zero, running.zero)
    for k, may, may_not in ((operands[1], truth.may, truth.may_not), (operands[2], truth.may_not, truth.may)):
        given = slope.value.union(nothing)
        low = np.where(may, np.where(may_not, given.low, slope.value.low), 0.0)
        high = np.where(may, np.where(may_not, given.high, slope.value.high), 0.0)
        yield k, _Slope(slope.power, Interval(low, high))


def _slopes(step: Step, of: list[Interval]) -> list[Callable[[], Interval]]:
    """The derivatives of a function by its operands."""
    match step.op:
        case Op.SINE:
            return [lambda: function_of("cosine", of[0])]
        case Op.COSINE:
            return [lambda: -function_of("sine", of[0])]
        case Op.ARCTANGENT2:
            y, x = of
            square = x.squared + y.squared
            return [lambda: x / square, lambda: -(y / square)]
        case _ if step.function == "fabs":
            low, high = np.where(of[0].low < 0, -1.0, 1.0), np.where(of[0].high > 0, 1.0, -1.0)
            return [lambda: Interval(low, high)]
        case _:
            return [partial(function_of, slope_name(step.function, k), *of) for k in range(len(of))]


def against_largest(running: Running, groups: Sequence[Group], unit: Fraction, enough: float = 0.0) -> Array:
    """In each box the largest ratio, over groups, of an entry's error to the largest entry, in units of the roundoff.

    Infinite in boxes that are too large for a bound. A ratio is not made smaller where it is small `enough`.
    """
    found = running.zero
    with np.errstate(all="ignore"):
        for group in groups:
            found = np.maximum(found, _ratio(running, group, enough * float(unit)))
    return np.where(running.bad | np.isnan(found), np.inf, found) / float(unit) * SAFE


def errors(running: Running, group: Group, power: int, enough: Array) -> Array:
    """The largest error of the group's entries, as a multiple of a power of t; what is small enough is left so."""
    error = running.zero
    first = {k: running.values[k].error for k in group}
    for number in sorted(first, key=lambda k: -float(np.nan_to_num(first[k], posinf=1e300, nan=1e300).max())):
        wide = ~(first[number] <= np.maximum(error, enough)) & ~running.bad & ~running.empty
        rows, finer = np.flatnonzero(wide), first[number].copy()
        if len(rows):
            part = running.part(rows, number)
            finer[rows] = np.fmin(finer[rows], entry_error(part, number, power))
            running.split[0][rows], running.split[1][rows] = part.split
            running._weight[rows] = part._weight
        error = np.maximum(error, finer)
    return error


def _ratio(running: Running, group: Group, enough: float) -> Array:
    power = min(running.values[k].power for k in group)
    size = running.zero
    for k in group:
        value = running.values[k]
        if value.power == power:
            size = np.maximum(size, value.value.below)
    size = below(size)
    error = errors(running, group, power, enough * size)
    return np.where(error == 0, 0, error / size * SAFE)
