"""Expressions as they stand, for the checker: every root is a variable of its own, known by its square, and a value."""

from __future__ import annotations

from collections.abc import Callable
from contextlib import suppress
from fractions import Fraction

import sympy

from chasles.checker.expressions.expressions import Expressions
from chasles.checker.expressions.reals import Reals
from chasles.checker.sparse import ZERO, Polynomial, Rejected, exponents, number, variable


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


class Symbolic(Expressions):
    """Reads expressions in variables; what is in numbers only has a value in `reals`."""

    def __init__(self, names: dict[str, str], units: dict[str, Fraction]) -> None:
        super().__init__(names, units)
        self.reals = Reals()
        self._numbers = Valuation(self, self.reals, self._number)
        self._by_square: dict[tuple[frozenset[tuple[int, int]], ...], int] = {}

    def root(self, value: Polynomial) -> Polynomial:
        """The nonnegative square root, as a variable."""
        square, below = self.cleared(value)
        key = frozenset((*square.terms.items(), (-1, square.below))), frozenset(below.items())
        if key not in self._by_square:
            self._by_square[key] = self.fresh("root", self.normal(value))
            self.words.add(self._by_square[key])
        return variable(self._by_square[key])

    def called(self, function: str, *arguments: Polynomial) -> Polynomial:
        """The value of a function, as a variable."""
        arguments = tuple(map(self.normal, arguments))
        named = ((place, of) for place, (name, of) in self.calls.items() if name == function)
        place = next((k for k, of in named if not any(a - b for a, b in zip(of, arguments, strict=True))), None)
        if place is None:
            place = self.fresh(f"{function} {len(self.calls) + 1}")
            self.calls[place] = function, arguments
        return variable(place)

    def sign(self, value: Polynomial) -> int:
        """1, 0 or -1, for what is a number."""
        return self.reals.sign(self._numbers(value))

    def is_near(self, value: Polynomial, other: Fraction, distance: Fraction) -> bool:
        """Whether a number is known to differ from another by less than a distance."""
        return self.reals.is_near(self._numbers(value), other, distance)

    def part_of_turn(self, y: Polynomial, x: Polynomial) -> Fraction | None:
        """The multiple of pi that is the angle of a point, which is of numbers, if it is seen to be one."""
        with suppress(Rejected):
            return self.reals.part_of_turn(*map(self._numbers, (y, x)))
        return None

    def _number(self, place: int) -> Polynomial:
        if self.atoms.get(place) is sympy.pi:
            return self.reals.pi
        raise Rejected(f"{self.names[place]} is no number")
