"""The values of expressions at one point in floating point, functions of scalars among them, each worked out once."""

from __future__ import annotations

import math
import operator
from collections.abc import Callable, Iterable, Mapping
from fractions import Fraction
from typing import TypeVar

from chasles.checker.sparse import Rejected
from chasles.evaluation.interpreter import Interpreter
from chasles.evaluation.matrices import Matrix, each
from chasles.vocabulary import PI, Call, Inverse, Misfit, Node, Norm, Symbol
from chasles.vocabulary.differentiation import NoRule
from chasles.vocabulary.functions import Cases, FunctionOf

_Point = TypeVar("_Point")
FUNCTIONS: dict[str, Callable[..., float]] = {
    "sin": math.sin, "cos": math.cos, "sqrt": math.sqrt, "abs": abs, "exp": math.exp, "log": math.log,
    "arcsin": math.asin, "arccos": math.acos, "arctan": math.atan, "atan2": math.atan2, "sinh": math.sinh,
    "cosh": math.cosh, "tanh": math.tanh, "sign": lambda x: (x > 0) - (x < 0), "max": max, "min": min,
}  # fmt: skip
RELATIONS = {"<": operator.lt, "<=": operator.le, ">": operator.gt, ">=": operator.ge}
NO_VALUE = (ArithmeticError, ValueError, LookupError, TypeError, Misfit, NoRule)
"""What is raised for an expression that has no value at a point."""


class RealPoint(Interpreter):
    """Values of expressions at a point that names the entries of letters; raises what is in `NO_VALUE`."""

    def __init__(self, rules: Mapping[Node, Node], entries: Mapping[tuple[Symbol, int, int], float]) -> None:
        super().__init__(rules)
        self.at = entries

    def constant(self, value: Fraction) -> float:
        return float(value)

    def quotient(self, numerator: Matrix, denominator: Node) -> Matrix:
        below = self.scalar(denominator)
        return each(numerator, lambda entry: entry / below)

    def own(self, node: Node) -> Matrix:
        match node:
            case _ if node == PI:
                return [[math.pi]]
            case Symbol():
                rows, columns = node.shape
                return [[self.at[node, i, j] for j in range(columns)] for i in range(rows)]
            case Norm(of):
                return [[math.hypot(*(entry for row in self(of) for entry in row))]]
            case Call(function, argument) | FunctionOf(function, (argument,)):
                return [[FUNCTIONS[function](self.scalar(argument))]]
            case FunctionOf(function, arguments):
                return [[FUNCTIONS[function](*map(self.scalar, arguments))]]
            case Cases(values, left, right, signs):
                for value, one, sign, other in zip(values, left, signs, right, strict=False):
                    if RELATIONS[sign](self.scalar(one), self.scalar(other)):
                        return self(value)
                return self(values[-1])
            case Inverse(of):
                return self.inverse(of)
            case _:
                raise TypeError(f"{node} has no value by its parts")


def agree_at(points: Iterable[_Point], compared: Callable[[_Point], bool]) -> bool:
    """Whether sides are equal, as `compared`, at all points at which both have a value, and at two or more."""
    count = 0
    for point in points:
        try:
            if not compared(point):
                return False
        except (*NO_VALUE, Rejected):
            continue
        count += 1
    return count > 1
