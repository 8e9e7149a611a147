"""Cosines and sines of rational multiples of pi, as numbers: SymPy's are taken after they have been checked."""

from __future__ import annotations

from fractions import Fraction
from typing import TYPE_CHECKING

import sympy

from chasles.checker.expressions.intervals import Enclosing
from chasles.checker.expressions.reals import LARGEST_PART
from chasles.checker.sparse import Polynomial, Rejected, number

if TYPE_CHECKING:
    from chasles.checker.expressions.expressions import Expressions

DIGITS = 64


def turned(multiple: Fraction, reading: Expressions) -> tuple[Polynomial, Polynomial]:
    """Cosine and sine of a multiple of pi; raises `Rejected` where they are not known in square roots."""
    angle = sympy.Rational(multiple.numerator, multiple.denominator) * sympy.pi
    known = sympy.cos(angle), sympy.sin(angle)
    if any(e.has(sympy.cos, sympy.sin) for e in known) or multiple.denominator > LARGEST_PART:
        raise Rejected(f"the cosine of {angle} is not known in square roots")
    cosine_read, sine_read = map(reading, known)
    if not is_turn(multiple, cosine_read, sine_read, reading):
        raise Rejected(f"{known[0]} and {known[1]} are not seen to be cosine and sine of {angle}")
    return cosine_read, sine_read


def is_turn(multiple: Fraction, cosine: Polynomial, sine: Polynomial, reading: Expressions) -> bool:
    """Whether two numbers are cosine and sine of a multiple of pi.

    As a complex number c + i s they are the right root of one, if they are a root and no other is as near.
    """
    c, s = reading.complex_power(cosine, sine, multiple.denominator)
    if not reading.vanishes(c - number((-1) ** (multiple.numerator % 2))) or not reading.vanishes(s):
        return False
    near = Fraction(1, multiple.denominator)
    at = Enclosing(DIGITS)
    values = zip((cosine, sine), at.cosine_and_sine(at.times(at.number(multiple % 2), at.pi)), strict=True)
    return all(reading.is_near(value, Fraction(found.low, at.one), near) for value, found in values)
