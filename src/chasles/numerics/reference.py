"""What is the value, to 50 digits? Expressions evaluated with mpmath, apart from the prover and from every program.

The digits are those of the result, not of the arithmetic: intervals enclose every step, and an evaluation is repeated
with more precision until they are narrow. So 1 - cos(phi) has 50 right digits for phi = 1e-60 too.
"""

from __future__ import annotations

from collections.abc import Iterable, Mapping, Sequence
from functools import reduce
from operator import add
from typing import Any

from chasles.numerics.enclosures import ends, exactly, interval_context, is_narrow, middle
from chasles.numerics.small_matrices import Matrix, cofactors, determinant, flipped, plus, product
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
    Inverse,
    Misfit,
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
)
from chasles.vocabulary.differentiation import rate_of

__all__ = ["Matrix", "NoValue", "Singular", "evaluate"]

GUARD = 15
"""Digits beyond those asked for in the first evaluation."""
MOST_DIGITS = 4000
"""Precision at which what cannot be told from zero is zero: no product of ten floats is as small."""


class NoValue(LookupError):
    """A symbol or a rate that has neither a value nor a rule; the message names it."""


class Singular(ZeroDivisionError):
    """A division by zero, or the inverse of a singular matrix; the message names the divisor."""


def evaluate(
    node: Node, values: Mapping[Node, Any], rules: Mapping[Node, Node] | None = None, digits: int = 50
) -> Matrix:
    """The entries of the expression, row by row, each with `digits` right digits.

    `values` gives numbers (exactly as they are: integers, fractions, floats, mpmath numbers, nested sequences or arrays
    of them) to symbols and to rates of symbols, and comes before `rules`, which say what a symbol stands for. Raises
    `NoValue` for a symbol or rate with neither, `Singular` for a division by zero, `Misfit` for an expression that does
    not fit together, ValueError for a value of another shape than its symbol's.
    """
    if node.fault:
        raise Misfit(node.fault)
    precision = digits + GUARD
    while True:
        last = precision >= MOST_DIGITS
        try:
            enclosures = _Evaluation(precision, values, rules or {})(node)
            if last or all(is_narrow(entry, digits) for row in enclosures for entry in row):
                return [[middle(entry, precision) for entry in row] for row in enclosures]
        except _TooWide as wide:
            if last:
                raise Singular(str(wide)) from None
        precision *= 2


class _TooWide(ArithmeticError):
    """A divisor whose enclosure still holds zero."""


