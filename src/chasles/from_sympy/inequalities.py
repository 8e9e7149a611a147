"""Inequalities that are given, as equations with new symbols that may have any value, or any of a sign."""

from __future__ import annotations

from collections.abc import Iterator
from functools import partial
from typing import Any

import sympy
from sympy.core.function import AppliedUndef

from chasles.from_sympy.angles_between import between
from chasles.from_sympy.atoms import ASSUMPTIONS
from chasles.from_sympy.cases import eliminable
from chasles.from_sympy.complex_symbols import expressions_in
from chasles.from_sympy.decimals import with_values
from chasles.from_sympy.opening import excerpt
from chasles.from_sympy.side_conditions import listed
from chasles.problems.variables import Untreatable

SIGNS = {sympy.Gt: "positive", sympy.Ge: "nonnegative", sympy.Lt: "negative", sympy.Le: "nonpositive"}
COMPARED = tuple(SIGNS)
STRICT = sympy.Gt | sympy.Lt
Said = tuple[Any, ...]
"""Both sides, the list of what is given, and the list of what does not vanish."""


def without_inequalities(said: Said) -> Said:
    """What was said, with equations for what is given as `a > b`, and `a != b` as what does not vanish.

    A symbol or function that is compared with zero is read with that assumption. One between two multiples of pi is
    an angle whose tangent, sine or direction may have any value. Else a = b + d_1 for a positive d_1, and where that
    defines a symbol, everything is said by d_1. Inequalities of functions of time hold at all times.

    Raises `Untreatable` for an inequality between functions of different variables, or with what is infinite.
    """
    items = [part for _, item in listed(said[2], "given") for part in _plain(item) if part is not sympy.true]
    apart = [item for item in items if isinstance(item, sympy.Ne)]
    if not apart and not any(isinstance(item, COMPARED) for item in items):
        return said
    stated = [item for item in items if item not in apart]
    said = (*said[:2], stated, [*(item for _, item in listed(said[3], "nonzero")), *apart])
    for symbol in sorted({s for item in stated if isinstance(item, COMPARED) for s in item.free_symbols}, key=str):
        said = _with_angle(said, symbol)
    while signed := next((values for item in said[2] if (values := _signed(item))), None):
        said = with_values(said, signed)
    number = 0
    while compared := [item for item in said[2] if isinstance(item, COMPARED)]:
        number += 1
        said = _with_excess(said, compared[0], number)
    return (*said[:2], [item for item in said[2] if item is not sympy.true], said[3])


def _plain(item: Any) -> Iterator[Any]:
    """What is said of a size, as two inequalities; of integers, one is less than the other one by one or more."""
    if not isinstance(item, COMPARED):
        yield item
    elif item.has(sympy.oo, -sympy.oo, sympy.zoo, sympy.nan):
        raise Untreatable(f"{excerpt(item)} is not treated: it compares with what is infinite")
    elif isinstance(item.lts, sympy.Abs) and not item.lts.has(sympy.I):
        less = sympy.Lt if isinstance(item, STRICT) else sympy.Le
        yield from _plain(less(item.lts.args[0], item.gts))
        yield from _plain(less(-item.gts, item.lts.args[0]))
    elif isinstance(item, STRICT) and item.lts.is_integer and item.gts.is_integer:
        yield item.lts <= item.gts - 1 if item.gts.is_number else item.gts >= item.lts + 1
    else:
        yield item


def _signed(item: Any) -> dict[Any, Any]:
    """The symbol or function that is compared with zero, with that sign in its assumptions."""
    kind = SIGNS.get(type(item))
    if kind is None:
        return {}
    e, other = item.args
    if e.is_zero:
        e, other, kind = other, e, SIGNS[type(item.reversed)]
    if not other.is_zero or not isinstance(e, sympy.Symbol | AppliedUndef):
        return {}
    assumed = {**e.assumptions0, kind: True}
    return {e: sympy.Symbol(e.name, **assumed) if e.is_Symbol else sympy.Function(e.name, **assumed)(*e.args)}


def _with_angle(said: Said, symbol: Any) -> Said:
    """What is said, with an angle of any tangent, sine or direction for a symbol between two multiples of pi."""
    compared = [item for item in said[2] if isinstance(item, COMPARED)]
    above = [(item.lts, isinstance(item, STRICT), item) for item in compared if item.gts == symbol]
    below = [(item.gts, isinstance(item, STRICT), item) for item in compared if item.lts == symbol]
    if not above and symbol.is_nonnegative:
        above = [(sympy.S.Zero, bool(symbol.is_positive), None)]
    ends = [end for end in (*above, *below) if (end[0] / sympy.pi).is_Rational]
    if len(above) != 1 or len(below) != 1 or len(ends) != 2:
        return said
    (low, after, _), (high, before, _) = ends
    other = sympy.Dummy()
    if symbol.is_nonnegative:
        other = sympy.Dummy(positive=True) if after and low == 0 else sympy.Dummy(nonnegative=True)
    if high <= low or not _is_free(symbol, other, said):
        return said
    value = between(low, high, after, before, partial(_fresh, said))
    if value is None:
        return said
    stated = [item for item in said[2] if item not in (ends[0][2], ends[1][2])]
    lhs, rhs, given, nonzero = with_values((*said[:2], stated, said[3]), {symbol: value})
    return lhs, rhs, [sympy.Eq(symbol, value, evaluate=False), *given], nonzero


def _with_excess(said: Said, item: Any, number: int) -> Said:
    """What is said, with an equation for one of the inequalities; the `number` names the excess."""
    lhs, rhs, given, nonzero = said
    others: Said = (lhs, rhs, [e for e in given if e is not item], nonzero)
    more, less = item.gts, item.lts
    excess = _excess(item, f"d_{number}", said)
    equation = sympy.Eq(more, less + excess, evaluate=False)
    defined = eliminable(more - less, expressions_in(said))
    if defined is not None and _is_free(defined, sympy.Dummy(), said):
        value = sympy.expand(defined + (excess - more + less) / sympy.diff(more - less, defined))
        others = with_values(others, {defined: value})
        equation = sympy.Eq(defined, value, evaluate=False)
    lhs, rhs, given, nonzero = others
    return lhs, rhs, [equation, *given], nonzero


def _is_free(symbol: Any, other: Any, said: Said) -> bool:
    """Whether a symbol may have the values of the other one, and no function is said to depend on it."""
    same = all(getattr(symbol, f"is_{kind}") is getattr(other, f"is_{kind}") for kind in ASSUMPTIONS)
    return same and not any(call.has(symbol) for e in expressions_in(said) for call in e.atoms(AppliedUndef))


def _excess(item: Any, name: str, said: Said) -> Any:
    """A new positive or nonnegative symbol, or a function if functions are compared."""
    calls = {call.args for call in item.atoms(AppliedUndef)}
    if len(calls) > 1:
        raise Untreatable(f"{excerpt(item)} is not treated: it compares functions of different variables")
    kind = {"positive" if isinstance(item, STRICT) else "nonnegative": True}
    symbol = _fresh(said, name, **kind)
    return sympy.Function(symbol.name, **kind)(*calls.pop()) if calls else symbol


def _fresh(said: Said, name: str, **assumed: bool) -> Any:
    """A symbol with a name that nothing has."""
    taken = {atom.name for e in expressions_in(said) for atom in (*e.free_symbols, *e.atoms(AppliedUndef))}
    while name in taken:
        name += "_"
    return sympy.Symbol(name, real=True, **assumed)
