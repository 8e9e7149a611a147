"""Inequalities that are given, as equations with new symbols that may have any value, or any of a sign."""

from __future__ import annotations

from collections.abc import Iterator
from functools import partial
from itertools import combinations
from typing import Any

import sympy
from sympy.core.function import AppliedUndef
from sympy.functions.elementary.trigonometric import InverseTrigonometricFunction

from chasles.checker.expressions.bounded_angles import between, is_halved, ratio
from chasles.checker.expressions.quantities import is_atom
from chasles.checker.expressions.readings import CIRCULAR
from chasles.checker.expressions.switches import visible_signs
from chasles.from_sympy.atoms import assumed_of
from chasles.from_sympy.complex_symbols import expressions_in
from chasles.from_sympy.decimals import each_replaced, with_values
from chasles.from_sympy.divisors import lost_divisors
from chasles.from_sympy.monotone import is_whole, of_arguments
from chasles.from_sympy.opening import atoms_of, excerpt
from chasles.from_sympy.side_conditions import listed
from chasles.problems.variables import Untreatable

SIGNS = {sympy.Gt: "positive", sympy.Ge: "nonnegative", sympy.Lt: "negative", sympy.Le: "nonpositive"}
COMPARED = tuple(SIGNS)
STRICT = sympy.Gt | sympy.Lt
Said = tuple[Any, ...]
"""Both sides, the list of what is given, and the list of what does not vanish."""
End = tuple[Any, bool, Any]
"""What something is compared with, whether it is not equal to that, and the inequality that says so."""


def without_inequalities(said: Said, by_excess: bool = False) -> Said:
    """What was said, with equations for what is given as `a > b`, and `a != b` as what does not vanish.

    A symbol or function that is compared with zero is read with that assumption. One between two multiples of pi is
    an angle whose tangent, sine or direction may have any value; one between a and b is (a + b d_1)/(1 + d_1), or, if
    it may be both, a + (b - a) (1 + d_1)^2/(2 + 2 d_1^2). Else a = b + d_1 for a positive d_1, and where that defines a
    symbol, everything is said by d_1; `by_excess`, of what is between others, too. Inequalities of functions of time
    hold at all times.

    Raises `Untreatable` for an inequality between functions of different variables, or with what is infinite.
    """
    items = [part for _, item in listed(said[2], "given") for part in _plain(item) if part is not sympy.true]
    items = [item for item in items if not any(_follows(item, other) for other in items)]
    apart = [item for item in items if isinstance(item, sympy.Ne)]
    if not apart and not any(isinstance(item, COMPARED) for item in items):
        return said
    stated = _joined([item for item in items if item not in apart])
    said = *said[:2], stated, [*(item for _, item in listed(said[3], "nonzero")), *apart]
    compared = [item for item in stated if isinstance(item, COMPARED) and not by_excess]
    for symbol in sorted({s for item in compared for s in item.free_symbols}, key=str):
        said = _with_angle(said, symbol)
    while found := next((values for item in said[2] if (values := signed(item, by_excess))), None):
        put = with_values(said, found)
        said = (*put[:3], [*put[3], *lost_divisors(said[:3], put[:3], found)])
    number = 0
    while compared := [item for item in said[2] if isinstance(item, COMPARED)]:
        number += 1
        symbols = sorted({s for item in compared for s in (item.lts, item.gts) if s.is_Symbol}, key=str)
        ways = (_with_ratio(said, symbol, f"d_{number}") for symbol in symbols if not by_excess)
        said = next(filter(None, ways), ()) or _with_excess(said, compared[0], f"d_{number}")
    return (*said[:2], [item for item in said[2] if item is not sympy.true], said[3])


def definitions(said: Said, asked: Said) -> list[str]:
    """How the verdict says the equations by which something is said otherwise than it was, if it is spoken of."""
    known, before, now = (
        {atom for e in expressions_in(part) for atom in atoms_of(e)}
        for part in (said, (*said[:2], said[3]), (*asked[:2], asked[3]))
    )
    equations = (e for e in expressions_in(asked[2]) if isinstance(e, sympy.Eq) and is_atom(e.lhs))
    new = ((e, set(atoms_of(e.rhs)) - known) for e in equations)
    return [f"{e.lhs} = {e.rhs}" for e, atoms in new if atoms & now or (atoms and e.lhs in before)]


def _plain(item: Any) -> Iterator[Any]:
    """What is said of a size, as two inequalities; of integers, what it comes to with the nearest possible bound."""
    if not isinstance(item, COMPARED):
        yield item
    elif item.has(sympy.oo, -sympy.oo, sympy.zoo, sympy.nan):
        raise Untreatable(f"{excerpt(item)} is not treated: it compares with what is infinite")
    elif isinstance(item.lts, sympy.Abs) and not item.lts.has(sympy.I):
        less = sympy.Lt if isinstance(item, STRICT) else sympy.Le
        yield from _plain(less(item.lts.args[0], item.gts))
        yield from _plain(less(-item.gts, item.lts.args[0]))
    elif (other := of_arguments(item)) is not item:
        yield from _plain(other)
    else:
        yield _rounded(item)


