"""What does a declaration say? It is read a second time here, for the checker, which shares no code with the prover.

What a hypothesis declares nonzero has its inverse as a variable, so that every expression is a polynomial.
"""

from __future__ import annotations

import re
from collections.abc import Iterable, Mapping
from fractions import Fraction
from functools import reduce
from operator import add, mul

from chasles import vocabulary as w
from chasles.proof.recheck.expansion import determinant
from chasles.proof.recheck.quantities import Quantities
from chasles.proof.recheck.sparse import ONE, ZERO, Polynomial, Rejected, exponents, number, variable
from chasles.statements import Hypothesis, Problem

__all__ = ["Reading"]


class Reading(Quantities):
    """A problem as polynomials: everything `vanishing` is zero, by name, and none of the `atoms` is.

    Variable k is the inverse of atom k as long as there are atoms. `names` tell of which fraction of each angle the
    cosine and sine are variables; nothing else is taken from them. Raises `Rejected` for what has no polynomial form.
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
            self._variable(f"{place + 1}. {hypothesis.text}", "inverse", place)
        self._inverses = (1 << 8 * len(divisors)) - 1
        for hypothesis, node in divisors:
            self.atoms.append(self.cleared(self(node)[0][0])[0])
            self._positive(hypothesis)
        for goal in problem.goals:
            self.difference(goal.left, goal.right)
        self._conditions()
        self._hypotheses()

    def _positive(self, hypothesis: Hypothesis) -> None:
        """What is greater than zero: a positive scalar, the leading minors of a positive-definite matrix."""
        entries = self(hypothesis.subjects[0]) if hypothesis.kind in ("positive", "definite") else []
        for size in range(1, len(entries) + 1):
            minor, below = self.cleared(determinant([row[:size] for row in entries[:size]]))
            self.positive.append((hypothesis.text, minor * self.product(below)))

    def _conditions(self) -> None:
        """What the conditions say, and its rates up to the highest order of an unknown that occurs."""
        unknown = [what[2] for what in self.variables if what[0] == "entry" and what[1] in self.problem.unknowns]
        highest = max(unknown, default=0)
        for goal in self.problem.conditions:
            for i, j, polynomial in self.difference(goal.left, goal.right):
                if polynomial:
                    self.conditions.append(self.cleared(polynomial)[0])
                    label, rates = f"{len(self.conditions)}. {goal.label} [{i + 1}, {j + 1}]", [polynomial]
                    for order in range(highest + 1):
                        rates += [self.rate(rates[-1])] if order else []
                        self._vanish(label + (f" ({'d' * order}ot)" if order else ""), rates[-1])

    def _hypotheses(self) -> None:
        """What the hypotheses say, and its rates up to the highest order that occurs, or of which a rule speaks."""
        highest = max((what[2] for what in self.variables if what[0] == "entry"), default=0)
        ruled = {of: order for of, order in map(w.undotted, self.rules) if order}
        for hypothesis in self.problem.hypotheses:
            for place, (left, right) in enumerate(hypothesis.equations):
                entries = self.difference(left, right)
                symbols = {self.variables[k][1] for _, _, entry in entries for k in entry.places}
                last = max(highest, *(ruled[symbol] for symbol in symbols & ruled.keys()), 0)
                for order in range(1 if hypothesis.kind == "given" else last + 1):
                    label = hypothesis.text + (f" ({'d' * order}ot)" if order else "")
                    entries = [(i, j, self.rate(entry)) for i, j, entry in entries] if order else entries
                    for i, j, entry in entries:
                        self._vanish(f"{label} [{place}: {i + 1}, {j + 1}]", entry)

    def settle(self, values: Mapping[int, Polynomial]) -> None:
        """From here on, these variables have these values."""
        self._values |= values
        self._known.clear()
        self._speeds.clear()

    def difference(self, left: w.Node, right: w.Node) -> list[tuple[int, int, Polynomial]]:
        """Row, column and left - right, for each entry."""
        rows = enumerate(zip(self(left), self(right), strict=True))
        return [(i, j, a - b) for i, row in rows for j, (a, b) in enumerate(zip(*row, strict=True))]

    def cleared(self, polynomial: Polynomial) -> tuple[Polynomial, int]:
        """The polynomial times the least product of atoms that leaves no inverse in it, and the powers of these."""
        parts: dict[int, dict[int, int]] = {}
        for monomial, coefficient in polynomial.terms.items():
            inverses = monomial & self._inverses
            parts.setdefault(inverses, {})[monomial - inverses] = coefficient
        least: dict[int, int] = {}
        for place, power in (power for inverses in parts for power in exponents(inverses)):
            least[place] = max(power, least.get(place, 0))
        top = sum(power << 8 * place for place, power in least.items())
        cleared = (Polynomial(part, polynomial.below) * self.product(top - powers) for powers, part in parts.items())
        return reduce(add, cleared, ZERO), top

    def product(self, powers: int) -> Polynomial:
        """The product of the atoms to these powers, packed as in a monomial."""
        return reduce(mul, (self.atoms[k] for k, power in exponents(powers) for _ in range(power)), ONE)

    def inverse(self, node: w.Node) -> Polynomial:
        """One over a scalar; raises `Rejected` unless it is a number times a product of atoms."""
        value, below = self.cleared(self(node)[0][0])
        for inverse, atom in [(ONE, ONE), *((variable(k), atom) for k, atom in enumerate(self.atoms))]:
            top = max(atom.terms, default=0)
            if top in value.terms and top in atom.terms:
                scale = Fraction(value.terms[top] * atom.below, atom.terms[top] * value.below)
                if not value - atom * number(scale):
                    return inverse * self.product(below) * number(1 / scale)
        match self.rules.get(node, node):
            case w.Negative(term):
                return -self.inverse(term)
            case w.Group(of) | w.At(of):
                return self.inverse(of)
            case w.Scale(factor, term):
                return self.inverse(factor) * self.inverse(term)
            case w.Power(base, exponent):
                return reduce(mul, [self.inverse(base)] * exponent)
            case rule if rule is not node:
                return self.inverse(rule)
            case _:
                raise Rejected(f"the statement divides by {node}, which nothing declares nonzero")
