"""What SymPy leaves unevaluated, written out as it is meant: matrix expressions, determinants, traces, finite sums."""

from __future__ import annotations

from collections.abc import Callable, Iterator, Mapping
from functools import reduce
from operator import mul
from typing import Any

import sympy
from sympy.concrete.expr_with_limits import ExprWithLimits
from sympy.matrices import MatrixBase, MatrixExpr
from sympy.matrices.expressions.matexpr import MatrixElement

from chasles.checker.expressions.quantities import COMPARING, is_atom, with_values
from chasles.checker.expressions.readings import is_integral
from chasles.checker.expressions.visible import is_running, signs_of
from chasles.checker.sparse import Rejected

MOST_TERMS, MOST_FUNCTIONS = 1000, 60  # of polynomials, and of others
MOST_POWERS = 32


def explicit(e: Any) -> Any:
    """A matrix expression entry by entry, an inverse as the adjugate over the determinant.

    Raises `Rejected`, or what SymPy raises, a `ValueError`, `TypeError` or `NotImplementedError`, for what cannot be
    written out.
    """
    if isinstance(e, MatrixBase):
        return e.applyfunc(written_out)
    for kind, write in MATRICES.items():
        if isinstance(e, kind):
            return write(e)
    return e.as_explicit().applyfunc(written_out)


def written_out(e: Any) -> Any:
    """A scalar in which no matrix expression, and no finite sum or product, is left."""
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


def hidden_in(e: Any) -> Iterator[Any]:
    """What has to be defined for something that is written out to be, though SymPy may cancel it then."""
    if not e.has(*SCALARS, MatrixElement, MatrixExpr):
        return
    bound = {limit[0] for part in e.atoms(sympy.Sum, sympy.Product) for limit in part.limits}
    parts = e.atoms(sympy.Pow, sympy.Function, *SCALARS)
    parts |= {1 / sympy.Determinant(part.base) for part in e.atoms(sympy.MatPow) if part.exp.is_negative}
    rates = [rate for rate in e.atoms(sympy.Derivative) if not is_atom(rate)]
    unseen = (part for part in sorted(parts, key=str) if not is_atom(part))  # what a function of time is has a value
    known = (part for part in unseen if not (part.free_symbols & bound or part.has(*rates)))
    yield from map(written_out, known)


def _inverse(matrix: Any) -> Any:
    return matrix.adjugate() / matrix.det(method="berkowitz")


def _power(e: Any) -> Any:
    base, exponent = explicit(e.base), e.exp
    if not exponent.is_Integer or abs(exponent) > MOST_POWERS:
        raise NotImplementedError(f"the exponent {exponent} is no small integer")
    return reduce(mul, [_inverse(base) if exponent < 0 else base] * abs(int(exponent)), sympy.eye(base.rows))


def _product(e: Any) -> Any:
    return reduce(mul, (explicit(e) if isinstance(e, MatrixExpr | MatrixBase) else written_out(e) for e in e.args))


def require_running(e: Any) -> None:
    """Raise `Rejected` where an index of a sum or product is assumed to be what it need not be from end to end."""
    for index, low, high in e.limits:
        ends = (low, high) if high.is_number or -1 in signs_of(low) else (low,)
        if not is_running(index, ends, "integer" if is_integral(low.xreplace(_integers(e.limits))) else "real"):
            raise Rejected(f"{e} is not treated: {index} is assumed to be what it need not be from {low} to {high}")


def summed(e: Any) -> Any:
    """A sum or product term by term, the inner index first; of many terms, sums of polynomials."""
    require_running(e)
    term, count = e.function, 1
    for place, (index, low, high) in enumerate(e.limits):
        outer = _integers(e.limits[place + 1 :])
        size, sample = sympy.expand(high - low + 1), term.xreplace({index: high})
        most = MOST_TERMS if sample.is_polynomial(*sample.free_symbols) else MOST_FUNCTIONS
        if size.is_Integer and 0 <= size * count <= most:
            count *= max(1, int(size))
            put = with_values if term.has(*COMPARING) else sympy.Basic.subs
            values = [put(term, {index: low + k}) for k in range(int(size))]
            term = sympy.Add(*values) if isinstance(e, sympy.Sum) else sympy.Mul(*values)
        elif isinstance(e, sympy.Sum) and is_integral(size.xreplace(outer)):
            number = sympy.Dummy(integer=is_integral(low.xreplace(outer)) or None)
            inside = term.subs(outer | {index: number}).replace(sympy.Sum, lambda *args: summed(sympy.Sum(*args)))
            before = _before(e, inside, number).xreplace({value: known for known, value in outer.items()})
            term = sympy.expand(before.xreplace({number: high + 1}) - before.xreplace({number: low}))
        elif size.is_Integer or isinstance(e, sympy.Product):
            raise Rejected(f"{e} is not treated: it may have more than {most} terms")
        else:
            raise Rejected(f"{e} is not treated: nothing says that {size} is an integer")
    return term


def _integers(limits: Any) -> dict[Any, Any]:
    """The indices, those that start from an integer as integers."""
    known: dict[Any, Any] = {}
    for index, low, _ in reversed(limits):
        known[index] = sympy.Dummy(integer=is_integral(low.xreplace(known)) or None)
    return known


def _before(e: Any, term: Any, index: Any) -> Any:
    """What grows by the term from an index to the next: SymPy's sum, tried; from above to below a sum is Karr's."""
    plain, each = term.is_polynomial(index) and sympy.degree(term, index) < MOST_POWERS, sympy.Dummy(integer=True)
    total = sympy.summation(sympy.expand(term.xreplace({index: each})), (each, 0, index - 1)) if plain else index
    if not plain or sympy.expand(total.xreplace({index: index + 1}) - total - term) != 0:
        raise Rejected(f"{e} is not treated: of so many terms, only sums of polynomials in the index are")
    return total


MATRICES: Mapping[type, Callable[[Any], Any]] = {
    sympy.Inverse: lambda e: _inverse(explicit(e.arg)),
    sympy.MatPow: _power,
    sympy.MatMul: _product,
    sympy.Adjoint: lambda e: explicit(e.arg).H if e.arg.has(sympy.I) else explicit(e.arg).T,
}
SCALARS: Mapping[type, Callable[[Any], Any]] = {
    sympy.Determinant: lambda e: explicit(e.arg).det(method="berkowitz"),
    sympy.Trace: lambda e: explicit(e.arg).trace(),
    sympy.Sum: lambda e: written_out(summed(e)),
    sympy.Product: lambda e: written_out(summed(e)),
    ExprWithLimits: lambda e: e,
}
