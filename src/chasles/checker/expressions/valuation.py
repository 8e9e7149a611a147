"""The values of polynomials at a point, as real numbers."""

from __future__ import annotations

from collections.abc import Callable
from typing import TYPE_CHECKING

from chasles.checker.expressions.reals import Reals
from chasles.checker.sparse import ZERO, Polynomial, Rejected, exponents, number

if TYPE_CHECKING:
    from chasles.checker.expressions.expressions import Expressions


class UnknownValue(Rejected):
    """Something has no value at a point."""


class Valuation:
    """Evaluates what was read, by the values that `given` tells: roots and inverses follow from these."""

    def __init__(self, reading: Expressions, reals: Reals, given: Callable[[int], Polynomial]) -> None:
        self.reading, self.reals, self.given = reading, reals, given
        self._known: dict[int, Polynomial] = {}

    def __call__(self, polynomial: Polynomial) -> Polynomial:
        """The value; raises `Rejected` where it has none, or something in it has no value."""
        total = ZERO
        for monomial, coefficient in polynomial.terms.items():
            term = number(coefficient)
            for place, power in exponents(monomial):
                term = self.reals.normal(term * self.reals.power(self.of(place), power))
            total += term
        return Polynomial(total.terms, total.below * polynomial.below)

    def of(self, place: int) -> Polynomial:
        """The value of a variable."""
        if place not in self._known:
            if place in self.reading.inverses:
                value = self.reals.inverse(self(self.reading.inverses[place]))
            elif place in self.reading.words:
                value = self.reals.root(self(self.reading.squares[place]))
            elif place in self.reading.calls:
                function, arguments = self.reading.calls[place]
                value = self.reals.called(function, *map(self, arguments))
            else:
                value = self.given(place)
            self._known[place] = value
        return self._known[place]
