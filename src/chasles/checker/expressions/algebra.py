"""Polynomials of which some variables have known squares and some are inverses: their normal forms, for the checker.

The squares are those of roots, given by earlier variables, and of sines, given by cosines. Their leading terms are
coprime, so that a polynomial vanishes because of them only if nothing is left of it (Buchberger's first criterion).
"""

from __future__ import annotations

from collections.abc import Callable, Mapping
from fractions import Fraction
from math import gcd

from chasles.checker.sparse import ZERO, Polynomial, Rejected, cleared, exponents, number, packed, product, variable

MOST_DIGITS = 10_000_000
Key = frozenset[tuple[int, int]]


class QuotientRing:
    """Variables by place: `squares` says what the squares of some are, `inverses` of what others are the inverse.

    A reading knows the `root` of a value, the value of a function that is `called`, and what `is_near`.
    """

    root: Callable[[Polynomial], Polynomial]
    called: Callable[..., Polynomial]
    is_near: Callable[[Polynomial, Fraction, Fraction], bool]

    def __init__(self) -> None:
        self.names: list[str] = []
        self.squares: dict[int, Polynomial] = {}
        self.inverses: dict[int, Polynomial] = {}
        self._inverse_of: dict[Key, int] = {}
        self._twice = self._below = 0

    def fresh(self, name: str, square: Polynomial | None = None) -> int:
        """The place of a new variable; `square` is what its square is."""
        self.names.append(name)
        place = len(self.names) - 1
        if square is not None:
            self.squares[place] = square
            self._twice |= packed(place + 1) - packed(place, 2)
        return place

    def normal(self, polynomial: Polynomial) -> Polynomial:
        """The polynomial with known squares put in until none is left."""
        while any(monomial & self._twice for monomial in polynomial.terms):
            parts: dict[int, dict[int, int]] = {}
            for monomial, coefficient in polynomial.terms.items():
                halves = sum(packed(place, power // 2) for place, power in exponents(monomial & self._twice))
                parts.setdefault(halves, {})[monomial - 2 * halves] = coefficient
            total = ZERO
            for halves, terms in parts.items():
                total += Polynomial(terms, polynomial.below) * product(self.squares, halves)
            polynomial = total
        return polynomial

    def cleared(self, polynomial: Polynomial) -> tuple[Polynomial, dict[int, int]]:
        """The normal form of the polynomial times the least powers of what is divided by that leave no inverse in it.

        The powers are by the places of the inverses.
        """
        numerator, powers = cleared(polynomial, self.inverses, self._below)
        return self.normal(numerator), dict(exponents(powers))

    def undivided(self, value: Polynomial) -> Polynomial:
        """What has the same sign, with nothing divided by."""
        numerator, below = self.cleared(value)
        return self.normal(numerator * self.divisors({place: power % 2 for place, power in below.items()}))

    def vanishes(self, polynomial: Polynomial) -> bool:
        """Whether nothing is left of the polynomial."""
        return not self.cleared(polynomial)[0]

    def divisors(self, powers: Mapping[int, int]) -> Polynomial:
        """The product of what is divided by, to these powers."""
        return product(self.inverses, sum(packed(*pair) for pair in powers.items()))

    def inverse(self, polynomial: Polynomial) -> Polynomial:
        """One over the polynomial: a variable of its own, unless it is a number; raises `Rejected` for zero."""
        numerator, below = self.cleared(polynomial)
        if not numerator:
            raise Rejected("what is divided by is zero")
        above = self.divisors(below)
        if (value := constant(numerator)) is not None:
            return above * number(1 / value)
        scale, base = primitive(numerator)
        key = frozenset(base.terms.items())
        if key not in self._inverse_of:
            place = self._inverse_of[key] = self.fresh(f"inverse {len(self.inverses) + 1}")
            self.inverses[place] = base
            self._below |= packed(place + 1) - packed(place)
        return above * variable(self._inverse_of[key]) * number(1 / scale)

    def inverse_place(self, polynomial: Polynomial) -> int | None:
        """The place of the inverse of the polynomial, up to a factor, if it has one."""
        return self._inverse_of.get(frozenset(primitive(self.normal(polynomial))[1].terms.items()))

    def power(self, base: Polynomial, exponent: int) -> Polynomial:
        """A power with a natural exponent."""
        if (value := constant(base)) is not None:
            if max(value.numerator.bit_length(), value.denominator.bit_length()) * exponent > MOST_DIGITS:
                raise Rejected("a number is raised to a very large power")
            return number(value**exponent)
        total = number(1)
        while exponent:
            total = self.normal(total * base) if exponent % 2 else total
            exponent //= 2
            base = self.normal(base * base) if exponent else base
        return total

    def complex_power(self, x: Polynomial, y: Polynomial, exponent: int) -> tuple[Polynomial, Polynomial]:
        """The two parts of a power of x + i y with a natural exponent."""
        real, imaginary = number(1), ZERO
        for _ in range(exponent):
            real, imaginary = self.normal(real * x - imaginary * y), self.normal(real * y + imaginary * x)
        return real, imaginary


def constant(polynomial: Polynomial) -> Fraction | None:
    """The number that a polynomial is; None if it is none."""
    return Fraction(polynomial.terms.get(0, 0), polynomial.below) if polynomial.terms.keys() <= {0} else None


def primitive(polynomial: Polynomial) -> tuple[Fraction, Polynomial]:
    """A number and a polynomial whose product this is: whole coprime coefficients, that of the top term positive."""
    content = gcd(*polynomial.terms.values()) or 1
    if polynomial.terms and polynomial.terms[max(polynomial.terms)] < 0:
        content = -content
    return Fraction(content, polynomial.below), Polynomial({m: c // content for m, c in polynomial.terms.items()})
