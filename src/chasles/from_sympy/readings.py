"""What is treated: how each class of SymPy expressions is read.

Of an angle, quotients of its sine and cosine are; a multiple of pi is split off and evaluated by SymPy.
"""

from __future__ import annotations

from collections.abc import Mapping
from fractions import Fraction
from typing import Any

from chasles.checker.expressions.readings import CIRCULAR
from chasles.from_sympy.divisors import DivisorText
from chasles.from_sympy.reader import ARITHMETIC, Reader, Reading
from chasles.vocabulary import Call, Node, Number, Quotient, Scale, Sum


def _circular(reader: Reader, e: Any) -> Node:
    above, below = CIRCULAR[e.func]
    if not below:
        return _of_angle(reader, above, e.args[0])
    divisor = _of_angle(reader, below, e.args[0])
    reader.declare(divisor, DivisorText(f"{below}({e.args[0]}) != 0", not e.free_symbols))
    return Quotient(_of_angle(reader, above, e.args[0]), divisor)


def _of_angle(reader: Reader, function: str, argument: Any) -> Node:
    if not function:
        return Number(Fraction(1))
    angle, cosine, sine = reader.angles(argument)
    if angle is None:
        return reader(cosine if function == "cos" else sine)
    if sine == 0 and cosine == 1:
        return Call(function, angle)
    one, other = (Scale(reader(value), Call(f, angle)) for value, f in _addition(function, cosine, sine))
    return Sum((one, other))


def _addition(function: str, cosine: Any, sine: Any) -> tuple[tuple[Any, str], tuple[Any, str]]:
    """The addition formulas: what multiplies the cosine and what the sine of the other angle."""
    return ((cosine, "cos"), (-sine, "sin")) if function == "cos" else ((sine, "cos"), (cosine, "sin"))


OF_ANGLES: Mapping[type, Reading] = dict.fromkeys(CIRCULAR, _circular)
"""Sine, cosine, tangent and their reciprocals."""


READINGS: Mapping[type, Reading] = {**ARITHMETIC, **OF_ANGLES}
