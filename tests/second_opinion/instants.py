"""What is the value at one moment of an explicit motion? Every expression with its rates, which are differences.

Nothing is differentiated by a rule of calculus: a rate is the central difference of the values a little later and a
little earlier. The step is so small, and the digits so many, that a second rate still has a hundred digits. Where only
a rate is prescribed, the quantity is integrated from its value at the moment in question. An integral over the body is
a sum over a few point masses.
"""

from __future__ import annotations

from collections.abc import Mapping
from fractions import Fraction
from functools import reduce
from typing import Any

from chasles.evaluation.matrices import Matrix, plus, transposed
from chasles.numerics.enclosures import plain_context
from chasles.statements import Problem
from chasles.vocabulary import PI, At, Group, Integral, Node, Rate, Symbol

from .combinations import combined, scaled
from .linear_systems import solved
from .motions import Motion

__all__ = ["DIGITS", "Instant", "World"]

DIGITS = 400
STEP = 90
"""The step of a difference is 10^-STEP."""
ELEMENTS = 4
"""Point masses of a body: enough for an inertia of rank three about their center of mass."""

States = Mapping[Symbol, Matrix]


class World:
    """A motion that a problem speaks of: functions of time, and what the rules and conditions make of them."""

    def __init__(self, problem: Problem, seed: int) -> None:
        self.problem = problem
        self.rules: dict[Node, Node] = dict(problem.rules)
        self.context = plain_context(DIGITS)
        self.step = self.context.mpf(10) ** -STEP
        self.motion = Motion(problem.hypotheses, self.context, seed)
        rated = [left.of for left in self.rules if isinstance(left, Rate)]
        self.integrated = tuple(s for s in rated if isinstance(s, Symbol) and s not in self.rules)
        self._instants: dict[tuple[Fraction, int | None, frozenset[Symbol]], Instant] = {}

    def instant(
        self, steps: Fraction = Fraction(0), element: int | None = None, running: frozenset[Symbol] = frozenset()
    ) -> Instant:
        """The moment so many steps after the beginning, in one element of the body."""
        key = steps, element, running
        if key not in self._instants:
            self._instants[key] = Instant(self, steps, element, running)
        return self._instants[key]


class Instant:
    """One moment, in the whole body or in one of its elements; each expression is evaluated once."""

    def __init__(
        self,
        world: World,
        steps: Fraction,
        element: int | None = None,
        running: frozenset[Symbol] = frozenset(),
        states: States | None = None,
    ) -> None:
        self.world, self.steps, self.element, self.running = world, steps, element, running
        self.context = world.context
        self.moment = world.step * steps.numerator / steps.denominator
        self._states = states
        self._solution: dict[Symbol, Matrix] | None = None
        self._integrals: dict[Symbol, Matrix] | None = None
        self._known: dict[Node, Matrix] = {}

    def __call__(self, node: Node) -> Matrix:
        """The expression's entries, row by row."""
        known = self._known.get(node)
        if known is None:
            known = self._known[node] = self._evaluate(node)
        return known

    def _evaluate(self, node: Node) -> Matrix:
        if node in self.world.rules:
            return self(self.world.rules[node])
        match node:
            case Symbol(stands_for=Node() as meaning):
                return self(meaning)
            case Symbol() if node == PI:
                return [[+self.context.pi]]
            case Symbol():
                return self._symbol(node)
            case Rate(At(of, "t") | Group(of)):
                return self(Rate(of))
            case Rate(of):
                later, earlier = self._shifted(1)(of), self._shifted(-1)(of)
                return scaled(plus(later, scaled(earlier, -1)), 1 / (2 * self.world.step))
            case Integral(of):
                parts = (self._in_element(k, node.running)(of) for k in range(ELEMENTS))
                return reduce(plus, parts)
            case At(of, "t") | Group(of):
                return self(of)
            case _:
                return combined(node, self, self.context)

    def _symbol(self, symbol: Symbol) -> Matrix:
        if symbol in self.world.problem.unknowns:
            return self._determined()[symbol]
        if self._states is not None and symbol in self._states:
            return self._states[symbol]
        if symbol in self.world.integrated and self.steps:
            return self._flow()[symbol]
        element = self.element if symbol in self.running else None
        if symbol in self.world.integrated:
            return self.world.motion.at(symbol, self.context.mpf(0), element)
        value = self.world.motion.at(symbol, self.moment, element)
        is_density = element is not None and symbol.is_scalar and symbol.constant
        return [[1 + value[0][0] ** 2]] if is_density else value

    def _shifted(self, steps: int) -> Instant:
        return self.world.instant(self.steps + steps, self.element, self.running)

    def _in_element(self, element: int, running: frozenset[Symbol]) -> Instant:
        return self.world.instant(self.steps, element, running)

    def _flow(self) -> dict[Symbol, Matrix]:
        """What is integrated, from the beginning to this moment, in one step of the midpoint rule.

        Its error is of third order in the step: second rates keep as many digits as the step has.
        """
        if self._integrals is None:
            start = self.world.instant(Fraction(0), self.element, self.running)
            begin = {symbol: start(symbol) for symbol in self.world.integrated}
            halfway = self._advanced(begin, self.steps / 2, self._slopes(Fraction(0), begin))
            self._integrals = self._advanced(begin, self.steps, self._slopes(self.steps / 2, halfway))
        return self._integrals

    def _slopes(self, steps: Fraction, states: States) -> dict[Symbol, Matrix]:
        there = Instant(self.world, steps, self.element, self.running, states)
        return {symbol: there(self.world.rules[Rate(symbol)]) for symbol in states}

    def _advanced(self, begin: States, steps: Fraction, slopes: States) -> dict[Symbol, Matrix]:
        by = self.world.step * steps.numerator / steps.denominator
        return {symbol: plus(value, scaled(slopes[symbol], by)) for symbol, value in begin.items()}

    def _determined(self) -> dict[Symbol, Matrix]:
        """The unknowns that satisfy the conditions, which are linear in them."""
        if self._solution is None:
            problem = self.world.problem
            places = [(s, i, j) for s in problem.unknowns for i in range(s.shape[0]) for j in range(s.shape[1])]
            nothing = self._residuals({})
            columns = [[a - b for a, b in zip(self._residuals({place: 1}), nothing, strict=True)] for place in places]
            solution = solved(transposed(columns), [-entry for entry in nothing], self.context)
            values = dict(zip(places, solution, strict=True))
            self._solution = {
                s: [[values[s, i, j] for j in range(s.shape[1])] for i in range(s.shape[0])] for s in problem.unknowns
            }
        return self._solution

    def _residuals(self, ones: Mapping[tuple[Symbol, int, int], int]) -> list[Any]:
        """By how much the conditions are violated where the unknowns are zero, but for a few entries."""
        trial = Instant(self.world, self.steps, self.element, self.running, self._states)
        zero = self.context.mpf(0)
        trial._solution = {
            s: [[zero + ones.get((s, i, j), 0) for j in range(s.shape[1])] for i in range(s.shape[0])]
            for s in self.world.problem.unknowns
        }
        return [
            a - b
            for goal in self.world.problem.conditions
            for one, other in zip(trial(goal.left), trial(goal.right), strict=True)
            for a, b in zip(one, other, strict=True)
        ]
