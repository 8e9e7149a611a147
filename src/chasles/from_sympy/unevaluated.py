"""What SymPy leaves unevaluated, written out: products and inverses of matrices, determinants, finite sums."""

from __future__ import annotations

from collections.abc import Callable, Mapping
from functools import reduce
from itertools import pairwise
from operator import add, mul
from typing import Any

import sympy
from sympy.concrete.expr_with_limits import ExprWithLimits
from sympy.matrices import MatrixBase, MatrixExpr
from sympy.matrices.expressions.matexpr import MatrixElement

from chasles.problems.variables import Untreatable

MOST_TERMS = 1000
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


def _repeated(combine: Callable[[Any, Any], Any], empty: Any) -> Callable[[Any], Any]:
    """A sum or product term by term, the inner index first; of many terms, sums of polynomials."""

    def written(e: Any) -> Any:
        term, count = e.function, 1
        for place, (index, *limits) in enumerate(e.limits):
            low, high = map(written_out, limits)
            outer = _integers(e.limits[place + 1 :])
            size = sympy.expand(high - low + 1)
            few = size.is_Integer and 0 <= size * count <= MOST_TERMS
            if few:
                count *= max(1, int(size))
                term = reduce(combine, (term.subs(index, low + k) for k in range(int(size))), empty)
            elif combine is add and size.xreplace(outer).is_integer:
                number = sympy.Dummy(integer=low.xreplace(outer).is_integer)
                inside = written_out(term.subs(outer | {index: number}))
                before = _before(e, inside, number).xreplace({value: known for known, value in outer.items()})
                term = sympy.expand(before.xreplace({number: high + 1}) - before.xreplace({number: low}))
            elif size.is_Integer or combine is mul:
                raise Untreatable(f"{e} is not treated: it may have more than {MOST_TERMS} terms")
            else:
                raise Untreatable(f"{e} is not treated: nothing says that {size} is an integer")
        return written_out(term)

    return written


def _integers(limits: Any) -> dict[Any, Any]:
    """The indices, those that start from an integer as integers."""
    known: dict[Any, Any] = {}
    for index, low, _ in reversed(limits):
        known[index] = sympy.Dummy(integer=low.xreplace(known).is_integer)
    return known


def _before(e: Any, term: Any, index: Any) -> Any:
    """What grows by the term from an index to the next, by Newton's series; from above to below a sum is Karr's."""
    known = range(MOST_MULTIPLIED if term.is_polynomial(index) else 0)
    differences = [sympy.expand(term.xreplace({index: sympy.Integer(k)})) for k in known]
    total, choices = sympy.S.Zero, index
    for k in known:
        total += differences[0] * choices
        choices *= (index - k - 1) / sympy.Integer(k + 2)
        differences = [sympy.expand(b - a) for a, b in pairwise(differences)]
        if not any(differences) and len(differences) > 1:
            return total
    raise Untreatable(f"{e} is not treated: of so many terms, only sums of polynomials in the index are")


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
    sympy.Sum: _repeated(add, sympy.S.Zero),
    sympy.Product: _repeated(mul, sympy.S.One),
    ExprWithLimits: lambda e: e,
}
