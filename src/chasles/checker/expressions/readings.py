"""How each class of SymPy expressions is read; see `expressions` for what else a new function needs."""

from __future__ import annotations

from collections.abc import Callable, Mapping
from fractions import Fraction
from functools import reduce
from operator import add
from typing import TYPE_CHECKING, Any

import sympy

from chasles.checker.expressions.complexes import OF_COMPLEX, parts
from chasles.checker.expressions.elementary import FUNCTIONS
from chasles.checker.sparse import ONE, Polynomial, Rejected, number

if TYPE_CHECKING:
    from chasles.checker.expressions.expressions import Expressions

CIRCULAR = {
    sympy.sin: ("sin", ""), sympy.cos: ("cos", ""), sympy.tan: ("sin", "cos"), sympy.cot: ("cos", "sin"),
    sympy.sec: ("", "cos"), sympy.csc: ("", "sin"),
}  # fmt: skip
"""What each function of an angle has above and below the line: 1, the cosine or the sine."""


def _power(reading: Expressions, e: Any) -> Polynomial:
    if not e.exp.is_Rational or e.exp.q & (e.exp.q - 1):
        return reading.powered(reading(e.base), reading(e.exp))
    return reading.raised(e.base, Fraction(int(e.exp.p), int(e.exp.q)))


def _of_angle(reading: Expressions, e: Any) -> Polynomial:
    above, below = CIRCULAR[e.func]
    numerator = reading.circular(above, e.args[0])
    return numerator * reading.over(reading.circular(below, e.args[0]), f"{below}({e.args[0]})") if below else numerator


def _sign(reading: Expressions, e: Any) -> Polynomial:
    inverse = reading.divide(e.args[0])
    return reading(e.args[0]) * reading.absolute(reading(e.args[0])) * inverse * inverse


def _part(reading: Expressions, e: Any) -> Polynomial:
    """A real part, an imaginary part, or a size."""
    if isinstance(e, sympy.Abs) and not e.has(*OF_COMPLEX):
        return reading.absolute(reading(e.args[0]))
    real, imaginary = parts(reading, e)
    if imaginary:
        raise Rejected(f"{e} is not seen to be real")
    return real


def _function(name: str) -> Callable[[Expressions, Any], Polynomial]:
    return lambda reading, e: FUNCTIONS[name](reading, *map(reading, e.args))


READINGS: Mapping[type, Callable[[Expressions, Any], Polynomial]] = {
    sympy.Rational: lambda reading, e: number(Fraction(int(e.p), int(e.q))),
    type(sympy.pi): lambda reading, e: reading.half_turn(),
    sympy.Add: lambda reading, e: reduce(add, map(reading, e.args)),
    sympy.Mul: lambda reading, e: reduce(lambda total, factor: reading.normal(total * reading(factor)), e.args, ONE),
    sympy.Pow: _power,
    sympy.sign: _sign,
    sympy.Derivative: lambda reading, e: reduce(reading.rate, e.variables, reading(e.expr)),
    **dict.fromkeys((sympy.conjugate, sympy.re, sympy.im, sympy.Abs), _part),
    **dict.fromkeys(CIRCULAR, _of_angle),
    **{getattr(sympy, name): _function(name) for name in FUNCTIONS},
    type(sympy.E): lambda reading, e: reading.exp(ONE),
}
"""How each class of expressions is read."""
