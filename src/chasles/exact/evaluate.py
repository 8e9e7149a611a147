"""Words at exact values, functions of scalars among them: an expression becomes a SymPy matrix of numbers.

The values may hold free symbols, as the unknowns of equations do. Nothing is rounded and nothing is guessed.
"""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from fractions import Fraction
from typing import Any

import sympy as sp

from chasles.evaluation.interpreter import Interpreter
from chasles.evaluation.matrices import Matrix, each
from chasles.exact.numbers import angle, compare, is_zero, normal, root, sign
from chasles.vocabulary import PI, At, Call, Dot, Group, Inverse, Misfit, Node, Norm, Rate, Symbol, plain
from chasles.vocabulary.functions import Cases, FunctionOf

Value = Any
"""A number or a matrix as SymPy, which has no types, holds it."""
HOLDS = {"<": (-1,), "<=": (-1, 0), ">": (1,), ">=": (1, 0)}
"""The signs of a difference for which it compares so."""


class NoValue(LookupError):
    """A symbol or a rate without a value; the message names it."""


class DividesByZero(ZeroDivisionError):
    """A division by zero, or the inverse of a singular matrix; the message names the divisor."""


def evaluate(node: Node, values: Mapping[Node, Any]) -> Any:
    """The expression as a SymPy matrix of its shape, each entry in normal form.

    `values` gives SymPy matrices, or numbers for scalars, to symbols, to their rates, and to cosines and sines. Raises
    NoValue for a symbol without one, DividesByZero, Misfit for what does not fit together.
    """
    if node.fault:
        raise Misfit(node.fault)
    return sp.ImmutableMatrix(_ExactValues(values)(node))


def matrix_of(rows: Any) -> Any:
    """A matrix with its entries in normal form."""
    return sp.ImmutableMatrix(rows).applyfunc(normal)


def column_of(*entries: Any) -> Any:
    """A column with its entries in normal form."""
    return matrix_of([[entry] for entry in entries])


class _ExactValues(Interpreter):
    """One evaluation; every entry is in normal form."""

    def __init__(self, values: Mapping[Node, Any]) -> None:
        super().__init__({})
        self._values = values

    def entries(self, node: Node) -> Matrix:
        return self._given(node) if node in self._values else super().entries(node)

    def constant(self, value: Fraction) -> Any:
        return sp.Rational(value)

    def reduced(self, matrix: Matrix) -> Matrix:
        return each(matrix, normal)

    def quotient(self, numerator: Matrix, denominator: Node) -> Matrix:
        below = self.scalar(denominator)
        if is_zero(below):
            raise DividesByZero(f"{plain(denominator)} is zero here, and nothing can be divided by it")
        return super().quotient(numerator, denominator)

    def own(self, node: Node) -> Matrix:
        match node:
            case Symbol() if node == PI:
                return [[sp.pi]]
            case Rate(At(of) | Group(of)):
                return self(Rate(of))
            case Symbol() | Rate():
                raise NoValue(f"{plain(node)} has no value here")
            case Inverse(of):
                return self.inverse(of)
            case Norm(of):
                return [[root(self.scalar(Dot(of, of)))]]
            case Call("sin" | "cos" as function, argument):
                return [[getattr(sp, function)(self.scalar(argument))]]
            case FunctionOf(function, arguments) if (
                value := value_of(function, [*map(self.scalar, arguments)])
            ) is not None:
                return [[value]]
            case Cases():
                return self(self._case(node))
            case _:
                raise TypeError(f"{plain(node)} ({type(node).__name__}) has no exact value here")

    def _case(self, node: Cases) -> Node:
        """The first of the values whose condition holds."""
        rows = zip(node.values, node.left, node.signs, node.right, strict=False)
        held = (value for value, one, sign, other in rows if compares(self.scalar(one), sign, self.scalar(other)))
        return next(held, node.values[-1])

    def _given(self, node: Node) -> Matrix:
        value = self._values[node]
        if not hasattr(value, "shape"):
            value = column_of(value)
        if value.shape != node.shape:
            rows, columns = node.shape
            raise ValueError(
                f"{plain(node)} is {rows} x {columns}, and its value is {value.shape[0]} x {value.shape[1]}"
            )
        matrix: Matrix = value.tolist()
        return matrix


def value_of(function: str, arguments: Sequence[Any]) -> Any:
    """The value of a function at exact numbers; None for a function that has none by roots and angles.

    Raises ValueError where the function is not real.
    """
    match function, *arguments:
        case "sqrt", of:
            return root(of)
        case "abs", of:
            return of if sign(of) >= 0 else -of
        case "sign", of:
            return sp.Integer(sign(of))
        case "arcsin", of:
            return angle(root(1 - of**2), of)
        case "arccos", of:
            return angle(of, root(1 - of**2))
        case "arctan", of:
            return value_of("atan2", (of, sp.Integer(1)))
        case "atan2", sine, cosine:
            length = root(sine**2 + cosine**2)
            if is_zero(length):
                raise ValueError("atan2(0, 0) is no angle")
            return angle(cosine / length, sine / length)
        case "max" | "min", *numbers:
            return _extreme(numbers, 1 if function == "max" else -1)
    return None


def _extreme(numbers: Sequence[Any], side: int) -> Any:
    found = numbers[0]
    for number in numbers[1:]:
        found = number if compare(number, found) == side else found
    return found


def compares(one: Any, sign_between: str, other: Any) -> bool:
    """Whether a comparison of two exact numbers is true."""
    return compare(one, other) in HOLDS[sign_between]
