"""Rewriting in the free algebra: what a known equation makes of words in which its largest word stands, with proof.

A proof is a sum of known equations, each multiplied from both sides or, as a scalar, standing before a word.
"""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import dataclass
from fractions import Fraction
from typing import NamedTuple

from chasles.algebra.work_limit import STEP, spend
from chasles.checker.any_size.free_algebra import Atom, FreeAlgebra, Letters, Monomial, Words, added
from chasles.vocabulary.measure import Extent


class Multiple(NamedTuple):
    """A known equation in its place: multiplied from both sides, and, "scalar" or "trace", before a word."""

    scalars: tuple[Atom, ...]
    left: Letters
    of: str
    transposed: bool
    right: Letters
    kind: str
    beside: Letters


Proof = dict[Multiple, Fraction]


class Occurrence(NamedTuple):
    """Where a rule is applied: what stands around it; `size` is that of the matrix of which a trace is taken."""

    scalars: tuple[Atom, ...]
    left: Letters = ()
    right: Letters = ()
    kind: str = ""
    beside: Letters = ()
    size: Extent = 0


@dataclass(slots=True, eq=False)
class Derived:
    """Words, and the sum of known equations that they are equal to; of a claim, but for what it was."""

    words: Words
    proof: Proof


@dataclass(slots=True, eq=False)
class Rule(Derived):
    """An equation whose largest word is `lead`, with the coefficient one."""

    lead: Monomial


