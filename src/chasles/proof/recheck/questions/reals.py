"""Real numbers for the checker: sums of products of pi, of arctangents and of square roots, also nested ones.

Such a number is known to be zero if nothing is left of its normal form, and known to be positive or negative by
rational numbers between which it lies. Where neither is known, the checker rejects.
"""

from __future__ import annotations

from fractions import Fraction
from math import isqrt

from chasles.proof.recheck.questions.algebra import Algebra, constant, primitive
from chasles.proof.recheck.sparse import ONE, Polynomial, Rejected, exponents, number, variable

__all__ = ["Reals"]

Bounds = tuple[Fraction, Fraction]
DIGITS = (64, 256, 1024)
"""Binary digits with which a sign is looked for."""
LARGEST_PRIME = 10_000


class Reals(Algebra):
    """Variables that are positive real numbers; polynomials in them are numbers."""

    def __init__(self) -> None:
        super().__init__()
        self._tangents: dict[int, Fraction] = {}
        self._angles: dict[Fraction, int] = {}
        self._roots: dict[tuple[int, frozenset[tuple[int, int]]], int] = {}
        self._measured: dict[tuple[int, int], Bounds] = {}
        self.pi = self.arctangent(Fraction(1)) * number(4)

    def arctangent(self, tangent: Fraction) -> Polynomial:
        """The angle between quarter turns that has this tangent."""
        if tangent <= 0:
            return -self.arctangent(-tangent) if tangent else number(0)
        if tangent not in self._angles:
            place = self._angles[tangent] = self.fresh(f"atan({tangent})")
            self._tangents[place] = tangent
        return variable(self._angles[tangent])

    def angle(self, value: Polynomial) -> list[tuple[Fraction, Fraction]] | None:
        """The number as a sum of multiples of arctangents: tangents and multiples; None if it is none."""
        parts = []
        for monomial, coefficient in self.normal(value).terms.items():
            match exponents(monomial):
                case [(place, 1)] if place in self._tangents:
                    parts.append((self._tangents[place], Fraction(coefficient, value.below)))
                case _:
                    return None
        return parts

    def root(self, value: Polynomial) -> Polynomial:
        """The square root; raises `Rejected` for a negative number."""
        numerator, below = self.cleared(value)
        inside, outside = numerator, ONE
        for place, power in below.items():
            inside = inside * self.inverses[place] if power % 2 else inside
            size = variable(place) * number(self.sign(self.inverses[place]))
            outside *= self.power(size, (power + 1) // 2)
        inside = self.normal(inside)
        sign = self.sign(inside)
        if sign < 0:
            raise Rejected("a square root is taken of a negative number")
        return self._root(inside) * outside if sign else number(0)

    def _root(self, value: Polynomial) -> Polynomial:
        """The square root of a positive number that divides by nothing."""
        if (known := self._simple_root(value)) is not None:
            return known
        for place in list(self._roots.values()):
            together = self.normal(value * self.squares[place])
            if constant(self.squares[place]) is None and (known := self._simple_root(together)) is not None:
                return known * self.inverse(variable(place))
        scale, base = primitive(value)
        if scale < 0:
            scale, base = -scale, -base
        return self._of_rational(scale) * self._variable(base)

    def _simple_root(self, value: Polynomial) -> Polynomial | None:
        """The root of a single product, or of a + b sqrt(n) as a sum of two roots of numbers, if that is one."""
        if len(value.terms) == 1:
            ((monomial, coefficient),) = value.terms.items()
            total = self._of_rational(Fraction(coefficient, value.below))
            for place, power in exponents(monomial):
                total *= self.power(variable(place), power // 2)
                total *= self._variable(variable(place)) if power % 2 else ONE
            return total
        root = next((m for m in value.terms if m), 0)
        square = constant(self.normal(Polynomial({2 * root: 1})))
        if len(value.terms) != 2 or 0 not in value.terms or square is None:
            return None
        a, b = (Fraction(value.terms[monomial], value.below) for monomial in (0, root))
        rest = a * a - b * b * square
        c = Fraction(isqrt(max(rest.numerator, 0)), isqrt(rest.denominator))
        if c * c != rest or a <= 0:
            return None
        one, other = self._of_rational((a + c) / 2), self._of_rational((a - c) / 2)
        return one + other if b > 0 else one - other

    def _of_rational(self, value: Fraction) -> Polynomial:
        """The root of a nonnegative rational number: a multiple of roots of primes, and of one that is not factored."""
        if value < 0:
            raise Rejected("a square root is taken of a negative number")
        rest, total, factor = value.numerator * value.denominator, number(Fraction(1, value.denominator)), 2
        while rest > 1 and factor <= LARGEST_PRIME and factor * factor <= rest:
            power = 0
            while rest % factor == 0:
                rest, power = rest // factor, power + 1
            total *= number(factor ** (power // 2))
            total *= self._variable(number(factor)) if power % 2 else ONE
            factor += 1
        if isqrt(rest) ** 2 == rest:
            return total * number(isqrt(rest))
        return total * self._variable(number(rest))

    def _variable(self, square: Polynomial) -> Polynomial:
        key = square.below, frozenset(square.terms.items())
        if key not in self._roots:
            self._roots[key] = self.fresh(f"root {len(self._roots) + 1}", square)
        return variable(self._roots[key])

    def sign(self, value: Polynomial) -> int:
        """1, 0 or -1; raises `Rejected` where that cannot be told."""
        numerator, below = self.cleared(value)
        if not numerator:
            return 0
        for digits in DIGITS:
            least, most = self._bounds(numerator, digits)
            if least > 0 or most < 0:
                sign = 1 if least > 0 else -1
                for place, power in below.items():
                    sign *= self.sign(self.inverses[place]) if power % 2 else 1
                return sign
        raise Rejected("whether a number is zero cannot be told")

    def is_near(self, value: Polynomial, other: Fraction, distance: Fraction) -> bool:
        """Whether a number is known to differ from another by less than a distance."""
        return self.sign(value - number(other - distance)) > 0 > self.sign(value - number(other + distance))

    def _bounds(self, value: Polynomial, digits: int) -> Bounds:
        least = most = Fraction(0)
        for monomial, coefficient in value.terms.items():
            low = high = Fraction(coefficient)
            for place, power in exponents(monomial):
                below, above = self._bounds_of(place, digits)
                low, high = low * below**power, high * above**power
            least, most = least + min(low, high), most + max(low, high)
        return least / value.below, most / value.below

    def _bounds_of(self, place: int, digits: int) -> Bounds:
        if (place, digits) not in self._measured:
            if place in self.squares:
                low, high = self._bounds(self.squares[place], digits)
                least, most = isqrt(int(max(low, Fraction(0)) * 4**digits)), isqrt(int(high * 4**digits) + 1) + 1
            else:
                least, most = _arctangent(self._tangents[place], digits)
            self._measured[place, digits] = Fraction(least, 2**digits), Fraction(most, 2**digits)
        return self._measured[place, digits]


def _arctangent(tangent: Fraction, digits: int) -> tuple[int, int]:
    """Whole numbers of units of so many binary digits between which the arctangent of a positive number lies.

    Euler's series, whose terms are positive and each less than x^2/(1 + x^2) times the one before.
    """
    if tangent > 1:
        (least, most), (low, high) = _arctangent(Fraction(1), digits), _arctangent(1 / tangent, digits)
        return 2 * least - high, 2 * most - low
    unit, ratio = 1 << digits, tangent * tangent / (1 + tangent * tangent)
    term = int(tangent / (1 + tangent * tangent) * unit)
    total = count = 0
    while term:
        total, count = total + term, count + 1
        term = term * 2 * count * ratio.numerator // ((2 * count + 1) * ratio.denominator)
    # Each term is less than its number of units too small, and what is left out less than twice that of the next.
    return total, total + (count + 2) * (count + 2)
