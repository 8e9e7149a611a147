"""Moments of inertia as data: what any such matrix must satisfy."""

from __future__ import annotations

from typing import Any

from chasles.exact.numbers import is_zero
from chasles.exact.spectra import signature
from chasles.exercises.data import DataError


def require_symmetric(key: str, matrix: Any) -> Any:
    """The matrix; DataError, with the entries that differ, if it is not symmetric."""
    for i in range(matrix.rows):
        for j in range(i):
            if not is_zero(matrix[i, j] - matrix[j, i]):
                raise DataError(
                    f"{key}: expected a symmetric matrix, and got {matrix[i, j]} in row {i + 1}, column {j + 1} "
                    f"and {matrix[j, i]} in row {j + 1}, column {i + 1}"
                )
    return matrix


def require_inertia(key: str, matrix: Any) -> Any:
    """The matrix; DataError if it is not symmetric and positive-semidefinite, as any moment of inertia is."""
    _, negative, _ = signature(require_symmetric(key, matrix))
    if negative:
        raise DataError(f"{key}: expected a positive-semidefinite matrix, and got one with a negative principal moment")
    return matrix