class Rewriting:
    """Rewrites words by the `rules`, the largest words first."""

    def __init__(self, algebra: FreeAlgebra) -> None:
        self.algebra = algebra
        self.rules: list[Rule] = []

    def reduce(self, equation: Derived) -> None:
        """Rewrite the words as long as a rule applies; what is taken away is added to the proof."""
        done: set[Monomial] = set()
        while left := equation.words.keys() - done:
            monomial = max(left, key=rank)
            found = self._applied(monomial) or self._turned(monomial)
            if found is None:
                done.add(monomial)
                continue
            known, place, factor = found
            self.subtract(equation, known, place, equation.words[monomial] / factor)

    def subtract(self, equation: Derived, known: Derived, place: Occurrence, times: Fraction) -> None:
        """Take a multiple of what is known away, in its place."""
        spend(STEP * (1 + len(known.proof)))
        added(equation.words, self.placed(known.words, place), -times)
        for term, coefficient in known.proof.items():
            for moved, factor in self._moved(term, place):
                value = equation.proof.get(moved, Fraction(0)) - times * coefficient * factor
                equation.proof[moved] = value
                if not value:
                    del equation.proof[moved]

    def placed(self, words: Words, place: Occurrence) -> Words:
        """The words with what stands around them."""
        algebra = self.algebra
        found = algebra.product(algebra.product(algebra.alone(place.left), words), algebra.alone(place.right))
        if place.kind == "trace":
            found = algebra.trace(found, place.size)
        if place.kind:
            found = algebra.product(found, algebra.alone(place.beside))
        return algebra.product({(place.scalars, ()): Fraction(1)}, found)

    def _moved(self, term: Multiple, place: Occurrence) -> Iterator[tuple[Multiple, Fraction]]:
        """The terms that a term of a proof becomes in its place."""
        scalars = tuple(sorted((*term.scalars, *place.scalars)))
        if not term.kind:
            left, right = place.left + term.left, term.right + place.right
            yield Multiple(scalars, left, term.of, term.transposed, right, place.kind, place.beside), Fraction(1)
            return
        word = place.left + term.beside + place.right
        if not place.kind:
            yield term._replace(scalars=scalars, beside=word), Fraction(1)
            return
        algebra = self.algebra
        alone = algebra.alone(word)
        found = alone if place.kind == "scalar" else algebra.trace(alone, place.size)
        for (atoms, _), factor in found.items():
            yield term._replace(scalars=tuple(sorted((*scalars, *atoms))), beside=place.beside), factor

    def _applied(self, monomial: Monomial) -> tuple[Derived, Occurrence, Fraction] | None:
        """The first rule that makes less of a monomial, where, and how often the monomial is in it there.

        A scalar is its own transpose: what a rule makes of it may be a multiple of itself.
        """
        for rule in self.rules:
            for place in self.places(rule.lead, monomial):
                found = self.placed(rule.words, place)
                if found and max(found, key=rank) == monomial:
                    return rule, place, found[monomial]
        return None

    def _turned(self, monomial: Monomial) -> tuple[Derived, Occurrence, Fraction] | None:
        """The same for what all rules together make of the transpose of a matrix of which there is a trace."""
        for kind, inner in dict.fromkeys(monomial[0]):
            if kind == "trace":
                there: Words = {((), self.algebra.flipped(inner)): Fraction(1)}
                left = Derived(dict(there), {})
                self.reduce(left)
                added(there, left.words, Fraction(-1))
                known = Derived(there, {term: -c for term, c in left.proof.items()})
                beyond = without(monomial[0], ((kind, inner),)) or ()
                place = Occurrence(beyond, kind=kind, beside=monomial[1], size=self.algebra.height(inner[0]))
                found = self.placed(there, place)
                if found and max(found, key=rank) == monomial:
                    return known, place, found[monomial]
        return None

    def places(self, lead: Monomial, monomial: Monomial) -> Iterator[Occurrence]:
        """Where a leading monomial stands in another."""
        scalars, word = monomial
        rest = without(scalars, lead[0])
        if rest is None:
            return
        if not lead[1]:
            yield Occurrence(rest, kind="scalar", beside=word)
            return
        if (start := _start(lead[1], word)) is not None:
            yield Occurrence(rest, word[:start], word[start + len(lead[1]) :])
        cut = next((k for k, letter in enumerate(lead[1][:-1], 1) if self.algebra.width(letter) == 1), None)
        if cut is not None:
            yield from self._across(lead[1][:cut], lead[1][cut:], rest, word)
        for kind, inner in dict.fromkeys(rest):
            beyond = without(rest, ((kind, inner),)) or ()
            for one in (inner, self.algebra.flipped(inner)):
                around = one + one[:-1] if kind == "trace" else one
                if len(lead[1]) > len(one) or (start := _start(lead[1], around)) is None:
                    continue
                end = start + len(lead[1])
                if kind == "trace":
                    behind = (one + one)[end : start + len(one)]
                    size = self.algebra.height(behind[0] if behind else lead[1][0])
                    yield Occurrence(beyond, behind, (), kind, word, size)
                else:
                    yield Occurrence(beyond, one[:start], one[end:], "scalar", word)

    def _across(self, p: Letters, q: Letters, scalars: tuple[Atom, ...], word: Letters) -> Iterator[Occurrence]:
        """Where a column p and a row q meet: what stands in one ends with p, what stands in another begins with q."""
        algebra = self.algebra
        cut = 0 if not word or algebra.height(word[0]) == 1 else None
        cut = next((k for k, letter in enumerate(word, 1) if algebra.width(letter) == 1), cut)
        parts: list[tuple[tuple[Atom, ...], Letters, Letters, Letters]] = [
            ((atom,), one, (), ()) for atom in dict.fromkeys(scalars) for one in (atom[1], algebra.flipped(atom[1]))
        ]
        head, tail = (
            ([((), word[:cut], (), word[cut:])], [((), word[cut:], word[:cut], ())]) if cut is not None else ([], [])
        )
        for used, first, _, behind in (*parts, *head):
            for also, second, before, _ in (*parts, *tail):
                rest = without(scalars, (*used, *also))
                if rest is not None and (used or also) and first[len(first) - len(p) :] == p and second[: len(q)] == q:
                    left, right = before + first[: len(first) - len(p)], second[len(q) :] + behind
                    both = bool(used and also)
                    yield Occurrence(rest, left, right, "scalar" if both else "", word if both else ())


def rank(monomial: Monomial) -> tuple[int, Monomial]:
    """By how many letters there are, then by the letters."""
    return sum(len(word) for _, word in monomial[0]) + len(monomial[1]), monomial


def _start(part: Letters, word: Letters) -> int | None:
    """Where a word first contains another."""
    size = len(part)
    return next((k for k in range(len(word) - size + 1) if word[k : k + size] == part), None)


def without(scalars: tuple[Atom, ...], fewer: tuple[Atom, ...]) -> tuple[Atom, ...] | None:
    """The scalars but for some of them; None if these are not among them."""
    left = list(scalars)
    for atom in fewer:
        if atom not in left:
            return None
        left.remove(atom)
    return tuple(left)
