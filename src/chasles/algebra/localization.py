"""Fractions without greatest common divisors: a numerator over powers of declared nonzero factors.

Nothing is ever cancelled, because a fraction vanishes exactly when its numerator does; and what is divided by stays in
sight, as the list of these factors.
"""

from __future__ import annotations

from dataclasses import dataclass, field
from fractions import Fraction
from itertools import zip_longest

from chasles.algebra.rings import Polynomial, Ring
from chasles.algebra.work_limit import afford, spend


@dataclass(slots=True)
class Localization:
    """A localization of a ring: fractions whose denominators are products of factors that are declared nonzero."""

    ring: Ring
    nonzero: list[Polynomial]
    _products: dict[tuple[int, ...], Polynomial] = field(default_factory=dict)

    def ratio(self, numerator: Polynomial) -> Ratio:
        """A polynomial as a fraction."""
        return Ratio(self, numerator, ())

    def constant(self, value: Fraction | int) -> Ratio:
        """A rational number as a fraction."""
        return Ratio(self, self.ring.constant(Fraction(value)), ())

    def power_product(self, exponents: tuple[int, ...]) -> Polynomial:
        """The product of the nonzero factors with the given exponents."""
        if exponents not in self._products:
            total = self.ring.constant(Fraction(1))
            for factor, exponent in zip(self.nonzero, exponents, strict=False):
                for _ in range(exponent):
                    total = times(total, factor)
            self._products[exponents] = total
        return self._products[exponents]


@dataclass(frozen=True, slots=True)
class Ratio:
    """numerator / product of atom_k ** denominator[k]; trailing zeros of the exponents are left out."""

    field: Localization
    numerator: Polynomial
    denominator: tuple[int, ...]

    def __add__(self, other: Ratio) -> Ratio:
        spend(len(self.numerator) + len(other.numerator))
        if self.denominator == other.denominator:
            return Ratio(self.field, self.numerator + other.numerator, self.denominator)
        common = tuple(map(max, zip_longest(self.denominator, other.denominator, fillvalue=0)))
        return Ratio(self.field, self.over(common) + other.over(common), common)

    def __neg__(self) -> Ratio:
        return Ratio(self.field, -self.numerator, self.denominator)

    def __sub__(self, other: Ratio) -> Ratio:
        return self + (-other)

    def __mul__(self, other: Ratio) -> Ratio:
        numerator = times(self.numerator, other.numerator)
        return Ratio(self.field, numerator, joined(self.denominator, other.denominator))

    def over(self, denominator: tuple[int, ...]) -> Polynomial:
        """The numerator over a denominator that this one's divides."""
        missing = tuple(a - b for a, b in zip_longest(denominator, self.denominator, fillvalue=0))
        return times(self.numerator, self.field.power_product(missing)) if any(missing) else self.numerator

    def divided(self, constant: Fraction, exponents: tuple[int, ...]) -> Ratio:
        """The fraction divided by a constant times a product of powers of nonzero factors.

        A factor that moves into the numerator stays in the denominator too, so that it is seen to have been divided by.
        """
        numerator = self.numerator if constant == 1 else self.numerator * self.field.ring.constant(1 / constant)
        total = joined(self.denominator, exponents)
        if any(exponent < 0 for exponent in total):
            numerator = numerator * self.field.power_product(tuple(1 - e if e < 0 else 0 for e in total))
            total = tuple(1 if exponent < 0 else exponent for exponent in total)
        return Ratio(self.field, numerator, total)

    def multiplied(self, exponents: tuple[int, ...]) -> Ratio:
        """The same fraction, above and below multiplied by powers of nonzero factors."""
        numerator = times(self.numerator, self.field.power_product(exponents))
        return Ratio(self.field, numerator, joined(self.denominator, exponents))

    @property
    def is_zero(self) -> bool:
        """Whether the numerator is the zero polynomial."""
        return bool(self.numerator == 0)


def quotient(above: Ratio, below: Ratio, scale: Fraction, exponents: tuple[int, ...]) -> Ratio:
    """One fraction over another, whose numerator is the scale times a product of powers of units."""
    field = above.field
    numerator = above.numerator * field.power_product(below.denominator)
    return Ratio(field, numerator, above.denominator).divided(scale, exponents)


def times(one: Polynomial, other: Polynomial) -> Polynomial:
    """The product, counted as work before it is formed; raises `OutOfTime` if that is more than what is left."""
    afford(len(one) * len(other))
    spend(len(one) * len(other))
    return one * other


def joined(one: tuple[int, ...], other: tuple[int, ...]) -> tuple[int, ...]:
    """The exponents of a product of two products of nonzero factors."""
    return tuple(map(sum, zip_longest(one, other, fillvalue=0))) if one and other else one or other
