"""Exact points where free hypotheses hold: witnesses and counterexamples for questions that are no declarations."""

from __future__ import annotations

from collections.abc import Callable, Iterator, Mapping, Sequence
from contextlib import contextmanager
from contextvars import ContextVar
from dataclasses import dataclass, field
from fractions import Fraction
from random import Random
from typing import Any, Protocol

from chasles.algebra.localization import Ratio
from chasles.algebra.surds import SurdSum
from chasles.algebra.work_limit import check, remaining
from chasles.points.search.angles import Turning
from chasles.points.search.constraints import ConstraintSystem, constraint_system
from chasles.points.search.drawing import Drawing, Frame
from chasles.points.search.values import Values, sparse
from chasles.problems.context import Context
from chasles.statements import Goal, Problem
from chasles.verdict import Counterexample
from chasles.vocabulary import Node, Symbol

__all__ = ["Frame", "Search", "UnreducedEntry", "height"]

ATTEMPTS = (150, 600)
ENOUGH = 10
VANISHING = 30
REPEATED = 25
SHARE = 0.3


class UnreducedEntry(Protocol):
    """An entry of a goal that did not reduce to zero, with the difference of its sides as a fraction."""

    @property
    def goal(self) -> Goal: ...
    @property
    def place(self) -> tuple[int, int]: ...
    @property
    def ratio(self) -> Ratio: ...


_is_told: ContextVar[bool] = ContextVar("is_told", default=True)


def counterexamples_are_told() -> bool:
    """Whether it is worth while to look for one that nothing else is decided by."""
    return _is_told.get()


@contextmanager
def any_counterexample() -> Iterator[None]:
    """Take the first counterexample that is found, where it says no more than that nothing is proved."""
    token = _is_told.set(False)
    try:
        yield
    finally:
        _is_told.reset(token)


