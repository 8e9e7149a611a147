"""What SymPy leaves unevaluated, written out: products and inverses of matrices, determinants, finite sums."""

from __future__ import annotations

from collections.abc import Callable, Mapping
from functools import reduce
from operator import add, mul
from typing import Any

import sympy
from sympy.concrete.expr_with_limits import ExprWithLimits
from sympy.matrices import MatrixBase, MatrixExpr
from sympy.matrices.expressions.matexpr import MatrixElement

from chasles.checker.expressions.unevaluated import summed
from chasles.checker.sparse import Rejected
from chasles.problems.variables import Untreatable

MOST_MULTIPLIED = 32


def explicit(e: Any) -> Any:
    """A matrix expression entry by entry, an inverse as the adjugate over the determinant.

    Raises what SymPy raises, a `ValueError`, `TypeError` or `NotImplementedError`, for what cannot be written out.
    """
    if isinstance(e, MatrixBase):
        return e.applyfunc(written_out)
    for kind, write in MATRICES.items():
        if isinstance(e, kind):
            return write(e)
    return e.as_explicit().applyfunc(written_out)


def written_out(e: Any) -> Any:
    """A scalar in which no matrix expression, finite sum or factorial of a number is left."""
    if not e.has(*SCALARS, MatrixElement):
        return e
    for kind, write in SCALARS.items():
        if isinstance(e, kind):
            return write(e)
    if isinstance(e, MatrixElement):
        matrix, i, j = e.args
        if isinstance(matrix, sympy.MatrixSymbol) or not (i.is_Integer and j.is_Integer):
            return e
        return explicit(matrix)[i, j]
    return e.func(*map(written_out, e.args)) if e.args else e


def _inverse(matrix: Any) -> Any:
    return matrix.adjugate() / matrix.det(method="berkowitz")


def _power(e: Any) -> Any:
    base, exponent = explicit(e.base), e.exp
    if not exponent.is_Integer or abs(exponent) > MOST_MULTIPLIED:
        raise NotImplementedError(f"the exponent {exponent} is no small integer")
    factors = [_inverse(base) if exponent < 0 else base] * abs(int(exponent))
    return reduce(mul, factors, sympy.eye(base.rows))


def _product(e: Any) -> Any:
    factors = [explicit(part) if isinstance(part, MatrixExpr | MatrixBase) else written_out(part) for part in e.args]
    return reduce(mul, factors)


def _entrywise(e: Any) -> Any:
    return reduce(lambda one, other: one.multiply_elementwise(other), map(explicit, e.args))


def _blocks(e: Any) -> Any:
    rows = [[explicit(e.blocks[i, j]) for j in range(e.blocks.cols)] for i in range(e.blocks.rows)]
    return reduce(lambda one, other: one.col_join(other), [reduce(lambda a, b: a.row_join(b), row) for row in rows])


def _summed(e: Any) -> Any:
    try:
        return written_out(summed(e))
    except Rejected as reason:
        raise Untreatable(str(reason)) from None


MATRICES: Mapping[type, Callable[[Any], Any]] = {
    sympy.MatrixSymbol: lambda e: e.as_explicit(),
    sympy.Inverse: lambda e: _inverse(explicit(e.arg)),
    sympy.MatPow: _power,
    sympy.MatAdd: lambda e: reduce(add, map(explicit, e.args)),
    sympy.MatMul: _product,
    sympy.Transpose: lambda e: explicit(e.arg).T,
    sympy.Adjoint: lambda e: explicit(e.arg).H,
    sympy.HadamardProduct: _entrywise,
    sympy.BlockMatrix: _blocks,
}
SCALARS: Mapping[type, Callable[[Any], Any]] = {
    sympy.Determinant: lambda e: explicit(e.arg).det(method="berkowitz"),
    sympy.Trace: lambda e: explicit(e.arg).trace(),
    sympy.Sum: _summed,
    sympy.Product: _summed,
    ExprWithLimits: lambda e: e,
}
