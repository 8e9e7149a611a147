"""Signs by slopes: what is not negative at zero and does not fall is not negative after it, nor zero again.

All functions treated are analytic wherever they are real, and that is from zero on: one that is zero again is so
everywhere between, and so everywhere.
"""

from __future__ import annotations

from dataclasses import replace
from typing import TYPE_CHECKING, Any

import sympy

from chasles.checker.expressions.enclosed import sign_of_number
from chasles.checker.expressions.quantities import NUMBERS
from chasles.checker.expressions.visible import signs_of

if TYPE_CHECKING:
    from chasles.checker.expressions.cases import CheckedCase

ENTIRE = (
    sympy.Add, sympy.Mul, sympy.Pow, sympy.exp, sympy.sin, sympy.cos, sympy.sinh, sympy.cosh, sympy.tanh, sympy.sech,
    sympy.atan, sympy.asinh, sympy.erf,
)  # fmt: skip
MOST_OPERATIONS = 60


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
    return frozenset((-1, 0, 1))


def _held_before(e: Any, sign: int, symbol: Any) -> bool:
    """Whether something has its sign at all smaller values of a symbol, too."""
    linear = sign != 0 and not e.diff(symbol).has(symbol)
    return not e.has(symbol) or (linear and signs_of(e.xreplace({symbol: sympy.S.Zero})) <= {0, sign})


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
        return signs_of(inside.xreplace(zero)) == {side} and all(_is_smooth(case, part, symbol) for part in e.args)
    return isinstance(e, ENTIRE) and all(_is_smooth(case, part, symbol) for part in e.args)
