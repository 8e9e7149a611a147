"""What is the value, to 50 digits? Expressions evaluated with mpmath, apart from the prover and from every program.

The digits are those of the result, not of the arithmetic: intervals enclose every step, and an evaluation is repeated
with more precision until they are narrow, as Ziv proposes (Fast evaluation of elementary mathematical functions, 1991).
So 1 - cos(phi) has 50 right digits for phi = 1e-60 too.
"""

from __future__ import annotations

from collections.abc import Callable, Mapping
from fractions import Fraction
from functools import reduce
from operator import add
from typing import Any

import numpy as np

from chasles.evaluation.interpreter import Interpreter
from chasles.evaluation.matrices import Matrix
from chasles.numerics.enclosures import ends, exactly, interval_context, is_narrow, middle
from chasles.vocabulary import PI, At, Call, Determinant, Group, Inverse, Misfit, Node, Norm, Rate, Symbol
from chasles.vocabulary.differentiation import rate_of
from chasles.vocabulary.functions import Cases, FunctionOf
from chasles.vocabulary.partial import CarriedOut, with_derivatives

GUARD = 15
"""Digits beyond those asked for in the first evaluation."""
MOST_DIGITS = 4000
"""Precision at which what cannot be told from zero is zero: no product of ten floats is as small."""


class MissingValue(LookupError):
    """A symbol or a rate that has neither a value nor a rule; the message names it."""


class Singular(ZeroDivisionError):
    """A division by zero, or the inverse of a singular matrix; the message names the divisor."""


def evaluate(
    node: Node, values: Mapping[Node, Any], rules: Mapping[Node, Node] | None = None, digits: int = 50
) -> Matrix:
    """The entries of the expression, row by row, each with `digits` right digits.

    `values` gives numbers (exactly as they are: integers, fractions, floats, mpmath numbers, nested sequences or arrays
    of them) to symbols and to rates of symbols, and comes before `rules`, which say what a symbol stands for. Raises
    `MissingValue` for a symbol or rate with neither, `Singular` for a division by zero, `Misfit` for an expression that
    does not fit together, ValueError for a value of another shape than its symbol's.
    """
    if node.fault:
        raise Misfit(node.fault)
    precision = digits + GUARD
    while True:
        last = precision >= MOST_DIGITS
        try:
            enclosures = _Enclosures(precision, values, rules or {})(node)
            if last or all(is_narrow(entry, digits) for row in enclosures for entry in row):
                return [[middle(entry, precision) for entry in row] for row in enclosures]
        except Undetermined:
            if last:
                raise
        except _TooWide as wide:
            if last:
                raise Singular(str(wide)) from None
        precision *= 2


class _TooWide(ArithmeticError):
    """A divisor whose enclosure still holds zero."""


