"""The expressions that the user asked about, as scalars and matrices of entries with nothing left to evaluate."""

from __future__ import annotations

from collections.abc import Callable, Iterator
from dataclasses import dataclass
from typing import Any

import sympy
from sympy.core.function import AppliedUndef
from sympy.logic.boolalg import Boolean
from sympy.matrices import MatrixBase, MatrixExpr

from chasles.checker.expressions.asked import valued
from chasles.checker.expressions.quantities import is_atom
from chasles.checker.expressions.unevaluated import explicit
from chasles.checker.sparse import Rejected
from chasles.problems.variables import Untreatable

LONGEST_EXCERPT = 80


class FunctionSymbol(sympy.Symbol):  # type: ignore[misc]
    """The variable that stands for a function's value; its name is that value in SymPy's spelling."""


class Signed(FunctionSymbol):
    """The variable for what is positive only where the question is meant."""


@dataclass(frozen=True, slots=True)
class Entries:
    """The entries of a scalar or a matrix, row by row."""

    rows: tuple[tuple[Any, ...], ...]
    is_matrix: bool

    @property
    def shape(self) -> tuple[int, int]:
        """The numbers of rows and columns."""
        return len(self.rows), len(self.rows[0]) if self.rows else 0

    @property
    def size(self) -> str:
        """The shape in words."""
        return f"a {self.shape[0]} x {self.shape[1]} matrix" if self.is_matrix else "a scalar"


def excerpt(expression: Any) -> str:
    """The expression in SymPy's spelling, cut short if it is long."""
    text = str(expression)
    return text if len(text) <= LONGEST_EXCERPT else f"{text[: LONGEST_EXCERPT - 4]} ..."


def parts_of(expression: Any) -> Iterator[Any]:
    """Each different part of an expression once, itself first; `atoms` meets all that is repeated again."""
    return different_parts(expression, lambda _: False)


def atoms_of(expression: Any) -> Iterator[Any]:
    """The real variables that occur in an expression, each once."""
    return filter(is_atom, different_parts(expression, is_atom))


def different_parts(expression: Any, is_last: Callable[[Any], bool]) -> Iterator[Any]:
    """Each different part of an expression once, itself first, and nothing inside of what is last."""
    seen = set()
    waiting = [expression]
    while waiting:
        part = waiting.pop()
        if part not in seen:
            seen.add(part)
            yield part
            if not is_last(part):
                waiting += reversed(part.args)


def opened(value: Any, what: str) -> Entries:
    """The entries of what was handed in as `what`; raises `Untreatable` for what is no SymPy scalar or matrix."""
    if isinstance(value, str):
        raise Untreatable(f"{what} is the text {value!r}: hand in a SymPy expression, for instance sympify({value!r})")
    try:
        value = sympy.sympify(value, strict=True)
    except sympy.SympifyError:
        raise Untreatable(f"{what} is {value!r}, which is no SymPy expression or matrix") from None
    if isinstance(value, MatrixExpr):
        value = written(explicit, value)
    if isinstance(value, MatrixBase):
        if 0 in value.shape:
            raise Untreatable(f"{what} is an empty matrix, {value.shape[0]} x {value.shape[1]}")
        rows = tuple(tuple(_evaluated(value[i, j]) for j in range(value.cols)) for i in range(value.rows))
        return Entries(rows, is_matrix=True)
    if not isinstance(value, sympy.Expr):
        kind = type(value).__name__
        raise Untreatable(f"{what} is {excerpt(value)}, of type {kind}: a scalar or a matrix is expected")
    return Entries(((_evaluated(value),),), is_matrix=False)


def written(write: Callable[[Any], Any], value: Any) -> Any:
    """What is written out of it; raises `Untreatable` where that cannot be done."""
    try:
        return write(value)
    except Rejected as reason:
        raise Untreatable(str(reason)) from None
    except (ValueError, TypeError, AttributeError, NotImplementedError) as error:
        raise Untreatable(f"{excerpt(value)} has entries that SymPy cannot write out: {error}") from None


def _evaluated(entry: Any) -> Any:
    """The entry written out, derivatives of expressions taken, with zero for the symbols that SymPy is told to be."""
    whole, entry = entry, written(valued, entry)
    if entry.has(sympy.zoo, sympy.nan) and not whole.has(sympy.zoo, sympy.nan):
        raise Untreatable(f"{excerpt(whole)} is not treated: it divides by what is assumed to be zero")
    parts = list(parts_of(entry))
    for inexact in (part for part in parts if isinstance(part, sympy.Float)):
        exact = str(sympy.nsimplify(inexact, rational=True))
        raise Untreatable(f"{inexact} is a floating-point number, which is not exact: write Rational({exact!r})")
    for derivative in (part for part in parts if isinstance(part, sympy.Derivative)):
        if not isinstance(derivative.expr, AppliedUndef):
            entry = entry.xreplace({derivative: derivative.doit()})
    return entry


def sides(relation: Any, what: str) -> Iterator[tuple[Any, Any]]:
    """The pairs that an equation, or an expression that is zero, sets equal, entry by entry.

    What SymPy finds false is said as 0 = 1. Raises `Untreatable` for inequalities and for numbers that are not zero.
    """
    if relation is sympy.true:
        return
    if relation is sympy.false:
        yield sympy.S.Zero, sympy.S.One
        return
    if isinstance(relation, sympy.Equality):
        left, right = opened(relation.lhs, what), opened(relation.rhs, what)
    elif isinstance(relation, Boolean) and not isinstance(relation, sympy.Expr):
        raise Untreatable(
            f"{what} is {excerpt(relation)}, which is no equation and no inequality: each condition stands in the list "
            "by itself"
        )
    else:
        left = opened(relation, what)
        if left.shape == (1, 1) and left.rows[0][0].is_Rational and left.rows[0][0] != 0:
            raise Untreatable(f"{what} is {relation}, which is not zero: write Eq(a, b) for an equation")
        right = Entries(tuple(tuple(sympy.S.Zero for _ in row) for row in left.rows), left.is_matrix)
    if left.shape != right.shape:
        raise Untreatable(f"{what} sets {left.size} equal to {right.size}")
    for one, other in zip(left.rows, right.rows, strict=True):
        yield from zip(one, other, strict=True)
