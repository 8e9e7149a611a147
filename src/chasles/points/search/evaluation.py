"""The value of an expression at a point, from its words as they stand: nothing is expanded.

It shares nothing with the polynomials that were reduced, so that a counterexample is found true a second way.
"""

from __future__ import annotations

from fractions import Fraction

from chasles.algebra.surds import SurdSum
from chasles.algebra.work_limit import check
from chasles.evaluation.interpreter import Interpreter
from chasles.evaluation.matrices import Matrix, each
from chasles.points.search.constraints import BoundAngle, ConstraintSystem
from chasles.points.search.values import Values
from chasles.problems.context import Context
from chasles.problems.variables import angle_multiples
from chasles.vocabulary import Block, Call, Node, Symbol


def entry_of(node: Node, place: tuple[int, int]) -> Node:
    """The word in a row and column of a matrix of scalars; a scalar is its own."""
    return node.rows[place[0] - 1][place[1] - 1] if isinstance(node, Block) else node


class _NoInverse(ArithmeticError):
    """A divisor has no exact inverse here."""


class Evaluation(Interpreter):
    """Evaluates scalars at one point."""

    def __init__(self, context: Context, system: ConstraintSystem, values: Values) -> None:
        super().__init__(dict(context.problem.rules))
        self.system = system
        self.values = values
        self.angles: dict[Symbol, BoundAngle] = {angle.symbol: angle for angle in system.angles}

    def at_point(self, node: Node) -> SurdSum | None:
        """The value of a scalar; None if a divisor on the way has no exact inverse here."""
        try:
            value: SurdSum = self.scalar(node)
        except _NoInverse:
            return None
        return value

    def begin(self) -> None:
        check()

    def constant(self, value: Fraction) -> SurdSum:
        return SurdSum.rational(value)

    def quotient(self, numerator: Matrix, denominator: Node) -> Matrix:
        inverse = self.scalar(denominator).inverse()
        if inverse is None:
            raise _NoInverse
        return each(numerator, lambda entry: entry * inverse)

    def own(self, node: Node) -> Matrix:
        match node:
            case Symbol():
                return [[self.values[self.system.place[node.name]]]]
            case Call(function, argument):
                return [[self._circular(function, argument)]]
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
