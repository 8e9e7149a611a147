"""Inverses and determinants of matrices of expressions, which SymPy writes out for minutes from four rows on."""

from __future__ import annotations

from functools import cache
from typing import Any

import sympy

from chasles.compiling.elementary import Inverted
from chasles.compiling.variables import outermost
from chasles.lowering.refusal import LoweringError

WRITTEN_OUT = 3
"""Up to so many rows the inverse is a quotient of polynomials."""
MOST_ROWS = 12
"""A determinant has twice as many minors for every row."""


def explicit(matrix: Any) -> Any:
    """The matrix in its entries. Raises `LoweringError` for a determinant of too many rows."""
    table: dict[sympy.Basic, sympy.Basic] = {}
    entries: dict[sympy.Basic, sympy.Basic] = {}
    for number, node in enumerate(outermost([matrix], _is_large)):
        of = explicit(node.args[0])
        if isinstance(node, sympy.Determinant):
            table[node] = _determinant(of)
        else:
            # SymPy multiplies entries that are symbols in a fraction of the time.
            table[node] = standing = sympy.MatrixSymbol(f"inverse {number}", *node.shape)
            entries |= dict(zip(standing.as_explicit(), _inverse(of) ** -int(node.exp), strict=True))
    found = matrix.xreplace(table).as_explicit()
    return found.xreplace(entries) if entries else found


def without_inverses(expression: sympy.Basic) -> sympy.Basic:
    """The scalar with its traces and determinants of matrices that hold inverses or are large, in entries."""
    found = outermost([expression], lambda node: isinstance(node, sympy.Trace) or _is_large(node))
    return expression.xreplace({node: _scalar(node) for node in found}) if found else expression


def _scalar(node: Any) -> Any:
    if isinstance(node, sympy.Trace):
        return explicit(node.arg).trace()
    return _determinant(explicit(node.arg)) if isinstance(node, sympy.Determinant) else explicit(node)


def _is_large(node: Any) -> bool:
    """Whether it is an inverse, a power of one, or a determinant, of a matrix of many rows."""
    if isinstance(node, sympy.Inverse | sympy.MatPow):
        is_one = node.exp.is_Integer and node.exp < 0
    else:
        is_one = isinstance(node, sympy.Determinant)
    return bool(is_one and node.args[0].rows.is_Integer and node.args[0].rows > WRITTEN_OUT)


def _inverse(matrix: sympy.MatrixBase) -> sympy.MatrixBase:
    if not any(entry.free_symbols for entry in matrix):
        return matrix.inv()
    return sympy.ImmutableDenseMatrix(*matrix.shape, lambda i, j: Inverted(i, j, matrix.rows, *matrix))


def _determinant(matrix: sympy.MatrixBase) -> sympy.Expr:
    """By minors, each once (Laplace): a polynomial has its derivatives where the matrix is singular, too."""
    if matrix.rows > MOST_ROWS:
        raise LoweringError(f"a determinant of {matrix.rows} rows is not computed: at most of {MOST_ROWS}")

    @cache
    def minor(columns: tuple[int, ...]) -> sympy.Expr:
        """The determinant of these columns of the last rows."""
        row = matrix.rows - len(columns)
        places = enumerate(columns)
        terms = ((-1) ** k * matrix[row, c] * minor((*columns[:k], *columns[k + 1 :])) for k, c in places)
        return sympy.Add(*terms) if columns else sympy.S.One

    return minor(tuple(range(matrix.rows)))
