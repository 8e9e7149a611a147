"""Whether a number vanishes for all values of the angles and cosines in it that are independent.

The cosine and sine of a rational number other than zero are transcendental (Lindemann): between them c^2 + s^2 = 1 is
all there is, so that a polynomial in them over the algebraic numbers vanishes only if its coefficients do.
"""

from __future__ import annotations

from collections.abc import Iterable
from functools import cache, reduce
from math import lcm
from typing import Any

import mpmath
import sympy as sp

from chasles.checker.expressions.complexes import QUOTIENTS
from chasles.exact.enclosures import INVERSES, enclosed
from chasles.exact.separation import is_algebraic, is_algebraic_zero

C, S = sp.Symbol("c", real=True), sp.Symbol("s", real=True)
LARGEST_MULTIPLE = 120
BITS = 400
LARGEST_TIMES = 1000
MOST_OPERATIONS = 400
"""In a number that is multiplied out: beyond, that may take minutes."""


def by_sine_and_cosine(expression: Any) -> Any:
    """The expression with tangents, cotangents, secants and cosecants written by sines and cosines."""
    for function in (sp.tan, sp.cot, sp.sec, sp.csc):
        expression = expression.replace(function, QUOTIENTS[function])
    return expression


def is_of_rational_angle(atom: Any) -> bool:
    """Whether it is the cosine or the sine of a rational number."""
    return isinstance(atom, sp.cos | sp.sin) and bool(atom.args[0].is_Rational)


def in_one_angle(expression: Any) -> Any:
    """The expression with all such cosines and sines written in C and S.

    None without any, where it grows large, and where it is no quotient of polynomials in them.
    """
    atoms = [atom for atom in expression.atoms(sp.cos, sp.sin) if is_of_rational_angle(atom)]
    if not atoms:
        return None
    below = lcm(*(int(atom.args[0].q) for atom in atoms))
    times = {atom: int(atom.args[0] * below) for atom in atoms}
    if max(map(abs, times.values()), default=0) > LARGEST_MULTIPLE:
        return None
    written = expression.xreplace({atom: _multiple(k)[isinstance(atom, sp.sin)] for atom, k in times.items()})
    return written if written.is_rational_function(C, S) else None


def without_squares(polynomial: Any, cosine: Any = C, sine: Any = S) -> Any:
    """The polynomial in a cosine and a sine of one angle with at most the first power of the sine."""
    squares = {
        power: sine ** (power.exp % 2) * (1 - cosine**2) ** (power.exp // 2)
        for power in sp.expand(polynomial).atoms(sp.Pow)
        if power.base == sine and power.exp.is_Integer and power.exp > 1
    }
    return sp.expand(sp.expand(polynomial).xreplace(squares))


def coefficients(polynomial: Any, symbols: Iterable[Any]) -> dict[Any, Any]:
    """What multiplies each product of powers of the symbols."""
    found: dict[Any, Any] = {}
    for term in sp.Add.make_args(sp.expand(polynomial)):
        factor, powers = term.as_independent(*symbols, as_Add=False)
        found[powers] = found.get(powers, sp.Integer(0)) + factor
    return found


@cache
def _multiple(times: int) -> tuple[Any, Any]:
    """The cosine and the sine of a multiple of the angle."""
    if times < 0:
        cosine, sine = _multiple(-times)
        return cosine, -sine
    cosine, sine = sp.Integer(1), sp.Integer(0)
    for _ in range(times):
        cosine, sine = without_squares(cosine * C - sine * S), without_squares(sine * C + cosine * S)
    return cosine, sine


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
