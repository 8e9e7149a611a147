"""What was asked: the entries of both sides, the equations that are given, and what does not vanish."""

from __future__ import annotations

from collections.abc import Iterator, Mapping
from contextlib import suppress
from dataclasses import dataclass
from typing import Any

import sympy
from sympy.core.function import AppliedUndef
from sympy.logic.boolalg import Boolean
from sympy.matrices import MatrixBase, MatrixExpr

from chasles.checker.expressions.complexes import OF_COMPLEX
from chasles.checker.expressions.defined_functions import BY_OTHERS
from chasles.checker.expressions.enclosed import EnclosedValues
from chasles.checker.expressions.quantities import atoms_of, rebuilt, require_real, with_values
from chasles.checker.expressions.unevaluated import explicit, hidden_in, written_out
from chasles.checker.sparse import Rejected

Entries = dict[tuple[int, int], Any]


@dataclass(frozen=True, slots=True)
class GivenEquation:
    """An equation that is given, entry by entry, as the question spells it."""

    text: str
    pairs: dict[tuple[int, int], tuple[Any, Any]]

    @property
    def functions(self) -> set[Any]:
        """The functions of which it speaks."""
        return {call for pair in self.pairs.values() for side in pair for call in side.atoms(AppliedUndef)}


class Asked:
    """A question on SymPy expressions; raises `Rejected` if it is none.

    `hidden` has to be defined, too. `real` says of what it takes conjugates or parts that nothing says to be real, and
    that is read so.
    """

    def __init__(self, lhs: Any, rhs: Any, given: Any, nonzero: Any) -> None:
        self.hidden: list[Any] = []
        self.left, self.right = self._entries(lhs), self._entries(rhs)
        if self.left.keys() != self.right.keys():
            raise Rejected("the two sides have different shapes")
        self.given = [self._given(item, what) for what, item in listed(given, "given")]
        self.nonzero = [self._nonzero(item) for _, item in listed(nonzero, "nonzero") if item is not sympy.true]
        for atom in {atom for expression in self.expressions for atom in atoms_of(expression)}:
            require_real(atom)
        calls = {call for e in self.expressions for call in e.atoms(*OF_COMPLEX)}
        self.real = sorted({f"{e} is real" for call in calls for e in atoms_of(call) if e.is_real is None})

    @property
    def expressions(self) -> Iterator[Any]:
        """Everything of which the question speaks."""
        yield from (*self.left.values(), *self.right.values(), *self.nonzero, *self.hidden)
        yield from (side for item in self.given for pair in item.pairs.values() for side in pair)

    def _entries(self, value: Any) -> Entries:
        """The entries of a scalar or a matrix, by row and column counted from zero."""
        value = sympy.sympify(value, strict=True)
        self.hidden += map(valued, hidden_in(value))
        value = explicit(value) if isinstance(value, MatrixExpr) else value
        if isinstance(value, MatrixBase):
            return {(i, j): valued(value[i, j]) for i in range(value.rows) for j in range(value.cols)}
        if not isinstance(value, sympy.Expr):
            raise Rejected(f"{value} is no scalar and no matrix")
        return {(0, 0): valued(value)}

    def _given(self, item: Any, what: str) -> GivenEquation:
        """An equation, an expression or a matrix that is zero; what is true on its face says nothing."""
        if item is sympy.true:
            return GivenEquation("", {})
        equation = isinstance(item, sympy.Equality)
        if not equation and isinstance(item, bool | Boolean) and not isinstance(item, sympy.Expr):
            raise Rejected(f"{what} is no equation")
        one, other = (item.lhs, item.rhs) if equation else (item, 0)
        left = self._entries(one)
        right = self._entries(other) if equation else dict.fromkeys(left, sympy.S.Zero)
        if left.keys() != right.keys():
            raise Rejected(f"{what} sets equal what has different shapes")
        text = f"{one} = {other}" if isinstance(one, sympy.Expr) else what
        return GivenEquation(text, {key: (left[key], right[key]) for key in left})

    def _nonzero(self, item: Any) -> Any:
        (entry,) = self._entries(item.lhs - item.rhs if isinstance(item, sympy.Unequality) else item).values()
        return entry


def listed(conditions: Any, name: str) -> Iterator[tuple[str, Any]]:
    """Conditions that are handed in as one, as a list or as values by symbol, each with its place."""
    if isinstance(conditions, Mapping | sympy.Dict):
        items = [(f"{name}[{key}]", sympy.Eq(key, value, evaluate=False)) for key, value in conditions.items()]
    elif isinstance(conditions, sympy.Basic | MatrixBase) and not isinstance(conditions, sympy.Tuple):
        items = [(name, conditions)]
    else:
        ordered = sorted(conditions, key=str) if isinstance(conditions, set | frozenset) else conditions
        items = [(f"{name}[{place}]", item) for place, item in enumerate(ordered)]
    for what, item in items:
        for part in sorted(item.args, key=str) if isinstance(item, sympy.And) else (item,):
            yield what, part


def valued(e: Any) -> Any:
    """The expression written out, with zero for what SymPy is told to be zero, and mixed derivatives in one order."""
    e = by_definition(with_values(e, {rate: rate.canonical for rate in e.atoms(sympy.Derivative)}))
    zeros = {part: sympy.S.Zero for part in e.atoms(sympy.Symbol, AppliedUndef) if part.is_zero}
    value = with_values(e, zeros) if zeros else e
    met = {with_values(part, zeros) for part in e.atoms(sympy.Pow, sympy.Function)} if zeros else set()
    if any(part.args and part.free_symbols for part in met - value.atoms(sympy.Pow, sympy.Function)):
        raise Rejected(f"{e} is multiplied by zero, and may not be defined")
    return by_definition(written_out(value))


def by_definition(e: Any) -> Any:
    """What others define said by these, and functions of numbers with SymPy's values, unless seen to be wrong."""
    if not e.has(*BY_OTHERS, sympy.Function):
        return e
    parts, whole = tuple(map(by_definition, e.args)), e
    if parts != e.args or (e.is_Function and e.is_number):
        whole = rebuilt(e, parts)
        if e.is_Function and e.is_number and not isinstance(whole, e.func):
            plain, values = e.func(*parts, evaluate=False), EnclosedValues({})
            with suppress(Rejected):
                whole = whole if values(plain).meets(values(whole)) else plain
    rule = BY_OTHERS.get(type(whole))
    return rule(whole) if rule else whole
