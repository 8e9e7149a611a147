"""Roots of polynomials, for the checker: known by their squares, as a certificate says them, or visibly roots."""

from __future__ import annotations

from collections.abc import Iterable, Mapping, Sequence
from fractions import Fraction
from functools import reduce
from math import isqrt
from operator import and_, mul

from chasles.checker.expressions.algebra import constant, primitive
from chasles.checker.expressions.factoring import Terms, quotient, root_of_square
from chasles.checker.expressions.signs import SignedReading, is_nonnegative
from chasles.checker.sparse import ONE, Polynomial, Rejected, exponents, number, packed, variable


class KnownRoots(SignedReading):
    """Reads expressions, each root as what is known to be it.

    `domains` must not be negative for the roots to be real. It is `complete` once all is read that the certificate
    says: from then on, roots of which it does not speak are variables of their own; it `adds_roots` of whole numbers
    already once there is an angle of a point.
    """

    def __init__(self, names: dict[str, str], units: dict[str, Fraction]) -> None:
        super().__init__(names, units)
        self.domains: list[Polynomial] = []
        self.complete = self.adds_roots = False
        self._roots: dict[Terms, tuple[Fraction, Polynomial]] = {}

    def require_nonnegative(self, value: Polynomial) -> None:
        """Something is visibly not negative, or has to be said to be."""
        value = self.undivided(value)
        if not is_nonnegative(self, value):
            self.domains.append(value)
            self.know(value)

    def state_word(self, name: str, square: Polynomial, visible: bool) -> None:
        """A new variable is the root of what has to be not negative, where that is not `visible`."""
        root = self._new_root(square, name)
        if not visible:
            self.require_nonnegative(square)
        scale, key = _key(square)
        self._roots.setdefault(key, (scale, root))

    def state_root(self, square: Polynomial, factors: Sequence[Polynomial]) -> None:
        """The root of a polynomial: factors that are not negative, and whose product squared it is."""
        if not all(map(self.is_seen, map(self.normal, factors))):
            raise Rejected("a root is said to be what is not seen to be nonnegative")
        root = self.normal(reduce(mul, factors, ONE))
        if self.normal(square - root * root):
            raise Rejected("a root is said to be what does not have the right square")
        scale, key = _key(self.normal(square))
        self._roots[key] = scale, root

    def equal(self, one: list[Polynomial], other: list[Polynomial]) -> Polynomial:
        """The difference of two products, which is zero: no factor is negative, and the squares are the same."""
        if not all(map(self.is_seen, map(self.normal, (*one, *other)))):
            raise Rejected("something is said to be equal that is not seen to be nonnegative")
        left, right = reduce(mul, one, ONE), reduce(mul, other, ONE)
        if self.normal(left * left - right * right):
            raise Rejected("something is said to be equal that has different squares")
        return self.normal(left - right)

    def root(self, value: Polynomial) -> Polynomial:
        """The nonnegative square root, as the certificate says it."""
        numerator, below = self._lowest(*self.cleared(value))
        odd = [place for place, power in below.items() if power % 2]
        inside, outside = self.normal(numerator * self.divisors(dict.fromkeys(odd, 1))), ONE
        parts = [self.inverses[place] for place in odd]
        apart = parts and _key(inside)[1] not in self._roots and all(_key(part)[1] in self._roots for part in parts)
        for place, power in below.items():
            half = power // 2 if apart else (power + 1) // 2
            outside *= self.power(self.absolute(self.inverses[place]) * variable(place, 2), half)
        if apart:
            return self.normal(reduce(mul, (*map(self.root, (numerator, *parts)), *map(variable, odd), outside)))
        if (square := constant(inside)) is not None:
            return self._of_number(square) * outside
        scale, key = _key(inside)
        if key not in self._roots:
            even = reduce(and_, (_powers(monomial, self.positive) for monomial in inside.terms))
            half = sum(packed(place, max(n for k, n in even if k == place) // 2) for place in {k for k, _ in even})
            inside = Polynomial({monomial - 2 * half: c for monomial, c in inside.terms.items()}, inside.below)
            outside = outside * Polynomial({half: 1})
            if (square := constant(inside)) is not None:
                return self._of_number(square) * outside
            scale, key = _key(inside)
        if key not in self._roots and (root := self._by_factors(inside)) is not None:
            self._roots[key] = scale, root
        if key not in self._roots:
            positive = self.complete and self.is_number(inside) and self.sign(inside) > 0
            if positive or root_of_square(inside) is not None or self.is_seen(inside):
                self._roots[key] = scale, self._new_root(inside)
        if key not in self._roots:
            raise Rejected("the certificate does not say what a root is")
        known, root = self._roots[key]
        return self.normal(root * self._of_number(scale / known) * outside)

    def _by_factors(self, inside: Polynomial) -> Polynomial | None:
        """The root of a product of what known roots are of."""
        total = ONE
        for key, (scale, root) in [*self._roots.items()]:
            square = Polynomial(dict(key)) * number(scale)
            while constant(square) is None is constant(inside) and (left := quotient(inside, square)) is not None:
                inside, total = left, total * root
        scale, base = primitive(inside)
        whole = root_of_square(base) if scale > 0 else None
        rest = next((side for side in (whole, whole and -whole) if side and self.is_seen(side)), None)
        return self.normal(total * rest * self._of_number(scale)) if rest else None

    def _lowest(self, numerator: Polynomial, below: Mapping[int, int]) -> tuple[Polynomial, dict[int, int]]:
        """A fraction without the divisors that are factors of its numerator."""
        powers = dict(below)
        for place in below:
            while powers[place] and (rest := quotient(numerator, self.inverses[place])) is not None:
                numerator, powers[place] = rest, powers[place] - 1
        return numerator, powers

    def in_lowest_terms(self, value: Polynomial) -> Polynomial:
        """The same without divisors that are factors of the rest."""
        numerator, below = self._lowest(*self.cleared(value))
        return numerator * Polynomial({sum(packed(*pair) for pair in below.items()): 1})

    def _of_number(self, square: Fraction) -> Polynomial:
        """The root of a rational number in the roots of whole numbers that the certificate has."""
        rest, total = square.numerator * square.denominator, number(Fraction(1, square.denominator))
        for place in sorted(self.words):
            factor = constant(self.squares[place])
            while factor is not None and factor > 1 and rest % factor == 0:
                rest //= factor.numerator
                total = self.normal(total * variable(place))
        if rest > 0 and isqrt(rest) ** 2 != rest and self.adds_roots:
            return total * self._new_root(number(rest))
        if rest < 0 or isqrt(rest) ** 2 != rest:
            raise Rejected(f"the certificate does not say what the root of {square} is")
        return total * number(isqrt(rest))

    def _new_root(self, square: Polynomial, name: str = "") -> Polynomial:
        """The root of what is not negative; it has no name where the certificate does not speak of it."""
        place = self.named(name, square) if name else self.fresh("root", square)
        self.words.add(place)
        if square.places <= self.numeric:
            self.numeric.add(place)
        return variable(place)

    def absolute(self, value: Polynomial) -> Polynomial:
        """The absolute value: the root of the square, or what is visibly not negative."""
        value = self.normal(value)
        if self.complete and self.is_known(value):
            return value
        if _key(self.normal(value * value))[1] in self._roots or value.places & set(self.inverses):
            return self.root(self.normal(value * value))
        if self.is_seen(value):
            return value
        return -value if self.is_seen(-value) else self.root(self.normal(value * value))


def _powers(monomial: int, places: Iterable[int]) -> frozenset[tuple[int, int]]:
    """The even powers of some variables in a monomial."""
    return frozenset((k, 2 * n) for k, power in exponents(monomial) if k in places for n in range(1, power // 2 + 1))


def _key(polynomial: Polynomial) -> tuple[Fraction, Terms]:
    scale, base = primitive(polynomial)
    return scale, frozenset(base.terms.items())
