"""Determinants of matrices of polynomials, or of other numbers, for the checker."""

from __future__ import annotations

from functools import reduce
from operator import add
from typing import Any

from chasles.checker.sparse import ONE

Matrix = list[list[Any]]


def determinant(m: Matrix, one: Any = ONE) -> Any:
    """The determinant, by expansion along the first row; `one` is that of nothing."""
    terms = [entry * cofactor(m, 0, j, one) for j, entry in enumerate(m[0] if m else []) if entry]
    return reduce(add, terms) if terms else m[0][0] if m else one


def cofactor(m: Matrix, i: int, j: int, one: Any = ONE) -> Any:
    """What multiplies an entry in the determinant."""
    minor = determinant([row[:j] + row[j + 1 :] for row in (*m[:i], *m[i + 1 :])], one)
    return -minor if (i + j) % 2 else minor
