"""Matrices before their components: combinations of the identity, dyads, cross-product matrices and grids of steps.

Terms on one tensor are collected into one coefficient, so that e e^T + c (1 - e e^T) + s E becomes
(1 - c) e e^T + c 1 + s E before any component is written down.
"""

from __future__ import annotations

from functools import reduce

from chasles.lowering.components import Components
from chasles.lowering.matrices import (
    Column,
    CrossProduct,
    Dense,
    DoubleCross,
    Dyad,
    Matrix,
    Rows,
    SymmetricDyad,
    Tensor,
    Unit,
    transposed,
)


class Tensors(Components):
    """Matrix algebra on steps."""

    def matrix(self, shape: tuple[int, int], terms: tuple[tuple[int, Tensor], ...]) -> Matrix:
        """The sum of the terms, collected; all cross-product matrices become one."""
        collected: dict[Tensor, int] = {}
        turning: list[tuple[int, CrossProduct]] = []
        for factor, tensor in terms:
            if isinstance(tensor, CrossProduct):
                turning.append((factor, tensor))
            else:
                collected[tensor] = self.builder.add(collected.get(tensor, self.builder.zero), factor)
        for factor, tensor in self._one_cross_product(turning):
            collected[tensor] = factor
        return Matrix(shape, tuple((f, t) for t, f in collected.items() if self.builder.value(f) != 0))

    def _one_cross_product(self, terms: list[tuple[int, CrossProduct]]) -> list[tuple[int, CrossProduct]]:
        factors: dict[CrossProduct, int] = {}
        for factor, tensor in terms:
            factors[tensor] = self.builder.add(factors.get(tensor, self.builder.zero), factor)
        if len(factors) < 2:
            return [(factor, tensor) for tensor, factor in factors.items()]
        vectors = (self.scaled(factor, tensor.of) for tensor, factor in factors.items())
        return [(self.builder.one, CrossProduct(reduce(self.sum, vectors)))]

    def plus(self, a: Matrix, b: Matrix) -> Matrix:
        """The sum a + b."""
        return self.matrix(a.shape, a.terms + b.terms)

    def times_scalar(self, factor: int, a: Matrix) -> Matrix:
        """The matrix times a scalar."""
        return self.matrix(a.shape, tuple((self.builder.multiply(factor, f), t) for f, t in a.terms))

    def divided(self, a: Matrix, divisor: int) -> Matrix:
        """The matrix divided by a scalar, coefficient by coefficient."""
        return self.matrix(a.shape, tuple((self.builder.divide(f, divisor), t) for f, t in a.terms))

    def transpose(self, a: Matrix) -> Matrix:
        """The transpose of a."""
        rows, columns = a.shape
        return self.matrix((columns, rows), tuple(self._flipped(f, t) for f, t in a.terms))

    def _flipped(self, factor: int, tensor: Tensor) -> tuple[int, Tensor]:
        match tensor:
            case Unit() | SymmetricDyad():
                return factor, tensor
            case Dyad(left, right):
                return factor, Dyad(right, left)
            case CrossProduct():
                return self.builder.negate(factor), tensor
            case DoubleCross(left, right):
                return factor, DoubleCross(right, left)
            case Dense(rows):
                return factor, Dense(transposed(rows))

    def applied(self, a: Matrix, x: Column) -> Column:
        """The product a x, term by term: the coefficient of a dyad multiplies one scalar."""
        total: Column = (self.builder.zero,) * a.shape[0]
        for tensor, factor in self._projecting(a).items():
            total = self.sum(total, self._applied(factor, tensor, x))
        return total

    def _projecting(self, a: Matrix) -> dict[Tensor, int]:
        """The terms, k x x^T - k |x|^2 1 written as k times the square of the cross-product matrix of x.

        So written nothing cancels: on the diagonal |x|^2 - x_i^2 is the sum of the other squares.
        """
        terms = {tensor: factor for factor, tensor in a.terms}
        for factor, tensor in a.terms:
            if isinstance(tensor, Dyad) and tensor.left == tensor.right and a.shape == (3, 3):
                size = self.builder.multiply(factor, self.dot(tensor.left, tensor.left))
                if terms.get(Unit(3)) == self.builder.negate(size):
                    del terms[Unit(3)], terms[tensor]
                    terms[DoubleCross(tensor.left, tensor.left)] = factor
        return terms

    def _in_pairs(self, a: Matrix) -> dict[Tensor, int]:
        """The same with k x y^T + k y x^T written as one term."""
        terms = self._projecting(a)
        for tensor in list(terms):
            match tensor:
                case Dyad(left, right) if left != right and tensor in terms:
                    if terms.get(Dyad(right, left)) == terms[tensor]:
                        terms[SymmetricDyad(left, right)] = terms.pop(tensor)
                        del terms[Dyad(right, left)]
        return terms

    def _applied(self, factor: int, tensor: Tensor, x: Column) -> Column:
        match tensor:
            case Unit():
                return self.scaled(factor, x)
            case Dyad(left, right):
                return self.scaled(self.builder.multiply(factor, self.dot(right, x)), left)
            case SymmetricDyad(left, right):
                one, other = Dyad(left, right), Dyad(right, left)
                return self.sum(self._applied(factor, one, x), self._applied(factor, other, x))
            case CrossProduct(of):
                return self.scaled(factor, self.cross(of, x))
            case DoubleCross(left, right) if left == right and left in self.units:
                along = self.scaled(self.dot(left, x), left)
                return self.scaled(factor, tuple(map(self.builder.subtract, along, x)))
            case DoubleCross(left, right):
                return self.scaled(factor, self.cross(left, self.cross(right, x)))
            case Dense(rows):
                return self.scaled(factor, tuple(self.dot(row, x) for row in rows))

    def product(self, a: Matrix, b: Matrix) -> Matrix:
        """The product a b, where the identity and dyads are multiplied as such and all else entry by entry."""
        shape = (a.shape[0], b.shape[1])
        terms: list[tuple[int, Tensor]] = []
        for f, s in a.terms:
            for g, t in b.terms:
                terms.append((self.builder.multiply(f, g), self._product(s, t)))
        return self.matrix(shape, tuple(terms))

    def _product(self, a: Tensor, b: Tensor) -> Tensor:
        match a, b:
            case Unit(), _:
                return b
            case _, Unit():
                return a
            case Dyad(left, right), _:
                return Dyad(left, self._applied(*self._flipped(self.builder.one, b), right))
            case _, Dyad(left, right):
                return Dyad(self._applied(self.builder.one, a, left), right)
            case CrossProduct(left), CrossProduct(right):
                return DoubleCross(left, right)
            case _:
                columns = transposed(self.rows_of(b))
                return Dense(tuple(tuple(self.dot(row, c) for c in columns) for row in self.rows_of(a)))

    def trace(self, a: Matrix) -> int:
        """The sum of the diagonal entries."""
        total = self.builder.zero
        for factor, tensor in a.terms:
            match tensor:
                case Unit(size):
                    part = self.builder.constant(size)
                case Dyad(left, right):
                    part = self.dot(left, right)
                case SymmetricDyad(left, right):
                    part = self.builder.multiply(self.builder.constant(2), self.dot(left, right))
                case CrossProduct():
                    part = self.builder.zero
                case DoubleCross(left, right):
                    part = self.builder.multiply(self.builder.constant(-2), self.dot(left, right))
                case Dense(rows):
                    part = reduce(self.builder.add, (row[i] for i, row in enumerate(rows)))
            total = self.builder.add(total, self.builder.multiply(factor, part))
        return total

    def axial(self, a: Matrix) -> Column:
        """The axial vector of a 3 x 3 matrix."""
        total: Column = (self.builder.zero,) * 3
        half = self.builder.divide(self.builder.one, self.builder.constant(2))
        for factor, tensor in a.terms:
            match tensor:
                case Unit():
                    continue
                case CrossProduct(of):
                    part = self.scaled(factor, of)
                case _:
                    m, minus = self.rows_of(tensor), self.builder.subtract
                    twice = tuple(minus(m[k][j], m[j][k]) for j, k in ((1, 2), (2, 0), (0, 1)))
                    part = self.scaled(self.builder.multiply(half, factor), twice)
            total = self.sum(total, part)
        return total

    def rows(self, a: Matrix) -> Rows:
        """All entries."""
        zero = (self.builder.zero,) * a.shape[1]
        total: Rows = (zero,) * a.shape[0]
        for tensor, factor in self._in_pairs(a).items():
            part = self.rows_of(tensor, factor)
            total = tuple(map(self.sum, total, part))
        return total
