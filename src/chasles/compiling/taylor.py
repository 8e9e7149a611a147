"""What is left of a function once the first terms of its series at zero are taken, over the power that follows.

Of sine and cosine these are the functions of Stumpff, which are computed everywhere. Of others it is a Taylor
polynomial, which is good near zero; away from there a formula is taken as it is.
"""

from __future__ import annotations

from dataclasses import dataclass
from functools import lru_cache, reduce
from typing import Any

import sympy
from sympy.codegen.cfunctions import log1p

_ENOUGH = sympy.Rational(1, 2**60)
"""What is left out of a polynomial, in parts of its first term."""
_ANY = sympy.Integer(2)
_HALF = sympy.Rational(1, 2)


@dataclass(frozen=True, slots=True)
class Analytic:
    """The first power with a coefficient in a function's series, the step to the next, and up to where it is taken."""

    first: int
    step: int
    limit: sympy.Rational


CIRCULAR = {sympy.cos: Analytic(0, 2, _ANY), sympy.sin: Analytic(1, 2, _ANY)}
ANALYTIC = CIRCULAR | {
    sympy.exp: Analytic(0, 1, _ANY),
    sympy.cosh: Analytic(0, 2, _ANY),
    sympy.sinh: Analytic(1, 2, _ANY),
    sympy.erf: Analytic(1, 2, sympy.S.One),
    log1p: Analytic(1, 1, sympy.Rational(1, 3)),
    **dict.fromkeys((sympy.tanh, sympy.atan, sympy.asin, sympy.asinh, sympy.atanh), Analytic(1, 2, _HALF)),
}
"""By function."""


class Stumpff(sympy.Function):  # type: ignore[misc]
    """The function c_k of the square of a: the sum of (-1)^n a^(2 n) / (2 n + k)!."""

    nargs = (2,)
    is_real = True

    @classmethod
    def eval(cls, order: Any, a: Any) -> Any:
        """At zero the first coefficient."""
        return 1 / sympy.factorial(order) if a.is_zero else cls._stated(order, a) if a.is_number else None

    @staticmethod
    def _stated(order: Any, a: Any) -> Any:
        """What it is in sine and cosine."""
        if order < 2:
            return sympy.sin(a) / a if order else sympy.cos(a)
        return (1 / sympy.factorial(order - 2) - Stumpff._stated(order - 2, a)) / a**2

    def _eval_expand_func(self, **_: Any) -> Any:
        return self._stated(*self.args)


class TaylorPolynomial(sympy.Function):  # type: ignore[misc]
    """The polynomial of a with the coefficients that come after the limit up to which the size of a may go."""

    is_real = True

    @classmethod
    def eval(cls, a: Any, limit: Any, first: Any, *others: Any) -> Any:
        """At zero the first of them."""
        return first if a.is_zero else None


class WholeChoice(sympy.Piecewise):  # type: ignore[misc]
    """A choice of which powers are taken after it."""

    def _eval_power(self, exponent: sympy.Expr) -> None:
        return None


class NearZero(WholeChoice):
    """What holds where an angle is small, and what is stated of all others."""


@lru_cache(2**12)
def coefficient_of(function: Any, power: int) -> Any:
    """The coefficient of a power in a function's series."""
    if function is log1p:
        return sympy.Rational((-1) ** (power + 1), power) if power else sympy.S.Zero
    return function.taylor_term(power, sympy.S.One)


def left_of(function: Any, order: int, times: Any, angle: Any, square: Any) -> Any:
    """The terms of a function's series in a multiple of the angle from an order on, over that power of the angle."""
    if function in CIRCULAR:
        even = Stumpff(order, times * angle) if order else sympy.cos(times * angle)
        return (-1) ** (order // 2) * times**order * even
    coefficients, limit = _polynomial(function, order)
    argument = times * angle if ANALYTIC[function].step == 1 else times**2 * square
    return times**order * TaylorPolynomial(argument, limit, *coefficients)


@lru_cache(2**10)
def _polynomial(function: Any, order: int) -> tuple[list[Any], Any]:
    """So many coefficients as count below the limit, and this; it is lower where little cancels beyond it."""
    kind, found = ANALYTIC[function], [coefficient_of(function, order)]
    limit = kind.limit if kind.step == 1 else (kind.limit / (1 if order > 1 else 2)) ** 2
    while abs(found[-1]) * limit ** (len(found) - 1) > abs(found[0]) * _ENOUGH:
        found.append(coefficient_of(function, order + kind.step * len(found)))
    return found, limit


def horner(build: Any, a: int, *coefficients: int) -> int:
    """The steps of a polynomial, by Horner's scheme."""
    return reduce(lambda total, each: build.add(each, build.multiply(a, total)), reversed(coefficients))
