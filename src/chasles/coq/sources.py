"""From where is it known that a polynomial vanishes? From an equation of a hypothesis or a condition, or its rate."""

from __future__ import annotations

import re
from collections.abc import Iterable, Iterator
from dataclasses import dataclass
from functools import reduce
from operator import mul

from chasles import vocabulary as w
from chasles.checker.reading import PolynomialProblem
from chasles.checker.sparse import MOST_POWER, ZERO, Polynomial, cleared, packed
from chasles.coq.expressions import Unsaid
from chasles.statements import Goal, Hypothesis, Problem

PLACED = re.compile(
    r"(?P<text>.*?)(?: \((?P<dots>d*)ot\))? \[(?:(?P<equation>\d+): )?(?P<i>\d+), (?P<j>\d+)\]", re.DOTALL
)


@dataclass(frozen=True, slots=True)
class StatedEntry:
    """An entry of an equation that a hypothesis or a condition states, differentiated `order` times.

    Its polynomial is multiplied by `below`, nonzero factors packed as in a monomial.
    """

    about: Hypothesis | Goal
    stem: str
    equation: int
    left: w.Node
    right: w.Node
    order: int
    i: int
    j: int
    below: int

    @property
    def name(self) -> str:
        """What the equation is called in a proof, differentiated."""
        return f"{self.stem}_{self.order}"


def multiples(polynomial: Polynomial, factors: int, guard: int) -> Polynomial:
    """By what a product of variables, packed as a monomial with a bit above each, is multiplied in a polynomial."""
    terms = {m - factors: c for m, c in polynomial.terms.items() if (m | guard) - factors & guard == guard}
    return Polynomial(terms, polynomial.below)


def replaced(polynomial: Polynomial, factors: int, quotient: Polynomial, equal: Polynomial) -> Polynomial:
    """The polynomial with something equal in place of the product of variables that is multiplied by the quotient."""
    kept = {m: c for m, c in polynomial.terms.items() if m - factors not in quotient.terms}
    return Polynomial(kept, polynomial.below) + quotient * equal


class ProofReading(PolynomialProblem):
    """A problem as polynomials, as the checker reads it, with what a proof in Coq asks of it."""

    def __init__(self, problem: Problem, names: Iterable[str], nodes: Iterable[w.Node]) -> None:
        divisors = [node.denominator for node in nodes if isinstance(node, w.Quotient)]
        powers = (part for each in divisors for part in w.walk(each) if isinstance(part, w.Power))
        self.keeps_squares = any(isinstance(each.base, w.Norm) and each.exponent % 2 == 0 for each in powers)
        self._literal = False
        super().__init__(problem, names)
        differences = ((goal, *each) for goal in problem.conditions for each in self.difference(*goal.sides))
        self._stated = [(goal, i, j) for goal, i, j, entry in differences if entry]

    def turned(self, call: w.Call) -> Polynomial:
        """A cosine or sine in those that are variables."""
        return self._turned(call.argument)[call.function == "sin"]

    def place_of_norm(self, of: w.Node) -> int | None:
        """The variable of a norm, if it was asked for."""
        return self._norms.get(of)

    def as_written(self, left: w.Node, right: w.Node) -> dict[tuple[int, int], Polynomial]:
        """The entries of a difference, squares of norms left as they are written."""
        known, self._known, self._literal = self._known, {}, self.keeps_squares
        try:
            return {(i, j): entry for i, j, entry in self.difference(left, right)}
        finally:
            self._known, self._literal = known, False

    def _entries(self, node: w.Node) -> list[list[Polynomial]]:
        if self._literal and isinstance(node, w.Power) and isinstance(node.base, w.Norm):
            return [[reduce(mul, [self._norm(node.base.of)] * node.exponent)]]
        if self._literal and isinstance(node, w.Integral):
            known, self._known, self._literal = self._known, {}, False
            try:
                return super()._entries(node)
            finally:
                self._known, self._literal = known, True
        return super()._entries(node)

    def squares(self, polynomial: Polynomial) -> dict[str, Polynomial]:
        """By what squares of norms, less what they are, are multiplied in a polynomial that is made of them."""
        found, rest = self._squares(polynomial)
        if rest:
            numerator, powers = cleared(polynomial, self.nonzero)
            found, rest = self._squares(numerator, powers)
        if rest:
            raise Unsaid("norms whose squares are not told apart")
        return found

    def _squares(self, rest: Polynomial, powers: int = 0) -> tuple[dict[str, Polynomial], Polynomial]:
        """The same of a numerator over a product of nonzero factors, and what of it is left."""
        found: dict[str, Polynomial] = {}
        for place, what in enumerate(self.variables):
            label = f"norm |{what[1]}|" if what[0] == "norm" else ""
            if not label or not rest:
                continue
            equal = self(w.Dot(what[1], what[1]))[0][0]
            below = Polynomial({cleared(equal, self.nonzero)[1] + powers: 1})
            while quotient := multiples(rest, packed(place, 2), packed(place, MOST_POWER + 1)):
                rest = replaced(rest, packed(place, 2), quotient, equal)
                found[label] = found.get(label, ZERO) + quotient * below
        return found, rest

    def sources(self, labels: Iterable[str]) -> dict[str, StatedEntry]:
        """From where these are known that are equations; to be asked before anything is settled."""
        return {label: source for label in labels for source in self._source(label)}

    def _source(self, label: str) -> Iterator[StatedEntry]:
        found = PLACED.fullmatch(label)
        if label.startswith(("circle ", "norm ")) or found is None:
            return
        i, j, equation = int(found["i"]) - 1, int(found["j"]) - 1, int(found["equation"] or 0)
        if found["equation"] is None:
            goal, i, j = self._stated[int(found["text"].partition(".")[0]) - 1]
            about: Hypothesis | Goal = goal
            stem, (left, right) = f"rate'c{self.problem.conditions.index(goal)}", goal.sides
        else:
            place, hypothesis = next((k, h) for k, h in enumerate(self.problem.hypotheses) if h.text == found["text"])
            about, stem = hypothesis, f"rate'h{place}_{equation}"
            left, right = hypothesis.equations[equation]
        entry = next(entry for a, b, entry in self.difference(left, right) if (a, b) == (i, j))
        order = len(found["dots"] or "")
        for _ in range(order):
            entry = self.rate(entry)
        below = cleared(entry, self.nonzero)[1]
        yield StatedEntry(about, stem, equation, left, right, order, i, j, below)
