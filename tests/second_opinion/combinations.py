"""Sums, products, quotients and the operations of three dimensions, for numbers of any context."""

from __future__ import annotations

from collections.abc import Callable
from functools import reduce
from operator import add
from typing import Any

from chasles.evaluation.matrices import Matrix, cofactors, determinant, plus, product, transposed
from chasles.vocabulary import (
    Block,
    Call,
    Cofactor,
    Contract,
    Cross,
    Determinant,
    Dot,
    Identity,
    Inverse,
    Negative,
    Node,
    Norm,
    Number,
    Power,
    Quotient,
    Scale,
    Skew,
    Sum,
    Trace,
    Transpose,
    Vect,
    Zero,
)

__all__ = ["combined", "scaled"]

Value = Callable[[Node], Matrix]


def combined(node: Node, value: Value, context: Any) -> Matrix:
    """The entries of an expression from those of its parts, which `value` gives; numbers are the context's.

    Raises TypeError for a node that is no combination of others, as a symbol, a rate or an integral.
    """
    match node:
        case Number(number):
            return [[context.mpf(number.numerator) / number.denominator]]
        case Identity(size):
            return [[context.mpf(int(i == j)) for j in range(size)] for i in range(size)]
        case Zero(rows, columns):
            return [[context.mpf(0)] * columns for _ in range(rows)]
        case Block(rows):
            lines = [zip(*map(value, row), strict=True) for row in rows]
            return [[entry for part in parts for entry in part] for line in lines for parts in line]
        case Sum(terms):
            return reduce(plus, map(value, terms))
        case Negative(term):
            return scaled(value(term), -1)
        case Scale(factor, term):
            return scaled(value(term), value(factor)[0][0])
        case Quotient(numerator, denominator):
            return scaled(value(numerator), 1 / value(denominator)[0][0])
        case Contract(factors):
            return reduce(product, map(value, factors))
        case Power(base, exponent):
            return reduce(product, [value(base)] * exponent)
        case Transpose(inner):
            return transposed(value(inner))
        case Dot(left, right):
            return product(transposed(value(left)), value(right))
        case Inverse(inner):
            return scaled(transposed(cofactors(value(inner), context.mpf(1))), 1 / determinant(value(inner)))
        case _:
            return _geometry(node, value, context)


def _geometry(node: Node, value: Value, context: Any) -> Matrix:
    match node:
        case Norm(inner):
            return [[context.sqrt(reduce(add, (row[0] ** 2 for row in value(inner))))]]
        case Call("sin" | "cos" as function, argument):
            return [[getattr(context, function)(value(argument)[0][0])]]
        case Skew(inner):
            (x,), (y,), (z,) = value(inner)
            return [[x * 0, -z, y], [z, x * 0, -x], [-y, x, x * 0]]
        case Cross(left, right):
            return product(value(Skew(left)), value(right))
        case Vect(inner):
            m = value(inner)
            return [[(m[k][j] - m[j][k]) / 2] for j, k in ((1, 2), (2, 0), (0, 1))]
        case Trace(inner):
            return [[reduce(add, (row[i] for i, row in enumerate(value(inner))))]]
        case Determinant(inner):
            return [[determinant(value(inner))]]
        case Cofactor(inner):
            return cofactors(value(inner), context.mpf(1))
        case _:
            raise TypeError(f"{node} ({type(node).__name__}) is no combination of other expressions")


def scaled(matrix: Matrix, factor: Any) -> Matrix:
    """The matrix times a number."""
    return [[factor * entry for entry in row] for row in matrix]
