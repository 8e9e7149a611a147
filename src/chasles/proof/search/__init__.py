"""Exact points where free hypotheses hold: witnesses and counterexamples for questions that are no declarations."""

from __future__ import annotations

from collections.abc import Callable, Iterator, Mapping, Sequence
from dataclasses import dataclass, field
from fractions import Fraction
from random import Random
from typing import Any, Protocol

from chasles.proof.context import Context
from chasles.proof.deadline import check, remaining
from chasles.proof.ratios import Ratio
from chasles.proof.search.angles import Turning
from chasles.proof.search.drawing import Drawing, Frame
from chasles.proof.search.motion import Motion
from chasles.proof.search.stage import Stage, staged
from chasles.proof.search.values import Values, sparse
from chasles.proof.surds import Exact
from chasles.proof.verdict import Counterexample
from chasles.statements import Goal
from chasles.vocabulary import Symbol

__all__ = ["Frame", "Motion", "Search"]

ATTEMPTS = (150, 600)
ENOUGH = 10
VANISHING = 12
SHARE = 0.3


class Suspect(Protocol):
    """An entry of a goal that did not reduce to zero."""

    goal: Goal
    place: tuple[int, int]
    ratio: Ratio


@dataclass(slots=True)
class Search:
    """Finds points; what a context does not tell is said here.

    `allowed` says whether a variable may have a value, `products` which angles are products of which factors, `frames`
    which variables are the entries of orthonormal columns; `spelled` is how an angle is written. If `blind`, there
    are conditions that no point here is checked for, and nothing is refuted.
    """

    allowed: Callable[[str, Exact], bool] = lambda _, __: True
    products: Mapping[Symbol, Mapping[Symbol, int]] = field(default_factory=dict)
    frames: Sequence[Frame] = ()
    motion: Motion | None = None
    spelled: Callable[[Symbol], str] = str
    blind: bool = False
    calls: int = 0

    def refute(self, context: Context, suspects: Sequence[Suspect]) -> Counterexample | None:
        """The counterexample that is easiest to evaluate by hand among a number of them; None if none is found."""
        attempts = ATTEMPTS[min(self.calls, len(ATTEMPTS) - 1)]
        self.calls += 1
        if self.blind:
            return None
        best: tuple[int, Counterexample] | None = None
        found = vanishing = 0
        stage = staged(context)
        numerators = [sparse(context.field.ring, s.ratio.numerator) for s in suspects]
        for values in self._points(context, stage, attempts, keep_some_time=True):
            suspect = next((s for s, n in zip(suspects, numerators, strict=True) if not values.of(n).is_zero), None)
            vanishing += suspect is None
            if suspect is not None and (self.motion is None or self.motion.exists(context, stage, values)):
                candidate = self._candidate(context, stage, suspect, values)
                best = candidate if best is None or candidate[0] < best[0] else best
                found += 1
            if found == ENOUGH or (vanishing == VANISHING and best is None):
                break
        return best[1] if best else None

    def witness(self, context: Context) -> Mapping[str, Any] | None:
        """A point that satisfies every hypothesis, with rational coordinates if such a one is found."""
        stage = staged(context)
        fallback: Values | None = None
        for count, values in enumerate(self._points(context, stage, ATTEMPTS[-1], keep_some_time=False)):
            if not values.irrational:
                return dict(self._shown(stage, values))
            fallback = fallback or values
            if count > ENOUGH:
                break
        return dict(self._shown(stage, fallback)) if fallback else None

    def _points(self, context: Context, stage: Stage, attempts: int, keep_some_time: bool) -> Iterator[Values]:
        """Different points that satisfy everything, simple ones first."""
        turning = Turning(stage, self.products)
        drawing = Drawing(stage, turning, self.frames, self.allowed)
        least = remaining() * (1 - SHARE) if keep_some_time else 0.0
        seen: set[tuple[Fraction | None, ...]] = set()
        for attempt in range(attempts):
            check()
            if remaining() < least:
                return
            values = drawing.attempt(Random(attempt), attempt)
            if values is None:
                continue
            key = tuple(values.rational.get(k) for k in range(len(stage.names)))
            if key not in seen or values.irrational:
                seen.add(key)
                yield values

    def _candidate(
        self, context: Context, stage: Stage, suspect: Suspect, values: Values
    ) -> tuple[int, Counterexample]:
        row, column = suspect.place
        theta = Turning(stage, self.products).theta
        name = "pi" if theta is None else self.spelled(theta)
        sides = [context.unfold(side)[row - 1][column - 1] for side in (suspect.goal.left, suspect.goal.right)]
        texts = [self._text(context, values, side, name) for side in sides]
        at = dict(self._shown(stage, values))
        cost = sum(map(_height, at.values())) + sum(map(len, texts))
        return cost, Counterexample(at, suspect.place, texts[0], texts[1], suspect.goal.label)

    def _text(self, context: Context, values: Values, side: Ratio, theta: str) -> str:
        ring = context.field.ring
        above = values.of(sparse(ring, side.numerator))
        below = values.of(sparse(ring, context.field.power_product(side.denominator)))
        inverse = below.inverse()
        return f"({above.text(theta)})/({below.text(theta)})" if inverse is None else (above * inverse).text(theta)

    def _shown(self, stage: Stage, values: Values) -> Iterator[tuple[str, Any]]:
        """The coordinates, rational ones as fractions; the angle that is the transcendental number is left out."""
        theta = Turning(stage, self.products).theta
        for place, name in enumerate(stage.names):
            value = values[place].as_rational
            if value is not None:
                yield name, value
            elif theta is None or not any(power for power, _ in values[place].terms):
                yield name, values[place]


def _height(value: Fraction | Exact) -> int:
    """How much work a person has with a number."""
    if isinstance(value, Exact):
        return 8 * len(value.terms)
    if value == 0:
        return 0
    below = 3 * len(str(value.denominator)) if value.denominator != 1 else 0
    return 1 + 2 * (abs(value) != 1) + len(str(abs(value.numerator))) + below
