"""Which variable of an expression is which entry of an input? The one of its name, whatever is assumed of either.

A variable is what has a value of its own: a symbol, a function applied to anything, a derivative of such a function, an
entry of an array. Derivatives are variables beside the function: what is no input is not derived from one that is.
"""

from __future__ import annotations

from collections.abc import Callable, Container, Iterable, Mapping
from operator import is_
from typing import Any

import sympy
from sympy.concrete.expr_with_limits import ExprWithLimits
from sympy.core.function import AppliedUndef
from sympy.matrices.expressions.matexpr import MatrixElement
from sympy.polys.rootoftools import RootOf

from chasles.compiling.identifiers import name_of_group
from chasles.compiling.scalars import shown
from chasles.lowering.refusal import LoweringError

_KINDS = (sympy.Symbol, sympy.Derivative, AppliedUndef, sympy.Indexed)
_BINDING = (ExprWithLimits, sympy.Lambda, sympy.Limit, sympy.Subs, RootOf, sympy.RootSum)
HELD = (sympy.sin, sympy.cos, sympy.exp, sympy.log)
_MATRICES = (sympy.MatrixExpr, sympy.MatrixBase)


def is_variable(value: object) -> bool:
    """Whether it is a symbol, an entry of an array, an unknown function's value or a derivative of one."""
    if isinstance(value, sympy.Derivative):
        return isinstance(value.expr, AppliedUndef)
    return isinstance(value, (*_KINDS, MatrixElement))


def correspondence(
    expressions: Iterable[sympy.Basic], known: Mapping[sympy.Basic, sympy.Basic]
) -> dict[sympy.Basic, sympy.Basic]:
    """What replaces each variable in the expressions: what replaces the `known` one that it is, or whose name it has.

    Raises `LoweringError` with all variables that are not known, and for two that differ in their assumptions where the
    known ones do not.
    """
    named: dict[object, list[sympy.Basic]] = {}
    for variable in known:
        named.setdefault(_key(variable), []).append(variable)
    found: dict[sympy.Basic, sympy.Basic] = {}
    owners: dict[sympy.Basic, sympy.Basic] = {}
    strays: dict[sympy.Basic, sympy.Basic] = {}
    seen: set[sympy.Basic] = set()
    for expression in expressions:
        for variable in variables_of(expression, known, seen):
            same = [variable] if variable in known else named.get(_key(variable), [])
            if not same:
                strays.setdefault(_whole(variable, known), expression)
                continue
            if len(same) > 1 or owners.setdefault(same[0], variable) != variable:
                raise LoweringError(
                    f"{variable} is the name of variables that differ only in their assumptions, and the inputs do not "
                    "say which is meant: make them one, or give each as an input of its own"
                )
            found[variable] = known[same[0]]
    if strays:
        raise LoweringError(_missing(strays))
    return found


def variables_of(expression: sympy.Basic, known: Container[sympy.Basic], seen: set[sympy.Basic]) -> list[sympy.Basic]:
    """The variables in an expression that are not `seen` yet, each once, and nothing inside known ones."""
    waiting, found = [expression], []
    while waiting:
        node = waiting.pop()
        if node in seen or not isinstance(node, sympy.Basic | sympy.MatrixBase):
            continue
        seen.add(node)
        if node in known or is_variable(node) or isinstance(node, sympy.MatrixSymbol):
            found.append(node)
        elif isinstance(node, _BINDING):
            waiting.extend(node.free_symbols)
        else:
            waiting.extend(node.args)
    return found


def carried_out(expressions: Iterable[sympy.Basic]) -> list[sympy.Basic]:
    """The expressions without derivatives of what is written out, values at a place, and sums of so many terms."""
    given = list(expressions)
    left = {node: node.doit(integrals=False) for node in outermost(given, _is_left)}
    return [expression.xreplace(left) for expression in given] if left else given


