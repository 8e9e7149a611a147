"""Symbols between bounds, or more than something else, said by new symbols that may have any value of a sign."""

from __future__ import annotations

from functools import partial
from typing import Any

import sympy
from sympy.core.function import AppliedUndef
from sympy.functions.elementary.trigonometric import InverseTrigonometricFunction

from chasles.checker.expressions.bounded_angles import RIGHT, Fresh, between, is_halved, ratio
from chasles.checker.expressions.readings import CIRCULAR
from chasles.checker.expressions.switches import visible_signs
from chasles.from_sympy.atoms import assumed_of
from chasles.from_sympy.complex_symbols import expressions_in
from chasles.from_sympy.decimals import each_replaced, with_values
from chasles.from_sympy.divisors import lost_divisors
from chasles.from_sympy.monotone import is_whole
from chasles.from_sympy.opening import atoms_of, excerpt
from chasles.problems.variables import Untreatable

COMPARED = sympy.Gt, sympy.Ge, sympy.Lt, sympy.Le
STRICT = sympy.Gt | sympy.Lt
Said = tuple[Any, ...]
"""Both sides, the list of what is given, and the list of what does not vanish."""
End = tuple[Any, bool, Any]
"""What something is compared with, whether it is not equal to that, and the inequality that says so."""


def with_angle(said: Said, symbol: Any, by_sine: bool = False) -> Said:
    """What is said, with an angle of any tangent, sine or direction for a symbol between two multiples of pi.

    If it is said `by_sine`, that one is between neither of which it is, and not a tangent.
    """
    ends = _ends(said, symbol)
    if ends is None or not all((end / sympy.pi).is_Rational for end, _, _ in ends):
        return said
    (low, after, _), (high, before, _) = ends
    if high <= low:
        return said
    part = _part(said, symbol)
    said_by = _by_sine if by_sine else between
    value = said_by(low * part, high * part, after, before, partial(_fresh, said))
    if value is None or (is_halved(value) and _has_arcs(said, symbol)):
        return said
    value = value / part
    bounded = sympy.Dummy(positive=after or None, nonnegative=True) if low == 0 else sympy.Dummy(real=True)
    return _defined(said, symbol, value, ends) if _may_be(symbol, bounded, said) else said


def _by_sine(low: Any, high: Any, after: bool, before: bool, fresh: Fresh) -> Any:
    """An expression for all angles between two others in one half turn in which sines rise; None if it is no other."""
    middle = sympy.floor(high / RIGHT) * RIGHT - (RIGHT if (high / RIGHT).is_integer else 0)
    if not (after and before) or low < middle - RIGHT:
        return None
    return middle + sympy.asin(ratio(sympy.sin(low - middle), sympy.sin(high - middle), after, before, fresh))


def _has_arcs(said: Said, symbol: Any) -> bool:
    """Whether an inverse function has a symbol in it: SymPy comes to no end with the roots of what is halved there."""
    return any(e.has(symbol) for each in expressions_in(said) for e in each.atoms(InverseTrigonometricFunction))


def _part(said: Said, symbol: Any) -> Any:
    """The half of a symbol if that is an angle, of which a sine or a tangent of the whole does not tell the sign."""
    angles = (each.args[0] for e in expressions_in(said) for each in e.atoms(*CIRCULAR))
    halves = any(angle.coeff(symbol).is_Rational and angle.coeff(symbol).q % 2 == 0 for angle in angles)
    return sympy.S.Half if halves else sympy.S.One


def with_ratio(said: Said, symbol: Any, name: str) -> Said | None:
    """What is said, with (a + b d)/(1 + d) for a symbol between a and b; None for others, or if it may not be that."""
    ends = _ends(said, symbol)
    if ends is None:
        return None
    (low, after, _), (high, before, _) = ends
    if not (high - low).is_positive:
        return None
    value = ratio(low, high, after, before, partial(_fresh, said), name)
    return _defined(said, symbol, value, ends) if _may_be(symbol, value, said) else None


def _ends(said: Said, symbol: Any) -> tuple[End, End] | None:
    """Between what a symbol is said to be; None unless there is one end below it and one above it."""
    compared = [item for item in said[2] if isinstance(item, COMPARED)]
    above = [(item.lts, isinstance(item, STRICT), item) for item in compared if item.gts == symbol]
    below = [(item.gts, isinstance(item, STRICT), item) for item in compared if item.lts == symbol]
    if not above and symbol.is_nonnegative:
        above = [(sympy.S.Zero, bool(symbol.is_positive), None)]
    if len(above) != 1 or len(below) != 1 or any(end.has(symbol) for end, _, _ in (*above, *below)):
        return None
    return above[0], below[0]


