"""A question read in the variables of a certificate: its roots are what the certificate says, after that is checked.

What a verdict needs, and values at a point, are read from their text as Python spells them.
"""

from __future__ import annotations

import ast
import re
from collections.abc import Callable, Mapping
from fractions import Fraction
from functools import partial, reduce
from operator import and_
from typing import Any

import sympy
from sympy.core.function import AppliedUndef

from chasles.checker.expressions.algebra import constant
from chasles.checker.expressions.arcs import Arcs
from chasles.checker.expressions.asked import Asked
from chasles.checker.expressions.expressions import Expressions
from chasles.checker.expressions.functions import Functions
from chasles.checker.expressions.known_roots import KnownRoots
from chasles.checker.expressions.motion import eliminate_angle
from chasles.checker.expressions.quantities import atoms_of
from chasles.checker.expressions.rates import MOST_RATES
from chasles.checker.expressions.readings import CIRCULAR, FUNCTIONS
from chasles.checker.sparse import ONE, Polynomial, Rejected, exponents, number, packed, parsed, variable

TURNED = re.compile(r"(?:cos|sin)\(([1-9]\d*)?(.+?)(?:/([1-9]\d*))?\)")


class Spoken:
    """Reads texts such as 3*x**2/sqrt(5) - cos(phi/2) with a reading; `named` are the values of what has a name."""

    def __init__(self, reading: Expressions, named: Mapping[str, Polynomial]) -> None:
        self.reading = reading
        self.named = {f"q{place}_": value for place, value in enumerate(named.values())}
        self._marks = dict(zip(named, self.named, strict=True))
        longest = sorted(map(re.escape, named), key=len, reverse=True)
        self._names = re.compile(rf"(?<![A-Za-z0-9_])(?:{'|'.join(longest)})(?![A-Za-z0-9_(])") if named else None

    def __call__(self, text: str) -> Polynomial:
        """What a text says; raises `Rejected` for what cannot be read."""
        return self.reading.normal(self._read(self._parsed(text)))

    def _read(self, node: ast.expr) -> Polynomial:
        match node:
            case ast.Constant(int(value)) if not isinstance(value, bool):
                return number(value)
            case ast.Name(name) if name in self.named:
                return self.named[name]
            case ast.Name("pi"):
                return self.reading.half_turn()
            case ast.UnaryOp(ast.USub(), term):
                return -self._read(term)
            case ast.BinOp(left, ast.Add() | ast.Sub() as sign, right):
                return self._read(left).plus(self._read(right), 1 if isinstance(sign, ast.Add) else -1)
            case ast.BinOp(left, ast.Mult(), right):
                return self.reading.normal(self._read(left) * self._read(right))
            case ast.BinOp(left, ast.Div(), right):
                return self._read(left) * self.reading.inverse(self._read(right))
            case ast.BinOp(base, ast.Pow(), exponent):
                return self._power(self._read(base), self._read(exponent))
            case ast.Call(ast.Name("sqrt"), [radicand], []):
                return self.reading.root(self._read(radicand))
            case ast.Call(ast.Name("Abs"), [value], []):
                return self.reading.absolute(self._read(value))
            case ast.Call(ast.Name("cos" | "sin" | "tan" | "cot" | "sec" | "csc" as function), [angle], []):
                above, below = CIRCULAR[getattr(sympy, function)]
                of = dict(zip(("", "cos", "sin"), (ONE, *self.reading.direction(self._read(angle))), strict=True))
                return of[above] * (self.reading.inverse(of[below]) if below else ONE)
            case ast.Call(ast.Name(function), arguments, []) if function in FUNCTIONS:
                return FUNCTIONS[function](self.reading, *map(self._read, arguments))
            case ast.Name("E"):
                return self.reading.exp(ONE)
            case _:
                raise Rejected(f"{ast.unparse(node)} cannot be read")

    def call(self, text: str) -> tuple[str, list[Polynomial]]:
        """The function of which a text tells a value, and its arguments: a power is one, too."""
        match self._parsed(text):
            case ast.Call(ast.Name("log"), [ast.Call(ast.Name("Abs"), [of], [])], []):
                return "size", [self._read(of)]
            case ast.Call(ast.Name(function), arguments, []):
                return function, [self._read(argument) for argument in arguments]
            case ast.BinOp(base, ast.Pow(), exponent):
                return "power", [self._read(base), self._read(exponent)]
            case ast.Name("E"):
                return "exp", [ONE]
        raise Rejected(f"{text} is no value of a function")

    def _parsed(self, text: str) -> ast.expr:
        marked = self._names.sub(lambda found: self._marks[found[0]], text) if self._names else text
        try:
            return ast.parse(marked, mode="eval").body
        except SyntaxError:
            raise Rejected(f"{text!r} cannot be read") from None

    def _power(self, base: Polynomial, power: Polynomial) -> Polynomial:
        exponent = constant(power)
        if exponent is None or exponent.denominator > 2:
            return self.reading.powered(base, power)
        base = base if exponent.denominator == 1 else self.reading.root(base)
        base = base if exponent > 0 else self.reading.inverse(base)
        return self.reading.power(base, abs(exponent.numerator))


