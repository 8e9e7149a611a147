"""Vector algebra on steps, and the entries of matrices that are made of vectors."""

from __future__ import annotations

from functools import reduce

from chasles.lowering.builder import Builder
from chasles.lowering.matrices import Column, CrossProduct, Dense, DoubleCross, Dyad, Rows, SymmetricDyad, Tensor, Unit


class Components:
    """Vectors and entries; of a column among the `units` it is known that its length is one."""

    def __init__(self, builder: Builder) -> None:
        self.builder = builder
        self.units: set[Column] = set()

    def dot(self, a: Column, b: Column) -> int:
        """The scalar product a . b."""
        if a == b and a in self.units:
            return self.builder.one
        return reduce(self.builder.add, map(self.builder.multiply, a, b))

    def cross(self, a: Column, b: Column) -> Column:
        """The vector product a x b."""
        times, minus = self.builder.multiply, self.builder.subtract
        return tuple(minus(times(a[j], b[k]), times(a[k], b[j])) for j, k in ((1, 2), (2, 0), (0, 1)))

    def sum(self, a: Column, b: Column) -> Column:
        """The sum a + b."""
        return tuple(map(self.builder.add, a, b))

    def scaled(self, factor: int, a: Column) -> Column:
        """The column times a scalar."""
        return tuple(self.builder.multiply(factor, entry) for entry in a)

    def rows_of(self, tensor: Tensor, factor: int | None = None) -> Rows:
        """The entries of one tensor times a factor; the factor multiplies vectors, not products of their entries."""
        factor = self.builder.one if factor is None else factor
        match tensor:
            case Unit(size):
                zero = self.builder.zero
                return tuple(tuple(factor if i == j else zero for j in range(size)) for i in range(size))
            case Dyad(left, right):
                return self._dyad(self.scaled(factor, left), right, symmetric=left == right)
            case SymmetricDyad(left, right):
                return self._symmetric_dyad(factor, left, right)
            case CrossProduct(of):
                x, y, z = self.scaled(factor, of)
                zero, minus = self.builder.zero, self.builder.negate
                return (zero, minus(z), y), (z, zero, minus(x)), (minus(y), x, zero)
            case DoubleCross(left, right):
                return self._double_cross(self.scaled(factor, left), right, symmetric=left == right)
            case Dense(rows):
                return tuple(self.scaled(factor, row) for row in rows)

    def _dyad(self, left: Column, right: Column, *, symmetric: bool) -> Rows:
        """The dyad of two columns; entries below the diagonal repeat those above it where the dyad is symmetric."""
        order = [[(j, i) if symmetric and j < i else (i, j) for j in range(len(right))] for i in range(len(left))]
        return tuple(tuple(self.builder.multiply(left[i], right[j]) for i, j in line) for line in order)

    def _symmetric_dyad(self, factor: int, left: Column, right: Column) -> Rows:
        """Its entries; on the diagonal, twice the factor times the product is taken, which is free for a half."""
        build, scaled = self.builder, self.scaled(factor, left)
        twice = build.multiply(build.constant(2), factor)
        if build.value(twice) in (1, -1):
            diagonal = tuple(map(build.multiply, self.scaled(twice, left), right))
        else:
            diagonal = tuple(build.add(x, x) for x in map(build.multiply, scaled, right))

        def beside(i: int, j: int) -> int:
            return build.add(build.multiply(scaled[i], right[j]), build.multiply(scaled[j], right[i]))

        size = range(len(left))
        return tuple(tuple(diagonal[i] if i == j else beside(min(i, j), max(i, j)) for j in size) for i in size)

    def _double_cross(self, left: Column, right: Column, *, symmetric: bool) -> Rows:
        """The matrix right left^T - (left . right) 1, without the terms that cancel on the diagonal."""
        dyad = self._dyad(right, left, symmetric=symmetric)
        others = ((1, 2), (0, 2), (0, 1))
        diagonal = [self.builder.negate(self.builder.add(dyad[j][j], dyad[k][k])) for j, k in others]
        return tuple(tuple(diagonal[i] if i == j else dyad[i][j] for j in range(3)) for i in range(3))

    def determinant(self, rows: Rows) -> int:
        """The determinant, expanded along the first row."""
        if len(rows) < 2:
            return rows[0][0] if rows else self.builder.one
        total = self.builder.zero
        for j, entry in enumerate(rows[0]):
            if self.builder.value(entry) == 0:
                continue
            minor = self.determinant(tuple(row[:j] + row[j + 1 :] for row in rows[1:]))
            term = self.builder.multiply(entry, minor)
            total = self.builder.add(total, term) if j % 2 == 0 else self.builder.subtract(total, term)
        return total

    def cofactors(self, m: Rows) -> Rows:
        """The cofactor matrix of a square matrix."""
        if len(m) == 3:
            return tuple(self.cross(m[(i + 1) % 3], m[(i + 2) % 3]) for i in range(3))

        def cofactor(i: int, j: int) -> int:
            minor = self.determinant(tuple(row[:j] + row[j + 1 :] for row in (*m[:i], *m[i + 1 :])))
            return self.builder.negate(minor) if (i + j) % 2 else minor

        return tuple(tuple(cofactor(i, j) for j in range(len(m))) for i in range(len(m)))
