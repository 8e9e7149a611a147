"""Products of matrices and columns that have a sign of their own: direct sums, outer and Kronecker products."""

from __future__ import annotations

from typing import ClassVar

from chasles.vocabulary.arguments import declaring, making
from chasles.vocabulary.fitting import measured, word
from chasles.vocabulary.layout import Block
from chasles.vocabulary.letters import Zero
from chasles.vocabulary.measure import Measure, Misfit, uniform
from chasles.vocabulary.nodes import Contract, Node, OfOne, Scale, Transpose
from chasles.vocabulary.shorthand import Shorthand
from chasles.vocabulary.sizes import OfAnySize, sizes_of, times


@word
class DirectSum(Shorthand):
    """Two matrices on the diagonal of one, with zeros beside them."""

    first: Node
    second: Node
    function: ClassVar[str] = "diag"

    @property
    def definition(self) -> Node:
        (m, n), (p, q) = self.first.shape, self.second.shape
        return Block(((self.first, Zero(m, q)), (Zero(p, n), self.second)))


@word
class OuterProduct(Shorthand):
    """The matrix of the products of the entries of two columns: a b^T."""

    left: Node
    right: Node
    function: ClassVar[str] = "outer"

    @property
    def definition(self) -> Node:
        for side in (self.left, self.right):
            if side.shape[1] != 1:
                rows, columns = side.shape
                raise Misfit(f"an outer product is that of two columns, and {side} is {rows} x {columns}")
        return Contract((self.left, Transpose(self.right)))


@word
class KroneckerProduct(Shorthand):
    """The blocks that each entry of the first matrix makes with the second."""

    left: Node
    right: Node
    function: ClassVar[str] = "kron"

    @property
    def definition(self) -> Node:
        rows, columns = measured(self.left).shape
        if sizes_of([self.left]):
            return SizedKroneckerProduct(self.left, self.right)
        lines = ([self.left[i + 1, j + 1] for j in range(columns)] for i in range(rows))
        return Block(tuple(tuple(Scale(entry, self.right) for entry in line) for line in lines))


@word
class SizedKroneckerProduct(OfAnySize):
    """The Kronecker product whose left factor is of any size."""

    left: Node
    right: Node

    def _measured(self) -> Measure:
        (m, n), (p, q) = self.left.shape, self.right.shape
        one, other = (measured(side).the_dimension(side) for side in (self.left, self.right))
        return uniform((times(m, p), times(n, q)), one and other and one * other)

    @property
    def word(self) -> Node:
        return KroneckerProduct(self.left, self.right)


@word
class Vectorized(Shorthand, OfOne):
    """The columns of a matrix, one below the other."""

    function: ClassVar[str] = "vec"

    @property
    def definition(self) -> Node:
        rows, columns = measured(self.of).shape
        if sizes_of([self.of]):
            return SizedVectorized(self.of)
        return Block(tuple((self.of[1:rows, j + 1],) for j in range(columns)))


@word
class SizedVectorized(OfAnySize, OfOne):
    """The columns of a matrix of any size, one below the other."""

    def _measured(self) -> Measure:
        rows, columns = self.of.shape
        return uniform((times(columns, rows), 1), measured(self.of).the_dimension(self.of))

    @property
    def word(self) -> Node:
        return Vectorized(self.of)


@declaring
def direct_sum(first: Node, *others: Node) -> Node:
    """Matrices on the diagonal of one, with zeros beside them."""
    for other in others:
        first = DirectSum(first, other)
    return first


outer = making(OuterProduct, "outer")
vec = making(Vectorized, "vec")
kronecker_product = making(KroneckerProduct, "kronecker_product")
