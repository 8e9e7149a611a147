"""Determinants of matrices of polynomials, for the checker."""

from __future__ import annotations

from functools import reduce
from operator import add

from chasles.checker.sparse import ONE, ZERO, Polynomial

Matrix = list[list[Polynomial]]


def determinant(m: Matrix) -> Polynomial:
    """The determinant, by expansion along the first row."""
    terms = (entry * cofactor(m, 0, j) for j, entry in enumerate(m[0] if m else []) if entry)
    return reduce(add, terms, ZERO) if m else ONE


def cofactor(m: Matrix, i: int, j: int) -> Polynomial:
    """What multiplies an entry in the determinant."""
    minor = determinant([row[:j] + row[j + 1 :] for row in (*m[:i], *m[i + 1 :])])
    return -minor if (i + j) % 2 else minor
