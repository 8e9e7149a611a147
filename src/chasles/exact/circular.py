"""Cosines and sines of rational angles: polynomials in those of one angle, between which c^2 + s^2 = 1 is all there is.

The cosine of a rational number other than zero is transcendental (Lindemann), so that a polynomial in it over the
algebraic numbers vanishes only if its coefficients do.
"""

from __future__ import annotations

from collections.abc import Iterable
from functools import cache
from math import lcm
from typing import Any

import sympy as sp

from chasles.checker.expressions.complexes import QUOTIENTS

C, S = sp.Symbol("c", real=True), sp.Symbol("s", real=True)
LARGEST_MULTIPLE = 120


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