class _Enclosures(Interpreter):
    """One evaluation with a fixed precision, in intervals that hold the values."""

    def __init__(self, digits: int, values: Mapping[Node, Any], rules: Mapping[Node, Node]) -> None:
        super().__init__(rules)
        self.context = interval_context(digits)
        self.values = values

    def entries(self, node: Node) -> Matrix:
        if node in self.values:
            return self._given(node)
        if isinstance(node, At) and node.argument != "t" and node not in self.rules:
            raise TypeError(f"{node} (At) has no numeric value here")
        return super().entries(node)

    def constant(self, value: Fraction) -> Any:
        return exactly(value, self.context)

    def quotient(self, numerator: Matrix, denominator: Node) -> Matrix:
        below = self.scalar(denominator)
        low, high = ends(below)
        if low <= 0 <= high:
            said = f"{denominator} is zero here, and nothing can be divided by it"
            if isinstance(denominator, Determinant):
                said = f"{denominator.of} has no inverse here"
            raise Singular(said) if low == high else _TooWide(said)
        return super().quotient(numerator, denominator)

    def own(self, node: Node) -> Matrix:
        match node:
            case Symbol() if node == PI:
                return [[self.context.convert(self.context.pi)]]
            case Symbol():
                raise MissingValue(f"{node} has no value: give it one, or a statement that says what it is")
            case Rate(At(of, "t") | Group(of)):
                return self(Rate(of))
            case Rate(of):
                return self._rate(node, of)
            case Inverse(of):
                return self.inverse(of)
            case Norm(of):
                # Squares are formed as such: an enclosure of zero times itself would hold negative numbers.
                return [[self.context.sqrt(reduce(add, (row[0] ** 2 for row in self(of))))]]
            case Call("sin" | "cos" as function, argument):
                return [[getattr(self.context, function)(self.scalar(argument))]]
            case FunctionOf(function, arguments):
                return [[function_of(function, self.context)(*map(self.scalar, arguments))]]
            case CarriedOut():
                return self(with_derivatives(node, self.rules))
            case Cases(values, left, right, signs):
                told = zip(values, left, signs, right, strict=False)
                chosen = (value for value, a, sign, b in told if self._holds(a, sign, b))
                return self(next(chosen, values[-1]))
            case _:
                raise TypeError(f"{node} ({type(node).__name__}) has no numeric value here")

    def _holds(self, left: Node, sign: str, right: Node) -> bool:
        relation = sign_of(self.scalar(left) - self.scalar(right))
        return {"<": relation < 0, "<=": relation <= 0, ">": relation > 0, ">=": relation >= 0}[sign]

    def _rate(self, node: Node, of: Node) -> Matrix:
        """A rate that has no value of its own is made of the rates of what the symbol stands for."""
        match of:
            case _ if of in self.rules:
                return self(rate_of(self.rules[of]))
            case Symbol(stands_for=Node() as meaning):
                return self(rate_of(meaning))
            case Symbol() | Rate():
                raise MissingValue(
                    f"{node} has no value: give it among the values, or a statement that says what it is"
                )
            case _:
                return self(rate_of(of))

    def _given(self, node: Node) -> Matrix:
        rows, columns = node.shape
        flat = np.asarray(self.values[node], dtype=object).ravel().tolist()
        if len(flat) != rows * columns:
            raise ValueError(f"{node} is {rows} x {columns}, and its value has {len(flat)} entries")
        entries = [exactly(number, self.context) for number in flat]
        return [entries[i * columns : (i + 1) * columns] for i in range(rows)]


class Undetermined(ArithmeticError):
    """What holds of one number in an interval and not of another: more digits may tell."""


def function_of(name: str, context: Any) -> Callable[..., Any]:
    """The function of that name; raises ValueError where it is not real, `Undetermined` where that is not known."""

    def sqrt(x: Any) -> Any:
        low, high = ends(x)
        if high < 0:
            raise ValueError("the square root of a negative number is not real")
        return context.sqrt(x if low >= 0 else context.mpf([0, x.b]))

    def log(x: Any) -> Any:
        if sign_of(x) <= 0:
            raise ValueError("the logarithm of a number that is not positive is not real")
        return context.log(x)

    def sinh(x: Any) -> Any:
        return (context.exp(x) - context.exp(-x)) / 2

    def cosh(x: Any) -> Any:
        return (context.exp(x) + context.exp(-x)) / 2

    found: dict[str, Callable[..., Any]] = {
        "sqrt": sqrt,
        "abs": abs,
        "exp": context.exp,
        "log": log,
        "arcsin": lambda x: context.atan2(x, sqrt(1 - x**2)),
        "arccos": lambda x: context.atan2(sqrt(1 - x**2), x),
        "arctan": lambda x: context.atan2(x, context.mpf(1)),
        "atan2": context.atan2,
        "sinh": sinh,
        "cosh": cosh,
        "tanh": lambda x: sinh(x) / cosh(x),
        "arcsinh": lambda x: context.log(x + context.sqrt(x**2 + 1)),
        "arccosh": lambda x: log(x + sqrt(x**2 - 1)),
        "arctanh": lambda x: log((1 + x) / (1 - x)) / 2,
        "sign": lambda x: context.mpf(sign_of(x)),
        "max": lambda *xs: reduce(lambda a, b: (a + b + abs(a - b)) / 2, xs),
        "min": lambda *xs: reduce(lambda a, b: (a + b - abs(a - b)) / 2, xs),
    }
    return found[name]


def sign_of(x: Any) -> int:
    """1, 0 or -1; raises `Undetermined` for an interval that holds numbers of different signs."""
    low, high = ends(x)
    if low > 0 or high < 0:
        return 1 if low > 0 else -1
    if low == high:
        return 0
    raise Undetermined("the sign is not known")
