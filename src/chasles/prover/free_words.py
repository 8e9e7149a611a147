"""Equations between words of the free algebra completed, so that what follows from them is rewritten to zero.

Each equation is read as a rule for its largest word; where two rules overlap, what they make of the overlap is a new
equation (Mora 1986, after Buchberger and Knuth-Bendix). The completion may go on for ever: it ends after so many rules.
"""

from __future__ import annotations

from collections import Counter
from collections.abc import Iterable
from fractions import Fraction
from heapq import heappop, heappush
from typing import Any

from chasles.checker.any_size.free_algebra import FreeAlgebra
from chasles.prover.rewriting_words import Derived, Occurrence, Rewriting, Rule, rank, without

MOST_RULES, LONGEST = 150, 14
"""So many rules are made at most, of words that are at most so long."""


class Completion(Rewriting):
    """The rules that are known so far; `reduce` rewrites by them, `extend` makes more of them."""

    def __init__(self, algebra: FreeAlgebra, known: Iterable[Derived]) -> None:
        super().__init__(algebra)
        self._waiting: list[tuple[int, int, Any]] = []
        self._count = 0
        for equation in known:
            self._wait(max(map(rank, equation.words))[0], equation)

    def extend(self) -> bool:
        """Make one more rule; false if there is none, or if it would be too much."""
        while self._waiting and len(self.rules) < MOST_RULES:
            _, _, waiting = heappop(self._waiting)
            equation = waiting if isinstance(waiting, Derived) else self._overlap(*waiting)
            if equation is None:
                continue
            self.reduce(equation)
            if equation.words:
                self._add(equation)
                return True
        return False

    def _add(self, equation: Derived) -> None:
        """A new rule; those that it applies to are made anew, and its overlaps wait."""
        lead = max(equation.words, key=rank)
        factor = 1 / equation.words[lead]
        words = {monomial: factor * c for monomial, c in equation.words.items()}
        rule = Rule(words, {term: factor * c for term, c in equation.proof.items()}, lead)
        kept: list[Rule] = []
        for other in self.rules:
            if next(self.places(lead, other.lead), None) is None:
                kept.append(other)
            else:
                self._wait(rank(other.lead)[0], Derived(dict(other.words), dict(other.proof)))
        self.rules = [*kept, rule]
        for other in self.rules:
            for one, another in {(id(rule), id(other)): (rule, other), (id(other), id(rule)): (other, rule)}.values():
                for size in range(1, min(len(one.lead[1]), len(another.lead[1]))):
                    if one.lead[1][-size:] == another.lead[1][:size]:
                        self._wait(len(one.lead[1]) + len(another.lead[1]) - size, (one, another, size))
            if rule is not other and {*rule.lead[0]} & {*other.lead[0]} and not (rule.lead[1] and other.lead[1]):
                self._wait(rank(rule.lead)[0] + rank(other.lead)[0], (rule, other, 0))

    def _wait(self, degree: int, waiting: Any) -> None:
        if degree <= LONGEST:
            self._count += 1
            heappush(self._waiting, (degree, self._count, waiting))

    def _overlap(self, one: Rule, other: Rule, size: int) -> Derived | None:
        """The difference of what two rules make of the least monomial in which both stand."""
        if one not in self.rules or other not in self.rules:
            return None
        common = Counter(one.lead[0]) | Counter(other.lead[0])
        more = tuple(sorted(common.elements()))
        first, second = (without(more, rule.lead[0]) or () for rule in (one, other))
        words = one.lead[1], other.lead[1]
        equation = Derived({}, {})
        if size:
            places = Occurrence(first, (), words[1][size:]), Occurrence(second, words[0][: len(words[0]) - size], ())
        else:
            word = words[0] or words[1]
            places = tuple(  # type: ignore[assignment]
                Occurrence(scalars, kind="" if own else "scalar", beside=() if own else word)
                for scalars, own in ((first, words[0]), (second, words[1]))
            )
        self.subtract(equation, one, places[0], Fraction(-1))
        self.subtract(equation, other, places[1], Fraction(1))
        return equation
