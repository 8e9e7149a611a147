"""The principal axes of a symmetric 3 x 3 matrix, exactly: unit eigenvectors as the rows of a rotation.

Each row is a column of the projector onto the eigenspace, divided by its length: the projection of the first
coordinate axis that is not normal to the space (and, in a space of several dimensions, to the rows chosen before). Its
first entry that is not zero is positive by that. Only the last row's sign is the one that makes the rows right-handed.
"""

from __future__ import annotations

from dataclasses import replace as with_fields
from functools import reduce
from typing import Any

import sympy as sp
from sympy import Poly
from sympy.polys.matrices import DomainMatrix

from chasles.evaluation.matrices import determinant
from chasles.exact.fields import NumberField
from chasles.exact.numbers import is_zero, normal, root, sign
from chasles.exact.polynomial_roots import Root, X, merged, place_of, same_number, value_of
from chasles.exact.spectra import characteristic, eigenvalues_by_block

CHOICE_OF_AXES = (
    "Axes are rows, in the order of ascending moments. Each is the unit projection, onto the space of its moment, of "
    "the first coordinate axis that is not normal to that space and to the rows before it; the last row's sign makes "
    "the rows right-handed."
)


def principal_axes(matrix: Any) -> Any:
    """The rows, as a matrix of exact numbers; as lists with a Root for each entry where the eigenvalues are such.

    `matrix` is symmetric, 3 x 3, of exact numbers.
    """
    blocks = eigenvalues_by_block(matrix)
    found = merged([one for _, values in blocks for one in values])
    if isinstance(found[0][0], Root):
        rows = [_row_at_root(matrix, value) for value, _ in found]
    else:
        rows = [row for value, _ in found for row in _rows(_projector(matrix, value, blocks))]
    if sign(determinant([[value_of(entry) for entry in row] for row in rows])) < 0:
        rows[2] = [_negative(entry) for entry in rows[2]]
    return rows if isinstance(found[0][0], Root) else sp.ImmutableMatrix(rows)


def _projector(matrix: Any, value: Any, blocks: list[tuple[list[int], list[tuple[Any, int]]]]) -> Any:
    """The projector onto an eigenspace, block by block.

    In a block with that eigenvalue it is the product of (block - other) / (value - other) over the others.
    """
    whole = sp.zeros(matrix.rows, matrix.rows)
    for places, values in blocks:
        if not any(same_number(other, value) for other, _ in values):
            continue
        block = matrix.extract(places, places)
        one = sp.eye(len(places))
        others = [other for other, _ in values if not same_number(other, value)]
        factors = [(block - other * one) / (value - other) for other in others]
        found = reduce(product, factors) if factors else one
        for i, row in enumerate(places):
            for j, column in enumerate(places):
                whole[row, column] = normal(found[i, j])
    return whole


def _rows(projector: Any) -> list[list[Any]]:
    """Orthonormal rows that span what the projector projects onto."""
    rows = []
    for j in range(3):
        if is_zero(projector[j, j]):
            continue
        column = projector[:, j]
        # Each entry by itself as a signed root, which is short where entry / length is not.
        is_last = is_zero(projector.trace() - 1)
        squares = projector.diagonal() if is_last else [entry**2 / projector[j, j] for entry in column]
        rows.append([sign(entry) * root(square) for entry, square in zip(column, squares, strict=True)])
        if is_last:
            break
        projector = (projector - column * column.T / projector[j, j]).applyfunc(normal)
    return rows


def _row_at_root(matrix: Any, value: Root) -> list[Any]:
    """The row of a simple eigenvalue that square roots do not express.

    With B(x) the adjugate of x 1 - matrix and p' the derivative of the characteristic polynomial, B / p' is the
    projector: the squares of the row's entries are B_ii / p', and their signs those of B_i1 / p'.
    """
    field = NumberField(*matrix)
    polynomial = _over(field, characteristic(matrix))
    shifted = matrix - sp.trace(matrix) * sp.eye(3)
    adjugate = matrix.adjugate()
    entries = [
        [_over(field, [sp.Integer(int(i == j)), shifted[i, j], adjugate[i, j]]) for j in range(3)] for i in range(3)
    ]
    inverse = polynomial.diff(X).rem(polynomial).invert(polynomial)
    return [_entry(polynomial, entries[i][i] * inverse, entries[i][0] * inverse, value, field) for i in range(3)]


def _entry(polynomial: Poly, square: Poly, signed: Poly, value: Root, field: NumberField) -> Any:
    """The number whose square is one element of the field of the root, and whose sign is that of another."""
    square, signed = square.rem(polynomial), signed.rem(polynomial)
    turn = sign(signed.as_expr().xreplace({X: value.value}))
    if square.degree() == 0:
        return turn * root(field.expression(square.rep.to_list()[0]))
    least = _characteristic_of_multiplication(square, polynomial, field).compose(Poly(X**2, X, domain=field.domain))
    number = turn * sp.sqrt(square.as_expr().xreplace({X: value.value}))
    return place_of(least.norm() if field.domain.is_Algebraic else least, number)


def _characteristic_of_multiplication(element: Poly, polynomial: Poly, field: NumberField) -> Poly:
    columns = [(element * Poly(X**k, X, domain=field.domain)).rem(polynomial) for k in range(3)]
    rows = [[column.rep.nth(i) for column in columns] for i in range(3)]
    return Poly.from_list(DomainMatrix(rows, (3, 3), field.domain).charpoly(), X, domain=field.domain)


def _over(field: NumberField, coefficients: list[Any]) -> Poly:
    return Poly.from_list([field(c) for c in coefficients], X, domain=field.domain)


def _negative(entry: Any) -> Any:
    if not isinstance(entry, Root):
        return normal(-entry)
    degree = len(entry.coefficients) - 1
    turned = [c * (-1) ** (degree - k) for k, c in enumerate(entry.coefficients)]
    lead = 1 if turned[0] > 0 else -1
    count = Poly(entry.coefficients, X).count_roots()
    return with_fields(entry, coefficients=tuple(lead * c for c in turned), index=count - 1 - entry.index)


def in_axes(matrix: Any, axes: Any) -> Any:
    """The matrix in a frame whose axes are the rows of a matrix: axes matrix axes^T."""
    return product(product(axes, matrix), axes.T)


def product(one: Any, other: Any) -> Any:
    """The product of two matrices, entries in normal form."""
    return (one * other).applyfunc(normal)


def columns_of(axes: Any) -> tuple[Any, ...]:
    """The axes as column vectors; a Root becomes SymPy's."""
    rows = axes if isinstance(axes, list) else axes.tolist()
    return tuple(sp.ImmutableMatrix([e.value.evalf(50) if isinstance(e, Root) else e for e in row]) for row in rows)