class Proven(KnownRoots):
    """Reads a question in the variables of a certificate, after what the certificate says of them is checked."""

    def __init__(self, asked: Asked, certificate: Mapping[str, Any]) -> None:
        turns = map(TURNED.fullmatch, (*certificate["witness"], *certificate.get("turns", ())))
        units = {m[2]: Fraction(int(m[1] or 1), int(m[3] or 1)) for m in turns if m}
        names = {spelled: name for name, spelled in certificate["names"].items()}
        if len(names) < len(certificate["names"]):
            raise Rejected("two names of the certificate stand for the same quantity")
        super().__init__(names, units)
        self.substituted: list[str] = []
        for e in dict.fromkeys(atom for expression in asked.expressions for atom in atoms_of(expression)):
            self.place(e)
            self._state_rates(e, names)
        if not any(str(e) == "pi" and e is not sympy.pi for e in self.atoms.values()):
            self.numeric.add(self.place(sympy.pi))
        self.functions = Functions(self)
        self.arcs = Arcs(self, self.functions)
        for e, text in certificate.get("substituted", {}).items():
            self._eliminate(asked, e, text)
        self.exp, self.log, self.arc = self.functions.exp, self.functions.log, self.arcs.arc  # type: ignore[method-assign]
        self._state(certificate, units, {str(e) for e in self.atoms.values()})
        self.complete = self.adds_roots = True

    def _state(self, certificate: Mapping[str, Any], units: Mapping[str, Fraction], spelled: set[str]) -> None:
        """The functions and the roots of which the certificate speaks, each after those that are in it."""
        functions = sorted(((len(text), text, name) for name, text in certificate["names"].items()))
        waiting: list[Callable[[], None]] = [partial(self._state_angles, certificate, units)]
        waiting += (partial(self._state_function, name, text) for _, text, name in functions if text not in spelled)
        waiting += (partial(self._state_positive, text) for text in certificate.get("positive", ()))
        waiting += (partial(self._state_word, *word) for word in certificate.get("words", ()))
        waiting += (partial(self._state_root, *root) for root in certificate.get("roots", ()))
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

    def powered(self, base: Polynomial, exponent: Polynomial) -> Polynomial:
        """A power of what is positive."""
        if (known := constant(exponent)) is not None and (root := self.functions.radical(base, known)) is not None:
            return root
        return super().powered(base, exponent)

    def over(self, value: Polynomial, spelled: str) -> Polynomial:
        """One over a value, by positive factors apart."""
        numerator, below = self.cleared(value)
        common = reduce(and_, (frozenset(dict(exponents(m))) for m in numerator.terms)) if numerator else frozenset()
        outside = ONE
        for place in common & (self.positive | self.words) if below or len(numerator.terms) > 1 else ():
            numerator = Polynomial({m - packed(place): c for m, c in numerator.terms.items()}, numerator.below)
            inverse = self.inverse(self.squares[place] if place in self.words else variable(place))
            outside = outside * inverse * (variable(place) if place in self.words else ONE)
        if outside is ONE:
            return super().over(value, spelled)
        return super().over(numerator, spelled) * self.normal(outside * self.divisors(below))

    def turn(self, angle: Polynomial, both: bool = True) -> tuple[Polynomial, Polynomial]:
        """Cosine and sine of a sum of angles, those of points taken from them."""
        parts, rest = self.arcs.split(angle)
        cosine, sine = super().turn(rest)
        for place, multiple in parts:
            c, s = self.arcs.direction(place, multiple, both or len(parts) > 1 or bool(rest))
            cosine, sine = self.normal(cosine * c - sine * s), self.normal(sine * c + cosine * s)
        return cosine, sine

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
        if not any(eliminate_angle(self, self.cleared(self(left) - self(right))[0], e) for left, right in pairs):
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
        self.state_word(name, self.normal(inside if kind == "sqrt" else inside * inside), kind == "abs")

    def _state_root(self, text: str, texts: list[str]) -> None:
        self.state_root(parsed(text, self.places), [parsed(factor, self.places) for factor in texts])
