"""From words to polynomials: every expression becomes a matrix of fractions whose denominators are declared factors."""

from __future__ import annotations

from collections.abc import Mapping
from fractions import Fraction

from chasles.algebra.localization import Localization, Ratio
from chasles.algebra.work_limit import check
from chasles.evaluation.interpreter import Interpreter
from chasles.evaluation.matrices import Matrix, each
from chasles.problems.coordinates import Coordinates
from chasles.problems.differentiation import Differentiation
from chasles.problems.divisors import Divisors
from chasles.problems.moments import BodyMoments
from chasles.problems.variables import NoForm, Unlisted, Variable, angle_multiples
from chasles.vocabulary import PI, At, Call, Group, Integral, Node, Norm, Rate, Symbol, plain


class Unfolder(Interpreter):
    """Unfolds expressions over one field; `values` are symbols that conditions have determined.

    The symbols that are `running` differ from element to element in an integral over a body.
    """

    def __init__(
        self,
        field: Localization,
        variables: tuple[Variable, ...],
        rules: Mapping[Node, Node],
        running: frozenset[Symbol] = frozenset(),
    ) -> None:
        super().__init__(rules)
        self.field = field
        self.variables = variables
        self.values: dict[Symbol, Matrix] = {}
        self.norms: list[tuple[Matrix, Ratio]] = []
        self.moments = BodyMoments(field, variables, running, rules)
        self.coordinates = Coordinates(field, variables)
        self.divisors = Divisors(field, rules, self)
        self.rate = Differentiation(field, variables, self.coordinates, rules, self.moments, self.divisors, self)

    def begin(self) -> None:
        check()

    def constant(self, value: Fraction) -> Ratio:
        return self.field.constant(value)

    def is_zero(self, entry: Ratio) -> bool:
        return entry.is_zero

    def quotient(self, numerator: Matrix, denominator: Node) -> Matrix:
        constant, exponents = self.divisors(denominator)
        return each(numerator, lambda entry: entry.divided(constant, exponents))

    def own(self, node: Node) -> Matrix:
        match node:
            case Symbol():
                return self._symbol(node)
            case Norm(of):
                return [[self._norm(of)]]
            case Call(function, argument):
                return [[self._circular(function, argument)]]
            case Rate(Group(of) | At(of)):
                return self(Rate(of))
            case Rate(of):
                return each(self(of), self.rate)
            case Integral(of):
                return each(self(of), self.moments.integral)
            case _:
                raise NoForm(f"{plain(node)} ({type(node).__name__}) cannot stand here: it has no polynomial form")

    def forget(self) -> None:
        """Unfold anew from here on: `values` has changed."""
        self._known.clear()
        self.rate.forget()

    def _symbol(self, symbol: Symbol) -> Matrix:
        if symbol in self.values:
            return self.values[symbol]
        rows, columns = symbol.shape
        return [[self._entry(symbol, i, j) for j in range(columns)] for i in range(rows)]

    def _entry(self, symbol: Symbol, row: int, column: int) -> Ratio:
        entry = self.coordinates.entry(symbol, 0, row, column)
        if entry is None:
            raise Unlisted(f"{plain(symbol)} has no variable for its rate of order 0")
        return entry

    def _norm(self, of: Node) -> Ratio:
        value = self(of)
        for known, variable in self.norms:
            if len(known) == len(value) and (_equal(known, value) or _equal(known, each(value, lambda x: -x))):
                return variable
        self.norms.append((value, self.coordinates.norm(of)))
        return self.norms[-1][1]

    def _circular(self, function: str, argument: Node) -> Ratio:
        """The cosine or sine of a sum of angles, by the addition formulas."""
        cosine, sine = self.field.constant(1), self.field.constant(0)
        for symbol, multiple in angle_multiples(argument, self.rules).items():
            if symbol == PI:
                for _ in range(int(2 * multiple) % 4):
                    cosine, sine = -sine, cosine
                continue
            c, s = self.coordinates.circular(symbol)
            count = multiple / self.coordinates.unit(symbol)
            if count < 0:
                s, count = -s, -count
            for _ in range(int(count)):
                cosine, sine = cosine * c - sine * s, sine * c + cosine * s
        return cosine if function == "cos" else sine


def _equal(left: Matrix, right: Matrix) -> bool:
    return all((a - b).is_zero for one, other in zip(left, right, strict=True) for a, b in zip(one, other, strict=True))
