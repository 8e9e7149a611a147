"""What does a declaration say? It is read a second time here, for the checker, which imports nothing of the prover.

What a hypothesis declares nonzero has its inverse as a variable, so that every expression is a polynomial.
"""

from __future__ import annotations

import re
from collections.abc import Iterable, Iterator, Mapping
from dataclasses import dataclass, field
from fractions import Fraction

from chasles import vocabulary as w
from chasles.checker.division import Division, divided, solved_for
from chasles.checker.quantities import Quantities
from chasles.checker.sparse import ZERO, Polynomial, Rejected, cleared, determinant, product
from chasles.statements import Hypothesis, Problem

MOST_ORDERS = 8
"""So often what is assumed is differentiated at most, to see where its rates say nothing new."""
PROPER_ORTHOGONAL = ("rotation", "orthonormal")
"""Of these six of 27 equations, on and above the diagonal of the first, say all near where they all hold."""
REPEATING = ("symmetric", "definite")
"""What these say of an entry above the diagonal they repeat below it."""


@dataclass(slots=True)
class Said:
    """A polynomial that is zero, as `stated` and differentiated, and why; it `counts`, or follows from others near by.

    What says nothing new is a combination of what was said before, and so are all its rates.
    """

    label: str
    place: str
    polynomial: Polynomial
    counts: bool = True
    is_new: bool = True
    stated: Polynomial = field(init=False)

    def __post_init__(self) -> None:
        self.stated = self.polynomial

    @property
    def ties(self) -> bool:
        """Whether something new is said of rates."""
        return self.counts and self.is_new


class PolynomialProblem(Quantities):
    """A problem as polynomials: `vanishing` ones are zero, `nonzero` ones are not, `greater` ones are positive.

    `names` tell of which fraction of each angle the cosine and sine are variables; nothing else is taken from them.
    Raises `Rejected` for what has no polynomial form.
    """

    def __init__(self, problem: Problem, names: Iterable[str]) -> None:
        found = (re.fullmatch(r"(?:cos|sin)\(([1-9]\d*)?(.+?)(?:/([1-9]\d*))?\)", name) for name in names)
        super().__init__(dict(problem.rules), {m[2]: Fraction(int(m[1] or 1), int(m[3] or 1)) for m in found if m})
        self.problem = problem
        self.conditions: list[Polynomial] = []
        self.positive: list[tuple[str, Polynomial]] = []
        self.greater: dict[int, Polynomial] = {}
        self.ahead: list[tuple[Polynomial, Polynomial]] = []
        self.unclosed: list[str] = []
        self.highest = 0
        divisors = [(h, node) for h in problem.hypotheses for node in h.nonvanishing]
        for place, (hypothesis, _) in enumerate(divisors):
            self.variable(f"{place + 1}. {hypothesis.text}", "inverse", place)
        # Nothing is divided by zero: what is not read yet may not be divided by.
        self.nonzero += [ZERO] * len(divisors)
        waiting = dict(enumerate(divisors))
        while waiting:
            place = next((k for k, (_, node) in waiting.items() if self._is_read(node)), min(waiting))
            hypothesis, node = waiting.pop(place)
            self.nonzero[place] = cleared(self(node)[0][0], self.nonzero)[0]
            self._positive(hypothesis, place)
        for goal in problem.goals:
            self.difference(goal.left, goal.right)
        self._close([*self._conditions(), *self._hypotheses()])

    def _is_read(self, node: w.Node) -> bool:
        """Whether what an expression divides by is known not to vanish by now."""
        try:
            self(node)
        except Rejected:
            return False
        return True

    def _positive(self, hypothesis: Hypothesis, place: int) -> None:
        """What is greater than zero: a positive scalar, the leading minors of a positive-definite matrix."""
        entries = self(hypothesis.subjects[0]) if hypothesis.kind in ("positive", "definite") else []
        for size in range(1, len(entries) + 1):
            minor, below = cleared(determinant([row[:size] for row in entries[:size]]), self.nonzero)
            self.positive.append((hypothesis.text, minor * product(self.nonzero, below)))
            if size == len(entries) and not below:
                self.greater[place] = minor

    def _conditions(self) -> Iterator[Said]:
        for goal in self.problem.conditions:
            for i, j, entry in self.difference(goal.left, goal.right):
                if entry:
                    self.conditions.append(cleared(entry, self.nonzero)[0])
                    yield Said(f"{len(self.conditions)}. {goal.label}", f"[{i + 1}, {j + 1}]", entry)

    def _hypotheses(self) -> Iterator[Said]:
        for hypothesis in self.problem.hypotheses:
            for place, (left, right) in enumerate(hypothesis.equations):
                for i, j, entry in self.difference(left, right):
                    counts = i < j or hypothesis.kind not in REPEATING
                    if hypothesis.kind in PROPER_ORTHOGONAL:
                        counts = place == 0 and i <= j
                    yield Said(hypothesis.text, f"[{place}: {i + 1}, {j + 1}]", entry, counts)

    def _open_rules(self) -> bool:
        """Read what rules say of rates of all that occurs; whether anything that occurs moves."""
        rates = {left: right for left, right in self.rules.items() if isinstance(left, w.Rate)}
        moves = any(what[0] == "entry" and what[2] for what in self.variables)
        while found := [left for left in rates if w.undotted(left)[0] in {what[1] for what in self.variables}]:
            for left in found:
                self(rates.pop(left))
            moves = True
        return moves

    def _close(self, said: list[Said]) -> None:
        """All that is said is zero from here on, and so are its rates, until they say nothing new or are of new rates.

        What then is `ahead`, beside what was stated, determines the new rates; of what is `unclosed` it was not found
        out where it ends.
        """
        moves = self._open_rules()
        self.highest = max((what[2] for what in self.variables if what[0] == "entry"), default=0)
        known: list[Division] = []
        for order in range(MOST_ORDERS + 1):
            dots = f" ({'d' * order}ot)" if order else ""
            for each in said:
                polynomial = cleared(each.polynomial, self.nonzero)[0]
                self.vanish(f"{each.label}{dots} {each.place}", polynomial)
                if moves and (each.counts or order > self.highest):
                    each.is_new = each.is_new and bool(divided(polynomial, known))
                if moves and polynomial:
                    known.append(solved_for(max(polynomial.terms), polynomial))
            said = [each for each in said if moves and self._derived(each, order)]
        self.unclosed += [each.label for each in said if each.ties]

    def _derived(self, said: Said, order: int) -> bool:
        """Whether the rate of what is said is to be zero too, which takes its place."""
        try:
            said.polynomial = self.rate(said.polynomial)
        except Rejected:
            self.unclosed += [said.label] if said.ties else []
            return False
        if not said.polynomial or not (said.is_new or order < self.highest):
            return False
        kinds = [self.variables[place] for place in said.polynomial.places]
        if said.ties and any(kind == "moment" for kind, *_ in kinds):
            self.unclosed.append(said.label)
        is_ahead = any(what[0] == "entry" and what[2] > self.highest for what in kinds)
        if is_ahead and said.ties:
            stated, polynomial = (cleared(each, self.nonzero)[0] for each in (said.stated, said.polynomial))
            self.ahead.append((stated, polynomial))
        return not is_ahead

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
