"""Quadrics p^T M p + g^T p + h = 0: what kind of surface, by ranks and signs that are exact."""

from __future__ import annotations

from itertools import pairwise
from typing import Any

import sympy as sp

from chasles.exact.evaluate import matrix_of
from chasles.exact.linear import rank_of
from chasles.exact.numbers import normal, sign

PARAMETER = sp.Symbol("t", real=True)
"""Where along a line a point is."""


def signature_of(matrix: Any) -> tuple[int, int]:
    """How many eigenvalues of a symmetric matrix are positive, and how many negative.

    All roots of the characteristic polynomial are real, so that its changes of sign count the positive ones exactly.
    """
    upward = [sign(c) for c in characteristic_polynomial(matrix)]
    downward = [s if place % 2 == 0 else -s for place, s in enumerate(upward)]
    return _changes(upward), _changes(downward)


def characteristic_polynomial(matrix: Any) -> list[Any]:
    """The coefficients of det(x 1 - matrix), the highest first, by Faddeev and Le Verrier."""
    size = matrix.shape[0]
    coefficients, rest = [sp.Integer(1)], sp.eye(size)
    for k in range(1, size + 1):
        product = matrix_of(matrix * rest)
        coefficients.append(normal(-product.trace() / k))
        rest = product + coefficients[-1] * sp.eye(size)
    return coefficients


def kind_of(whole: Any) -> str:
    """The kind of the surface with the 4 x 4 matrix [[M, g/2], [g^T/2, h]], which contains real lines."""
    rank, upper = rank_of(whole), rank_of(whole[:3, :3])
    kinds = {
        (4, 3): "one-sheet hyperboloid",
        (4, 2): "hyperbolic paraboloid",
        (2, 2): "two intersecting planes",
        (2, 1): "two parallel planes",
        (1, 1): "one plane, counted twice",
        (1, 0): "no point",
        (0, 0): "all of space",
    }
    return kinds.get((rank, upper), "cone or cylinder")


def transversal(point: Any, lines: list[tuple[Any, Any]]) -> Any:
    """The direction of the line through the point that meets two lines; zero where it is not determined."""
    (a, d), (b, e) = lines
    return matrix_of((a - point).cross(d).cross((b - point).cross(e)))


def _changes(signs: list[int]) -> int:
    kept = [s for s in signs if s]
    return sum(one != other for one, other in pairwise(kept))
