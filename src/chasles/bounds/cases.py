"""A program that chooses between cases by comparing rounded values: one straight line of steps for each case.

Which case is taken may depend on rounding; compared with the formula of the case that is taken, each has a bound. Where
a case is taken, something is known of its sums: that they do not cancel is found by covering all rotations.
"""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import dataclass
from fractions import Fraction
from itertools import product

import numpy as np
from numpy.typing import NDArray

from chasles.bounds.intervals import SAFE, Array, Interval, below
from chasles.bounds.model import Model
from chasles.bounds.outline import NoBound, Outline, is_sign, outlined, reached
from chasles.bounds.places import Scaled
from chasles.bounds.rotations import enclosed_forms, forms
from chasles.bounds.running import Running, no_angles
from chasles.bounds.sensitivity import entry_error
from chasles.bounds.termwise import TermwiseError, termwise_errors
from chasles.lowering.program import Op, Program
from chasles.lowering.scales import is_scale

SLACK = 2.0**-21
"""How far a rotation's entries may be from those of one: some roundoffs of single precision."""
CLOSE = 1.6
VANISHING = 2.0**-16
"""A sum that errs by more, relatively, at some point is taken to vanish somewhere."""
ROUNDS = 5
FEW = 6
"""The most comparisons a program may make: every combination of outcomes is a case."""

Truths = Mapping[int, bool]


@dataclass(frozen=True, slots=True, eq=False)
class CaseOutline:
    """The steps of a case, and the outcomes of comparisons that lead to it."""

    outline: Outline
    truths: tuple[Truths, ...]


def cases(program: Program) -> tuple[CaseOutline, ...]:
    """The cases of a program. Raises NoBound for too many comparisons, and for others than of two computed values."""
    choices = _choices(program)
    if len(choices) > FEW:
        raise NoBound("it chooses between cases by values that are rounded")
    found: dict[tuple[object, ...], tuple[Outline, list[Truths]]] = {}
    for outcome in product((True, False), repeat=len(choices)):
        truths = dict(zip(choices, outcome, strict=True))
        outline = outlined(program, truths)
        entries = tuple(map(outline.entries, range(len(program.results))))
        key = outline.needed, tuple(outline.operands(k) for k in outline.needed), entries
        found.setdefault(key, (outline, []))[1].append(truths)
    return tuple(CaseOutline(outline, tuple(truths)) for outline, truths in found.values())


def _choices(program: Program) -> tuple[int, ...]:
    """The comparisons of computed values by which cases are chosen, those of a scale left out."""
    steps = program.steps
    entries = (k for result in program.results for k in result.entries)
    needed = reached(entries, lambda number: () if is_scale(steps, number) else steps[number].operands)
    choices = (k for k in needed if steps[k].op is Op.SELECT and not (is_scale(steps, k) or is_sign(k, program)))
    compared = {steps[k].operands[0] for k in choices}
    return tuple(sorted(k for k in compared if steps[k].op is Op.LESS))


def errors_of_case(case: CaseOutline, model: Model, rotation: int | None) -> dict[int, TermwiseError]:
    """The errors of a case's steps, given that one of the arguments is a rotation. Raises NoBound."""
    if rotation is None:
        return termwise_errors(case.outline, model)
    sums = _sums(case.outline, rotation)
    return termwise_errors(case.outline, model, rotations(case, sums, rotation, model))


def _sums(outline: Outline, argument: int) -> tuple[int, ...]:
    """The sums of entries of one argument that are no single terms."""
    steps, alone = outline.program.steps, set[int]()
    found: list[int] = []
    for number in outline.needed:
        step, operands = steps[number], outline.operands(number)
        if (step.op is Op.INPUT and step.argument == argument) or step.op is Op.CONSTANT:
            alone.add(number)
        elif step.op is Op.MULTIPLY and alone.issuperset(operands):
            if any(steps[k].op is Op.CONSTANT for k in operands):
                alone.add(number)
        elif step.op in (Op.ADD, Op.SUBTRACT) and alone.issuperset(operands):
            alone.add(number)
            found = [k for k in found if k not in operands] + [number] * _is_mixed(outline, operands)
    return tuple(found)


