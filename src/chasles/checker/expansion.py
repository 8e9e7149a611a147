"""What do the words mean, entry by entry? They are expanded a second time here, for the checker alone."""

from __future__ import annotations

from collections.abc import Callable
from fractions import Fraction
from functools import reduce
from itertools import chain
from operator import add, mul
from typing import Any

from chasles import vocabulary as w
from chasles.checker.sparse import Matrix, Rejected, cofactor, determinant, number


class Formless(Rejected):
    """A word that is no polynomial in the entries of symbols, or an angle that is no sum of their multiples."""


def expanded(node: w.Node, of: Callable[[w.Node], Matrix], number: Callable[[int | Fraction], Any] = number) -> Matrix:
    """The entries of a word, made from those `of` its parts; raises `Formless` for a word that is none.

    They are polynomials, or whatever a `number` is made.
    """
    match node:
        case w.Number(value):
            return [[number(value)]]
        case w.Identity(size):
            return [[number(int(i == j)) for j in range(size)] for i in range(size)]
        case w.Zero(rows, columns):
            return [[number(0)] * columns] * rows
        case w.Sum(terms):
            return [[reduce(add, x) for x in zip(*row, strict=True)] for row in zip(*map(of, terms), strict=True)]
        case w.Negative(term):
            return [[-entry for entry in row] for row in of(term)]
        case w.Scale(factor, term):
            return scaled(of(factor)[0][0], of(term))
        case w.Contract(factors):
            return reduce(_times, map(of, factors))
        case w.Power(w.Norm(x), exponent) if exponent % 2 == 0:
            return reduce(_times, [of(w.Dot(x, x))] * (exponent // 2))
        case w.Power(base, exponent):
            return reduce(_times, [of(base)] * exponent)
        case w.Transpose(x):
            return _flipped(of(x))
        case w.Dot(left, right):
            return _times(_flipped(of(left)), of(right))
        case w.Block(rows):
            return [list(chain(*parts)) for row in rows for parts in zip(*map(of, row), strict=True)]
        case w.Skew(x):
            return _skew(of(x), number(0))
        case w.Cross(left, right):
            return _times(_skew(of(left), number(0)), of(right))
        case w.Vect(x):
            m, half = of(x), number(Fraction(1, 2))
            return scaled(half, [[m[2][1] - m[1][2]], [m[0][2] - m[2][0]], [m[1][0] - m[0][1]]])
        case w.Trace(x):
            return [[reduce(add, (row[i] for i, row in enumerate(of(x))))]]
        case w.Determinant(x):
            return [[determinant(of(x), number(1))]]
        case w.Cofactor(x):
            m = of(x)
            return [[cofactor(m, i, j, number(1)) for j in range(len(m))] for i in range(len(m))]
        case _:
            raise Formless(f"{node} ({type(node).__name__}) has no polynomial form")


def _times(left: Matrix, right: Matrix) -> Matrix:
    return [[reduce(add, map(mul, row, column)) for column in zip(*right, strict=True)] for row in left]


def scaled(factor: Any, matrix: Matrix) -> Matrix:
    """A scalar times a matrix."""
    return [[factor * entry for entry in row] for row in matrix]


def _flipped(matrix: Matrix) -> Matrix:
    return [list(column) for column in zip(*matrix, strict=True)]


def _skew(vector: Matrix, zero: Any) -> Matrix:
    (x,), (y,), (z,) = vector
    return [[zero, -z, y], [z, zero, -x], [-y, x, zero]]
