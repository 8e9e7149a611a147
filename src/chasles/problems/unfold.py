"""From words to polynomials: the one door. Every expression becomes a matrix of fractions over declared atoms.

Divisors are read by one room beside it, rates taken by another.
"""

from __future__ import annotations

from collections.abc import Mapping
from fractions import Fraction
from functools import reduce
from itertools import chain
from operator import add

from chasles.algebra.localization import Localization, Ratio
from chasles.algebra.matrices import Matrix, cofactor, determinant, each, equal, flipped, plus, times
from chasles.algebra.work_limit import check
from chasles.problems.coordinates import Coordinates
from chasles.problems.differentiation import Differentiation
from chasles.problems.divisors import Divisors, UndeclaredDivisor
from chasles.problems.moments import BodyMoments
from chasles.problems.variables import Unlisted, Untreatable, Variable, angle_multiples
from chasles.vocabulary import (
    PI,
    At,
    Block,
    Call,
    Cofactor,
    Contract,
    Cross,
    Determinant,
    Dot,
    Group,
    Identity,
    Integral,
    Negative,
    Node,
    Norm,
    Number,
    Power,
    Quotient,
    Rate,
    Scale,
    Skew,
    Sum,
    Symbol,
    Trace,
    Transpose,
    Vect,
    Zero,
    plain,
)

__all__ = ["Matrix", "UndeclaredDivisor", "Unfolder"]


class Unfolder:
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
        self.field = field
        self.variables = variables
        self.rules = rules
        self.values: dict[Symbol, Matrix] = {}
        self.norms: list[tuple[Matrix, Ratio]] = []
        self.moments = BodyMoments(field, variables, running, rules)
        self.coordinates = Coordinates(field, variables)
        self._known: dict[Node, Matrix] = {}
        self.divisors = Divisors(field, rules, self)
        self.rate = Differentiation(field, variables, self.coordinates, rules, self.moments, self.divisors, self)

    def __call__(self, node: Node) -> Matrix:
        """The entries of the expression."""
        known = self._known.get(node)
        if known is None:
            check()
            known = self._known[node] = self._unfold(node)
        return known

    def forget(self) -> None:
        """Unfold anew from here on: `values` has changed."""
        self._known.clear()
        self.rate.forget()

    def _unfold(self, node: Node) -> Matrix:
        if node in self.rules:
            return self(self.rules[node])
        match node:
            case Symbol():
                return self._symbol(node, 0)
            case Number(value):
                return [[self.field.constant(value)]]
            case Identity(size):
                return [[self.field.constant(int(i == j)) for j in range(size)] for i in range(size)]
            case Zero(rows, columns):
                return [[self.field.constant(0)] * columns for _ in range(rows)]
            case Sum(terms):
                return reduce(plus, map(self, terms))
            case Negative(term):
                return each(self(term), lambda entry: -entry)
            case Scale(factor, term):
                scalar = self(factor)[0][0]
                return each(self(term), lambda entry: scalar * entry)
            case Quotient(numerator, denominator):
                constant, exponents = self.divisors(denominator)
                return each(self(numerator), lambda entry: entry.divided(constant, exponents))
            case Contract(factors):
                return reduce(times, map(self, factors))
            case Power(Norm(of), exponent) if exponent % 2 == 0:
                square = times(flipped(self(of)), self(of))
                return reduce(times, [square] * (exponent // 2))
            case Power(base, exponent):
                return reduce(times, [self(base)] * exponent)
            case Transpose(of):
                return flipped(self(of))
            case Dot(left, right):
                return times(flipped(self(left)), self(right))
            case Norm(of):
                return [[self._norm(of)]]
            case Call(function, argument):
                return [[self._circular(function, argument)]]
            case Block(rows):
                return [list(chain(*parts)) for row in rows for parts in zip(*map(self, row), strict=True)]
            case At(of) | Group(of):
                return self(of)
            case Rate(of):
                return self._rate_of(of)
            case Integral(of):
                return each(self(of), self.moments.integral)
            case _:
                return self._spatial(node)

    def _spatial(self, node: Node) -> Matrix:
        """The operations of three dimensions."""
        match node:
            case Skew(of):
                (x,), (y,), (z,) = self(of)
                nothing = self.field.constant(0)
                return [[nothing, -z, y], [z, nothing, -x], [-y, x, nothing]]
            case Cross(left, right):
                a, b = (([row[0] for row in self(side)]) for side in (left, right))
                return [[a[j] * b[k] - a[k] * b[j]] for j, k in ((1, 2), (2, 0), (0, 1))]
            case Vect(of):
                m = self(of)
                half = Fraction(2)
                return [[(m[k][j] - m[j][k]).divided(half, ())] for j, k in ((1, 2), (2, 0), (0, 1))]
            case Trace(of):
                m = self(of)
                return [[reduce(add, (m[i][i] for i in range(len(m))))]]
            case Determinant(of):
                return [[determinant(self(of))]]
            case Cofactor(of):
                m = self(of)
                return [[cofactor(m, i, j) for j in range(len(m))] for i in range(len(m))]
            case _:
                raise Untreatable(f"{plain(node)} ({type(node).__name__}) cannot stand here: it has no polynomial form")

    def _symbol(self, symbol: Symbol, order: int) -> Matrix:
        if symbol.stands_for is not None:
            return self(symbol.stands_for)
        if symbol in self.values:
            return self.values[symbol]
        rows, columns = symbol.shape
        return [[self._entry(symbol, order, i, j) for j in range(columns)] for i in range(rows)]

    def _entry(self, symbol: Symbol, order: int, row: int, column: int) -> Ratio:
        entry = self.coordinates.entry(symbol, order, row, column)
        if entry is None:
            raise Unlisted(f"{plain(symbol)} has no variable for its rate of order {order}")
        return entry

    def _norm(self, of: Node) -> Ratio:
        value = self(of)
        for known, variable in self.norms:
            if len(known) == len(value) and (equal(known, value) or equal(known, each(value, lambda x: -x))):
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

    def _rate_of(self, of: Node) -> Matrix:
        """The rate: that of a symbol's own rule if it has one, else by the derivation."""
        if isinstance(of, Group | At):
            return self(Rate(of.of))
        return each(self(of), self.rate)
