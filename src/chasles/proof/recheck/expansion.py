"""What does a declaration say? Its words are expanded a second time here, for the checker alone."""

from __future__ import annotations

from abc import ABC, abstractmethod
from collections.abc import Mapping
from fractions import Fraction
from functools import reduce
from itertools import chain
from operator import add, mul

from chasles import vocabulary as w
from chasles.proof.recheck.sparse import ONE, ZERO, Polynomial, Rejected, number

__all__ = ["Expansion", "Matrix", "determinant"]

Matrix = list[list[Polynomial]]


class Expansion(ABC):
    """Every expression as a matrix of polynomials, `rules` applied; raises `Rejected` for what has no such form."""

    def __init__(self, rules: Mapping[w.Node, w.Node]) -> None:
        self.rules = rules
        self._known: dict[w.Node, Matrix] = {}

    @abstractmethod
    def symbol(self, node: w.Symbol | w.Rate) -> Matrix:
        """The entries of a symbol that nothing replaces, or of a rate."""

    @abstractmethod
    def inverse(self, node: w.Node) -> Polynomial:
        """One over a scalar."""

    @abstractmethod
    def norm(self, of: w.Node) -> Polynomial:
        """The norm of a column."""

    @abstractmethod
    def integral(self, node: w.Integral) -> Matrix:
        """The integral over a body."""

    @abstractmethod
    def circular(self, angle: w.Node) -> tuple[Polynomial, Polynomial]:
        """Cosine and sine of an angle."""

    def __call__(self, node: w.Node) -> Matrix:
        """The entries of an expression."""
        if node not in self._known:
            self._known[node] = self(self.rules[node]) if node in self.rules else self._unfold(node)
        return self._known[node]

    def _unfold(self, node: w.Node) -> Matrix:
        match node:
            case w.Symbol(stands_for=w.Node() as of) | w.At(of) | w.Group(of):
                return self(of)
            case w.Rate(w.At(of) | w.Group(of)):
                return self(w.Rate(of))
            case w.Symbol() | w.Rate():
                return self.symbol(node)
            case w.Number(value):
                return [[number(value)]]
            case w.Identity(size):
                return [[number(int(i == j)) for j in range(size)] for i in range(size)]
            case w.Zero(rows, columns):
                return [[ZERO] * columns] * rows
            case w.Sum(terms):
                return reduce(_plus, map(self, terms))
            case w.Negative(term):
                return [[-entry for entry in row] for row in self(term)]
            case w.Scale(factor, term):
                return _scaled(self(factor)[0][0], self(term))
            case w.Quotient(numerator, denominator):
                return _scaled(self.inverse(denominator), self(numerator))
            case w.Contract(factors):
                return reduce(_times, map(self, factors))
            case w.Power(w.Norm(of), exponent) if exponent % 2 == 0:
                return reduce(_times, [self(w.Dot(of, of))] * (exponent // 2))
            case w.Power(base, exponent):
                return reduce(_times, [self(base)] * exponent)
            case w.Transpose(of):
                return _flipped(self(of))
            case w.Dot(left, right):
                return _times(_flipped(self(left)), self(right))
            case w.Block(rows):
                return [list(chain(*parts)) for row in rows for parts in zip(*map(self, row), strict=True)]
            case _:
                return self._spatial(node)

    def _spatial(self, node: w.Node) -> Matrix:
        match node:
            case w.Skew(of):
                return _skew(self(of))
            case w.Cross(left, right):
                return _times(_skew(self(left)), self(right))
            case w.Vect(of):
                m, half = self(of), number(Fraction(1, 2))
                return _scaled(half, [[m[2][1] - m[1][2]], [m[0][2] - m[2][0]], [m[1][0] - m[0][1]]])
            case w.Trace(of):
                return [[reduce(add, (row[i] for i, row in enumerate(self(of))))]]
            case w.Determinant(of):
                return [[determinant(self(of))]]
            case w.Cofactor(of):
                m, pairs = self(of), ((1, 2), (2, 0), (0, 1))
                return [[m[a][c] * m[b][d] - m[a][d] * m[b][c] for c, d in pairs] for a, b in pairs]
            case w.Norm(of):
                return [[self.norm(of)]]
            case w.Integral():
                return self.integral(node)
            case w.Call("cos" | "sin" as function, argument):
                return [[self.circular(argument)[function == "sin"]]]
            case _:
                raise Rejected(f"{node} ({type(node).__name__}) has no polynomial form")


def _plus(left: Matrix, right: Matrix) -> Matrix:
    return [[a + b for a, b in zip(one, other, strict=True)] for one, other in zip(left, right, strict=True)]


def _times(left: Matrix, right: Matrix) -> Matrix:
    return [[reduce(add, map(mul, row, column)) for column in zip(*right, strict=True)] for row in left]


def _scaled(factor: Polynomial, matrix: Matrix) -> Matrix:
    return [[factor * entry for entry in row] for row in matrix]


def _flipped(matrix: Matrix) -> Matrix:
    return [list(column) for column in zip(*matrix, strict=True)]


def _skew(vector: Matrix) -> Matrix:
    (x,), (y,), (z,) = vector
    return [[ZERO, -z, y], [z, ZERO, -x], [-y, x, ZERO]]


def determinant(m: Matrix) -> Polynomial:
    """The determinant, by expansion along the first row."""
    total = ZERO if m else ONE
    for j, entry in enumerate(m[0] if m else []):
        if entry:
            minor = determinant([row[:j] + row[j + 1 :] for row in m[1:]])
            total = total - entry * minor if j % 2 else total + entry * minor
    return total
