"""The book's words as SymPy matrices, with SymPy's derivatives for rates: what outside software is compared with."""

from __future__ import annotations

from collections.abc import Mapping
from functools import reduce
from operator import add, mul

import sympy
from sympy.physics.vector import dynamicsymbols

from chasles import vocabulary as w

__all__ = ["TIME", "in_sympy"]

TIME = dynamicsymbols._t


def in_sympy(node: w.Node, values: Mapping[w.Node, sympy.Matrix]) -> sympy.Matrix:
    """The expression with SymPy matrices for its symbols; raises KeyError for a symbol that has none."""

    def of(part: w.Node) -> sympy.Matrix:
        return in_sympy(part, values)

    if node in values:
        return sympy.Matrix(values[node])
    match node:
        case w.Symbol(stands_for=w.Node() as meaning):
            return of(meaning)
        case w.Symbol():
            raise KeyError(str(node))
        case w.Rate(inner):
            return of(inner).diff(TIME)
        case w.Number(value):
            return sympy.Matrix([[sympy.Rational(value.numerator, value.denominator)]])
        case w.Identity(size):
            return sympy.eye(size)
        case w.Zero(rows, columns):
            return sympy.zeros(rows, columns)
        case w.At(inner) | w.Group(inner):
            return of(inner)
        case w.Block(rows):
            return sympy.Matrix.vstack(*(sympy.Matrix.hstack(*map(of, row)) for row in rows))
        case w.Sum(terms):
            return reduce(add, map(of, terms))
        case w.Negative(term):
            return -of(term)
        case w.Scale(factor, term):
            return of(factor)[0] * of(term)
        case w.Quotient(numerator, denominator):
            return of(numerator) / of(denominator)[0]
        case w.Contract(factors):
            return reduce(mul, map(of, factors))
        case w.Power(base, exponent):
            return of(base) ** exponent
        case w.Transpose(inner):
            return of(inner).T
        case w.Dot(left, right):
            return of(left).T * of(right)
        case _:
            return _geometry(node, values)


def _geometry(node: w.Node, values: Mapping[w.Node, sympy.Matrix]) -> sympy.Matrix:
    def of(part: w.Node) -> sympy.Matrix:
        return in_sympy(part, values)

    match node:
        case w.Norm(inner):
            return sympy.Matrix([[sympy.sqrt((of(inner).T * of(inner))[0])]])
        case w.Call(function, argument):
            return sympy.Matrix([[getattr(sympy, function)(of(argument)[0])]])
        case w.Skew(inner):
            return of(inner).hat()
        case w.Cross(left, right):
            return of(left).cross(of(right))
        case w.Vect(inner):
            m = of(inner)
            return sympy.Matrix([m[2, 1] - m[1, 2], m[0, 2] - m[2, 0], m[1, 0] - m[0, 1]]) / 2
        case w.Trace(inner):
            return sympy.Matrix([[of(inner).trace()]])
        case _:
            raise TypeError(f"{type(node).__name__} is not read into SymPy")
