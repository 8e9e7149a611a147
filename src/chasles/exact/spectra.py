"""Exact eigenvalues of symmetric matrices, their definiteness and signature.

Multiplicities come from the factors of the characteristic polynomial, signs from its coefficients (Descartes' rule is
an equality where all roots are real) or from minors: no decimal decides anything.
"""

from __future__ import annotations

from functools import lru_cache
from itertools import chain, pairwise
from typing import Any

import sympy as sp
from sympy.polys.matrices import DomainMatrix

from chasles.exact.evaluate import column_of
from chasles.exact.fields import NumberField
from chasles.exact.numbers import is_zero, normal, sign
from chasles.exact.polynomial_roots import Root, merged, real_roots, remainders


def characteristic(matrix: Any) -> list[Any]:
    """The coefficients of det(x 1 - matrix), highest power first."""
    if matrix.rows < 3:
        a, d = matrix[0, 0], matrix[-1, -1]
        values = [-a, sp.Integer(1)] if matrix.rows == 1 else [-a - d, a * d - matrix[0, 1] * matrix[1, 0]]
        return [sp.Integer(1), *(normal(value) for value in values[: matrix.rows])]
    field = NumberField(*matrix)
    rows = [[field(matrix[i, j]) for j in range(matrix.cols)] for i in range(matrix.rows)]
    coefficients = DomainMatrix(rows, matrix.shape, field.domain).charpoly()
    return [normal(field.expression(c)) for c in coefficients]


def eigenvalues(matrix: Any) -> list[tuple[Any, int]]:
    """The distinct eigenvalues of a symmetric matrix in ascending order, each with its multiplicity.

    A matrix that falls into blocks has the eigenvalues of these.
    """
    return merged([one for _, found in eigenvalues_by_block(matrix) for one in found])


def eigenvalues_by_block(matrix: Any) -> list[tuple[list[int], list[tuple[Any, int]]]]:
    """The rows of each block of a symmetric matrix, and the block's distinct eigenvalues with multiplicities."""
    return _by_block(sp.ImmutableMatrix(matrix))


@lru_cache(maxsize=50)
def _by_block(matrix: Any) -> list[tuple[list[int], list[tuple[Any, int]]]]:
    blocks = ((places, matrix.extract(places, places)) for places in blocks_of(matrix))
    return [(places, real_roots(characteristic(block))) for places, block in blocks]


def blocks_of(matrix: Any) -> list[list[int]]:
    """The rows that entries other than zero link with each other, directly or through further rows."""
    blocks: list[list[int]] = []
    for i in range(matrix.rows):
        linked = [block for block in blocks if any(not is_zero(matrix[i, j]) for j in block)]
        blocks = [block for block in blocks if block not in linked] + [sorted([i, *chain.from_iterable(linked)])]
    return blocks


def signature(matrix: Any) -> tuple[int, int, int]:
    """How many eigenvalues of a symmetric matrix are positive, negative, zero."""
    coefficients = characteristic(matrix)
    signs = [sign(c) for c in coefficients]
    zeros = next(k for k, one in enumerate(reversed(signs)) if one)
    turned = [one * (-1) ** k for k, one in enumerate(signs)]
    return _changes(signs), _changes(turned), zeros


def _changes(signs: list[int]) -> int:
    seen = [one for one in signs if one]
    return sum(one != other for one, other in pairwise(seen))


def leading_minors(matrix: Any) -> list[Any]:
    """The determinants of the leading square blocks, by size: Berkowitz (Inf. Process. Lett. 18, 1984)."""
    return [normal(matrix[:k, :k].det(method="berkowitz")) for k in range(1, matrix.rows + 1)]


def is_positive_definite(matrix: Any) -> bool:
    """Whether a symmetric matrix is positive-definite: all leading minors are positive (Sylvester)."""
    return all(sign(minor) > 0 for minor in leading_minors(matrix))


def each_eigenvalue(matrix: Any) -> Any:
    """The eigenvalues of a symmetric matrix in ascending order, each as often as its multiplicity says.

    A column of exact numbers, or a list where a Root is among them.
    """
    found = [value for value, multiplicity in eigenvalues(matrix) for _ in range(multiplicity)]
    return found if any(isinstance(value, Root) for value in found) else column_of(*found)


def residues_of(matrix: Any, values: Any) -> Any:
    """What is left of the characteristic polynomial, and of its degree, divided by these as its roots.

    All zero if they are the eigenvalues.
    """
    return column_of(*remainders(characteristic(matrix), list(values)))


def smallest_belongs_to(matrix: Any, vector: Any) -> bool:
    """Whether a vector is zero, or an eigenvector of the smallest eigenvalue of a symmetric 3 x 3 matrix.

    The eigenvalue of an eigenvector is its Rayleigh quotient, which is the smallest if matrix less quotient times
    identity has no negative eigenvalue.
    """
    if all(map(is_zero, vector)):
        return True
    if not all(map(is_zero, vector.cross(matrix * vector))):
        return False
    quotient = normal((vector.T * matrix * vector)[0, 0] / (vector.T * vector)[0, 0])
    _, negative, _ = signature((matrix - quotient * sp.eye(3)).applyfunc(normal))
    return negative == 0


def diagonal(values: Any) -> Any:
    """The diagonal matrix of exact numbers."""
    return sp.ImmutableMatrix(sp.diag(*values))
