"""Signs by slopes: what is not negative at zero and does not fall is not negative after it, nor zero again.

All functions treated are analytic wherever they are real, and that is from zero on: one that is zero again is so
everywhere between, and so everywhere. Up to an end it is looked at piece by piece: in each an enclosure says the sign,
or the slope and the sign at one end of the piece do.
"""

from __future__ import annotations

from collections.abc import Iterator
from contextlib import suppress
from dataclasses import replace
from typing import TYPE_CHECKING, Any

import sympy

from chasles.checker.expressions.enclosed import EnclosedValues, sign_of_number
from chasles.checker.expressions.intervals import Enclosure
from chasles.checker.expressions.quantities import NUMBERS
from chasles.checker.expressions.switches import visible_signs
from chasles.checker.sparse import Rejected

if TYPE_CHECKING:
    from chasles.checker.expressions.cases import CheckedCase

ENTIRE = (
    sympy.Add, sympy.Mul, sympy.Pow, sympy.exp, sympy.sin, sympy.cos, sympy.sinh, sympy.cosh, sympy.tanh, sympy.sech,
    sympy.atan, sympy.asinh, sympy.erf,
)  # fmt: skip
SMOOTH = (*ENTIRE, sympy.tan, sympy.log, sympy.asin, sympy.acos, sympy.Symbol, sympy.NumberSymbol, sympy.Rational)
"""What has a derivative inside of an interval on which it has an enclosure."""
MOST_OPERATIONS = 60
MOST_HALVINGS, MOST_DERIVATIVES, BITS = 12, 6, 60
EVERY = frozenset((-1, 0, 1))


def by_slope(case: CheckedCase, e: Any, slopes: int) -> frozenset[int]:
    """The signs that an expression may have in a case, by at most so many derivatives."""
    free = [s for s in e.free_symbols if s.is_nonnegative and all(getattr(s, f"is_{kind}") is None for kind in NUMBERS)]
    for symbol in sorted(free, key=str) if slopes and e.count_ops() <= MOST_OPERATIONS else ():
        facts = tuple((known, sign) for known, sign in case.facts if _held_before(known, sign, symbol))
        before = replace(case, facts=facts)
        if not _is_smooth(before, e, symbol):
            continue
        start = before.signs(e.xreplace({symbol: sympy.S.Zero}), slopes - 1)
        rise = before.signs(sympy.cancel(e.diff(symbol)), slopes - 1) if len(start) < 3 else start
        if len(both := start | rise) == 1 or both in ({0, 1}, {0, -1}):
            alone = e.free_symbols == {symbol} and sign_of_number(e.xreplace({symbol: sympy.S.One}))
            after = both - {0} if alone or 0 not in start & rise else both
            return after if symbol.is_positive else start | after
    return EVERY


def up_to_end(case: CheckedCase, e: Any) -> frozenset[int]:
    """The signs that an expression of one symbol may have from zero to a number."""
    parts = [*sympy.preorder_traversal(e)]
    if len(e.free_symbols) != 1 or len(parts) > MOST_OPERATIONS or not all(isinstance(part, SMOOTH) for part in parts):
        return EVERY
    (symbol,) = e.free_symbols
    for end, before in _ends(case, symbol) if symbol.is_nonnegative else ():
        found = _on_piece([e], 0, symbol, (sympy.S.Zero, end), MOST_HALVINGS)
        for place, apart in ((sympy.S.Zero, symbol.is_positive), (end, before)):
            found = found if apart else found | visible_signs(sympy.expand(e.xreplace({symbol: place})))
        return found
    return EVERY


def _ends(case: CheckedCase, symbol: Any) -> Iterator[tuple[Any, bool]]:
    """Numbers that a symbol does not exceed, and whether it is less."""
    known = [(side * (one - other), False) for one, other in case.pairs for side in (1, -1)]
    known += [(case.here(other), other.is_positive) for other, _ in case.values if other.is_nonnegative]
    for e, strict in ((e, strict) for e, strict in known if not e.has(sympy.Derivative)):
        slope, rest = e.diff(symbol), e.xreplace({symbol: sympy.S.Zero})
        least = rest.xreplace(dict.fromkeys(rest.free_symbols, sympy.S.Zero))
        if slope.is_number and slope.is_negative and (signs := visible_signs(sympy.expand(least - rest))) <= {0, 1}:
            yield -least / slope, strict or 0 not in signs


def _on_piece(slopes: list[Any], order: int, symbol: Any, ends: tuple[Any, Any], halvings: int) -> frozenset[int]:
    """The signs that a derivative of the first of some expressions may have inside of an interval."""
    values = EnclosedValues({}, BITS)
    with suppress(Rejected):
        low, high = map(values, ends)
        values.known[symbol] = Enclosure(low.low, high.high)
        values(slopes[0])  # or it is not real somewhere
        if sign := values(slopes[order]).sign:
            return frozenset((sign,))
    if order < MOST_DERIVATIVES:
        slopes += [slopes[order].diff(symbol)] if len(slopes) == order + 1 else []
        rise = _on_piece(slopes, order + 1, symbol, ends, 0)
        for place, side in zip(ends, (1, -1), strict=True) if len(rise) == 1 else ():
            there = visible_signs(sympy.expand(slopes[order].xreplace({symbol: place})))
            if {side * sign for sign in there} <= {0, *rise}:
                return frozenset(side * sign for sign in rise)
    found = EVERY
    if halvings:
        middle = (ends[0] + ends[1]) / 2
        found = visible_signs(sympy.expand(slopes[order].xreplace({symbol: middle})))
        for piece in ((ends[0], middle), (middle, ends[1])):
            found = found if len(found) == 3 else found | _on_piece(slopes, order, symbol, piece, halvings - 1)
    return found


def _held_before(e: Any, sign: int, symbol: Any) -> bool:
    """Whether something has its sign at all smaller values of a symbol, too."""
    linear = sign != 0 and not e.diff(symbol).has(symbol)
    return not e.has(symbol) or (linear and visible_signs(e.xreplace({symbol: sympy.S.Zero})) <= {0, sign})


def _is_smooth(case: CheckedCase, e: Any, symbol: Any) -> bool:
    """Whether an expression is analytic in a symbol from zero on, as far as it is real."""
    if symbol not in e.free_symbols or e == symbol:
        return True
    if isinstance(e, sympy.log) or (e.is_Pow and not (e.exp.is_Integer and e.exp > 0)):
        inside, linear = e.args[0], not e.args[0].diff(symbol).has(symbol)
        zero = {symbol: sympy.S.Zero if linear else sympy.Dummy(nonnegative=True)}
        side = case.sign(inside)
        if side != 1 and not (side == -1 and e.is_Pow and e.exp.is_Integer):
            return False
        return visible_signs(inside.xreplace(zero)) == {side} and all(_is_smooth(case, part, symbol) for part in e.args)
    return isinstance(e, ENTIRE) and all(_is_smooth(case, part, symbol) for part in e.args)
