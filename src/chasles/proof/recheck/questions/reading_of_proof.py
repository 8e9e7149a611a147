"""A question read in the variables of a certificate: its roots are what the certificate says, after that is checked."""

from __future__ import annotations

import re
from collections.abc import Mapping
from fractions import Fraction
from functools import reduce
from math import isqrt
from operator import mul
from typing import Any

import sympy
from sympy.core.function import AppliedUndef

from chasles.proof.recheck.questions.algebra import constant, primitive
from chasles.proof.recheck.questions.asked import Asked
from chasles.proof.recheck.questions.given import eliminate_angle
from chasles.proof.recheck.questions.quantities import atoms_of
from chasles.proof.recheck.questions.signs import is_nonnegative
from chasles.proof.recheck.questions.symbolic import Symbolic
from chasles.proof.recheck.sparse import ONE, Polynomial, Rejected, number, parsed, variable

__all__ = ["Proven"]

TURNED = re.compile(r"(?:cos|sin)\(([1-9]\d*)?(.+?)(?:/([1-9]\d*))?\)")
MOST_RATES = 20
Terms = frozenset[tuple[int, int]]


class Proven(Symbolic):
    """Reads a question; `domains` must not be negative for the roots to be real, `numeric` are the roots of numbers."""

    def __init__(self, asked: Asked, certificate: Mapping[str, Any]) -> None:
        units = {
            m[2]: Fraction(int(m[1] or 1), int(m[3] or 1)) for m in map(TURNED.fullmatch, certificate["witness"]) if m
        }
        names = {spelled: name for name, spelled in certificate["names"].items()}
        if len(names) < len(certificate["names"]):
            raise Rejected("two names of the certificate stand for the same quantity")
        super().__init__(names, units)
        self.domains: list[Polynomial] = []
        self.numeric: set[int] = set()
        self.substituted: list[str] = []
        self._roots: dict[Terms, tuple[Fraction, Polynomial]] = {}
        self._nonnegative: set[Terms] = set()
        for e in dict.fromkeys(atom for expression in asked.expressions for atom in atoms_of(expression)):
            self.place(e)
            self._state_rates(e, names)
        self.numeric.add(self.place(sympy.pi))
        for e, text in certificate.get("substituted", {}).items():
            self._eliminate(asked, e, text)
        self._state_angles(certificate, units)
        for name, kind, text in certificate.get("words", ()):
            self._state_word(name, kind, parsed(text, self.places))
        for square, factors in certificate.get("roots", ()):
            self._state_root(parsed(square, self.places), [parsed(factor, self.places) for factor in factors])

    def _state_rates(self, e: Any, names: Mapping[str, str]) -> None:
        """The rates of a function of one symbol of which the certificate speaks."""
        function = e.expr if isinstance(e, sympy.Derivative) else e
        if isinstance(function, AppliedUndef) and len(function.args) == 1:
            for order in range(1, MOST_RATES):
                rate = sympy.Derivative(function, (function.args[0], order))
                if str(rate) in names:
                    self.place(rate)

    def _eliminate(self, asked: Asked, spelled: str, text: str) -> None:
        """Let an angle have the value that an equation given says it has."""
        e = next((e for e in self.atoms.values() if str(e) == spelled), None)
        pairs = [pair for item in asked.given if item.text == text for pair in item.pairs.values()]
        if not any(eliminate_angle(self, self(left) - self(right), e) for left, right in pairs):
            raise Rejected(f"{text} does not say what {spelled} is")
        self.substituted.append(text)

    def _state_angles(self, certificate: Mapping[str, Any], units: Mapping[str, Fraction]) -> None:
        """The cosines and sines of the fractions of angles of which the certificate speaks."""
        products = {name: parsed(f"1*{text}", self.places) for name, text in certificate.get("angles", {}).items()}
        for name, product in products.items():
            (monomial,) = product.terms
            self.angles[monomial] = name
        for name, unit in units.items():
            if name not in products and name not in self.places:
                raise Rejected(f"{name} is no angle of the question")
            (monomial,) = (products.get(name) or variable(self.places[name])).terms
            self.circle(monomial, unit)

    def _state_word(self, name: str, kind: str, inside: Polynomial) -> None:
        """A new variable that is the root, or the absolute value, of what is said."""
        if kind not in ("sqrt", "abs"):
            raise Rejected(f"{name} is said to be {kind!r} of something, neither a root nor an absolute value")
        square = self.normal(inside if kind == "sqrt" else inside * inside)
        visible = kind == "abs" or is_nonnegative(self, square)
        place = self.named(name, square)
        self.words.add(place)
        if square.places <= self.numeric:
            self.numeric.add(place)
        elif not visible:
            self.domains.append(square)
            self._nonnegative.add(_signed(square))
        scale, key = _key(square)
        self._roots.setdefault(key, (scale, variable(place)))

    def _state_root(self, square: Polynomial, factors: list[Polynomial]) -> None:
        """The root of a polynomial: factors that are not negative, and whose product squared it is."""
        for factor in map(self.normal, factors):
            if not (self.is_known(factor) or is_nonnegative(self, factor)):
                raise Rejected("a root is said to be what is not seen to be nonnegative")
        root = self.normal(reduce(mul, factors, ONE))
        if self.normal(square - root * root):
            raise Rejected("a root is said to be what does not have the right square")
        scale, key = _key(self.normal(square))
        self._roots[key] = scale, root

    def is_known(self, polynomial: Polynomial) -> bool:
        """Whether something is not negative where the roots are real."""
        return _signed(polynomial) in self._nonnegative

    def equal(self, one: list[Polynomial], other: list[Polynomial]) -> Polynomial:
        """The difference of two products, which is zero: no factor is negative, and the squares are the same."""
        for factor in map(self.normal, (*one, *other)):
            if not (self.is_known(factor) or is_nonnegative(self, factor)):
                raise Rejected("something is said to be equal that is not seen to be nonnegative")
        left, right = reduce(mul, one, ONE), reduce(mul, other, ONE)
        if self.normal(left * left - right * right):
            raise Rejected("something is said to be equal that has different squares")
        return self.normal(left - right)

    def root(self, value: Polynomial) -> Polynomial:
        """The nonnegative square root, as the certificate says it."""
        numerator, below = self.cleared(value)
        odd = {place: power % 2 for place, power in below.items() if power % 2}
        inside, outside = self.normal(numerator * self.divisors(odd)), ONE
        for place, power in below.items():
            half = (power + 1) // 2
            outside *= self.power(self.absolute(self.inverses[place]) * variable(place, 2), half)
        if (square := constant(inside)) is not None:
            return self._of_number(square) * outside
        scale, key = _key(inside)
        if key not in self._roots:
            raise Rejected("the certificate does not say what a root is")
        known, root = self._roots[key]
        return self.normal(root * self._of_number(scale / known) * outside)

    def _of_number(self, square: Fraction) -> Polynomial:
        """The root of a rational number in the roots of whole numbers that the certificate has."""
        rest, total = square.numerator * square.denominator, number(Fraction(1, square.denominator))
        for place in sorted(self.words):
            factor = constant(self.squares[place])
            while factor is not None and factor > 1 and rest % factor == 0:
                rest //= factor.numerator
                total = self.normal(total * variable(place))
        if rest < 0 or isqrt(rest) ** 2 != rest:
            raise Rejected(f"the certificate does not say what the root of {square} is")
        return total * number(isqrt(rest))

    def absolute(self, value: Polynomial) -> Polynomial:
        """The absolute value: the root of the square, or what is visibly not negative."""
        value = self.normal(value)
        if _key(self.normal(value * value))[1] in self._roots or value.places & set(self.inverses):
            return self.root(self.normal(value * value))
        if is_nonnegative(self, value):
            return value
        return -value if is_nonnegative(self, -value) else self.root(self.normal(value * value))


def _key(polynomial: Polynomial) -> tuple[Fraction, Terms]:
    scale, base = primitive(polynomial)
    return scale, frozenset(base.terms.items())


def _signed(polynomial: Polynomial) -> Terms:
    """The same for all positive multiples."""
    scale, base = primitive(polynomial)
    return frozenset((base if scale > 0 else -base).terms.items())