@dataclass(slots=True)
class Search:
    """Finds points; what a context does not tell is said here.

    `allowed` says whether a variable may have a value, `products` which angles are products of which factors, `rigid`
    which of these are no arbitrary real numbers, `frames` which variables are the entries of orthonormal columns;
    `determined` are the names of the rates that equations determine; `moves` says whether a motion goes through a
    point, by its coordinates. `spelled` is how an angle is written. If `blind`, there are conditions that no point here
    is checked for, and nothing is refuted. If goals have more rows than `rows`, those below are the imaginary parts of
    those above. `write` writes the certificates. `theta` is the angle that was the transcendental number at the last
    point; else pi was.
    """

    allowed: Callable[[str, SurdSum], bool]
    products: Mapping[Symbol, Mapping[Symbol, int]] = field(default_factory=dict)
    rigid: frozenset[Symbol] = frozenset()
    frames: Sequence[Frame] = ()
    determined: frozenset[str] = frozenset()
    moves: Callable[[Mapping[str, Any]], bool] = lambda _: True
    spelled: Callable[[Symbol], str] = str
    blind: bool = False
    unseen: bool = False
    rows: int | None = None
    write: Callable[..., dict[str, Any]] | None = None
    calls: int = 0
    theta: Symbol | None = None

    def refute(self, context: Context, solved: object, suspects: Sequence[UnreducedEntry]) -> Counterexample | None:
        """The counterexample that is easiest to evaluate by hand among a number of them; None if none is found."""
        attempts = ATTEMPTS[min(self.calls, len(ATTEMPTS) - 1)]
        self.calls += 1
        if self.blind:
            return None
        best: tuple[int, Counterexample] | None = None
        found = vanishing = 0
        system = constraint_system(context)
        differences = [(s, sparse(context.field.ring, s.ratio.numerator)) for s in suspects]
        for values in self._points(context, system, attempts, keep_some_time=True):
            suspect = next((s for s, terms in differences if not values.of(terms).is_zero), None)
            vanishing += suspect is None
            if suspect is not None and self.moves(_coordinates(system, values)):
                candidate = self._candidate(context, system, values, suspect)
                best = candidate if candidate and (best is None or candidate[0] < best[0]) else best
                found += 1
            if found == (ENOUGH if counterexamples_are_told() else 1) or (vanishing == VANISHING and best is None):
                break
        return best[1] if best else None

    refute_soon = refute

    def contradiction(self, problem: Problem) -> None:
        """Whether conditions contradict each other is asked where they are read."""

    def witness(self, context: Context, solved: object) -> Mapping[str, Any] | None:
        """A point that satisfies every hypothesis, with rational coordinates if such a one is found."""
        if self.unseen:
            return {v.name: Fraction(v.kind == "cos") for v in context.variables if v.kind in ("cos", "sin")}
        system = constraint_system(context)
        fallback: Values | None = None
        for count, values in enumerate(self._points(context, system, ATTEMPTS[0], keep_some_time=False)):
            if not self.moves(_coordinates(system, values)):
                continue
            if not values.irrational or system.pi in values.irrational:
                return _coordinates(system, values)
            fallback = fallback or values
            if count == VANISHING:
                break
        return _coordinates(system, fallback) if fallback else None

    def _points(
        self, context: Context, system: ConstraintSystem, attempts: int, keep_some_time: bool
    ) -> Iterator[Values]:
        """Different points that satisfy everything, simple ones first."""
        turning = Turning(system, self.products, self.rigid)
        self.theta = turning.theta
        drawing = Drawing(system, turning, self.frames, self.allowed, self.determined)
        least = remaining() * (1 - SHARE) if keep_some_time else 0.0
        seen: set[tuple[str, ...]] = set()
        again = 0
        for attempt in range(attempts):
            check()
            if remaining() < least:
                return
            values = drawing.attempt(Random(attempt), attempt)
            if values is None:
                continue
            key = tuple(str(values[k]) for k in range(len(system.names)))
            again = again + 1 if key in seen else 0
            if again == REPEATED:
                return
            if not again:
                seen.add(key)
                yield values

    def _candidate(
        self, context: Context, system: ConstraintSystem, values: Values, suspect: UnreducedEntry
    ) -> tuple[int, Counterexample] | None:
        """The counterexample and how much work it is; None if its numbers are too long to be written."""
        name = "pi" if self.theta is None else self.spelled(self.theta)
        row, column = suspect.place
        row = row - self.rows if self.rows and row > self.rows else row
        sides = suspect.goal.left, suspect.goal.right
        try:
            texts = [self._whole(context, values, side, (row, column), name) for side in sides]
        except ValueError:
            return None
        at = _coordinates(system, values)
        cost = sum(map(height, at.values())) + sum(map(len, texts))
        return cost, Counterexample(at, (row, column), texts[0], texts[1], suspect.goal.label)

    def _whole(self, context: Context, values: Values, side: Node, place: tuple[int, int], theta: str) -> str:
        """A value, with its imaginary part if it may have one."""
        real = _text(context, values, side, place, theta)
        if self.rows is None:
            return real
        below = _text(context, values, side, (place[0] + self.rows, place[1]), theta)
        return real if below == "0" else f"({below})*I" if real == "0" else f"{real} + ({below})*I"


def _text(context: Context, values: Values, side: Node, place: tuple[int, int], theta: str) -> str:
    ratio: Ratio = context.unfold(side)[place[0] - 1][place[1] - 1]
    parts = ratio.numerator, context.field.power_product(ratio.denominator)
    above, below = (values.of(sparse(context.field.ring, part)) for part in parts)
    inverse = below.inverse()
    return f"({above.text(theta)})/({below.text(theta)})" if inverse is None else (above * inverse).text(theta)


def _coordinates(system: ConstraintSystem, values: Values) -> dict[str, Any]:
    """The coordinates by name, rational ones as fractions."""
    exact = {name: values[place] for place, name in enumerate(system.names)}
    return {name: value if value.as_rational is None else value.as_rational for name, value in exact.items()}


def height(value: Fraction | SurdSum) -> int:
    """How much work a person has with a number: none with zero, little with one."""
    if isinstance(value, SurdSum):
        return 8 * len(value.terms)
    if value == 0:
        return 0
    below = 3 * len(str(value.denominator)) if value.denominator != 1 else 0
    return 1 + 2 * (abs(value) != 1) + len(str(value.numerator)) + below
