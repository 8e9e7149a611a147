"""What SymPy leaves unevaluated is read as it is meant: expressions of matrices, determinants, traces, finite sums."""

from __future__ import annotations

from collections.abc import Callable, Mapping
from functools import reduce
from itertools import chain, pairwise
from operator import add, mul
from typing import TYPE_CHECKING, Any

import sympy
from sympy.matrices import MatrixBase, MatrixExpr

from chasles.checker.determinants import Matrix, cofactor, determinant
from chasles.checker.expressions.defined_functions import by_definition
from chasles.checker.sparse import Polynomial, Rejected, number

if TYPE_CHECKING:
    from chasles.checker.expressions.expressions import Expressions

MOST_TERMS = 1000
MOST_POWERS = 32
LARGEST_NUMBER = 200


def matrix_of(reading: Expressions, e: Any) -> Matrix:
    """The entries of a matrix; raises `Rejected` for what is none of given size."""
    match e:
        case MatrixBase() | sympy.MatrixSymbol() | sympy.Identity() | sympy.ZeroMatrix() | sympy.OneMatrix():
            return [[reading(e[i, j]) for j in range(e.cols)] for i in range(e.rows)]
        case sympy.MatAdd():
            return reduce(_plus, (matrix_of(reading, term) for term in e.args))
        case sympy.MatMul():
            return reduce(lambda one, other: _times(reading, one, other), (_factor(reading, part) for part in e.args))
        case sympy.Transpose() | sympy.Adjoint():
            return [list(column) for column in zip(*matrix_of(reading, e.arg), strict=True)]
        case sympy.Inverse():
            return _inverse(reading, matrix_of(reading, e.arg), f"Determinant({e.arg})")
        case sympy.MatPow() if e.exp.is_Integer and abs(e.exp) <= LARGEST_NUMBER:
            base = matrix_of(reading, e.base) if e.exp != 0 else []
            base = _inverse(reading, base, f"Determinant({e.base})") if e.exp < 0 else base
            one = [[number(int(i == j)) for j in range(e.cols)] for i in range(e.rows)]
            return reduce(lambda left, right: _times(reading, left, right), [base] * abs(int(e.exp)), one)
        case sympy.HadamardProduct():
            parts = [matrix_of(reading, part) for part in e.args]
            return [[reduce(mul, entries) for entries in zip(*rows, strict=True)] for rows in zip(*parts, strict=True)]
        case sympy.BlockMatrix():
            blocks = [[matrix_of(reading, e.blocks[i, j]) for j in range(e.blocks.cols)] for i in range(e.blocks.rows)]
            return [list(chain(*parts)) for row in blocks for parts in zip(*row, strict=True)]
        case sympy.KroneckerProduct():
            return matrix_of(reading, e.as_explicit())
    raise Rejected(f"{e} ({type(e).__name__}) is no matrix that is read")


def _factor(reading: Expressions, part: Any) -> Matrix:
    return matrix_of(reading, part) if isinstance(part, MatrixBase | MatrixExpr) else [[reading(part)]]


def _plus(one: Matrix, other: Matrix) -> Matrix:
    return [[a + b for a, b in zip(row, line, strict=True)] for row, line in zip(one, other, strict=True)]


def _times(reading: Expressions, one: Matrix, other: Matrix) -> Matrix:
    """The product; a scalar multiplies every entry."""
    for scalar, matrix in ((one, other), (other, one)):
        if len(scalar) == len(scalar[0]) == 1:
            return [[reading.normal(scalar[0][0] * entry) for entry in row] for row in matrix]
    columns = list(zip(*other, strict=True))
    return [[reading.normal(reduce(add, map(mul, row, column))) for column in columns] for row in one]


def _inverse(reading: Expressions, matrix: Matrix, spelled: str) -> Matrix:
    """The adjugate over the determinant."""
    below = reading.over(reading.normal(determinant(matrix)), spelled)
    size = range(len(matrix))
    return [[reading.normal(cofactor(matrix, j, i) * below) for j in size] for i in size]


