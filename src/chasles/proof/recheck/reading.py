"""What does a declaration say? It is read a second time here, for the checker, which shares no code with the prover.

What a hypothesis declares nonzero has its inverse as a variable, so that every expression is a polynomial.
"""

from __future__ import annotations

import re
from collections.abc import Iterable, Mapping
from fractions import Fraction

from chasles import vocabulary as w
from chasles.proof.recheck.expansion import determinant
from chasles.proof.recheck.quantities import Quantities
from chasles.proof.recheck.sparse import Polynomial, cleared, product
from chasles.statements import Hypothesis, Problem

__all__ = ["Reading"]


class Reading(Quantities):
    """A problem as polynomials: everything `vanishing` is zero, by name, and none of the `atoms` is.

    `names` tell of which fraction of each angle the cosine and sine are variables; nothing else is taken from them.
    Raises `Rejected` for what has no polynomial form.
    """

    def __init__(self, problem: Problem, names: Iterable[str]) -> None:
        found = (re.fullmatch(r"(?:cos|sin)\(([1-9]\d*)?(.+?)(?:/([1-9]\d*))?\)", name) for name in names)
        units = {m[2]: Fraction(int(m[1] or 1), int(m[3] or 1)) for m in found if m}
        super().__init__(dict(problem.rules), units)
        self.problem = problem
        self.conditions: list[Polynomial] = []
        self.positive: list[tuple[str, Polynomial]] = []
        divisors = [(h, node) for h in problem.hypotheses for node in h.nonvanishing]
        for place, (hypothesis, _) in enumerate(divisors):
            self.variable(f"{place + 1}. {hypothesis.text}", "inverse", place)
        for hypothesis, node in divisors:
            self.atoms.append(cleared(self(node)[0][0], self.atoms)[0])
            self._positive(hypothesis)
        for goal in problem.goals:
            self.difference(goal.left, goal.right)
        for goal in problem.conditions:
            for i, j, entry in self.difference(goal.left, goal.right):
                if entry:
                    self.conditions.append(cleared(entry, self.atoms)[0])
                    self.vanish(f"{len(self.conditions)}. {goal.label} [{i + 1}, {j + 1}]", entry)
        highest = max((what[2] for what in self.variables if what[0] == "entry"), default=0)
        for hypothesis in problem.hypotheses:
            self._hypothesis(hypothesis, highest)

    def _positive(self, hypothesis: Hypothesis) -> None:
        """What is greater than zero: a positive scalar, the leading minors of a positive-definite matrix."""
        entries = self(hypothesis.subjects[0]) if hypothesis.kind in ("positive", "definite") else []
        for size in range(1, len(entries) + 1):
            minor, below = cleared(determinant([row[:size] for row in entries[:size]]), self.atoms)
            self.positive.append((hypothesis.text, minor * product(self.atoms, below)))

    def _hypothesis(self, hypothesis: Hypothesis, highest: int) -> None:
        """What a hypothesis says, and its rates up to the highest order that occurs."""
        for place, (left, right) in enumerate(hypothesis.equations):
            entries = self.difference(left, right)
            for order in range(highest + 1):
                label = hypothesis.text + (f" ({'d' * order}ot)" if order else "")
                entries = [(i, j, self.rate(entry)) for i, j, entry in entries] if order else entries
                for i, j, entry in entries:
                    self.vanish(f"{label} [{place}: {i + 1}, {j + 1}]", entry)

    def settle(self, values: Mapping[int, Polynomial]) -> None:
        """From here on, these variables have these values."""
        if values:
            self._values |= values
            self._known.clear()
            self._speeds.clear()

    def difference(self, left: w.Node, right: w.Node) -> list[tuple[int, int, Polynomial]]:
        """Row, column and left - right, for each entry."""
        rows = enumerate(zip(self(left), self(right), strict=True))
        return [(i, j, a - b) for i, row in rows for j, (a, b) in enumerate(zip(*row, strict=True))]
