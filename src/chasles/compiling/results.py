"""What comes out? Scalars, vectors and matrices of expressions in the symbols of the inputs."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass
from typing import Any

import numpy
import sympy

from chasles.compiling.inputs import Input, core_shape, entries_of_matrix, require_name, require_order
from chasles.compiling.inverses import without_inverses
from chasles.compiling.scalars import shown
from chasles.compiling.variables import Substitution, carried_out, correspondence
from chasles.lowering.refusal import LoweringError


@dataclass(frozen=True, slots=True)
class ResultEntries:
    """A result: its name, its core shape and its entries, row-major."""

    name: str
    shape: tuple[int, ...]
    entries: tuple[sympy.Expr, ...]


def outputs_of(expression: Any, given: Sequence[Input], names: Any) -> tuple[ResultEntries, ...]:
    """The results, in symbols that stand for entries of inputs; one for each item of a list or tuple.

    Raises `LoweringError` for a free symbol that is no input, and where the names are not as many as the results.
    """
    several = isinstance(expression, list | tuple | sympy.Tuple)
    values = [_value(item) for item in (expression if several else (expression,))]
    if not values:
        raise LoweringError("there is nothing to compile: the list of expressions is empty")
    called = _names(names, len(values))
    known: dict[sympy.Basic, sympy.Basic] = {}
    for item in given:
        known |= dict(zip(item.entries, item.symbols, strict=True))
        if item.whole is not None:
            known[item.whole] = sympy.ImmutableDenseMatrix(*item.whole.shape, item.symbols)
    parts = [_entries(value) for value in values]
    standing = Substitution(correspondence((entry for _, entries in parts for entry in entries), known))
    return tuple(
        ResultEntries(name, shape, tuple(map(standing.of, entries)))
        for name, (shape, entries) in zip(called, parts, strict=True)
    )


def _names(names: Any, count: int) -> tuple[str, ...]:
    if names is None:
        return ("result",) if count == 1 else tuple(f"result_{k}" for k in range(1, count + 1))
    require_order(names, "outputs")
    found = (names,) if isinstance(names, str) else tuple(names)
    if len(found) != count:
        raise LoweringError(f"outputs names {len(found)} results, and there are {count} expressions")
    if len(set(found)) != count:
        raise LoweringError("two results have one name: give each its own in outputs")
    return tuple(require_name(name, "the output") for name in found)


def _value(item: Any) -> Any:
    """The expression as SymPy holds it: a scalar, or a matrix."""
    if isinstance(item, str):
        raise LoweringError(f"the expression {item!r} is a text; give it as SymPy expression")
    if isinstance(item, list | numpy.ndarray):
        item = _array(item)
    if isinstance(item, sympy.NDimArray):
        if item.rank() > 2:
            raise LoweringError(f"an output has {item.rank()} axes; scalars, vectors and matrices are computed")
        return sympy.Matrix(item) if item.rank() else item[()]
    try:
        value = sympy.sympify(item, strict=True)
    except sympy.SympifyError:
        if hasattr(item, "to_matrix"):
            raise LoweringError(f"{shown(item)} has components in a frame: give them, as .to_matrix(frame)") from None
        raise LoweringError(f"{item!r} is no SymPy expression") from None
    value = value.as_expr() if isinstance(value, sympy.Poly) else value
    if not isinstance(value, sympy.Expr | sympy.MatrixBase | sympy.MatrixExpr | sympy.logic.boolalg.Boolean):
        raise LoweringError(f"{shown(value)} is no scalar and no matrix ({type(value).__name__})")
    return value


def _array(item: Any) -> sympy.NDimArray:
    """Nested lists, or an array of NumPy, as an array of expressions."""
    leaves = numpy.array(item, dtype=object)
    values = [None if isinstance(leaf, list) else _value(leaf) for leaf in leaves.flat]
    if not all(isinstance(value, sympy.Expr) for value in values):
        raise LoweringError(f"{item!r} is no array of expressions")
    return sympy.Array(values, leaves.shape)


def _entries(value: Any) -> tuple[tuple[int, ...], tuple[sympy.Expr, ...]]:
    """The core shape of an expression, and its entries."""
    if not isinstance(value, sympy.MatrixBase | sympy.MatrixExpr):
        return (), tuple(carried_out([without_inverses(value)]))
    value = entries_of_matrix(value) if isinstance(value, sympy.MatrixExpr) else value
    return core_shape(value.shape), tuple(carried_out(map(sympy.sympify, value)))
