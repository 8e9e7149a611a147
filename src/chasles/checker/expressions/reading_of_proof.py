"""A question read in the variables of a certificate: its roots are what the certificate says, after that is checked."""

from __future__ import annotations

import re
from collections.abc import Callable, Iterable, Mapping
from fractions import Fraction
from functools import partial, reduce
from math import isqrt
from operator import and_, mul
from typing import Any

import sympy
from sympy.core.function import AppliedUndef

from chasles.checker.expressions.algebra import constant, primitive
from chasles.checker.expressions.arcs import Arcs
from chasles.checker.expressions.asked import Asked
from chasles.checker.expressions.factoring import root_of_square
from chasles.checker.expressions.functions import Functions
from chasles.checker.expressions.given import eliminate_angle
from chasles.checker.expressions.quantities import atoms_of
from chasles.checker.expressions.rates import MOST_RATES
from chasles.checker.expressions.signs import is_nonnegative
from chasles.checker.expressions.spoken import Spoken
from chasles.checker.expressions.symbolic import Symbolic
from chasles.checker.sparse import ONE, Polynomial, Rejected, exponents, number, parsed, variable

TURNED = re.compile(r"(?:cos|sin)\(([1-9]\d*)?(.+?)(?:/([1-9]\d*))?\)")
Terms = frozenset[tuple[int, int]]


