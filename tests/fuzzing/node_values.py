"""What do declared words come to? As matrices of power series in time, by walking the tree."""

from __future__ import annotations

from collections.abc import Mapping
from fractions import Fraction
from functools import reduce
from itertools import chain
from typing import Any

import numpy as np

from chasles import vocabulary as w

from . import series
from .series import Series, constant, mpf

__all__ = ["Entries", "Words", "entries_of"]

Entries = list[list[Series]]


class Words:
    """Values of words where symbols have the given entries, or stand for other words.

    A constant symbol has one coefficient for each entry.
    """

    def __init__(
        self, symbols: Mapping[w.Symbol, Entries], like: Any, meaning: Mapping[w.Symbol, w.Node] | None = None
    ) -> None:
        self.symbols = symbols
        self.like = like
        self.meaning = meaning or {}

    def scalar(self, node: w.Node) -> Any:
        """The value of a scalar."""
        return self(node, 0)[0][0][0]

    def number(self, value: Fraction | int, n: int) -> Series:
        """A number that does not change."""
        value = Fraction(value)
        if isinstance(self.like, np.ndarray):
            return constant(self.like * 0 + float(value), n)
        return constant(mpf(value.numerator) / value.denominator, n)

    def __call__(self, node: w.Node, n: int = 0) -> Entries:
        """The coefficients 0 to n of every entry; raises `Undefined` where there is no value."""
        match node:
            case w.Symbol():
                return self._symbol(node, n)
            case w.Number(value):
                return [[self.number(value, n)]]
            case w.Identity(size):
                return [[self.number(int(i == j), n) for j in range(size)] for i in range(size)]
            case w.Zero(rows, columns):
                return [[self.number(0, n) for _ in range(columns)] for _ in range(rows)]
            case w.Sum(terms):
                return reduce(_plus, [self(term, n) for term in terms])
            case w.Negative(term):
                return [[series.negative(x) for x in row] for row in self(term, n)]
            case w.Scale(factor, term):
                by = self(factor, n)[0][0]
                return [[series.times(by, x) for x in row] for row in self(term, n)]
            case w.Quotient(above, below):
                by = self(below, n)[0][0]
                return [[series.over(x, by) for x in row] for row in self(above, n)]
            case w.Contract(factors):
                return reduce(_product, [self(factor, n) for factor in factors])
            case w.Power(base, exponent):
                return reduce(_product, [self(base, n)] * exponent)
            case w.Transpose(of):
                return _flipped(self(of, n))
            case w.At(of) | w.Group(of):
                return self(of, n)
            case w.Rate(of):
                return [[series.rate(x) for x in row] for row in self(of, n + 1)]
            case w.Block(rows):
                blocks = [[self(block, n) for block in row] for row in rows]
                return [list(chain(*parts)) for row in blocks for parts in zip(*row, strict=True)]
            case w.Call(function, argument):
                ((angle,),) = self(argument, n)
                return [[series.sine(angle) if function == "sin" else series.cosine(angle)]]
            case _:
                return self._spatial(node, n)

    def _spatial(self, node: w.Node, n: int) -> Entries:
        match node:
            case w.Dot(left, right):
                return _product(_flipped(self(left, n)), self(right, n))
            case w.Cross(left, right):
                return _product(_skew(self(left, n)), self(right, n))
            case w.Skew(of):
                return _skew(self(of, n))
            case w.Vect(of):
                m = self(of, n)
                return [[series.divided(series.minus(m[k][j], m[j][k]), 2)] for j, k in ((1, 2), (2, 0), (0, 1))]
            case w.Trace(of):
                return [[reduce(series.plus, [row[i] for i, row in enumerate(self(of, n))])]]
            case w.Determinant(of):
                return [[_determinant(self(of, n))]]
            case w.Cofactor(of):
                return _flipped(_adjugate(self(of, n)))
            case w.Inverse(of):
                m = self(of, n)
                below = _determinant(m)
                return [[series.over(x, below) for x in row] for row in _adjugate(m)]
            case w.Norm(of):
                square = reduce(series.plus, [series.times(x, x) for (x,) in self(of, n)])
                return [[series.power(square, 1, 2)]]
        raise NotImplementedError(f"the oracle has no value for {node}")

    def _symbol(self, symbol: w.Symbol, n: int) -> Entries:
        if symbol.stands_for is not None:
            return self(symbol.stands_for, n)
        if symbol in self.meaning:
            return self(self.meaning[symbol], n)
        if symbol == w.PI:
            return [[constant(self.like * 0 + np.pi if isinstance(self.like, np.ndarray) else +series.mp.pi, n)]]
        found = self.symbols[symbol]
        return [[x[: n + 1] if len(x) > n else [*x, *[x[0] * 0] * (n + 1 - len(x))] for x in row] for row in found]


def entries_of(symbol: w.Symbol) -> list[tuple[int, int]]:
    """The places of a symbol's entries."""
    rows, columns = symbol.shape
    return [(i, j) for i in range(rows) for j in range(columns)]


def _plus(one: Entries, other: Entries) -> Entries:
    return [[series.plus(a, b) for a, b in zip(r, s, strict=True)] for r, s in zip(one, other, strict=True)]


def _product(one: Entries, other: Entries) -> Entries:
    columns = _flipped(other)
    return [
        [reduce(series.plus, [series.times(a, b) for a, b in zip(row, column, strict=True)]) for column in columns]
        for row in one
    ]


def _flipped(m: Entries) -> Entries:
    return [list(column) for column in zip(*m, strict=True)]


def _skew(vector: Entries) -> Entries:
    (x,), (y,), (z,) = vector
    nothing = series.minus(x, x)
    return [[nothing, series.negative(z), y], [z, nothing, series.negative(x)], [series.negative(y), x, nothing]]


def _determinant(m: Entries) -> Series:
    if len(m) == 1:
        return m[0][0]
    terms = []
    for j, entry in enumerate(m[0]):
        minor = series.times(entry, _determinant(_without(m, 0, j)))
        terms.append(minor if j % 2 == 0 else series.negative(minor))
    return reduce(series.plus, terms)


def _adjugate(m: Entries) -> Entries:
    size = range(len(m))
    if len(m) == 1:
        return [[constant(m[0][0][0] * 0 + 1, len(m[0][0]) - 1)]]
    minors = [[_determinant(_without(m, j, i)) for j in size] for i in size]
    return [[x if (i + j) % 2 == 0 else series.negative(x) for j, x in enumerate(row)] for i, row in enumerate(minors)]


def _without(m: Entries, i: int, j: int) -> Entries:
    return [row[:j] + row[j + 1 :] for k, row in enumerate(m) if k != i]
