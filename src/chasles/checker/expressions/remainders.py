"""Integers by their remainders: what half turns and signs (-1)^n are where n is m k + r, without whole turns."""

from __future__ import annotations

from typing import Any

import sympy

from chasles.checker.expressions.quantities import rebuilt
from chasles.checker.expressions.readings import CIRCULAR

MOST_PARTS = 90
"""Half a turn is divided into at most so many parts, and integers are by no larger number."""


class Floor(sympy.Function):  # type: ignore[misc]
    """The greatest integer; SymPy's own (1.14) takes a sixth of an even number, or of 2 (k + 1), for an integer."""

    is_integer = True

    @classmethod
    def eval(cls, x: Any) -> Any:
        """What is seen to be whole is taken out; None if nothing is."""
        whole = sympy.Add(*(term for term in sympy.Add.make_args(sympy.expand(x)) if is_whole(term)))
        rest = sympy.expand(x - whole)
        return whole + (sympy.floor(rest) if rest.is_number else cls(rest)) if rest.is_number or rest != x else None


Floor.__name__ = "floor"


def at_integer(e: Any, put: Any) -> Any:
    """The expression where an integer has a value, without whole turns and with powers of positive numbers alone."""
    if e in put or not e.args or not (e.has(*put) if put else any(symbol.is_integer for symbol in e.free_symbols)):
        return put.get(e, e)
    parts = [at_integer(part, put) for part in e.args]
    if type(e) in CIRCULAR:
        terms = sympy.Add.make_args(sympy.expand(parts[0]))
        left = [term for term in terms if not is_whole(term / sympy.pi / 2)]
        # SymPy drops half turns of a tangent's argument as if they were whole ones, if they are no numbers.
        turning = any(term.has(sympy.pi) and term.free_symbols for term in left)
        return e.func(sympy.Add(*left), evaluate=not turning) if put or len(left) < len(terms) else e
    if e.is_Pow and parts[0].is_negative and parts[1].is_integer and parts[1].free_symbols:
        exponent = sympy.expand(parts[1])
        odd = sympy.Add(*(term for term in sympy.Add.make_args(exponent) if not is_whole(term / 2)))
        return sympy.Pow(-1, odd) * (-parts[0]) ** exponent
    return rebuilt(e, parts)


def is_whole(term: Any) -> bool:
    """Whether a term is an integral multiple of a product of integers."""
    multiple, rest = term.as_coeff_Mul()
    factors = (
        isinstance(base, sympy.Symbol | Floor) and base.is_integer and n.is_Integer and n > 0
        for base, n in rest.as_powers_dict().items()
    )
    return bool(multiple.is_Integer) and (rest == 1 or all(factors))


def is_integral(e: Any) -> bool:
    """Whether an expression is a sum of integral multiples of products of integers."""
    return all(map(is_whole, sympy.Add.make_args(sympy.expand(e))))
