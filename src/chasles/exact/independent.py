"""Numbers with angles in them: polynomials in angles, cosines and sines that are independent of each other.

Relations between angles, sums of integer multiples that are zero, are found by PSLQ (Ferguson and Bailey, 1992) and
then proved: the sine of such a sum is an algebraic number, and zero. By Baker's theorem (Linear forms in the logarithms
of algebraic numbers, 1966) no others are linear, whatever algebraic numbers multiply them.
"""

from __future__ import annotations

from functools import reduce
from typing import Any

import mpmath
import sympy as sp

from chasles.exact.circular import C, S, by_sine_and_cosine, coefficients, in_one_angle, without_squares
from chasles.exact.enclosures import INVERSES, enclosed
from chasles.exact.separation import is_algebraic, is_algebraic_zero

BITS = 400
LARGEST_TIMES = 1000
MOST_OPERATIONS = 400
"""In a number that is multiplied out: beyond, that may take minutes."""


def vanishes(number: Any) -> bool:
    """Whether a number is zero for all values of what is independent in it: then it is zero, and else may be."""
    if number.count_ops() > MOST_OPERATIONS:
        return False
    apart = _apart(number)
    in_one = in_one_angle(apart)
    written = apart if in_one is None else in_one
    parts = sorted(_parts(written), key=sp.default_sort_key)
    named = _independent([part for part in parts if _is_angle(part)])
    circles = [(C, S)]
    for x in dict.fromkeys(part.args[0] for part in parts if isinstance(part, sp.cos | sp.sin)):
        circles.append((sp.Dummy("cos"), sp.Dummy("sin")))
        named[sp.cos(x)], named[sp.sin(x)] = circles[-1]
    named |= {part: sp.Dummy("other") for part in parts if part not in named}
    above = sp.fraction(sp.together(written.xreplace(named)))[0]
    above = reduce(lambda rest, circle: without_squares(rest, *circle), circles, above)
    return all(map(is_algebraic_zero, coefficients(above, above.free_symbols).values()))


def _apart(number: Any) -> Any:
    """By sines and cosines alone, and these of rational angles apart from those of others."""
    sine, cosine = sp.sin, sp.cos

    def sine_of_sum(x: Any) -> Any:
        a, b = x.as_coeff_Add()
        return sine(a) * cosine(b) + cosine(a) * sine(b)

    def cosine_of_sum(x: Any) -> Any:
        a, b = x.as_coeff_Add()
        return cosine(a) * cosine(b) - sine(a) * sine(b)

    return by_sine_and_cosine(number).replace(sp.sin, sine_of_sum).replace(sp.cos, cosine_of_sum)


def _parts(number: Any) -> set[Any]:
    """The largest parts that are not algebraic, and not made by arithmetic."""
    if number in (C, S) or is_algebraic(number):
        return set()
    if number.is_Add or number.is_Mul or (number.is_Pow and number.exp.is_Integer):
        return set().union(*map(_parts, number.args))
    return {number}


def _is_angle(part: Any) -> bool:
    return part == sp.pi or (isinstance(part, INVERSES) and is_algebraic(part.args[0]))


def _independent(angles: list[Any]) -> dict[Any, Any]:
    """Angles as sums of rational multiples of symbols, which stand for those that are independent."""
    symbols: dict[Any, Any] = {}
    named: dict[Any, Any] = {}
    for angle in angles:
        relation = _relation([*symbols, angle])
        if relation is None:
            symbols[angle] = named[angle] = sp.Dummy("angle")
        else:
            *times, last = relation
            named[angle] = sp.Add(*(-n * x for n, x in zip(times, symbols.values(), strict=True))) / last
    return named


def _relation(angles: list[Any]) -> list[int] | None:
    """Integers, the last not zero, by which the angles add up to zero."""
    with mpmath.workprec(BITS):
        near = [mpmath.mpf(enclosed(angle, BITS).mid._mpi_[0]) for angle in angles]
        found = mpmath.pslq(near, maxcoeff=LARGEST_TIMES, maxsteps=100_000) if len(near) > 1 else None
    if found is None or not found[-1]:
        return None
    whole = sp.Add(*(int(n) * angle for n, angle in zip(found, angles, strict=True)))
    proved = abs(enclosed(whole, BITS)) < 1 and is_algebraic_zero(sp.sin(whole))
    return [int(n) for n in found] if proved else None
