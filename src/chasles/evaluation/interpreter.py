"""What each word means entry by entry, said once; an arithmetic says what is its own."""

from __future__ import annotations

from collections.abc import Mapping
from fractions import Fraction
from functools import reduce
from operator import add
from typing import Any

from chasles import vocabulary as w
from chasles.evaluation import matrices
from chasles.evaluation.matrices import Matrix, each, plus, transposed
from chasles.vocabulary import Node
from chasles.vocabulary.shorthand import Shorthand


class Interpreter:
    """Evaluates expressions to matrices as lists of rows, each expression once; `rules` say what one is put for.

    A class for one arithmetic says what a `constant` is and what a word is that has no entries by its parts alone
    (`own`: symbols, rates, functions), and how it is divided where that is not entry by entry.
    """

    def __init__(self, rules: Mapping[Node, Node]) -> None:
        self.rules = rules
        self._known: dict[Node, Matrix] = {}

    def constant(self, value: Fraction) -> Any:
        """A rational number in this arithmetic."""
        raise NotImplementedError

    def own(self, node: Node) -> Matrix:
        """The entries of a symbol or of a word that this arithmetic alone knows."""
        raise NotImplementedError

    def quotient(self, numerator: Matrix, denominator: Node) -> Matrix:
        """The matrix divided by a scalar."""
        below = self.scalar(denominator)
        return each(numerator, lambda entry: entry / below)

    def reduced(self, matrix: Matrix) -> Matrix:
        """The matrix with its entries in the form in which they are kept."""
        return matrix

    def is_zero(self, entry: Any) -> bool:
        """Whether an entry is seen to vanish, so that no product with it needs to be formed."""
        return False

    def product(self, left: Matrix, right: Matrix) -> Matrix:
        """The matrix product."""
        return matrices.product(left, right)

    def __call__(self, node: Node) -> Matrix:
        """The entries of the expression."""
        known = self._known.get(node)
        if known is None:
            self.begin()
            known = self._known[node] = self.reduced(self.entries(node))
        return known

    def begin(self) -> None:
        """Called before an expression is evaluated, so that a limit on work can stop it."""

    def scalar(self, node: Node) -> Any:
        """The one entry of a scalar."""
        return self(node)[0][0]

    def entries(self, node: Node) -> Matrix:
        """The entries of an expression that is not known yet."""
        if node in self.rules:
            return self(self.rules[node])
        match node:
            case w.Symbol(stands_for=Node() as of) | w.At(of) | w.Group(of):
                return self(of)
            case Shorthand():
                return self(node.definition)
            case w.Number(value):
                return [[self.constant(value)]]
            case w.Identity(size):
                return [[self.constant(Fraction(i == j)) for j in range(size)] for i in range(size)]
            case w.Zero(rows, columns):
                return [[self.constant(Fraction(0))] * columns for _ in range(rows)]
            case w.Block(rows):
                lines = (zip(*map(self, row), strict=True) for row in rows)
                return [[entry for part in parts for entry in part] for line in lines for parts in line]
            case w.Sum(terms):
                return reduce(plus, map(self, terms))
            case w.Negative(term):
                return each(self(term), lambda entry: -entry)
            case w.Scale(factor, term):
                scalar = self.scalar(factor)
                return each(self(term), lambda entry: scalar * entry)
            case w.Quotient(numerator, denominator):
                return self.quotient(self(numerator), denominator)
            case w.Contract(factors):
                return reduce(self.product, map(self, factors))
            case w.Power(w.Norm(of), exponent) if exponent % 2 == 0:
                return reduce(self.product, [self.product(transposed(self(of)), self(of))] * (exponent // 2))
            case w.Power(base, exponent):
                return reduce(self.product, [self(base)] * exponent)
            case w.Transpose(of):
                return transposed(self(of))
            case _:
                return self._spatial(node)

    def _spatial(self, node: Node) -> Matrix:
        """The operations of three dimensions and of square matrices."""
        match node:
            case w.Dot(left, right):
                return self.product(transposed(self(left)), self(right))
            case w.Skew(of):
                return matrices.skew(self(of), self.constant(Fraction(0)))
            case w.Cross(left, right):
                return matrices.cross(self(left), self(right))
            case w.Vect(of):
                m, half = self(of), self.constant(Fraction(1, 2))
                return [[(m[k][j] - m[j][k]) * half] for j, k in ((1, 2), (2, 0), (0, 1))]
            case w.Trace(of):
                m = self(of)
                return [[reduce(add, (m[i][i] for i in range(len(m))))]]
            case w.Determinant(of):
                return [[matrices.determinant(self(of), self.is_zero)]]
            case w.Cofactor(of):
                return matrices.cofactors(self(of), self.constant(Fraction(1)))
            case _:
                return self.own(node)

    def inverse(self, of: Node) -> Matrix:
        """The inverse of a square matrix: its adjugate over its determinant."""
        return self.quotient(transposed(self(w.Cofactor(of))), w.Determinant(of))
