"""The fields from which towers of square roots rise: rational numbers, and rational functions of further numbers.

Numbers that square roots do not express, such as pi or the cotangent of 20 degrees, are the variables of rational
functions. A function other than zero may vanish at these numbers all the same: its sign is read from an enclosure of
its value (R. E. Moore, Interval Analysis, 1966), and not told where that holds zero.
"""

from __future__ import annotations

from collections.abc import Sequence
from fractions import Fraction
from functools import lru_cache, reduce
from math import gcd, isqrt, lcm, prod
from operator import mul
from textwrap import shorten
from typing import Any

import sympy as sp

from chasles.algebra.squarefree import squarefree
from chasles.exact.enclosures import enclosed, intervals

FEWEST_BITS, MOST_BITS = 128, 2048
PLACES = (7, 11, 13, 17, 19)
"""Where a rational function that is a square has a square for its value."""


class NotDecided(ArithmeticError):
    """Nothing that is known decides whether the number is zero."""


class RationalNumbers:
    """Fractions."""

    atoms: tuple[Any, ...] = ()

    def __call__(self, expression: Any) -> Fraction:
        """The element that a rational number is."""
        return Fraction(int(expression.p), int(expression.q))

    def expression(self, x: Fraction, times: Any = sp.S.One) -> Any:
        """The element, times a number without a rational factor, as SymPy spells it."""
        return sp.Rational(x.numerator, x.denominator) * times

    def sign(self, x: Fraction) -> int:
        """1, 0 or -1."""
        return (x > 0) - (x < 0)

    def root(self, x: Fraction) -> Fraction | None:
        """A square root in the field, if there is one."""
        return _root(x.numerator, x.denominator)

    def length(self, x: Fraction) -> int:
        """About how long the element is when it is written, in binary digits."""
        return 12 + x.numerator.bit_length() + x.denominator.bit_length()

    def square_within(self, elements: Sequence[Fraction]) -> Fraction:
        """A number by whose square the elements are divided: integers are left, with no square in common."""
        below = lcm(*(x.denominator for x in elements))
        content = gcd(*(x.numerator * (below // x.denominator) for x in elements)) * below
        return Fraction(_square_in(content), below)


class RationalFunctions:
    """Quotients of polynomials in numbers that are taken for independent, the `atoms`."""

    def __init__(self, atoms: tuple[Any, ...]) -> None:
        self.atoms = atoms
        self._field = sp.ZZ.frac_field(*(sp.Symbol(f"x{place}") for place in range(len(atoms))))

    def __call__(self, expression: Any) -> Any:
        """The element that a rational number, or an atom, is."""
        if expression.is_Rational:
            ring = self._field.field.ring
            return self._field.field.raw_new(ring.ground_new(int(expression.p)), ring.ground_new(int(expression.q)))
        return self._field.gens[self.atoms.index(expression)]

    def expression(self, x: Any, times: Any = sp.S.One) -> Any:
        """The element, times a square root, as SymPy spells it: multiplied out, no rational number divides below."""
        if not x:
            return sp.Integer(0)
        above, below = self._terms(x.numer, times), self._terms(x.denom, sp.Integer(1))
        content = sp.Rational(gcd(*(int(c.p) for c, _ in below)), lcm(*(int(c.q) for c, _ in below)))
        over, under = (sp.Add(*(c / content * power for c, power in terms)) for terms in (above, below))
        return over / under

    def _terms(self, polynomial: Any, times: Any) -> list[tuple[Any, Any]]:
        """Of each term a rational number and what it multiplies."""
        powers = ((int(c), _power(self.atoms, exponents, times)) for exponents, c in polynomial.terms())
        return [(c * number, power) for c, (number, power) in powers]

    def sign(self, x: Any) -> int:
        """1, 0 or -1; raises NotDecided where enclosures do not tell the value from zero."""
        bits = FEWEST_BITS
        while x and bits <= MOST_BITS:
            at = [_interval(atom, bits) for atom in self.atoms]
            signs = [_sign_of(part, at, bits) for part in (x.numer, x.denom)]
            if all(signs):
                return prod(signs)
            bits *= 2
        if x:
            raise NotDecided(f"nothing decides the sign of {shorten(str(self.expression(x)), 80)}")
        return 0

    def root(self, x: Any) -> Any:
        """A square root in the field, if there is one."""
        at = list(zip(x.numer.ring.gens, PLACES, strict=False))
        values = [int(part.evaluate(at)) for part in (x.numer, x.denom)]
        if all(values) and _root(*values) is None:
            return None
        (above, factors), (below, divisors) = (part.sqf_list() for part in (x.numer, x.denom))
        number = _root(int(above), int(below))
        if number is None or any(power % 2 for _, power in (*factors, *divisors)):
            return None
        found = self._field.field.one * number.numerator / number.denominator
        return found * _powers(factors, self._field.one) / _powers(divisors, self._field.one)

    def length(self, x: Any) -> int:
        """About how long the element is when it is written, in binary digits."""
        return sum(12 + int(c).bit_length() for part in (x.numer, x.denom) for c in part.coeffs())

    def square_within(self, elements: Sequence[Any]) -> Any:
        """A function by whose square the elements are divided: what is left has no square in common."""
        below = reduce(lambda one, other: one.lcm(other), (x.denom for x in elements))
        content = reduce(lambda one, other: one.gcd(other), (x.numer * below.exquo(x.denom) for x in elements))
        above, under = (self._square_in(polynomial) for polynomial in (content, below))
        return above / under

    def _square_in(self, polynomial: Any) -> Any:
        """The largest polynomial found whose square divides one."""
        number, factors = polynomial.sqf_list()
        return self._field.field.one * _square_in(abs(int(number))) * _powers(factors, self._field.one)


@lru_cache(maxsize=500)
def _power(atoms: tuple[Any, ...], exponents: tuple[int, ...], times: Any) -> tuple[Any, Any]:
    """A product of powers, times a number: its rational factor and what that multiplies."""
    found = prod((atom**k for atom, k in zip(atoms, exponents, strict=True)), start=times).as_coeff_Mul(rational=True)
    return found[0], found[1]


def _powers(factors: Sequence[tuple[Any, int]], one: Any) -> Any:
    """The product of the factors, each with half its power."""
    return reduce(mul, (factor ** (power // 2) for factor, power in factors), one)


def _root(above: int, below: int) -> Fraction | None:
    if above * below < 0:
        return None
    quotient = Fraction(abs(above), abs(below))
    over, under = isqrt(quotient.numerator), isqrt(quotient.denominator)
    return Fraction(over, under) if Fraction(over, under) ** 2 == quotient else None


def _square_in(number: int) -> int:
    """The largest integer found whose square divides a positive one."""
    parts = squarefree(number)
    return 1 if parts is None else parts[0]


def _sign_of(polynomial: Any, at: Sequence[Any], bits: int) -> int:
    """The sign of an integer polynomial at intervals; zero where these do not tell."""
    number = intervals(bits).mpf
    terms = (
        prod((x**k for x, k in zip(at, powers, strict=True)), start=number(int(c))) for powers, c in polynomial.terms()
    )
    value = sum(terms, number(0))
    return bool(value > 0) - bool(value < 0)


@lru_cache(maxsize=500)
def _interval(atom: Any, bits: int) -> Any:
    """An enclosure of the number."""
    return enclosed(atom, bits)
