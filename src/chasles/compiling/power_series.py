"""The first coefficients of an expression's power series at zero, exactly.

Powers of series are taken by the recurrence that their differential equation gives (Knuth, The Art of Computer
Programming, volume 2, section 4.7).
"""

from __future__ import annotations

from collections.abc import Callable, Sequence
from fractions import Fraction
from functools import partial, reduce
from typing import Any

import sympy
from sympy.codegen.cfunctions import expm1, log1p

from chasles.compiling.angles import QUOTIENTS
from chasles.compiling.elementary import PowerTimesLog
from chasles.compiling.taylor import ANALYTIC, NearZero, Stumpff, TaylorPolynomial, coefficient_of
from chasles.lowering.refusal import LoweringError

Series = list[Fraction]
"""Coefficients, from that of the power zero on."""


class SeriesAtZero:
    """Series in one symbol, each of as many coefficients."""

    def __init__(self, symbol: sympy.Symbol, length: int) -> None:
        self._length = length
        self._known: dict[Any, Series] = {symbol: self._padded([Fraction(0), Fraction(1)])}

    def of(self, expression: Any) -> Series:
        """The coefficients. Raises `LoweringError` where there is no such series, or none with rational ones."""
        if expression not in self._known:
            self._known[expression] = self._made(expression)
        return self._known[expression]

    def _made(self, expression: Any) -> Series:
        kind: Any = type(expression)
        match expression:
            case sympy.Rational() | sympy.Float():
                return self._padded([_fraction(expression)])
            case sympy.Add():
                return [sum(each) for each in zip(*map(self.of, expression.args), strict=True)]
            case sympy.Mul():
                return reduce(self._product, map(self.of, expression.args))
            case sympy.Pow(args=(base, sympy.Rational() as exponent)):
                return self._power(self.of(base), _fraction(exponent))
            case sympy.log():
                first, *others = self.of(expression.args[0])
                return self._composed(partial(coefficient_of, log1p), [first - 1, *others])
            case PowerTimesLog(args=(base, power, of)):
                return self.of(base**power * sympy.log(of))
            case expm1():
                return self.of(sympy.exp(expression.args[0]) - 1)
            case NearZero():
                return self.of(expression.args[0][0])
            case TaylorPolynomial(args=(of, _, *coefficients)):
                return self._composed(dict(enumerate(coefficients)).get, self.of(of))
            case Stumpff(args=(order, of)):
                alternating = {2 * k: (-1) ** k / sympy.factorial(2 * k + order) for k in range(self._length)}
                return self._composed(alternating.get, self.of(of))
            case _ if kind in QUOTIENTS:
                return self.of(QUOTIENTS[kind](expression.args[0]))
            case _ if kind in ANALYTIC:
                return self._composed(partial(coefficient_of, kind), self.of(expression.args[0]))
        raise LoweringError(f"no series of {kind.__name__} is known")

    def _padded(self, first: Sequence[Fraction]) -> Series:
        return [*first, *[Fraction(0)] * self._length][: self._length]

    def _product(self, one: Series, other: Series) -> Series:
        found = self._padded([])
        for i, a in enumerate(one):
            for j, b in enumerate(other[: self._length - i] if a else ()):
                found[i + j] += a * b
        return found

    def _power(self, of: Series, exponent: Fraction) -> Series:
        if exponent.denominator == 1 and exponent >= 0:
            return reduce(self._product, [of] * int(exponent), self._padded([Fraction(1)]))
        first = _fraction(sympy.Rational(of[0]) ** sympy.Rational(exponent)) if of[0] else Fraction(0)
        if not first:
            raise LoweringError("a power of zero has no series")
        found = [first]
        for n in range(1, self._length):
            terms = ((k * exponent - n + k) * of[k] * found[n - k] for k in range(1, n + 1) if of[k])
            found.append(sum(terms, Fraction(0)) / (n * of[0]))
        return found

    def _composed(self, coefficient: Callable[[int], Any], inner: Series) -> Series:
        """The sum of the coefficients times powers of what vanishes at zero, by Horner's scheme."""
        if inner[0]:
            raise LoweringError("a function is taken of what does not vanish")
        found, degrees = self._padded([]), [k for k, each in enumerate(inner) if each]
        first = min(degrees, default=self._length)
        if degrees == [first]:
            terms = ((k * first, k) for k in range(-(-self._length // first)))
            return self._padded_at({place: _fraction(coefficient(k) or 0) * inner[first] ** k for place, k in terms})
        for k in reversed(range(-(-self._length // first))):
            found = self._product(found, inner)
            found[0] += _fraction(coefficient(k) or 0)
        return found

    def _padded_at(self, places: dict[int, Fraction]) -> Series:
        return [places.get(k, Fraction(0)) for k in range(self._length)]


def _fraction(number: Any) -> Fraction:
    value = sympy.sympify(number)
    if not (value.is_Rational or value.is_Float) or not value.is_finite:
        raise LoweringError(f"{value} is not rational")
    above, below = sympy.Rational(value).as_numer_denom()
    return Fraction(int(above), int(below))
