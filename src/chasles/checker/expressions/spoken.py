"""Expressions from their text: what a verdict needs, and values at a point, are read as Python spells them."""

from __future__ import annotations

import ast
import re
from collections.abc import Mapping

import sympy

from chasles.checker.expressions.algebra import constant
from chasles.checker.expressions.expressions import Expressions
from chasles.checker.expressions.readings import CIRCULAR, FUNCTIONS
from chasles.checker.sparse import ONE, Polynomial, Rejected, number


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
