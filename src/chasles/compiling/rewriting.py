"""Functions that no step computes, in those that do where SymPy knows how: binomials by gamma, steps by conditions."""

from __future__ import annotations

from collections.abc import Callable, Iterable, Iterator
from typing import Any

import sympy

from chasles.compiling.angles import parts_of
from chasles.compiling.elementary import functions_by_class
from chasles.compiling.variables import Substitution, outermost
from chasles.lowering.builder import Builder


def _expanded(function: Any) -> Any:
    """In other functions; those of Bessel in sums of quotients, whose limits are looked for."""
    written = sympy.expand_func(function, deep=False)
    return written.expand() if isinstance(function, sympy.jn | sympy.yn) else written


_KNOWN = {*functions_by_class(Builder()), sympy.log, sympy.Piecewise}
_LOSING = (sympy.hyper, sympy.meijerg, sympy.lerchphi)
"""What SymPy writes these in cancels where it has a limit."""
_WAYS: tuple[Callable[[Any], Any], ...] = (
    lambda function: function.rewrite(sympy.Piecewise, deep=False),
    _expanded,
    lambda function: function.rewrite(sympy.gamma, deep=False),
    lambda function: function.rewrite(sympy.atan2, deep=False),
)
_DEPTH = 4
"""So often is looked at what comes out."""


def in_known_functions(expressions: Iterable[sympy.Basic]) -> list[Any]:
    """The expressions; what SymPy writes in no other functions is left."""
    found = list(expressions)
    if sympy.I in parts_of(sympy.Tuple(*found), ()):
        found = list(map(_without_i, found))
    for _ in range(_DEPTH):
        table = dict(_rewritten(outermost(found, _is_unknown)))
        if not table:
            break
        found = list(map(Substitution(table).of, found))
    return found


def _without_i(expression: Any) -> Any:
    """The expression without the imaginary unit where it drops out, as from an exponential of a rotation."""
    parts = sympy.expand_complex(expression)
    return expression if parts.has(sympy.I) else parts


def _is_unknown(node: object) -> bool:
    if isinstance(node, sympy.Contains):
        return True
    return isinstance(node, sympy.Function) and type(node) not in _KNOWN and not isinstance(node, _LOSING)


def _rewritten(functions: Iterable[Any]) -> Iterator[tuple[Any, Any]]:
    for function in functions:
        if isinstance(function, sympy.Contains):
            number, where = function.args
            if hasattr(where, "as_relational"):
                yield function, where.as_relational(number)
        elif not function.is_number:
            found = (way(function) for way in _WAYS)
            written = next((other for other in found if not other.has(type(function))), None)
            if written is not None:
                yield function, written