def _rounded(item: Any) -> Any:
    """What an inequality between integers and rational numbers says: 2 n > 1 that 2 n >= 2, and n < 5/2 that n <= 2."""
    constant, rest = sympy.expand(item.gts - item.lts).as_coeff_Add()
    content, terms = rest.primitive()
    if not constant.is_Rational or not rest.free_symbols or not is_whole(terms):
        return item
    least = -constant / content
    more = content * ((sympy.floor(least) + 1 if isinstance(item, STRICT) else sympy.ceiling(least)) - least)
    if not more:
        return item
    return item.lts <= item.gts - more if item.gts.is_number else item.gts >= item.lts + more


def _joined(items: list[Any]) -> list[Any]:
    """The same, with an equation for two inequalities that say of two sides that neither is greater."""
    for one, other in combinations([item for item in items if isinstance(item, sympy.Ge | sympy.Le)], 2):
        if sympy.expand(one.gts - one.lts + other.gts - other.lts) == 0:
            rest = [item for item in items if item not in (one, other)]
            return _joined([*rest, sympy.Eq(one.gts, one.lts, evaluate=False)])
    return items


def _follows(item: Any, other: Any) -> bool:
    """Whether an inequality says less than another, which compares the same with a number that is closer."""
    if not (isinstance(item, COMPARED) and isinstance(other, COMPARED)):
        return False
    more = isinstance(other, STRICT) and not isinstance(item, STRICT)
    gaps = (item.gts == other.gts, other.lts - item.lts), (item.lts == other.lts, item.gts - other.gts)
    return any(same and gap.is_number and (gap.is_positive or (gap.is_zero and more)) for same, gap in gaps)


def signed(item: Any, above: bool = False) -> dict[Any, Any]:
    """The symbol or function that is compared with zero, and maybe `above`, with that sign in its assumptions."""
    kind = SIGNS.get(type(item))
    if kind is None:
        return {}
    e, other = item.args
    if e.is_zero:
        e, other, kind = other, e, SIGNS[type(item.reversed)]
    below = above and kind in ("negative", "nonpositive")
    if below or not other.is_zero or not isinstance(e, sympy.Symbol | AppliedUndef):
        return {}
    assumed = {**(e.assumptions0 if e.is_Symbol else assumed_of(e)), kind: True}
    return {e: sympy.Symbol(e.name, **assumed) if e.is_Symbol else sympy.Function(e.name, **assumed)(*e.args)}


def _with_angle(said: Said, symbol: Any) -> Said:
    """What is said, with an angle of any tangent, sine or direction for a symbol between two multiples of pi."""
    ends = _ends(said, symbol)
    if ends is None or not all((end / sympy.pi).is_Rational for end, _, _ in ends):
        return said
    (low, after, _), (high, before, _) = ends
    if high <= low:
        return said
    part = _part(said, symbol)
    value = between(low * part, high * part, after, before, partial(_fresh, said))
    if value is None or (is_halved(value) and _has_arcs(said, symbol)):
        return said
    value = value / part
    bounded = sympy.Dummy(positive=after or None, nonnegative=True) if low == 0 else sympy.Dummy(real=True)
    return _defined(said, symbol, value, ends) if _may_be(symbol, bounded, said) else said


def _has_arcs(said: Said, symbol: Any) -> bool:
    """Whether an inverse function has a symbol in it: SymPy comes to no end with the roots of what is halved there."""
    return any(e.has(symbol) for each in expressions_in(said) for e in each.atoms(InverseTrigonometricFunction))


def _part(said: Said, symbol: Any) -> Any:
    """The half of a symbol if that is an angle, of which a sine or a tangent of the whole does not tell the sign."""
    angles = (each.args[0] for e in expressions_in(said) for each in e.atoms(*CIRCULAR))
    halves = any(angle.coeff(symbol).is_Rational and angle.coeff(symbol).q % 2 == 0 for angle in angles)
    return sympy.S.Half if halves else sympy.S.One


def _with_ratio(said: Said, symbol: Any, name: str) -> Said | None:
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
    """The expression with products where signs of new symbols matter: in divisors, radicands and functions."""
    if not e.args or not e.free_symbols & new:
        return e
    power = e.is_Pow and e.exp.is_Rational and not (e.exp.is_Integer and e.exp > 0)
    if power or (isinstance(e, sympy.Function) and len(e.args) == 1 and type(e) not in CIRCULAR):
        inside = sympy.factor(sympy.together(e.args[0]))
        signs = (visible_signs(part) for part in sympy.Mul.make_args(inside) if part.free_symbols)
        e = e.func(inside, *e.args[1:]) if any(len(each) < 3 for each in signs) else e
    return e.func(*(_with_signs_seen(part, new) for part in e.args)) if e.args else e


def _with_excess(said: Said, item: Any, name: str) -> Said:
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