def _is_mixed(outline: Outline, operands: tuple[int, ...]) -> bool:
    """Whether a sum of these is one of rounded values."""
    exact = {Op.INPUT, Op.CONSTANT}
    return any(outline.program.steps[k].op not in exact for k in operands)


def rotations(case: CaseOutline, sums: Sequence[int], argument: int, model: Model) -> dict[int, Fraction]:
    """The relative errors of the sums, for all rotations for which the case is taken; of those that have one."""
    found = {number: _Rotations(case, number, argument, model).largest() for number in sums}
    return {number: Fraction(error) for number, error in found.items() if np.isfinite(error)}


class _Rotations:
    """Boxes of quaternions, of which one component is 1 and the others are not larger."""

    def __init__(self, case: CaseOutline, number: int, argument: int, model: Model) -> None:
        steps = case.outline.program.steps
        compared = {k for truths in case.truths for c in truths for k in steps[c].operands}
        self._outline = _with(case.outline, (*compared, number))
        self._case, self._number, self._argument, self._model = case, number, argument, model
        self._forms = forms(self._outline, argument)

    def largest(self) -> float:
        """The largest relative error of the step; infinite where it may vanish."""
        low = np.repeat(-np.ones((1, 3)), 4, axis=0)
        axis, high, found, reached = np.arange(4), -low, 0.0, 0.0
        for _ in range(ROUNDS):
            middle = (low + high) / 2
            reached = max(reached, float(self._ratio(axis, middle, middle).max()))
            if reached > VANISHING:
                return np.inf
            ratio = self._ratio(axis, low, high)
            wide = ratio > CLOSE * reached
            found = max(found, float(ratio[~wide].max(initial=0.0)))
            if not wide.any():
                return found
            low, high, axis = _eighths(low[wide], high[wide], axis[wide])
        return max(found, float(self._ratio(axis, low, high).max(initial=0.0)))

    def _ratio(self, axis: NDArray[np.int64], low: Array, high: Array) -> Array:
        """The relative error in each box; zero where the case is not taken."""
        like, slack = np.ones(len(low)), np.full(len(low), SLACK)
        known = enclosed_forms(self._forms, _components(axis, low, high), like)
        steps = self._outline.program.steps
        inputs = {
            (self._argument, steps[k].entry): Scaled(0, known[k], slack)
            for k in self._outline.needed
            if steps[k].op is Op.INPUT
        }
        running = Running(self._outline, self._model, inputs, no_angles, len(low), known=known)
        taken = np.zeros(len(low), dtype=bool)
        for truths in self._case.truths:
            possible = np.ones(len(low), dtype=bool)
            for comparison, outcome in truths.items():
                a, b = (running.near[k].value for k in self._outline.operands(comparison))
                possible &= a.low < b.high if outcome else a.high >= b.low
            taken |= possible
        with np.errstate(all="ignore"):
            error = entry_error(running, self._number, 0) / below(running.around[self._number].value.below) * SAFE
        return np.where(taken, np.where(np.isnan(error), np.inf, error), 0.0)


def _with(outline: Outline, further: Sequence[int]) -> Outline:
    """The outline with further steps, of those that need entries of inputs alone."""
    needed = reached((outline.sources.get(k, k) for k in further), outline.operands)
    return Outline(outline.program, tuple(sorted(needed)), outline.sources, {})


def _components(axis: NDArray[np.int64], low: Array, high: Array) -> list[Interval]:
    """The components of quaternions of which one is 1 and the others run over boxes."""
    rows, found = np.arange(len(low)), []
    for k in range(4):
        place = np.clip(np.where(k < axis, k, k - 1), 0, 2)
        ends = (np.where(axis == k, 1.0, end[rows, place]) for end in (low, high))
        found.append(Interval(*ends))
    return found


def _eighths(low: Array, high: Array, axis: NDArray[np.int64]) -> tuple[Array, Array, NDArray[np.int64]]:
    middle = (low + high) / 2
    lows, highs = [], []
    for sides in product((False, True), repeat=3):
        upper = np.array(sides)
        lows.append(np.where(upper, middle, low))
        highs.append(np.where(upper, high, middle))
    return np.concatenate(lows), np.concatenate(highs), np.tile(axis, 8)
