"""The division that a certificate asks for, carried out once more with its quotients kept: they are the cofactors."""

from __future__ import annotations

from collections.abc import Iterator, Mapping
from dataclasses import dataclass
from fractions import Fraction
from typing import Any

from chasles.checker.division import solved_for
from chasles.checker.quantities import squeezed
from chasles.checker.sparse import (
    ZERO,
    Polynomial,
    Rejected,
    cleared,
    exponents,
    number,
    packed,
    parsed,
    product,
    variable,
)
from chasles.coq.sources import ProofReading, multiples, replaced
from chasles.vocabulary import Node

MOST_REPLACED = 10**5
"""So many terms are replaced at most; Coq would not get through more in reasonable time."""


@dataclass(frozen=True, slots=True)
class Combination:
    """A difference times a product of nonzero factors is the sum of cofactors times what vanishes, by label."""

    powers: int
    cofactors: tuple[tuple[str, Polynomial], ...]


@dataclass(frozen=True, slots=True)
class SolvedVariable:
    """The variable at a place is a numerator over a product of nonzero factors; and why."""

    place: int
    numerator: Polynomial
    below: int
    why: Combination


class Reckoning:
    """What a certificate says, as combinations of what vanishes: the entries of the goals, and what is solved."""

    def __init__(self, reading: ProofReading, certificate: Mapping[str, Any]) -> None:
        self.reading = reading
        self._divisions = [
            (label, *solved_for(_factors(reading, term), reading.vanishing[label]))
            for label, term in certificate.get("division", ())
        ]
        self.solved = [self._solved(name, said) for name, said in certificate.get("solved", {}).items()]
        self._require_no_rates({each.place for each in self.solved})
        reading.settle({each.place: each.numerator * _inverse(each.below) for each in self.solved})
        self._entries = certificate.get("entries", {})

    def _require_no_rates(self, solved: set[int]) -> None:
        """Raises `Rejected` where the goals speak of the rate of what conditions determine, but not it."""
        goals = self.reading.problem.goals
        places = {k for goal in goals for *_, entry in self.reading.difference(*goal.sides) for k in entry.places}
        of = {
            (what[1], *what[3:]) for k, what in enumerate(self.reading.variables) if k in solved and what[0] == "entry"
        }
        for what in (self.reading.variables[k] for k in places - solved):
            if what[0] == "entry" and what[2] and (what[1], *what[3:]) in of:
                raise Rejected(f"no proof is written of the rate of {what[1]}, which conditions determine")

    def goal(self, count: int, left: Node, right: Node) -> Iterator[Combination]:
        """The entries of one goal, row by row."""
        written = self.reading.as_written(left, right)
        for i, j, difference in self.reading.difference(left, right):
            said = self._entries.get(f"{count}:{i},{j}")
            squares = self.reading.squares(written[i, j] - difference)
            yield self._combined(written[i, j], said or {}, said is None, squares)

    def _solved(self, name: str, said: Mapping[str, Any]) -> SolvedVariable:
        places, below = self.reading.places, self._below(said)
        place, numerator = places[squeezed(name)], parsed(said["numerator"], places)
        claim = variable(place) - numerator * _inverse(below)
        return SolvedVariable(place, numerator, below, self._combined(claim, said, True))

    def _below(self, said: Mapping[str, Any]) -> int:
        """The nonzero factors that something is divided by."""
        places = self.reading.places
        return sum(packed(places[squeezed(label)], int(power)) for label, power in said.get("denominator", {}).items())

    def _combined(
        self, claim: Polynomial, said: Mapping[str, Any], divides: bool, squares: Mapping[str, Polynomial] | None = None
    ) -> Combination:
        """The claim as a combination; raises `Rejected` if the certificate does not make it one."""
        nonzero, places = self.reading.nonzero, self.reading.places
        over = _inverse(self._below(said))
        found = dict(squares or {})
        for label, text in said.get("cofactors", {}).items():
            found[label] = found.get(label, ZERO) + parsed(text, places) * over
        rest = claim
        for label, cofactor in found.items():
            rest -= cofactor * self.reading.vanishing[label]
        numerator, powers = cleared(rest, nonzero)
        top = _joined(powers, *(cleared(cofactor, nonzero)[1] for cofactor in found.values()))
        scaled = {label: _times(cofactor, top, nonzero) for label, cofactor in found.items()}
        for label, cofactor in self._divided(numerator, divides):
            more = _times(cofactor * _inverse(powers), top, nonzero)
            scaled[label] = scaled.get(label, ZERO) + more
        return Combination(top, tuple((label, cofactor) for label, cofactor in scaled.items() if cofactor))

    def _divided(self, polynomial: Polynomial, divides: bool) -> Iterator[tuple[str, Polynomial]]:
        """The quotients by what vanishes."""
        quotients = [ZERO] * len(self._divisions)
        before, count = -1, 0
        while before < count and divides:
            before = count
            for k, (_, factors, guard, equal) in enumerate(self._divisions):
                while quotient := multiples(polynomial, factors, guard):
                    polynomial = replaced(polynomial, factors, quotient, equal)
                    quotients[k] += quotient
                    count += len(quotient.terms)
                    if count > MOST_REPLACED:
                        raise Rejected("the division is too long")
        if polynomial:
            raise Rejected("something is left when the certificate's division is done")
        for (label, factors, *_), quotient in zip(self._divisions, quotients, strict=True):
            vanishing = self.reading.vanishing[label]
            yield label, quotient * number(Fraction(vanishing.below, vanishing.terms[factors]))


def _factors(reading: ProofReading, term: str) -> int:
    (factors,) = parsed(f"1*{term}", reading.places).terms
    return factors


def _inverse(powers: int) -> Polynomial:
    return Polynomial({powers: 1})


def _joined(*tops: int) -> int:
    powers: dict[int, int] = {}
    for top in tops:
        for place, power in exponents(top):
            powers[place] = max(powers.get(place, 0), power)
    return sum(packed(*pair) for pair in powers.items())


def _times(polynomial: Polynomial, top: int, nonzero: list[Polynomial]) -> Polynomial:
    """A polynomial times the product of nonzero factors, which leaves no inverse in it."""
    numerator, powers = cleared(polynomial, nonzero)
    return numerator * product(nonzero, top - powers)