def summed(e: Any) -> Any:
    """A sum or product term by term, the inner index first; of many terms, sums of polynomials."""
    term, count = e.function, 1
    for place, (index, low, high) in enumerate(e.limits):
        outer = _integers(e.limits[place + 1 :])
        size = sympy.expand(high - low + 1)
        if size.is_Integer and 0 <= size * count <= MOST_TERMS:
            count *= max(1, int(size))
            values = [term.subs(index, low + k) for k in range(int(size))]
            term = sympy.Add(*values) if isinstance(e, sympy.Sum) else sympy.Mul(*values)
        elif isinstance(e, sympy.Sum) and size.xreplace(outer).is_integer:
            number = sympy.Dummy(integer=low.xreplace(outer).is_integer)
            inside = term.subs(outer | {index: number}).replace(sympy.Sum, lambda *args: summed(sympy.Sum(*args)))
            before = _before(e, inside, number).xreplace({value: known for known, value in outer.items()})
            term = sympy.expand(before.xreplace({number: high + 1}) - before.xreplace({number: low}))
        elif size.is_Integer or isinstance(e, sympy.Product):
            raise Rejected(f"{e} is not treated: it may have more than {MOST_TERMS} terms")
        else:
            raise Rejected(f"{e} is not treated: nothing says that {size} is an integer")
    return term


def _integers(limits: Any) -> dict[Any, Any]:
    """The indices, those that start from an integer as integers."""
    known: dict[Any, Any] = {}
    for index, low, _ in reversed(limits):
        known[index] = sympy.Dummy(integer=low.xreplace(known).is_integer)
    return known


def _before(e: Any, term: Any, index: Any) -> Any:
    """What grows by the term from an index to the next: Newton's series, tried; from above to below a sum is Karr's."""
    known = range(MOST_POWERS if term.is_polynomial(index) else 0)
    differences = [sympy.expand(term.xreplace({index: sympy.Integer(k)})) for k in known]
    total, choices = sympy.S.Zero, index
    while any(differences):
        total, choices = total + differences[0] * choices, choices * (index - MOST_POWERS + len(differences) - 1)
        choices /= MOST_POWERS - len(differences) + 2
        differences = [sympy.expand(b - a) for a, b in pairwise(differences)]
    if not known or sympy.expand(total.xreplace({index: index + 1}) - total - term) != 0:
        raise Rejected(f"{e} is not treated: of so many terms, only sums of polynomials in the index are")
    return total


def _element(reading: Expressions, e: Any) -> Polynomial:
    matrix, i, j = e.args
    if not (i.is_Integer and j.is_Integer):
        raise Rejected(f"{e} has indices that are no numbers")
    return matrix_of(reading, matrix)[int(i)][int(j)]


def _trace(reading: Expressions, e: Any) -> Polynomial:
    """The sum of the entries on the diagonal; no other entry of a sum, or of a single matrix, is read."""
    match e:
        case sympy.MatAdd():
            return reduce(add, (_trace(reading, term) for term in e.args))
        case sympy.Transpose():
            return _trace(reading, e.arg)
        case MatrixBase() | sympy.MatrixSymbol():
            return reduce(add, (reading(e[i, i]) for i in range(e.rows)))
    return reduce(add, (row[i] for i, row in enumerate(matrix_of(reading, e))))


UNEVALUATED: Mapping[type, Callable[[Expressions, Any], Polynomial]] = {
    sympy.matrices.expressions.matexpr.MatrixElement: _element,
    sympy.Determinant: lambda reading, e: reading.normal(determinant(matrix_of(reading, e.arg))),
    sympy.Trace: lambda reading, e: _trace(reading, e.arg),
    **dict.fromkeys((sympy.Sum, sympy.Product), lambda reading, e: reading(by_definition(summed(e)))),
}
