"""The values of what `prove` was asked about at its counterexample, as theorems for Coq have them."""

from __future__ import annotations

from collections.abc import Callable, Sequence
from fractions import Fraction
from functools import cached_property
from typing import Any

import sympy

from chasles import vocabulary as w
from chasles.coq.expressions import Unsaid
from chasles.coq.of_sympy import SympyStatement
from chasles.coq.sympy_words import FUNCTIONS, OF_TWO
from chasles.coq.values import rational
from chasles.verdict import Counterexample
from chasles.vocabulary.functions import FunctionOf

MEANT: dict[str, Callable[..., Any]] = {
    **{word: function for function, word in (*FUNCTIONS.items(), *OF_TWO.items())},
    "sqrt": sympy.sqrt,
    "Rpower": sympy.Pow,
    "atan2": sympy.atan2,
    "Rlt_dec": lambda a, b, then, otherwise: then if a < b else otherwise,
    "Rle_dec": lambda a, b, then, otherwise: then if a <= b else otherwise,
    "Req_EM_T": lambda a, b, then, otherwise: then if a == b else otherwise,
}
"""What the words of the theories mean."""


class ScalarValues:
    """The values of a statement's symbols: `numbers`, or `angles` of which a multiple has this cosine and this sine.

    Raises `Unsaid` where a point says something else.
    """

    def __init__(self, said: SympyStatement, found: Counterexample) -> None:
        if said.timed:
            raise Unsaid("no proof is written with a point at which something moves")
        if any(atom.is_rational is not None and atom.is_Symbol for atom in said.words.atoms):
            raise Unsaid("what is claimed of whole or rational numbers is told to Coq of all real ones")
        self._said = said
        self.symbols = {node: sympy.Symbol(name, real=True) for node, name in said.names.symbols.items()}
        self.numbers: dict[Any, Any] = {}
        self.angles: dict[Any, tuple[Fraction, Any, Any]] = {}
        by_name = {node.name: symbol for node, symbol in self.symbols.items()}
        for text, value in found.at.items():
            if text in by_name:
                self.numbers[by_name[text]] = sympy.sympify(value)
        others = [(text, value) for text, value in found.at.items() if text not in by_name and not text.isidentifier()]
        directions = [(sympy.sympify(text, locals=by_name), sympy.sympify(value)) for text, value in others]
        for function, value in directions:
            self._direction(self._of_one(function, [each.args[0] for each, _ in directions]), value)
        self._told()
        for symbol in self.symbols.values():
            if symbol not in self.angles:
                self.numbers.setdefault(symbol, sympy.Integer(0))

    def _told(self) -> None:
        """The values of symbols that what is given says by others."""
        pairs = [pair for goal in self._said.problem.conditions for pair in (goal.sides, goal.sides[::-1])]
        for _ in pairs:
            for left, right in pairs:
                symbol = self.symbols.get(left) if isinstance(left, w.Symbol) else None
                if symbol is not None and symbol not in self.numbers and symbol not in self.angles:
                    value = self.of(right)
                    self.numbers |= {symbol: value} if value.is_Rational else {}

    def _of_one(self, function: Any, turned: Sequence[Any]) -> Any:
        """The function where symbols that several angles have as factors are one."""
        shared = {s for s in function.free_symbols if len({e for e in turned if s in e.free_symbols}) > 1}
        self.numbers = dict.fromkeys(shared, sympy.Integer(1)) | self.numbers
        if len(function.free_symbols - shared) != 1 or any(self.numbers[symbol] != 1 for symbol in shared):
            raise Unsaid(f"no proof is written with a point at which {function} is known")
        return function.xreplace(dict.fromkeys(shared, sympy.Integer(1)))

    def _direction(self, function: Any, value: Any) -> None:
        """The cosine or sine of a multiple of an angle."""
        (angle,) = function.free_symbols
        unit = function.args[0] / angle
        if not (unit.is_Rational and unit > 0 and function.func in (sympy.cos, sympy.sin)):
            raise Unsaid(f"no proof is written with a point at which {function} is known")
        _, cosine, sine = self.angles.get(angle, (Fraction(0), None, None))
        known = (value, sine) if function.func is sympy.cos else (cosine, value)
        self.angles[angle] = Fraction(int(unit.p), int(unit.q)), *known

    def __call__(self, node: w.Node) -> Any:
        """The value of a scalar at the point, rational but for pi; raises `Unsaid` where it has none."""
        value = self.of(node)
        spelled_number(value)
        return value

    def of(self, node: w.Node) -> Any:
        """The value of a scalar at the point, in the angles whose cosine and sine are known."""
        match node:
            case w.Number():
                return sympy.Rational(node.value.numerator, node.value.denominator)
            case w.Symbol():
                symbol = sympy.pi if node == w.PI else self.symbols[node]
                return self.numbers.get(symbol, symbol)
            case w.Sum():
                return sympy.Add(*map(self.of, node.terms))
            case w.Negative():
                return -self.of(node.term)
            case w.Scale():
                return self.of(node.factor) * self.of(node.term)
            case w.Quotient():
                return self.of(node.numerator) / self.of(node.denominator)
            case w.Power():
                return self.of(node.base) ** node.exponent
            case w.Call():
                return self._of_angle(node.function, self.of(node.argument))
            case FunctionOf(function="tan"):
                argument = self.of(node.arguments[0])
                return self._of_angle("sin", argument) / self._of_angle("cos", argument)
            case FunctionOf():
                return MEANT[node.function](*map(self.of, node.arguments))
        raise Unsaid(f"no proof is written with the value of {node}")

    def _of_angle(self, function: str, argument: Any) -> Any:
        units = {
            symbol: symbol / sympy.Rational(*unit.as_integer_ratio()) for symbol, (unit, *_) in self.angles.items()
        }
        apart = sympy.expand_trig(getattr(sympy, function)(sympy.expand(argument.xreplace(units))))
        return sympy.expand(apart.xreplace(self._cosines))

    @cached_property
    def _cosines(self) -> dict[Any, Any]:
        found = {sympy.cos(symbol): cosine for symbol, (_, cosine, _) in self.angles.items()}
        return found | {sympy.sin(symbol): sine for symbol, (_, _, sine) in self.angles.items()}


def spelled_number(value: Any) -> str:
    """A rational number, or one beside a multiple of pi."""
    times = value.coeff(sympy.pi) if value.has(sympy.pi) else sympy.Integer(0)
    rest = sympy.expand(value - times * sympy.pi)
    if not (times.is_Rational and rest.is_Rational):
        raise Unsaid("no proof is written where the values are not rational")
    number, turns = (rational(Fraction(int(each.p), int(each.q))) for each in (rest, times))
    return f"({number} + {turns} * PI)" if times else number