def outermost(expressions: Iterable[sympy.Basic], wanted: Callable[[Any], bool]) -> list[Any]:
    """The parts of expressions that are wanted, each once, and nothing inside them or inside variables."""
    waiting, seen, found = list(expressions), set[object](), []
    while waiting:
        node = waiting.pop()
        if node not in seen and isinstance(node, sympy.Basic | sympy.MatrixBase) and not is_variable(node):
            seen.add(node)
            if wanted(node):
                found.append(node)
            else:
                waiting.extend(node.args)
    return found


def _is_left(node: object) -> bool:
    if isinstance(node, sympy.Sum | sympy.Product):
        return all(len(limit) == 3 and (limit[2] - limit[1]).is_Integer for limit in node.limits)
    return isinstance(node, sympy.Derivative | sympy.Subs)


class Substitution:
    """Replaces variables in expressions; a part that occurs again is replaced once."""

    def __init__(self, table: Mapping[sympy.Basic, sympy.Basic]) -> None:
        self._table = dict(table)
        self._done: dict[sympy.Basic, Any] = dict(table)
        self._matrices = False

    def learn(self, table: Mapping[Any, Any]) -> Substitution:
        """The same, which replaces more: what is in no expression so far."""
        self._table |= table
        self._done |= table
        return self

    def of(self, expression: sympy.Basic) -> Any:
        """The expression without its variables. Raises `LoweringError` where it has no value for real ones."""
        try:
            found = self._replaced(expression)
        except (TypeError, ValueError) as error:
            raise LoweringError(f"{shown(expression)} has no value for real inputs: {error}") from None
        return found.doit() if self._matrices and found.has(*_MATRICES) else found

    def _replaced(self, node: Any) -> Any:
        found = self._done.get(node)
        if found is None:
            self._matrices |= isinstance(node, _MATRICES)
            if isinstance(node, (sympy.MatrixBase, *_BINDING)):
                found = node.xreplace(self._table)
            else:
                args = []
                for part in node.args:
                    args.append(self._replaced(part) if isinstance(part, sympy.Basic) else part)
                # Functions of the same by another name are not evaluated again: SymPy would ask what it knows for long.
                held = {"evaluate": False} if isinstance(node, HELD) else {}
                found = node if all(map(is_, args, node.args)) else node.func(*args, **held)
            self._done[node] = found
        self._matrices |= isinstance(found, _MATRICES)
        return found


def _key(variable: sympy.Basic) -> object:
    """What variables that differ in assumptions alone have in common; a dummy is like no other."""
    if isinstance(variable, sympy.Dummy) or not isinstance(variable, _KINDS):
        return variable
    return next(kind for kind in _KINDS if isinstance(variable, kind)), str(variable)


def _whole(variable: sympy.Basic, known: Container[sympy.Basic]) -> sympy.Basic:
    """What is to be an input for the variable to have a value. Raises `LoweringError` where it is one already."""
    if not isinstance(variable, MatrixElement):
        return variable
    if variable.parent in known:
        raise LoweringError(f"{variable} is no entry of {variable.parent}: give its row and column as numbers")
    return variable.parent


def _missing(strays: Mapping[sympy.Basic, sympy.Basic]) -> str:
    """All that is no input, and how to make it one."""
    names = sorted(map(str, strays))
    if len(names) == 1:
        [expression] = strays.values()
        return f"{names[0]} in {shown(expression)} is not among the inputs: add it, as in [..., {names[0]}]"
    groups: dict[int, list[sympy.Basic]] = {}
    for variable in sorted(strays, key=str):
        groups.setdefault(_order(variable), []).append(variable)
    said = [
        f"{(name_of_group(group) if order >= 0 else 'parameters') or 'values'!r}: [{', '.join(map(str, group))}]"
        for order, group in sorted(groups.items())
    ]
    return f"{', '.join(names)} are not among the inputs: add them, as in {{..., {', '.join(said)}}}"


def _order(variable: sympy.Basic) -> int:
    """How often a function is derived; -1 for what is no function."""
    if isinstance(variable, sympy.Derivative):
        return int(variable.derivative_count)
    return 0 if isinstance(variable, AppliedUndef) else -1
