"""From words to steps, node by node: vectors and tensors first, components last.

Factors of a whole expression meet before they meet its entries, and a multiple of a matrix of blocks is the matrix of
the blocks' multiples.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import replace as with_fields
from functools import reduce
from typing import Any

from chasles import vocabulary as w
from chasles.lowering.builder import Builder
from chasles.lowering.matrices import Column, CrossProduct, Dense, Dyad, Matrix, Rows, Unit
from chasles.lowering.meaning import Meanings
from chasles.lowering.products import Products
from chasles.lowering.refusal import LoweringError
from chasles.lowering.request import Request
from chasles.lowering.rewriting import flipped
from chasles.lowering.tensors import Tensors


class Expansion(Products):
    """The steps of one request; `dense` writes every matrix that a rule defines in components once and for all."""

    def __init__(self, builder: Builder, request: Request, *, dense: bool) -> None:
        self.builder = builder
        self.tensors = Tensors(builder)
        self.dense = dense
        self.meanings = Meanings(request, self)
        self.tensors.units |= self._unit_arguments(request)
        self._scalars: dict[w.Node, int] = {}
        self._columns: dict[w.Node, Column] = {}
        self._matrices: dict[w.Node, Matrix] = {}

    def rows(self, node: w.Node) -> Rows:
        """All entries of an expression of any shape."""
        rows, columns = node.shape
        if columns == 1:
            return tuple((entry,) for entry in self.column(node))
        return (self.column(flipped(node)),) if rows == 1 else self.tensors.rows(self.matrix(node))

    def scalar(self, node: w.Node) -> int:
        """The step that holds a scalar."""
        known = self._scalars.get(node)
        if known is None:
            known = self._scalars[node] = self._scalar(node)
        return known

    def column(self, node: w.Node) -> Column:
        """The entries of a column."""
        known = self._columns.get(node)
        if known is None:
            known = self._columns[node] = self.tensors.scaled(*self.parts(node))
        return known

    def matrix(self, node: w.Node) -> Matrix:
        """A matrix of at least two rows and two columns."""
        known = self._matrices.get(node)
        if known is None:
            known = self._matrix(node)
            if self.dense and self.meanings.is_ruled(node):
                known = self._as_dense(known.shape, self.tensors.rows(known))
            self._matrices[node] = known
        return known

    def _unit_arguments(self, request: Request) -> set[Column]:
        """The arguments whose length is one by hypothesis."""
        units = {h.subjects[0] for h in request.hypotheses if h.kind == "unit"}
        return {tuple(row[0] for row in self.meanings.rows(node)) for node in request.of if node in units}

    def _scalar(self, node: w.Node) -> int:
        build = self.builder
        node = self.meanings.of(node)
        if self.meanings.is_known(node):
            return self.meanings.rows(node)[0][0]
        match node:
            case w.Number(value):
                return build.constant(value)
            case w.Zero():
                return build.zero
            case w.Sum(terms):
                return reduce(build.add, map(self.scalar, terms))
            case w.Negative(term):
                return build.negate(self.scalar(term))
            case w.Scale(factor, term):
                return build.multiply(self.scalar(factor), self.scalar(term))
            case w.Quotient(numerator, denominator):
                return build.divide(self.scalar(numerator), self.scalar(denominator))
            case w.Power(w.Norm(of), exponent) if exponent % 2 == 0:
                square = self.tensors.dot(self.column(of), self.column(of))
                return reduce(build.multiply, [square] * (exponent // 2))
            case w.Power(base, exponent):
                return reduce(build.multiply, [self.scalar(base)] * exponent)
            case w.Contract(factors):
                return self.chained(self.factors(factors))[0]
            case w.Transpose(of) | w.Block(((of,),)):
                return self.scalar(of)
            case _:
                return self._measured(node)

    def _measured(self, node: w.Node) -> int:
        """A scalar that is taken of vectors, matrices and angles."""
        match node:
            case w.Dot(left, right):
                return self.tensors.dot(self.column(left), self.column(right))
            case w.Norm(of):
                return self.builder.square_root(self.tensors.dot(self.column(of), self.column(of)))
            case w.Call("sin", argument):
                return self.builder.sine(self.scalar(argument))
            case w.Call("cos", argument):
                return self.builder.cosine(self.scalar(argument))
            case w.Trace(of):
                return self.tensors.trace(self.matrix(of)) if of.shape != (1, 1) else self.scalar(of)
            case w.Determinant(of):
                return self.tensors.determinant(self.rows(of))
            case _:
                raise _no_program(node)

    def parts(self, node: w.Node) -> tuple[int, Column]:
        """A column as a scalar times a column, so that factors meet before they meet the entries."""
        if node.is_scalar:
            return self.builder.one, (self.scalar(node),)
        node = self.meanings.of(node)
        if self.meanings.is_known(node):
            return self.builder.one, tuple(row[0] for row in self.meanings.rows(node))
        match node:
            case w.Scale() | w.Negative() | w.Quotient() if (blocks := self._scaled_blocks(node)) is not None:
                return self.parts(blocks)
            case w.Negative(term):
                factor, entries = self.parts(term)
                return self.builder.negate(factor), entries
            case w.Scale(scalar, term):
                factor, entries = self.parts(term)
                return self.builder.multiply(self.scalar(scalar), factor), entries
            case w.Quotient(numerator, denominator):
                return self._divided(numerator, self.scalar(denominator))
            case w.Contract(factors):
                flat = self.factors(factors)
                if len(flat) > 1 and flat[0].shape[1] == 1:
                    return self.chained(flat[1:])[0], self.column(flat[0])
                return self.builder.one, self.chained(flat)
            case _:
                return self.builder.one, self._column(node)

    def _divided(self, numerator: w.Node, divisor: int) -> tuple[int, Column]:
        """A column divided by a scalar, entry by entry: x / x is exactly one, which x (1 / x) need not be."""
        factor, entries = self.parts(numerator)
        if self.builder.value(factor) is None:
            return self.builder.divide(factor, divisor), entries
        scaled = self.tensors.scaled(factor, entries)
        return self.builder.one, tuple(self.builder.divide(entry, divisor) for entry in scaled)

    def _column(self, node: w.Node) -> Column:
        match node:
            case w.Zero(rows, _):
                return tuple(self.builder.zero for _ in range(rows))
            case w.Sum(terms):
                return reduce(self.tensors.sum, map(self.column, terms))
            case w.Cross(left, right):
                return self.tensors.cross(self.column(left), self.column(right))
            case w.Vect(of):
                return self.tensors.axial(self.matrix(of))
            case w.Block(rows):
                return sum((self.column(block) for row in rows for block in row), ())
            case w.Transpose(of):
                inner = self.meanings.of(of)
                return self.meanings.rows(inner)[0] if self.meanings.is_known(inner) else self.column(flipped(inner))
            case _:
                raise _no_program(node)

    def _matrix(self, node: w.Node) -> Matrix:
        shape = node.shape
        if 1 in shape:
            return self._as_dense(shape, self.rows(node))
        node = self.meanings.of(node)
        if self.meanings.is_known(node):
            return self._as_dense(shape, self.meanings.rows(node))
        match node:
            case w.Identity(size):
                return self._single(shape, Unit(size))
            case w.Zero():
                return Matrix(shape)
            case w.Skew(of):
                return self._single(shape, CrossProduct(self.column(of)))
            case w.Sum(terms):
                return reduce(self.tensors.plus, map(self.matrix, terms))
            case w.Scale() | w.Negative() | w.Quotient() if (blocks := self._scaled_blocks(node)) is not None:
                return self.matrix(blocks)
            case w.Negative(term):
                return self.tensors.times_scalar(self.builder.constant(-1), self.matrix(term))
            case w.Scale(factor, term):
                return self.tensors.times_scalar(self.scalar(factor), self.matrix(term))
            case w.Quotient(numerator, denominator):
                return self.tensors.divided(self.matrix(numerator), self.scalar(denominator))
            case w.Transpose(of):
                return self.tensors.transpose(self.matrix(of))
            case w.Contract(factors):
                return self.product(shape, self.factors(factors))
            case w.Power(base, exponent):
                return reduce(self.tensors.product, [self.matrix(base)] * exponent)
            case w.Block(rows):
                return self._as_dense(shape, tuple(line for row in rows for line in self._side_by_side(row)))
            case w.Cofactor(of):
                return self._as_dense(shape, self.tensors.cofactors(self.rows(of)))
            case _:
                raise _no_program(node)

    def _single(self, shape: tuple[int, int], tensor: Unit | CrossProduct | Dyad | Dense) -> Matrix:
        return Matrix(shape, ((self.builder.one, tensor),))

    def _as_dense(self, shape: tuple[int, int], rows: Rows) -> Matrix:
        return self._single(shape, Dense(rows))

    def _side_by_side(self, blocks: Sequence[w.Node]) -> Rows:
        return tuple(sum(lines, ()) for lines in zip(*map(self.rows, blocks), strict=True))

    def _scaled_blocks(self, node: w.Scale | w.Negative | w.Quotient) -> w.Block | None:
        """A multiple of a matrix of blocks as the matrix of its blocks' multiples; None for any other multiple."""
        field = "numerator" if isinstance(node, w.Quotient) else "term"
        inner = self.meanings.of(getattr(node, field))
        if not isinstance(inner, w.Block):
            return None
        parts: Any = node
        return w.Block(tuple(tuple(with_fields(parts, **{field: block}) for block in row) for row in inner.rows))


def _no_program(node: w.Node) -> LoweringError:
    return LoweringError(f"{w.plain(node)} ({type(node).__name__}) has no program: write it out in the formula")