def _defined(said: Said, symbol: Any, value: Any, ends: tuple[End, ...]) -> Said:
    """What is said, with the value of a symbol instead of the inequalities that it satisfies by itself."""
    stated = [item for item in said[2] if all(item is not end for _, _, end in ends)]
    put = with_values((*said[:2], stated, said[3]), {symbol: value})
    new = value.free_symbols - {e for other in expressions_in(said) for e in other.free_symbols}
    lhs, rhs, given, nonzero = (each_replaced(each, lambda e: {e: _with_signs_seen(e, new)}) for each in put)
    lost = lost_divisors((*said[:2], stated), (lhs, rhs, given), {symbol: value})
    return lhs, rhs, [sympy.Eq(symbol, value, evaluate=False), *given], [*nonzero, *lost]


def _with_signs_seen(e: Any, new: set[Any]) -> Any:
    """The expression with products where signs of new symbols matter: in divisors, radicands and functions.

    Functions of a multiple of an inverse function are said by that of the whole.
    """
    if not e.args or not e.free_symbols & new:
        return e
    if type(e) in CIRCULAR and isinstance(e.args[0].as_coeff_Mul()[1], sympy.atan):
        e = sympy.together(sympy.expand_trig(e))
    power = e.is_Pow and e.exp.is_Rational and not (e.exp.is_Integer and e.exp > 0)
    if power or (isinstance(e, sympy.Function) and len(e.args) == 1 and type(e) not in CIRCULAR):
        inside = sympy.factor(sympy.together(e.args[0]))
        signs = (visible_signs(part) for part in sympy.Mul.make_args(inside) if part.free_symbols)
        e = e.func(inside, *e.args[1:]) if any(len(each) < 3 for each in signs) else e
    return e.func(*(_with_signs_seen(part, new) for part in e.args)) if e.args else e


def with_excess(said: Said, item: Any, name: str) -> Said:
    """What is said, with an equation for one of the inequalities, in which the excess has a name."""
    more, less = item.gts, item.lts
    excess = _excess(item, name, said)
    for atom in sorted(atoms_of(more - less), key=str):
        slope = sympy.diff(more - less, atom)
        if slope.is_nonzero and not slope.has(atom):
            value = sympy.expand(atom + (excess - more + less) / slope)
            if not value.has(atom.expr if isinstance(atom, sympy.Derivative) else atom) and _may_be(atom, value, said):
                return _defined(said, atom, value, ((more, True, item),))
    equation = sympy.Eq(more, less + excess, evaluate=False)
    return (*said[:2], [equation, *(e for e in said[2] if e is not item)], said[3])


def _may_be(symbol: Any, value: Any, said: Said) -> bool:
    """Whether what is assumed of a symbol is seen of a value, and no function is said to depend on it."""
    seen = all(getattr(value, f"is_{kind}") is known for kind, known in assumed_of(symbol).items())
    calls = (call for e in expressions_in(said) for call in e.atoms(AppliedUndef))
    return seen and not any(symbol in call.args for call in calls)


def _excess(item: Any, name: str, said: Said) -> Any:
    """A new positive or nonnegative symbol, an integer between integers, or a function if functions are compared."""
    calls = {call.args for call in item.atoms(AppliedUndef)}
    if len(calls) > 1:
        raise Untreatable(f"{excerpt(item)} is not treated: it compares functions of different variables")
    kind = {"positive" if isinstance(item, STRICT) else "nonnegative": True}
    kind |= {"integer": True} if is_whole(sympy.expand(item.gts - item.lts)) else {}
    symbol = _fresh(said, name, **kind)
    return sympy.Function(symbol.name, **kind)(*calls.pop()) if calls else symbol


def _fresh(said: Said, name: str, **assumed: bool) -> Any:
    """A symbol with a name that nothing has."""
    taken = {atom.name for e in expressions_in(said) for atom in (*e.free_symbols, *e.atoms(AppliedUndef))}
    while name in taken:
        name += "_"
    return sympy.Symbol(name, real=True, **assumed)
