"""Orthonormal columns among the given equations, recognised so that they are treated as a rotation.

Three orthonormal columns of determinant one satisfy 21 quadrics that are already a Groebner basis; starting from the
six equations and the determinant, completion takes many seconds.
"""

from __future__ import annotations

from collections.abc import Iterable, Sequence
from dataclasses import dataclass
from itertools import combinations
from typing import Any

import sympy

from chasles.checker.expressions.quantities import is_atom


@dataclass(frozen=True, slots=True)
class Triad:
    """A matrix of atoms with orthonormal columns; `proper` if its determinant is given to be one.

    `sources` are the places of the given equations that say so.
    """

    matrix: Any
    proper: bool
    sources: tuple[int, ...]

    @property
    def equations(self) -> list[tuple[Any, Any]]:
        """All quadrics that such a matrix satisfies, as pairs of sides."""
        Q = self.matrix
        found = list(zip(Q.T * Q, sympy.eye(Q.cols), strict=True))
        if Q.cols == Q.rows:
            found += list(zip(Q * Q.T, sympy.eye(Q.cols), strict=True))
        if self.proper and Q.cols == 3:
            found += list(zip(Q, Q.cofactor_matrix(), strict=True))
        return list(dict.fromkeys(found))


def triads_of(equations: Sequence[tuple[Any, Any]]) -> list[Triad]:
    """The matrices with two or three orthonormal columns that the equations speak of."""
    found: list[Triad] = []
    forms = [_normal(left - right) for left, right in equations]
    units: dict[frozenset[Any], list[int]] = {}
    products: dict[frozenset[frozenset[Any]], list[int]] = {}
    for place, form in enumerate(forms):
        if unit := _unit(form):
            units.setdefault(unit, []).append(place)
        elif pairs := _perpendicular(form):
            products.setdefault(pairs, []).append(place)
    used: set[Any] = set()
    for size, count in ((3, 3), (3, 2), (2, 2)):
        candidates = [unit for unit in units if len(unit) == size]
        for columns in combinations(candidates, count):
            atoms = frozenset[Any]().union(*columns)
            if not used & atoms and (triad := _triad(columns, units, products, forms)):
                found.append(triad)
                used |= atoms
    return found


def _normal(expression: Any) -> dict[Any, Any]:
    """Monomials and coefficients; those of an equation up to a factor."""
    if not expression.free_symbols:
        return {}
    return dict(sympy.expand(expression).as_coefficients_dict())


def _scaled(form: dict[Any, Any], constant: Any) -> dict[Any, Any]:
    return {monomial: c / constant for monomial, c in form.items()}


def _unit(form: dict[Any, Any]) -> frozenset[Any] | None:
    """The atoms of x^2 + y^2 + z^2 = 1."""
    constant = form.get(sympy.S.One)
    if constant is None or len(form) not in (3, 4):
        return None
    squares = {monomial: c for monomial, c in _scaled(form, -constant).items() if monomial != 1}
    if any(c != 1 or not (m.is_Pow and m.exp == 2 and is_atom(m.base)) for m, c in squares.items()):
        return None
    return frozenset(m.base for m in squares)


def _perpendicular(form: dict[Any, Any]) -> frozenset[frozenset[Any]] | None:
    """The pairs of a b + c d + e f = 0."""
    if len(form) not in (2, 3) or len({abs(c) for c in form.values()}) != 1 or len(set(form.values())) != 1:
        return None
    pairs = [frozenset(m.args) for m in form if m.is_Mul and len(m.args) == 2 and all(map(is_atom, m.args))]
    return frozenset(pairs) if len(pairs) == len(form) else None


def _triad(
    columns: tuple[frozenset[Any], ...],
    units: dict[frozenset[Any], list[int]],
    products: dict[frozenset[frozenset[Any]], list[int]],
    forms: list[dict[Any, Any]],
) -> Triad | None:
    """The columns as a matrix, their entries in matching order, if all pairs are given to be perpendicular."""
    if len(frozenset[Any]().union(*columns)) != sum(map(len, columns)):
        return None
    sources = [place for column in columns for place in units[column]]
    partners: dict[tuple[int, int], dict[Any, Any]] = {}
    for i, j in combinations(range(len(columns)), 2):
        matching = [
            (pairs, {a: b for pair in pairs for a in pair & columns[i] for b in pair & columns[j]})
            for pairs in products
            if all(len(pair & columns[i]) == len(pair & columns[j]) == 1 for pair in pairs)
        ]
        if len(matching) != 1 or set(matching[0][1]) != set(columns[i]):
            return None
        sources += products[matching[0][0]]
        partners[i, j] = matching[0][1]
    first = sorted(columns[0], key=str)
    rows = [[a, *(partners[0, j][a] for j in range(1, len(columns)))] for a in first]
    if len(columns) == 3 and any(partners[1, 2][row[1]] != row[2] for row in rows):
        return None
    return _oriented(sympy.Matrix(rows), sources, forms)


def _oriented(matrix: Any, sources: list[int], forms: Iterable[dict[Any, Any]]) -> Triad:
    """The matrix with its columns so ordered that a given determinant is one."""
    forms = list(forms)
    swapped = matrix[:, [1, 0, *range(2, matrix.cols)]]
    for candidate in (matrix, swapped) if matrix.rows == matrix.cols else ():
        wanted = _normal(candidate.det() - 1)
        for place, form in enumerate(forms):
            constant = form.get(sympy.S.One)
            if constant is not None and _scaled(form, -constant) == wanted:
                return Triad(candidate, True, (*sources, place))
    return Triad(matrix, False, tuple(sources))
