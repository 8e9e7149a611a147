"""Which steps solve linear equations? Those of an elimination, without an inverse, and none for a structural zero.

A matrix that is symmetric and positive definite is factorised as L D L^T without square roots and pivots, its unknowns
eliminated in the order of least degree, as in sparse Cholesky factorisation (Rose, 1972; Golub and Van Loan, Matrix
Computations, 2013, section 4.1); any other as L U with partial pivoting (section 3.4), rows exchanged by selection.
"""

from __future__ import annotations

from collections.abc import Sequence

from chasles.lowering.builder import Builder
from chasles.lowering.refusal import LoweringError

Matrix = Sequence[Sequence[int]]


def solved_definite(build: Builder, matrix: Matrix, right: Sequence[int]) -> list[int]:
    """The steps of the solution of a symmetric positive definite system, of which only one triangle is read.

    Raises `LoweringError` for a matrix that is singular whatever its entries are.
    """
    order = _order(build, matrix)
    size = len(order)
    lower = [[matrix[max(i, j)][min(i, j)] for j in order[:place]] for place, i in enumerate(order)]
    inverses: list[int] = []
    found: list[int] = []
    for i, row in enumerate(lower):
        pivot, value = matrix[order[i]][order[i]], right[order[i]]
        for j in range(i):
            for k in range(j):
                row[j] = build.subtract(row[j], build.multiply(row[k], lower[j][k]))
        for j in range(i):
            scaled = row[j]
            row[j] = build.multiply(scaled, inverses[j])
            pivot = build.subtract(pivot, build.multiply(scaled, row[j]))
            value = build.subtract(value, build.multiply(row[j], found[j]))
        inverses.append(_inverse(build, pivot))
        found.append(value)
    found = [build.multiply(value, inverse) for value, inverse in zip(found, inverses, strict=True)]
    for i in reversed(range(size)):
        for j in range(i):
            found[j] = build.subtract(found[j], build.multiply(lower[i][j], found[i]))
    places = {number: place for place, number in enumerate(order)}
    return [found[places[number]] for number in range(size)]


def solved(build: Builder, matrix: Matrix, right: Matrix) -> list[list[int]]:
    """The steps of the solutions of a system with any regular matrix, for each column on the right, in rows.

    Raises `LoweringError` for a matrix that is singular whatever its entries are.
    """
    rows = [[*row, *values] for row, values in zip(matrix, right, strict=True)]
    size = len(rows)
    inverses: list[int] = []
    for k in range(size):
        for i in range(k + 1, size):
            _exchange(build, rows, k, i)
        inverses.append(_inverse(build, rows[k][k]))
        for i in range(k + 1, size):
            factor = build.multiply(rows[i][k], inverses[k])
            for j in range(k + 1, len(rows[i])):
                rows[i][j] = build.subtract(rows[i][j], build.multiply(factor, rows[k][j]))
    found = [row[size:] for row in rows]
    for k in reversed(range(size)):
        for column in range(len(found[k])):
            for j in range(k + 1, size):
                found[k][column] = build.subtract(found[k][column], build.multiply(rows[k][j], found[j][column]))
            found[k][column] = build.multiply(found[k][column], inverses[k])
    return found


def _order(build: Builder, matrix: Matrix) -> list[int]:
    """The unknowns as they are eliminated: next is one with the fewest neighbours, which then become neighbours."""
    size = range(len(matrix))
    near = {i: {j for j in size if i != j and matrix[max(i, j)][min(i, j)] != build.zero} for i in size}
    order: list[int] = []
    while near:
        chosen = min(near, key=lambda i: (len(near[i]), -i))
        around = near.pop(chosen)
        for i in around:
            near[i] = (near[i] | around) - {i, chosen}
        order.append(chosen)
    return order


def _exchange(build: Builder, rows: list[list[int]], k: int, i: int) -> None:
    """Let row k be that of two with the larger entry in column k, and row i the other."""
    a, b = rows[k][k], rows[i][k]
    if b == build.zero:
        return
    if a == build.zero:
        rows[k], rows[i] = rows[i], rows[k]
        return
    larger = build.less(_size(build, a), _size(build, b))
    pairs = list(zip(rows[k], rows[i], strict=True))
    rows[k] = [build.select(larger, y, x) for x, y in pairs]
    rows[i] = [build.select(larger, x, y) for x, y in pairs]


def _size(build: Builder, a: int) -> int:
    return build.select(build.less(a, build.zero), build.negate(a), a)


def _inverse(build: Builder, pivot: int) -> int:
    """The reciprocal of a pivot; NaN for zero. Raises `LoweringError` for what is always zero."""
    if pivot == build.zero:
        raise LoweringError(
            "linear equations have no solution, as their matrix is singular whatever its entries are: for a method "
            "ask for outputs=['mass_matrix', 'forcing']"
        )
    is_zero = build.equal(pivot, build.zero)
    return build.divide(build.select(is_zero, build.zero, build.one), pivot)