class Proven(Symbolic):
    """Reads a question; `domains` must not be negative for the roots to be real, `numeric` are the roots of numbers.

    It is `complete` once all is read that the certificate says.
    """

    def __init__(self, asked: Asked, certificate: Mapping[str, Any]) -> None:
        turns = map(TURNED.fullmatch, (*certificate["witness"], *certificate.get("turns", ())))
        units = {m[2]: Fraction(int(m[1] or 1), int(m[3] or 1)) for m in turns if m}
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
        if not any(str(e) == "pi" and e is not sympy.pi for e in self.atoms.values()):
            self.numeric.add(self.place(sympy.pi))
        for e, text in certificate.get("substituted", {}).items():
            self._eliminate(asked, e, text)
        self.functions = Functions(self)
        self.arcs = Arcs(self, self.functions)
        self.complete = False
        self._state(certificate, units, {str(e) for e in self.atoms.values()})
        self.complete = True

    def _state(self, certificate: Mapping[str, Any], units: Mapping[str, Fraction], spelled: set[str]) -> None:
        """The functions and the roots of which the certificate speaks, each after those that are in it."""
        functions = sorted(((len(text), text, name) for name, text in certificate["names"].items()))
        waiting: list[Callable[[], None]] = [partial(self._state_angles, certificate, units)]
        for _, text, name in functions:
            if text not in spelled:
                waiting.append(partial(self._state_function, name, text))
        for text in certificate.get("positive", ()):
            waiting.append(partial(self._state_positive, text))
        for word in certificate.get("words", ()):
            waiting.append(partial(self._state_word, *word))
        for square, factors in certificate.get("roots", ()):
            waiting.append(partial(self._state_root, square, factors))
        while waiting:
            left: list[Callable[[], None]] = []
            for statement in waiting:
                try:
                    statement()
                except Rejected as error:
                    left.append(statement)
                    reason = error
            if len(left) == len(waiting):
                raise reason
            waiting = left

    def _state_positive(self, text: str) -> None:
        """A quantity that is positive because of a logarithm, or a sum that is a factor of what one is taken of."""
        value = self.normal(parsed(text, self.places))
        if len(value.terms) > 1:
            self.functions.log(value, evident=True)
        else:
            self.functions.require_positive(value)

    def _state_function(self, name: str, text: str) -> None:
        """A variable that is the value of a function."""
        function, arguments = Spoken(self, {str(e): self.atom(e) for e in self.atoms.values()}).call(text)
        self.functions.state(name, function, arguments)

    def exp(self, value: Polynomial) -> Polynomial:
        """The exponential of a sum, as the certificate names its factors."""
        return self.functions.exp(value)

    def log(self, value: Polynomial, evident: bool = False) -> Polynomial:
        """The logarithm of a product, as the certificate names its terms."""
        return self.functions.log(value, evident)

    def arc(self, y: Polynomial, x: Polynomial) -> Polynomial:
        """The angle of a point, as the certificate names it."""
        return self.arcs.arc(y, x)

    def powered(self, base: Polynomial, exponent: Polynomial) -> Polynomial:
        """A power of what is positive."""
        if (known := constant(exponent)) is not None and (root := self.functions.radical(base, known)) is not None:
            return root
        return super().powered(base, exponent)

    def over(self, value: Polynomial, spelled: str) -> Polynomial:
        """One over a value, by positive factors apart."""
        numerator, below = self.cleared(value)
        common = reduce(and_, map(_places, numerator.terms)) if numerator else frozenset()
        outside = ONE
        for place in common & (self.positive | self.words) if below or len(numerator.terms) > 1 else ():
            numerator = Polynomial({m - (1 << 8 * place): c for m, c in numerator.terms.items()}, numerator.below)
            inverse = self.inverse(self.squares[place] if place in self.words else variable(place))
            outside = outside * inverse * (variable(place) if place in self.words else ONE)
        if outside is ONE:
            return super().over(value, spelled)
        return super().over(numerator, spelled) * self.normal(outside * self.divisors(below))

    def turn(self, angle: Polynomial) -> tuple[Polynomial, Polynomial]:
        """Cosine and sine of a sum of angles, those of points taken from them."""
        parts, rest = self.arcs.split(angle)
        cosine, sine = super().turn(rest)
        for place, multiple in parts:
            c, s = self.arcs.direction(place, multiple)
            cosine, sine = self.normal(cosine * c - sine * s), self.normal(sine * c + cosine * s)
        return cosine, sine

    def require_nonnegative(self, value: Polynomial) -> None:
        """Something is visibly not negative, or has to be said to be."""
        if not is_nonnegative(self, value):
            self.domains.append(value)
            self._nonnegative.add(_signed(value))

    def know(self, value: Polynomial) -> None:
        """Something is not negative where the question is meant."""
        self._nonnegative.add(_signed(value))

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

    def _state_word(self, name: str, kind: str, text: str) -> None:
        """A new variable that is the root, or the absolute value, of what is said."""
        inside = parsed(text, self.places)
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

    def _state_root(self, text: str, texts: list[str]) -> None:
        """The root of a polynomial: factors that are not negative, and whose product squared it is."""
        square, factors = parsed(text, self.places), [parsed(factor, self.places) for factor in texts]
        for factor in map(self.normal, factors):
            if not (self.is_known(factor) or is_nonnegative(self, factor)):
                raise Rejected("a root is said to be what is not seen to be nonnegative")
        root = self.normal(reduce(mul, factors, ONE))
        if self.normal(square - root * root):
            raise Rejected("a root is said to be what does not have the right square")
        scale, key = _key(self.normal(square))
        self._roots[key] = scale, root

    def _is_seen(self, polynomial: Polynomial) -> bool:
        return self.is_known(polynomial) or is_nonnegative(self, polynomial)

    def is_known(self, polynomial: Polynomial) -> bool:
        """Whether something is not negative where the roots are real."""
        return _signed(polynomial) in self._nonnegative

    def is_number(self, polynomial: Polynomial) -> bool:
        """Whether something is made of numbers alone."""
        return all(map(self.is_numeric, polynomial.places))

    def is_numeric(self, place: int) -> bool:
        """Whether a variable is a number."""
        parts = (self.inverses[place],) if place in self.inverses else self.calls.get(place, (None, None))[1]
        return place in self.numeric or (parts is not None and all(map(self.is_number, parts)))

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
            even = reduce(and_, (_powers(monomial, self.positive) for monomial in inside.terms))
            half = sum(max(n for k, n in even if k == place) // 2 << 8 * place for place in {k for k, _ in even})
            inside = Polynomial({monomial - 2 * half: c for monomial, c in inside.terms.items()}, inside.below)
            outside = outside * Polynomial({half: 1})
            if (square := constant(inside)) is not None:
                return self._of_number(square) * outside
            scale, key = _key(inside)
        if key not in self._roots:
            sides = [] if (whole := root_of_square(inside)) is None else [whole, -whole]
            if (root := next(filter(self._is_seen, sides), None)) is not None:
                return root * outside
            positive = self.complete and self.is_number(inside) and self.sign(inside) > 0
            if sides or positive or is_nonnegative(self, inside):
                self._roots[key] = scale, self._new_root(inside)
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
        if rest > 0 and isqrt(rest) ** 2 != rest and (self.complete or self.arcs.points):
            return total * self._new_root(number(rest))
        if rest < 0 or isqrt(rest) ** 2 != rest:
            raise Rejected(f"the certificate does not say what the root of {square} is")
        return total * number(isqrt(rest))

    def _new_root(self, square: Polynomial) -> Polynomial:
        """The root of what is not negative, and of which the certificate does not speak."""
        place = self.fresh("root", square)
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
        if self._is_seen(value):
            return value
        return -value if self._is_seen(-value) else self.root(self.normal(value * value))


def _places(monomial: int) -> frozenset[int]:
    return frozenset(place for place, _ in exponents(monomial))


def _powers(monomial: int, places: Iterable[int]) -> frozenset[tuple[int, int]]:
    """The even powers of some variables in a monomial."""
    return frozenset((k, 2 * n) for k, power in exponents(monomial) if k in places for n in range(1, power // 2 + 1))


def _key(polynomial: Polynomial) -> tuple[Fraction, Terms]:
    scale, base = primitive(polynomial)
    return scale, frozenset(base.terms.items())


def _signed(polynomial: Polynomial) -> Terms:
    """The same for all positive multiples."""
    scale, base = primitive(polynomial)
    return frozenset((base if scale > 0 else -base).terms.items())
