"""Products in the order that costs least: a column is met from the right, a matrix keeps its structure until then."""

from __future__ import annotations

from abc import ABC, abstractmethod
from collections.abc import Sequence
from functools import reduce

from chasles.lowering.builder import Builder
from chasles.lowering.matrices import Column, Dyad, Matrix
from chasles.lowering.meaning import Meanings
from chasles.lowering.rewriting import flipped
from chasles.lowering.tensors import Tensors
from chasles.vocabulary import Block, Contract, Group, Negative, Node, Power, Quotient, Scale, Sum, Transpose, Zero


class Products(ABC):
    """Products of matrices and columns; `dense` takes every matrix that a rule defines in components."""

    builder: Builder
    tensors: Tensors
    meanings: Meanings
    dense: bool

    @abstractmethod
    def scalar(self, node: Node) -> int:
        """The step that holds a scalar."""

    @abstractmethod
    def column(self, node: Node) -> Column:
        """The entries of a column."""

    @abstractmethod
    def parts(self, node: Node) -> tuple[int, Column]:
        """A column as a scalar times a column."""

    @abstractmethod
    def matrix(self, node: Node) -> Matrix:
        """A matrix of at least two rows and two columns."""

    def factors(self, factors: Sequence[Node]) -> list[Node]:
        """The factors of a product with the products among them opened."""
        flat: list[Node] = []
        for factor in factors:
            match factor:
                case Group(inside):
                    flat += self.factors([inside])
                case Contract(inner):
                    flat += self.factors(inner)
                case Power(base, exponent) if not factor.is_scalar:
                    flat += self.factors([base] * exponent)
                case Transpose(of) if isinstance(inside := flipped(of), Contract):
                    flat += self.factors(inside.factors)
                case _:
                    flat.append(factor)
        return flat

    def product(self, shape: tuple[int, int], factors: list[Node]) -> Matrix:
        """A product of matrices; a dyad where it has a column inside."""
        for place, factor in enumerate(factors[:-1]):
            if factor.shape[1] == 1:
                right = [flipped(f) for f in reversed(factors[place + 1 :])]
                (f, u), (g, v) = self._scaled_chain(factors[: place + 1]), self._scaled_chain(right)
                return Matrix(shape, ((self.builder.multiply(f, g), Dyad(u, v)),))
        return reduce(self.tensors.product, map(self.matrix, factors))

    def _scaled_chain(self, factors: list[Node]) -> tuple[int, Column]:
        """A product that is a column as a scalar times a column: k e e^T is k times a symmetric dyad."""
        return self.parts(factors[0]) if len(factors) == 1 else (self.builder.one, self.chained(factors))

    def chained(self, factors: list[Node]) -> Column:
        """A product whose last factor is a column, from the right."""
        entries = self.column(factors[-1])
        for factor in reversed(factors[:-1]):
            entries = self.applied(factor, entries)
        return entries

    def applied(self, node: Node, x: Column) -> Column:
        """The product of a matrix and a column, without writing the matrix in components where it has structure."""
        rows, columns = node.shape
        if columns == 1:
            return self.tensors.scaled(x[0], self.column(node))
        if rows == 1:
            return (self.tensors.dot(self.column(flipped(node)), x),)
        opened = self._structure(node)
        match opened:
            case Contract() | Power():
                entries = x
                for factor in reversed(self.factors([opened])):
                    entries = self.applied(factor, entries)
                return entries
            case Block(lines):
                return sum((self._applied_side_by_side(line, x) for line in lines), ())
            case Sum(terms) if self._holds_product(opened):
                return reduce(self.tensors.sum, (self.applied(term, x) for term in terms))
            case Negative(term) if self._holds_product(opened):
                return tuple(map(self.builder.negate, self.applied(term, x)))
            case Scale(factor, term) if self._holds_product(opened):
                return self.tensors.scaled(self.scalar(factor), self.applied(term, x))
            case Quotient(numerator, denominator) if self._holds_product(opened):
                divisor = self.scalar(denominator)
                return tuple(self.builder.divide(entry, divisor) for entry in self.applied(numerator, x))
            case _:
                return self.tensors.applied(self.matrix(node), x)

    def _applied_side_by_side(self, blocks: Sequence[Node], x: Column) -> Column:
        total: Column = (self.builder.zero,) * blocks[0].shape[0]
        start = 0
        for block in blocks:
            width = block.shape[1]
            if not isinstance(block, Zero):
                total = self.tensors.sum(total, self.applied(block, x[start : start + width]))
            start += width
        return total

    def _structure(self, node: Node) -> Node:
        """The node that says how a matrix is made up; itself where it is to be taken in components."""
        if self.dense and self.meanings.is_ruled(node):
            return node
        opened = self.meanings.of(node)
        if isinstance(opened, Transpose):
            turned = flipped(self._structure(opened.of))
            return opened if isinstance(turned, Transpose) else turned
        return opened

    def _holds_product(self, node: Node) -> bool:
        """Whether a sum holds a product of matrices, which is cheaper to apply factor by factor."""
        opened = self._structure(node)
        match opened:
            case Sum(terms):
                return any(map(self._holds_product, terms))
            case Negative(term) | Scale(_, term) | Quotient(term, _):
                return self._holds_product(term)
            case Contract(factors):
                return not any(factor.shape[1] == 1 for factor in self.factors(factors))
            case Block() | Power():
                return True
            case _:
                return False
