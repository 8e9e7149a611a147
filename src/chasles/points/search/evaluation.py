"""The value of an expression at a point, from its words as they stand: nothing is expanded.

It shares nothing with the polynomials that were reduced, so that a counterexample is found true a second way.
"""

from __future__ import annotations

from functools import reduce
from operator import add

from chasles.algebra.surds import SurdSum
from chasles.algebra.work_limit import check
from chasles.points.search.constraints import BoundAngle, ConstraintSystem
from chasles.points.search.values import Values
from chasles.problems.context import Context
from chasles.problems.variables import angle_multiples
from chasles.vocabulary import Block, Call, Negative, Node, Number, Power, Quotient, Scale, Sum, Symbol

__all__ = ["Evaluation", "entry_of"]


def entry_of(node: Node, place: tuple[int, int]) -> Node:
    """The word in a row and column of a matrix of scalars; a scalar is its own."""
    return node.rows[place[0] - 1][place[1] - 1] if isinstance(node, Block) else node


class Evaluation:
    """Evaluates scalars at one point."""

    def __init__(self, context: Context, system: ConstraintSystem, values: Values) -> None:
        self.rules = dict(context.problem.rules)
        self.system = system
        self.values = values
        self.angles: dict[Symbol, BoundAngle] = {angle.symbol: angle for angle in system.angles}
        self._known: dict[Node, SurdSum | None] = {}

    def __call__(self, node: Node) -> SurdSum | None:
        """The value; None if a divisor on the way has no exact inverse here."""
        if node not in self._known:
            check()
            self._known[node] = self._evaluate(node)
        return self._known[node]

    def _evaluate(self, node: Node) -> SurdSum | None:
        match node:
            case _ if node in self.rules:
                return self(self.rules[node])
            case Symbol():
                return self.values[self.system.place[node.name]]
            case Number(number):
                return SurdSum.rational(number)
            case Sum(terms):
                found = [value for value in map(self, terms) if value is not None]
                return reduce(add, found) if len(found) == len(terms) else None
            case Negative(term):
                value = self(term)
                return None if value is None else -value
            case Scale(factor, term):
                one, other = self(factor), self(term)
                return None if one is None or other is None else one * other
            case Quotient(numerator, denominator):
                above, below = self(numerator), self(denominator)
                inverse = None if below is None else below.inverse()
                return None if above is None or inverse is None else above * inverse
            case Power(base, exponent):
                value = self(base)
                return None if value is None else value**exponent
            case Call(function, argument):
                return self._circular(function, argument)
            case _:
                raise TypeError(f"{type(node).__name__} is no scalar of a question")

    def _circular(self, function: str, argument: Node) -> SurdSum:
        cosine, sine = SurdSum.rational(1), SurdSum({})
        for symbol, multiple in angle_multiples(argument, self.rules).items():
            angle = self.angles[symbol]
            c, s = self.values[angle.cosine], self.values[angle.sine]
            times = int(multiple / angle.unit)
            s, times = (-s, -times) if times < 0 else (s, times)
            while times:
                if times % 2:
                    cosine, sine = cosine * c - sine * s, sine * c + cosine * s
                c, s, times = c * c - s * s, c * s + c * s, times // 2
        return cosine if function == "cos" else sine
