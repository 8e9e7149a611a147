"""Integers in half turns, powers of negative numbers and greatest integers, by their remainders: (-1)^n, cos(n*pi/2).

Where n is 4*m + 1, the angle n*pi/2 is pi/2, but for whole turns.
"""

from __future__ import annotations

from collections.abc import Sequence
from math import lcm
from typing import Any

import sympy
from sympy.core.function import AppliedUndef

from chasles.checker.expressions.readings import CIRCULAR, Floor, is_whole
from chasles.from_sympy.opening import parts_of

LARGEST_MODULUS = 60


def modulus_of(spoken: Sequence[Any]) -> tuple[Any, int] | None:
    """An integer on whose remainder it depends how many half turns something has, and what to divide it by."""
    if not any(symbol.is_integer for e in spoken for symbol in e.free_symbols):
        return None
    found: dict[Any, int] = {}
    parts = {part for e in spoken for part in parts_of(e)}
    inside = {s for part in parts if isinstance(part, AppliedUndef | sympy.Derivative) for s in part.free_symbols}
    for part in parts:
        for term in _half_turns(part):
            for symbol in term.free_symbols - inside:
                multiple = term.as_coeff_Mul()[0] / 2
                found[symbol] = lcm(found.get(symbol, 2), int(multiple.q))
    known = sorted(((symbol, modulus) for symbol, modulus in found.items() if modulus <= LARGEST_MODULUS), key=str)
    return known[0] if known else None


def _half_turns(part: Any) -> list[Any]:
    """The terms with integers that say how many half turns an angle, how many signs a power, or halves a number has."""
    if type(part) in CIRCULAR:
        number = sympy.expand(part.args[0]) / sympy.pi
    elif isinstance(part, sympy.Pow) and part.base.is_negative:
        number = part.exp
    elif isinstance(part, Floor):
        number = 2 * part.args[0]
    else:
        return []
    terms = sympy.Add.make_args(sympy.expand(number))
    return [term for term in terms if term.free_symbols and is_whole(term.as_coeff_Mul()[1]) and not is_whole(term / 2)]
