"""Exact eigenvalues of symmetric matrices, their definiteness and signature.

Multiplicities come from the factors of the characteristic polynomial, signs from its coefficients (Descartes' rule is
an equality where all roots are real) or from minors: no decimal decides anything.
"""

from __future__ import annotations

from typing import Any

import sympy as sp
from sympy.polys.matrices import DomainMatrix

from chasles.exact.fields import Field
from chasles.exact.numbers import normal, sign
from chasles.exact.roots import real_roots, remainders

__all__ = [
    "characteristic",
    "diagonal",
    "each_eigenvalue",
    "eigenvalues",
    "is_positive_definite",
    "leading_minors",
    "residues_of",
    "signature",
]


def characteristic(matrix: Any) -> list[Any]:
    """The coefficients of det(x 1 - matrix), highest power first."""
    field = Field(*matrix)
    rows = [[field(matrix[i, j]) for j in range(matrix.cols)] for i in range(matrix.rows)]
    coefficients = DomainMatrix(rows, matrix.shape, field.domain).charpoly()
    return [normal(field.expression(c)) for c in coefficients]


def eigenvalues(matrix: Any) -> list[tuple[Any, int]]:
    """The distinct eigenvalues of a symmetric matrix in ascending order, each with its multiplicity."""
    return real_roots(characteristic(matrix))


def signature(matrix: Any) -> tuple[int, int, int]:
    """How many eigenvalues of a symmetric matrix are positive, negative, zero."""
    coefficients = characteristic(matrix)
    signs = [sign(c) for c in coefficients]
    zeros = next(k for k, one in enumerate(reversed(signs)) if one)
    turned = [one * (-1) ** k for k, one in enumerate(signs)]
    return _changes(signs), _changes(turned), zeros


def _changes(signs: list[int]) -> int:
    seen = [one for one in signs if one]
    return sum(one != other for one, other in zip(seen, seen[1:], strict=False))


def leading_minors(matrix: Any) -> list[Any]:
    """The determinants of the leading square blocks, by size."""
    return [normal(matrix[:k, :k].det(method="berkowitz")) for k in range(1, matrix.rows + 1)]


def is_positive_definite(matrix: Any) -> bool:
    """Whether a symmetric matrix is positive-definite: all leading minors are positive (Sylvester)."""
    return all(sign(minor) > 0 for minor in leading_minors(matrix))


def each_eigenvalue(matrix: Any) -> list[Any]:
    """The eigenvalues of a symmetric matrix in ascending order, each as often as its multiplicity says."""
    return [value for value, multiplicity in eigenvalues(matrix) for _ in range(multiplicity)]


def residues_of(matrix: Any, values: list[Any]) -> list[Any]:
    """What is left of the characteristic polynomial divided by these as its roots, and of its degree: all zero if they
    are the eigenvalues.
    """
    return remainders(characteristic(matrix), values)


def diagonal(values: list[Any]) -> Any:
    """The diagonal matrix of exact numbers."""
    return sp.ImmutableMatrix(sp.diag(*values))
