"""Polynomials for the checker of certificates: exact, sparse, and nobody else's."""

from __future__ import annotations

from fractions import Fraction
from functools import reduce
from math import lcm
from operator import or_

__all__ = ["MOST_VARIABLES", "ONE", "ZERO", "Polynomial", "Rejected", "exponents", "number", "variable"]

MOST_VARIABLES = 4096
GUARD = int.from_bytes(b"\x80" * MOST_VARIABLES, "big")


class Rejected(ValueError):
    """What was to be checked does not show what it says; the message says why."""


class Polynomial:
    """Integers by monomial, none of them zero, over one integer; byte k of a monomial is variable k's exponent."""

    __slots__ = ("below", "terms")

    def __init__(self, terms: dict[int, int], below: int = 1) -> None:
        # With every exponent below 128, two monomials are multiplied by adding them, and none spills over its byte.
        if reduce(or_, terms, 0) & GUARD:
            raise Rejected("an exponent is larger than 127")
        self.terms, self.below = terms, below

    def __bool__(self) -> bool:
        return bool(self.terms)

    def __add__(self, other: Polynomial) -> Polynomial:
        large, small = (self, other) if len(self.terms) > len(other.terms) else (other, self)
        below = lcm(large.below, small.below)
        one, another = below // large.below, below // small.below
        total = dict(large.terms) if one == 1 else {monomial: c * one for monomial, c in large.terms.items()}
        for monomial, coefficient in small.terms.items():
            if value := total.get(monomial, 0) + coefficient * another:
                total[monomial] = value
            else:
                del total[monomial]
        return Polynomial(total, below)

    def __neg__(self) -> Polynomial:
        return Polynomial({monomial: -coefficient for monomial, coefficient in self.terms.items()}, self.below)

    def __sub__(self, other: Polynomial) -> Polynomial:
        return self + -other

    def __mul__(self, other: Polynomial) -> Polynomial:
        total: dict[int, int] = {}
        for one, coefficient in self.terms.items():
            for another, factor in other.terms.items():
                total[one + another] = total.get(one + another, 0) + coefficient * factor
        return Polynomial({monomial: c for monomial, c in total.items() if c}, self.below * other.below)

    @property
    def places(self) -> set[int]:
        """The variables that occur."""
        return {place for place, _ in exponents(reduce(or_, self.terms, 0))}

    def partials(self) -> dict[int, Polynomial]:
        """The derivative by each variable that occurs."""
        total: dict[int, dict[int, int]] = {}
        for monomial, coefficient in self.terms.items():
            for place, exponent in exponents(monomial):
                total.setdefault(place, {})[monomial - (1 << 8 * place)] = coefficient * exponent
        return {place: Polynomial(terms, self.below) for place, terms in total.items()}


def exponents(monomial: int) -> list[tuple[int, int]]:
    """The variables of a monomial with their exponents."""
    return [(k, e) for k, e in enumerate(monomial.to_bytes(monomial.bit_length() // 8 + 1, "little")) if e]


def variable(place: int, power: int = 1) -> Polynomial:
    """A power of a variable."""
    return Polynomial({power << 8 * place: 1})


def number(value: int | Fraction) -> Polynomial:
    """A constant."""
    return Polynomial({0: value.numerator} if value else {}, value.denominator)


ZERO, ONE = number(0), number(1)
