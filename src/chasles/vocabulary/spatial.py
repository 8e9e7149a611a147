"""Words of space and of matrices: products and norms of vectors, cross-product matrices, traces, inverses."""

from __future__ import annotations

from functools import reduce
from itertools import permutations

from chasles.vocabulary.dimension import NO_DIMENSION, Dimension
from chasles.vocabulary.fitting import SCALAR, measured, square_measure, word
from chasles.vocabulary.measure import Measure, Misfit, completed, contracted, entrywise, uniform
from chasles.vocabulary.nodes import Node, OfOne


def _vector(of: Node, rule: str) -> Dimension | None:
    if measured(of).shape != (3, 1):
        rows, columns = of.shape
        raise Misfit(f"{rule} takes a vector (3 x 1), and {of} is {rows} x {columns}")
    return measured(of).the_dimension(of)


def _times(one: Dimension | None, other: Dimension | None) -> Dimension | None:
    return None if one is None or other is None else one * other


def _of_determinant(measure: Measure) -> Dimension | None:
    """The dimension of the determinant; None if it is zero wherever the zeros are, or depends on a letter."""
    grid = measure.grid
    if measure.partition is not None and {d for row in grid for d in row} - {None, NO_DIMENSION}:
        return None
    terms = ([row[j] for row, j in zip(grid, order, strict=True)] for order in permutations(range(len(grid))))
    term = next((term for term in terms if None not in term), [None])
    return reduce(_times, term)


@word
class Inverse(OfOne):
    """The inverse of a square matrix; a claim about it says that the product with the other side is the identity."""

    def _measured(self) -> Measure:
        of = completed(square_measure(self.of, "an inverse"), self.of)
        return entrywise(lambda d: NO_DIMENSION / d, of.transposed)


@word
class Cofactor(OfOne):
    """The cofactor matrix of a square matrix; a rotation equals its own."""

    def _measured(self) -> Measure:
        of = completed(square_measure(self.of, "a cofactor matrix"), self.of)
        total = _of_determinant(of)
        return uniform(of.shape, None) if total is None else entrywise(lambda d: total / d, of)


@word
class Skew(OfOne):
    """The cross-product matrix of a vector: CPM(a) b = a x b. Source: (2.38)."""

    def _measured(self) -> Measure:
        dimension = _vector(self.of, "a cross-product matrix")
        return Measure(tuple(tuple(None if i == j else dimension for j in range(3)) for i in range(3)))


@word
class Vect(OfOne):
    """The axial vector of a 3 x 3 matrix: that of its skew-symmetric part."""

    def _measured(self) -> Measure:
        if square_measure(self.of, "an axial vector").shape != (3, 3):
            raise Misfit(f"the axial vector is that of a 3 x 3 matrix, and {self.of} is not")
        return uniform((3, 1), measured(self.of).the_dimension(self.of))


@word
class Trace(OfOne):
    """The sum of the diagonal entries of a square matrix."""

    def _measured(self) -> Measure:
        grid = square_measure(self.of, "a trace").grid
        diagonal = Measure((tuple(grid[i][i] for i in range(len(grid))),))
        return uniform(SCALAR, diagonal.the_dimension(f"the diagonal of {self.of}"))


@word
class Determinant(OfOne):
    """The determinant of a square matrix."""

    def _measured(self) -> Measure:
        return uniform(SCALAR, _of_determinant(completed(square_measure(self.of, "a determinant"), self.of)))


@word
class Norm(OfOne):
    """The Euclidean norm of a column or a scalar."""

    def _measured(self) -> Measure:
        if measured(self.of).shape[1] != 1:
            raise Misfit(f"the norm is that of a column, and {self.of} is {self.of.shape[0]} x {self.of.shape[1]}")
        return uniform(SCALAR, measured(self.of).the_dimension(self.of))


@word
class Dot(Node):
    """The scalar product of two columns, written with a dot."""

    left: Node
    right: Node

    def _measured(self) -> Measure:
        left, right = measured(self.left), measured(self.right)
        if left.shape[1] != 1 or left.shape != right.shape:
            sizes = [f"{side} is {side.shape[0]} x {side.shape[1]}" for side in (self.left, self.right)]
            raise Misfit(f"the scalar product is that of two columns of one height: {sizes[0]}, and {sizes[1]}")
        return contracted(left.transposed, right, (self.left, self.right))


@word
class Cross(Node):
    """The vector product of two vectors."""

    left: Node
    right: Node

    def _measured(self) -> Measure:
        left = _vector(self.left, "a vector product")
        return uniform((3, 1), _times(left, _vector(self.right, "a vector product")))
