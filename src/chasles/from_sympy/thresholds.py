"""Where something may change its sign: the cases into which the question of its sign is divided."""

from __future__ import annotations

from itertools import accumulate, permutations
from typing import Any

import sympy

from chasles.checker.expressions.cases import CheckedCase
from chasles.checker.expressions.enclosed import sign_of_number
from chasles.checker.expressions.switches import visible_signs

FRACTIONS = map(sympy.Rational, ("0", "1", "1/2", "2", "1/4", "4", "1/3", "3"))
NUMBERS = [
    side * n for n in (*FRACTIONS, sympy.E, sympy.exp(-1), sympy.pi / 2, sympy.pi) for side in ((1, -1) if n else (1,))
]
FAR = 4
MOST_NUMBERS, MOST_SYMBOLS, MOST_TERMS = 3, 3, 60
CALLED = (sympy.exp, sympy.sin, sympy.cos, sympy.sinh, sympy.cosh, sympy.tanh, sympy.atan)


def thresholds(case: CheckedCase) -> list[Any]:
    """What is to have a known sign, so that what decides a form has one: of one symbol, its distance from numbers.

    There something vanishes, or does not change to the first order; if it nowhere does so, a piece around zero is told
    from what is far. Of several symbols it is which one is larger.
    """
    e = next((part.args[0] for part in case.switches() if isinstance(part, sympy.Abs | sympy.sign)), sympy.S.Zero)
    symbols = sorted(e.free_symbols, key=str)
    if len(symbols) == 1:
        gaps = [symbols[0] - number for number in NUMBERS if _is_flat(e, symbols[0], number)]
        gaps = gaps or ([] if e.is_rational_function() else [symbols[0] - FAR, symbols[0] + FAR])
        return [gap for gap in gaps if len(visible_signs(gap)) == 3][:MOST_NUMBERS]
    if not symbols or len(symbols) > MOST_SYMBOLS or (e.is_rational_function() and not _has_sign_in_order(e, symbols)):
        return []
    inside = sorted({call.args[0] for call in e.atoms(*CALLED) if call.args[0].is_polynomial()} - {*symbols}, key=str)
    gaps = [symbols[k] - symbols[k + step] for step in range(1, len(symbols)) for k in range(len(symbols) - step)]
    return [*inside[:1], *gaps]


def _is_flat(e: Any, symbol: Any, number: Any) -> bool:
    """Whether an expression vanishes, or its slope does, where its only symbol has a value."""
    slope = e.diff(symbol)
    parts = (e,) if slope.has(sympy.Derivative) else (e, slope)
    return any(sign_of_number(part.xreplace({symbol: number})) == 0 for part in parts)


def _has_sign_in_order(e: Any, symbols: list[Any]) -> bool:
    """Whether all coefficients have one sign in the least of positive symbols and in how much more each next one is."""
    sides = [sympy.Poly(side, *symbols) for side in sympy.fraction(sympy.together(e))]
    if not all(symbol.is_positive for symbol in symbols) or len(sides[0].terms()) > MOST_TERMS:
        return False
    orders = (dict(zip(order, accumulate(symbols), strict=True)) for order in permutations(symbols))
    shifted = (sympy.Poly(sides[0].as_expr().xreplace(put), *symbols) for put in orders)
    return len({c > 0 for c in sides[1].coeffs()}) == len({c > 0 for side in shifted for c in side.coeffs()}) == 1
