"""Real numbers for the checker: sums of products of pi, of arctangents and of square roots, also nested ones.

Such a number is known to be zero if nothing is left of its normal form, and known to be positive or negative by
rational numbers between which it lies. Where neither is known, the checker rejects.
"""

from __future__ import annotations

from contextlib import suppress
from fractions import Fraction
from math import isqrt

from chasles.checker.expressions.algebra import QuotientRing, constant, primitive
from chasles.checker.expressions.intervals import Enclosing, Enclosure, Unbounded
from chasles.checker.sparse import ONE, Polynomial, Rejected, exponents, number, variable

DIGITS = (64, 256, 1024)
"""Binary digits with which a sign is looked for."""
LARGEST_PRIME = 10_000
LARGEST_PART = 60
"""Angles are looked for among the multiples of pi with denominators up to this."""


class Reals(QuotientRing):
    """Variables that are positive real numbers; polynomials in them are numbers."""

    def __init__(self) -> None:
        super().__init__()
        self._tangents: dict[int, Fraction] = {}
        self._angles: dict[Fraction, int] = {}
        self._roots: dict[tuple[int, frozenset[tuple[int, int]]], int] = {}
        self._measured: dict[tuple[int, int], Enclosure] = {}
        self._called: dict[int, tuple[str, Polynomial, int]] = {}
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
            outside *= self.power(variable(place) * number(self.sign(self.inverses[place])), (power + 1) // 2)
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
        return total * (number(isqrt(rest)) if isqrt(rest) ** 2 == rest else self._variable(number(rest)))

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
            with suppress(Unbounded):
                sign = self._enclosed(Polynomial(numerator.terms), digits).sign
                if not sign:
                    continue
                for place, power in below.items():
                    sign *= self.sign(self.inverses[place]) if power % 2 else 1
                return sign
        raise Rejected("whether a number is zero cannot be told")

    def is_near(self, value: Polynomial, other: Fraction, distance: Fraction) -> bool:
        """Whether a number is known to differ from another by less than a distance."""
        return self.sign(value - number(other - distance)) > 0 > self.sign(value - number(other + distance))

    def called(self, function: str, *arguments: Polynomial) -> Polynomial:
        """The value of a function: exp, log, cos, sin, or arc, the angle of the point of which y and x are given."""
        values = tuple(map(self.normal, arguments))
        if function == "arc":
            return self._angle(*values) if (part := self.part_of_turn(*values)) is None else self.pi * number(part)
        if function == "root":
            return self.called("exp", self.called("log", values[0]) * values[1])
        (value,) = values
        if function == "log" and self.sign(value) <= 0:
            raise Rejected("the logarithm is taken of what is not positive")
        if (known := constant(value)) is not None and known == (function == "log"):
            return number(int(function in ("exp", "cos")))
        for place, (other, argument, sign) in self._called.items():
            if other == function and not self.cleared(argument - value)[0]:
                return variable(place) * number(sign)
        return self._call(function, value)

    def _call(self, function: str, value: Polynomial) -> Polynomial:
        """A variable for the size of a function's value, with its sign."""
        place = self.fresh(f"{function} {len(self._called) + 1}")
        self._called[place] = function, value, 1
        sign = self.sign(variable(place))
        if not sign:
            raise Rejected("whether a number is zero cannot be told")
        self._called[place] = function, value, sign
        self._measured = {key: known for key, known in self._measured.items() if key[0] != place}
        return variable(place) * number(sign)

    def _angle(self, y: Polynomial, x: Polynomial) -> Polynomial:
        """The angle of a point, between minus pi and pi, by an arctangent in the half plane in which it lies."""
        right, up = self.sign(x), self.sign(y)
        if right > 0 or (not up and right):
            return self._arc(y * self.inverse(x)) if right > 0 else self.pi
        if not up:
            raise Rejected("the origin has no angle")
        return self.pi * number(Fraction(up, 2)) - self._arc(x * self.inverse(y))

    def part_of_turn(self, y: Polynomial, x: Polynomial) -> Fraction | None:
        """The multiple of pi that is the angle of a point, if it is one with a small denominator.

        A power of x + i y is real then; which of the roots of a real number it is tells how near the angle is.
        """
        with suppress(Unbounded):
            angle, pi = (self._enclosed(self.normal(value), DIGITS[0]) for value in (self._angle(y, x), self.pi))
            multiple = Fraction(angle.low, pi.low).limit_denominator(LARGEST_PART)
            doubt = max(abs(end - multiple * half) for end in (angle.low, angle.high) for half in (pi.low, pi.high))
            real = self.vanishes(self.complex_power(x, y, multiple.denominator)[1])
            return multiple if real and 2 * doubt * multiple.denominator < pi.low else None
        return None

    def _arc(self, tangent: Polynomial) -> Polynomial:
        numerator, below = self.cleared(tangent)
        known = constant(numerator)
        return self.called("atan", tangent) if known is None or below else self.arctangent(known)

    def _enclosed(self, value: Polynomial, digits: int) -> Enclosure:
        """What holds a number; raises `Unbounded` where it takes more digits to tell."""
        at = Enclosing(digits)
        total = at.number(0)
        for monomial, coefficient in value.terms.items():
            term = at.number(Fraction(coefficient, value.below))
            for place, power in exponents(monomial):
                if (place, digits) not in self._measured:
                    self._measured[place, digits] = self._measure(place, at)
                term = at.times(term, at.power(self._measured[place, digits], power))
            total = total + term
        return total

    def _measure(self, place: int, at: Enclosing) -> Enclosure:
        if place in self._called:
            function, argument, sign = self._called[place]
            inside = self._enclosed(argument, at.bits)
            circular = at.cosine_and_sine(inside)[function == "sin"] if function in ("cos", "sin") else None
            value: Enclosure = circular or getattr(at, function)(inside)
            return value if sign > 0 else -value
        if place in self.inverses:
            return at.inverse(self._enclosed(self.inverses[place], at.bits))
        if place not in self.squares:
            return at.atan(at.number(self._tangents[place]))
        square = self._enclosed(self.squares[place], at.bits)
        return at.root(Enclosure(max(square.low, 0), square.high), 2)