class _Evaluation:
    """One evaluation with a fixed precision, in enclosures; every node is evaluated once."""

    def __init__(self, digits: int, values: Mapping[Node, Any], rules: Mapping[Node, Node]) -> None:
        self.context = interval_context(digits)
        self.values = values
        self.rules = rules
        self._known: dict[Node, Matrix] = {}

    def __call__(self, node: Node) -> Matrix:
        known = self._known.get(node)
        if known is None:
            known = self._known[node] = self._evaluate(node)
        return known

    def _evaluate(self, node: Node) -> Matrix:
        if node in self.values:
            return self._given(node)
        if node in self.rules:
            return self(self.rules[node])
        match node:
            case Symbol(stands_for=Node() as meaning):
                return self(meaning)
            case Symbol() if node == PI:
                return [[self.context.convert(self.context.pi)]]
            case Symbol():
                raise NoValue(f"{node} has no value: give it one, or a statement that says what it is")
            case Rate(At(of, "t") | Group(of)):
                return self(Rate(of))
            case Rate(of):
                return self._rate(node, of)
            case Number(value):
                return [[exactly(value, self.context)]]
            case Identity(size):
                return [[self.context.mpf(int(i == j)) for j in range(size)] for i in range(size)]
            case Zero(rows, columns):
                return [[self.context.mpf(0)] * columns for _ in range(rows)]
            case At(of, "t") | Group(of):
                return self(of)
            case Block(rows):
                return [
                    [entry for part in parts for entry in part]
                    for row in rows
                    for parts in zip(*map(self, row), strict=True)
                ]
            case _:
                return self._algebra(node)

    def _rate(self, node: Node, of: Node) -> Matrix:
        """A rate that has no value of its own is made of the rates of what the symbol stands for."""
        match of:
            case _ if of in self.rules:
                return self(rate_of(self.rules[of]))
            case Symbol(stands_for=Node() as meaning):
                return self(rate_of(meaning))
            case Symbol() | Rate():
                raise NoValue(f"{node} has no value: give it among the values, or a statement that says what it is")
            case _:
                return self(rate_of(of))

    def _algebra(self, node: Node) -> Matrix:
        """Sums, products and quotients."""
        match node:
            case Sum(terms):
                return reduce(plus, map(self, terms))
            case Negative(term):
                return [[-entry for entry in row] for row in self(term)]
            case Scale(factor, term):
                scalar = self(factor)[0][0]
                return [[scalar * entry for entry in row] for row in self(term)]
            case Quotient(numerator, denominator):
                divisor = self._divisor(
                    self(denominator)[0][0], f"{denominator} is zero here, and nothing can be divided by it"
                )
                return [[entry / divisor for entry in row] for row in self(numerator)]
            case Contract(factors):
                return reduce(product, map(self, factors))
            case Power(base, exponent) if base.is_scalar:
                return [[self(base)[0][0] ** exponent]]
            case Power(base, exponent):
                return reduce(product, [self(base)] * exponent)
            case Transpose(of):
                return flipped(self(of))
            case Dot(left, right):
                return product(flipped(self(left)), self(right))
            case Inverse(of):
                matrix = self(of)
                below = self._divisor(determinant(matrix), f"{of} has no inverse here")
                return [[entry / below for entry in row] for row in flipped(cofactors(matrix))]
            case _:
                return self._geometry(node)

    def _geometry(self, node: Node) -> Matrix:
        """Functions, and the operations of three dimensions."""
        match node:
            case Norm(of):
                # Squares are formed as such: an enclosure of zero times itself would hold negative numbers.
                return [[self.context.sqrt(reduce(add, (row[0] ** 2 for row in self(of))))]]
            case Call("sin" | "cos" as function, argument):
                return [[getattr(self.context, function)(self(argument)[0][0])]]
            case Skew(of):
                (x,), (y,), (z,) = self(of)
                nothing = self.context.mpf(0)
                return [[nothing, -z, y], [z, nothing, -x], [-y, x, nothing]]
            case Cross(left, right):
                a, b = ([row[0] for row in self(side)] for side in (left, right))
                return [[a[j] * b[k] - a[k] * b[j]] for j, k in ((1, 2), (2, 0), (0, 1))]
            case Vect(of):
                m = self(of)
                return [[(m[k][j] - m[j][k]) / 2] for j, k in ((1, 2), (2, 0), (0, 1))]
            case Trace(of):
                m = self(of)
                return [[sum((m[i][i] for i in range(1, len(m))), m[0][0])]]
            case Determinant(of):
                return [[determinant(self(of))]]
            case Cofactor(of):
                return cofactors(self(of))
            case _:
                raise TypeError(f"{node} ({type(node).__name__}) has no numeric value here")

    def _divisor(self, divisor: Any, otherwise: str) -> Any:
        low, high = ends(divisor)
        if low == high == 0:
            raise Singular(otherwise)
        if low <= 0 <= high:
            raise _TooWide(otherwise)
        return divisor

    def _given(self, node: Node) -> Matrix:
        rows, columns = node.shape
        flat = list(_flattened(self.values[node]))
        if len(flat) != rows * columns:
            raise ValueError(f"{node} is {rows} x {columns}, and its value has {len(flat)} entries")
        entries = [exactly(number, self.context) for number in flat]
        return [entries[i * columns : (i + 1) * columns] for i in range(rows)]


def _flattened(value: Any) -> Iterable[Any]:
    """The numbers in a number, in nested sequences or in an array, row by row."""
    if hasattr(value, "tolist"):
        value = value.tolist()
    if isinstance(value, Sequence) and not isinstance(value, str):
        for part in value:
            yield from _flattened(part)
    else:
        yield value
