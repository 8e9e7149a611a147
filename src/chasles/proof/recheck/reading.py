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
        self._conditions()
        self._hypotheses()

    def _positive(self, hypothesis: Hypothesis) -> None:
        """What is greater than zero: a positive scalar, the leading minors of a positive-definite matrix."""
        entries = self(hypothesis.subjects[0]) if hypothesis.kind in ("positive", "definite") else []
        for size in range(1, len(entries) + 1):
            minor, below = cleared(determinant([row[:size] for row in entries[:size]]), self.atoms)
            self.positive.append((hypothesis.text, minor * product(self.atoms, below)))

    def _conditions(self) -> None:
        """What the conditions say, and its rates up to the highest order of an unknown that occurs."""
        orders = [what[2] for what in self.variables if what[0] == "entry" and what[1] in self.problem.unknowns]
        for goal in self.problem.conditions:
            for i, j, entry in self.difference(goal.left, goal.right):
                if entry:
                    self.conditions.append(cleared(entry, self.atoms)[0])
                    label = f"{len(self.conditions)}. {goal.label}"
                    self._always_zero(entry, max(orders, default=0), label, f"[{i + 1}, {j + 1}]")

    def _hypotheses(self) -> None:
        """What the hypotheses say, and its rates up to the highest order that occurs, or of which a rule speaks."""
        highest = max((what[2] for what in self.variables if what[0] == "entry"), default=0)
        ruled = {of: order for of, order in map(w.undotted, self.rules) if order}
        for hypothesis in self.problem.hypotheses:
            for place, (left, right) in enumerate(hypothesis.equations):
                entries = self.difference(left, right)
                symbols = {self.variables[k][1] for _, _, entry in entries for k in entry.places}
                last = max(highest, *(ruled[symbol] for symbol in symbols & ruled.keys()), 0)
                for i, j, entry in entries:
                    order = 0 if hypothesis.kind == "given" else last
                    self._always_zero(entry, order, hypothesis.text, f"[{place}: {i + 1}, {j + 1}]")

    def _always_zero(self, polynomial: Polynomial, last: int, label: str, place: str) -> None:
        """From here on, this is zero and so are its rates, up to the last order."""
        for order in range(last + 1):
            polynomial = self.rate(polynomial) if order else polynomial
            dots = f" ({'d' * order}ot)" if order else ""
            self.vanish(f"{label}{dots} {place}", polynomial)

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
