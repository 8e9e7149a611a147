"""Words at exact values: an expression of the book becomes a SymPy matrix of numbers in normal form.

The values may hold free symbols, as the unknowns of equations do. Nothing is rounded and nothing is guessed.
"""

from __future__ import annotations

from collections.abc import Callable, Mapping
from functools import reduce
from itertools import chain
from typing import Any

import sympy as sp

from chasles.exact.numbers import is_zero, normal, root
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
    plain,
)

__all__ = ["DividesByZero", "NoValue", "Value", "column_of", "evaluate", "matrix_of"]

Value = Any
"""A number or a matrix as SymPy, which has no types, holds it."""


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
    return _Evaluation(values)(node)


def matrix_of(rows: Any) -> Any:
    """A matrix with its entries in normal form."""
    return sp.ImmutableMatrix(rows).applyfunc(normal)


def column_of(*entries: Any) -> Any:
    """A column with its entries in normal form."""
    return matrix_of([[entry] for entry in entries])


class _Evaluation:
    """One evaluation; every node is evaluated once."""

    def __init__(self, values: Mapping[Node, Any]) -> None:
        self._values = values
        self._known: dict[Node, Any] = {}

    def __call__(self, node: Node) -> Any:
        if node not in self._known:
            self._known[node] = self._evaluate(node).applyfunc(normal)
        return self._known[node]

    def number(self, node: Node) -> Any:
        return self(node)[0, 0]

    def _evaluate(self, node: Node) -> Any:
        if node in self._values:
            return self._given(node)
        match node:
            case Symbol(stands_for=Node() as meaning):
                return self(meaning)
            case Symbol() if node == PI:
                return column_of(sp.pi)
            case Symbol() | Rate():
                if isinstance(node, Rate) and isinstance(node.of, At | Group):
                    return self(Rate(node.of.of))
                raise NoValue(f"{plain(node)} has no value here")
            case Number(value):
                return column_of(value)
            case Identity(size):
                return sp.ImmutableMatrix(sp.eye(size))
            case Zero(rows, columns):
                return sp.ImmutableMatrix(sp.zeros(rows, columns))
            case At(of) | Group(of):
                return self(of)
            case Block(rows):
                return sp.ImmutableMatrix(sp.Matrix.vstack(*(sp.Matrix.hstack(*map(self, row)) for row in rows)))
            case _:
                return self._algebra(node)

    def _algebra(self, node: Node) -> Any:
        """Sums, products and quotients."""
        match node:
            case Sum(terms):
                return reduce(lambda one, other: one + other, map(self, terms))
            case Negative(term):
                return -self(term)
            case Scale(factor, term):
                return self.number(factor) * self(term)
            case Quotient(numerator, denominator):
                return self(numerator) / self._divisor(self.number(denominator), denominator)
            case Contract(factors):
                return reduce(_product, map(self, factors))
            case Power(Norm(of), exponent) if exponent % 2 == 0:
                return column_of(_squared(self(of)) ** (exponent // 2))
            case Power(base, exponent) if base.is_scalar:
                return column_of(self.number(base) ** exponent)
            case Power(base, exponent):
                return reduce(_product, [self(base)] * exponent)
            case Transpose(of):
                return self(of).T
            case Dot(left, right):
                return _product(self(left).T, self(right))
            case Inverse(of):
                matrix = self(of)
                self._divisor(normal(matrix.det(method="berkowitz")), node)
                return matrix.adjugate() / normal(matrix.det(method="berkowitz"))
            case _:
                return self._geometry(node)

    def _geometry(self, node: Node) -> Any:
        """Functions, and the operations of three dimensions."""
        match node:
            case Norm(of):
                return column_of(root(_squared(self(of))))
            case Call("sin" | "cos" as function, argument):
                return column_of(getattr(sp, function)(self.number(argument)))
            case Skew(of):
                x, y, z = self(of)
                return sp.ImmutableMatrix([[0, -z, y], [z, 0, -x], [-y, x, 0]])
            case Cross(left, right):
                return self(left).cross(self(right))
            case Vect(of):
                m = self(of)
                return column_of(*((m[k, j] - m[j, k]) / 2 for j, k in ((1, 2), (2, 0), (0, 1))))
            case Trace(of):
                return column_of(self(of).trace())
            case Determinant(of):
                return column_of(self(of).det(method="berkowitz"))
            case Cofactor(of):
                return self(of).cofactor_matrix(method="berkowitz")
            case _:
                raise TypeError(f"{plain(node)} ({type(node).__name__}) has no exact value here")

    def _divisor(self, divisor: Any, node: Node) -> Any:
        if is_zero(divisor):
            raise DividesByZero(f"{plain(node)} is zero here, and nothing can be divided by it")
        return divisor

    def _given(self, node: Node) -> Any:
        value = self._values[node]
        if not hasattr(value, "shape"):
            value = column_of(value)
        if value.shape != node.shape:
            rows, columns = node.shape
            raise ValueError(
                f"{plain(node)} is {rows} x {columns}, and its value is {value.shape[0]} x {value.shape[1]}"
            )
        return sp.ImmutableMatrix(value)


def _product(left: Any, right: Any) -> Any:
    """The matrix product, entry by entry in normal form; a 1 x 1 factor does not scale."""
    each: Callable[[int, int], Any] = lambda i, j: normal(  # noqa: E731
        sp.Add(*(normal(left[i, k] * right[k, j]) for k in range(left.cols)))
    )
    return sp.ImmutableMatrix(left.rows, right.cols, list(chain(*([each(i, j) for j in range(right.cols)]
                                                                 for i in range(left.rows)))))  # fmt: skip


def _squared(vector: Any) -> Any:
    return normal(sp.Add(*(normal(entry**2) for entry in vector)))
