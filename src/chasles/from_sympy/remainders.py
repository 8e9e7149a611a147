"""Integers in half turns and in powers of negative numbers, by their remainders: (-1)^n, cos(n*pi/2 + a).

Where n is 4*m + 1, the angle n*pi/2 is pi/2, but for whole turns.
"""

from __future__ import annotations

from collections.abc import Sequence
from math import lcm
from typing import Any

import sympy
from sympy.core.function import AppliedUndef

from chasles.from_sympy.divisors import CIRCULAR
from chasles.from_sympy.opening import parts_of

LARGEST_MODULUS = 24


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


def remainders_of(symbol: Any, modulus: int) -> list[int]:
    """The remainders that the integer may have."""
    odd = [False] if symbol.is_even else [True] if symbol.is_odd else [False, True]
    return [remainder for remainder in range(modulus) if bool(remainder % 2) in odd]


def quotient(name: str, symbol: Any) -> Any:
    """A symbol for the integer quotient, of which is said what sign it has."""
    sign = {"nonnegative": True} if symbol.is_nonnegative else {"negative": True} if symbol.is_negative else {}
    return sympy.Symbol(name, integer=True, **sign)


def at_integer(e: Any, symbol: Any = None, value: Any = None) -> Any:
    """The expression where an integer has a value, without whole turns and with powers of positive numbers alone."""
    if e == symbol:
        return value
    if not any(part.is_integer for part in e.free_symbols):
        return e
    arguments = [at_integer(part, symbol, value) for part in e.args]
    if type(e) in CIRCULAR:
        terms = sympy.Add.make_args(sympy.expand(arguments[0]))
        left = [term for term in terms if not _is_whole(term / sympy.pi / 2)]
        # SymPy drops half turns of a tangent's argument as if they were whole ones, if they are no numbers.
        turning = any(_is_integral(term / sympy.pi) for term in left if term.free_symbols)
        unchanged = symbol is None and len(left) == len(terms)
        return e if unchanged else e.func(sympy.Add(*left), evaluate=not turning)
    if isinstance(e, sympy.Pow) and arguments[0].is_negative and arguments[1].is_integer and arguments[1].free_symbols:
        base, exponent = arguments[0], sympy.expand(arguments[1])
        odd = sympy.Add(*(term for term in sympy.Add.make_args(exponent) if not _is_whole(term / 2)))
        return sympy.Pow(-1, odd) * (-base) ** exponent
    return e.func(*arguments) if e.args else e


def _half_turns(part: Any) -> list[Any]:
    """The terms with integers that say how many half turns an angle, or how many signs a power has."""
    if type(part) in CIRCULAR:
        number = sympy.expand(part.args[0]) / sympy.pi
    elif isinstance(part, sympy.Pow) and part.base.is_negative:
        number = part.exp
    else:
        return []
    terms = sympy.Add.make_args(sympy.expand(number))
    return [term for term in terms if term.free_symbols and _is_integral(term) and not _is_whole(term / 2)]


def _is_integral(term: Any) -> bool:
    """Whether a term is a rational multiple of a product of integers."""
    multiple, rest = term.as_coeff_Mul()
    factors = rest.as_powers_dict().items()
    return bool(multiple.is_Rational) and all(
        base.is_Symbol and base.is_integer and n.is_Integer and n > 0 for base, n in factors if base != 1
    )


def _is_whole(term: Any) -> bool:
    return _is_integral(term) and bool(term.as_coeff_Mul()[0].is_Integer)
