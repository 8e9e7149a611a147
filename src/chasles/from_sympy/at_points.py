"""Expressions and derivatives at points, which SymPy writes as `Subs`."""

from __future__ import annotations

from typing import Any

import sympy
from sympy.core.function import Application, AppliedUndef

from chasles.from_sympy.calls import value_of
from chasles.from_sympy.complex_symbols import expressions_in
from chasles.from_sympy.decimals import each_replaced
from chasles.from_sympy.opening import excerpt
from chasles.problems.variables import Untreatable

SMOOTH = sympy.sin | sympy.cos | sympy.exp | AppliedUndef


def without_points(said: tuple[Any, ...]) -> tuple[Any, ...]:
    """What was said, with values put in; raises `Untreatable` where SymPy might cancel what a divisor is, or a kink."""
    if not any(e.has(sympy.Subs) for e in expressions_in(said)):
        return said
    return tuple(each_replaced(each, lambda e: {part: _put(part) for part in e.atoms(sympy.Subs)}) for each in said)


def _put(e: Any) -> Any:
    """The value of what is smooth; of other expressions, the same with other names; a function's value is as it is."""
    if value_of(e) is not None:
        return e
    parts = sympy.Tuple(e.expr, *e.point).atoms(sympy.Pow, Application)
    if all(isinstance(part, SMOOTH) or (part.is_Pow and part.exp.is_Integer and part.exp > 0) for part in parts):
        return e.doit()
    if all(value.is_Symbol for value in e.point) and not {*e.point} & e.expr.free_symbols:
        named = e.expr.xreplace(dict(zip(e.variables, e.point, strict=True)))
        if named.xreplace(dict(zip(e.point, e.variables, strict=True))) == e.expr:
            return named
    raise Untreatable(f"{excerpt(e)} is not treated: what it divides by may cancel, or it may have no derivative there")
