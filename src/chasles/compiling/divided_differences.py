"""What is left of an expression once it is divided by how far a symbol is from a point: (f(x) - f(p))/(x - p).

By the chain rule, and of each function by its addition theorem, so that nothing cancels and nothing is divided that
vanishes (Reps and Rall, Computational divided differencing and divided-difference arithmetics, 2003).
"""

from __future__ import annotations

from collections.abc import Callable, Mapping
from dataclasses import dataclass, field
from functools import lru_cache, partial
from typing import Any

import sympy
from sympy.codegen.cfunctions import expm1, log1p
from sympy.integrals.quadrature import gauss_legendre

from chasles.compiling.angles import KEPT, QUOTIENTS, parts_of_kinds, square_of, vanishes
from chasles.compiling.taylor import ANALYTIC, NearZero, Stumpff, TaylorPolynomial, left_of
from chasles.lowering.refusal import LoweringError

NO_VALUES = (sympy.nan, sympy.zoo, sympy.oo, -sympy.oo, sympy.I)
_NEGLIGIBLE = sympy.Float("1e-50")
_WRITTEN_OUT = 8
"""So many factors has a whole power of which the terms are written one by one."""
_ENTIRE = (sympy.sin, sympy.cos, sympy.tan, sympy.exp)
_BY_QUADRATURE = (sympy.erf, sympy.erfc, sympy.fresnels, sympy.fresnelc)


@dataclass(slots=True)
class _Validity:
    """Where divided differences are as good as what is stated; `close` is asked for only where there is a product."""

    conditions: dict[Any, None] = field(default_factory=dict)
    close: dict[Any, None] = field(default_factory=dict)
    has_product: bool = False

    def add(self, other: _Validity) -> None:
        self.conditions |= other.conditions
        self.close |= other.close
        self.has_product |= other.has_product


@dataclass(frozen=True, slots=True)
class SymbolValue:
    """A value of a symbol: a number, or an expression in other symbols."""

    symbol: sympy.Symbol
    value: sympy.Expr

    @property
    def apart(self) -> Any:
        """How far the symbol is from the value."""
        return self.symbol - self.value

    def changes(self, expression: Any) -> bool:
        """Whether the expression has the symbol."""
        return self.symbol in parts_of_kinds(expression, (sympy.Symbol,))

    def of(self, expression: Any) -> Any:
        """The expression with the value for the symbol."""
        try:
            return expression.xreplace({self.symbol: self.value})
        except (TypeError, ValueError):
            # SymPy asks for the sign, or the larger, of what has no value.
            return sympy.nan

    def vanish(self, expression: Any) -> bool:
        """Whether the expression has the symbol and is zero at the point, as is seen of polynomials."""
        return _vanishes(expression, self)

    def hold(self, condition: Any) -> bool:
        """Whether a condition holds at the point, whatever other symbols are."""
        return bool(self.of(condition) == sympy.true)


class DividedDifferences:
    """Those by a symbol and a point, and where they are as good as what is stated."""

    def __init__(self, point: SymbolValue) -> None:
        self.point = point
        self.validity = _Validity()

    def conditions_of(self, found: sympy.Expr) -> list[Any]:
        """Where what was found with them is as good as what is stated."""
        polynomials = sorted(parts_of_kinds(found, (TaylorPolynomial,)), key=sympy.default_sort_key)
        # The square that is put in for that of a root may be negative.
        near = (sympy.Abs(part.args[0], evaluate=False) < part.args[1] for part in polynomials)
        return [*self.validity.conditions, *(self.validity.close if self.validity.has_product else ()), *near]

    def of(self, expression: Any) -> Any:
        """The divided difference. Raises `LoweringError` for a function of which none is known."""
        if not self.point.changes(expression):
            return sympy.S.Zero
        if expression == self.point.symbol:
            return sympy.S.One
        found, validity = _difference(expression, self.point)
        self.validity.add(validity)
        return found

    def _made(self, expression: Any) -> Any:
        args = expression.args
        if isinstance(expression, sympy.Add):
            return sympy.Add(*map(self.of, args))
        if isinstance(expression, sympy.Mul):
            return self._product(args)
        if isinstance(expression, NearZero):
            (near, where), (stated, _) = args
            if not self.point.hold(where):
                return self.of(stated)
            self.validity.conditions[where] = None
            return self.of(near)
        stated = _in_others(expression)
        if stated is not None:
            return self.of(stated)
        if isinstance(expression, sympy.Pow):
            if self.point.changes(args[1]):
                return self.of(sympy.exp(args[1] * sympy.log(args[0])))
            return self.of(args[0]) * self._power(*self._sides(args[0]), args[1])
        if isinstance(expression, Stumpff | TaylorPolynomial):
            return self._of_rest(expression)
        rule = _RULES.get(type(expression))
        if rule is None:
            raise LoweringError(f"no divided difference of {type(expression).__name__} is known")
        u, v, d = self._sides(args[0])
        if v == 0 and type(expression) in ANALYTIC:
            kind = type(expression)
            first = ANALYTIC[kind].first or ANALYTIC[kind].step
            return self.of(args[0]) * u ** (first - 1) * left_of(kind, first, sympy.S.One, u, square_of(u))
        if isinstance(expression, sympy.log):
            self.validity.conditions[u + v > 0] = None
        if isinstance(expression, sympy.atan):
            self.validity.conditions[1 + u * v > 0] = None
        if type(expression) in _ENTIRE:
            self.validity.close[sympy.Abs(d) < 1] = None
        if type(expression) in _BY_QUADRATURE:
            self.validity.conditions[sympy.Abs(d) * (1 + sympy.Abs(u + v)) < 1] = None
        return self.of(args[0]) * rule(u, v, d)

    def _sides(self, of: Any) -> tuple[Any, Any, Any]:
        """What it is, what it is at the point, and how far these are apart."""
        at = self.point.of(of)
        if at.has(*NO_VALUES) or at.is_extended_real is False:
            raise LoweringError("there is no value at the point")
        return of, at, self.point.apart * self.of(of)

    def _product(self, factors: tuple[Any, ...]) -> Any:
        """One factor after the other is taken to the point; far from it the terms may cancel."""
        if sum(map(self.point.changes, factors)) > 1:
            self.validity.has_product = True
        split = [(factors[:k], factor, factors[k + 1 :]) for k, factor in enumerate(factors)]
        return sympy.Add(*(self.point.of(sympy.Mul(*a)) * self.of(factor) * sympy.Mul(*b) for a, factor, b in split))

    def _power(self, u: Any, v: Any, d: Any, exponent: Any) -> Any:
        if exponent.is_Integer and 0 < exponent <= _WRITTEN_OUT:
            return sympy.Add(*(u**k * v ** (exponent - 1 - k) for k in range(exponent)))
        self.validity.close[2 * sympy.Abs(d) < sympy.Abs(v)] = None
        if exponent.is_number and exponent < 0:
            return -self._power(u, v, d, -exponent) / (u**-exponent * v**-exponent)
        if exponent.is_Rational and exponent.q == 2:
            a, b = sympy.sqrt(u), sympy.sqrt(v)
            return self._power(a, b, d / (a + b), sympy.Integer(exponent.p)) / (a + b)
        self.validity.conditions[u + v > 0] = None
        slope = exponent * _RULES[sympy.log](u, v, d)
        return u ** (exponent / 2) * v ** (exponent / 2) * slope * _left(sympy.sinh, d * slope / 2)

    def _of_rest(self, expression: Any) -> Any:
        """Of what is left of a function at zero: what follows in its series; elsewhere of what it is."""
        first, *others = expression.args
        if isinstance(expression, Stumpff):
            [of] = others
            if self.point.of(of) != 0:
                return self.of(expression.expand(func=True))
            return -self.of(of) * of * Stumpff(first + 2, of)
        if self.point.of(first) != 0:
            raise LoweringError("no divided difference of the rest of a series is known away from zero")
        return self.of(first) * TaylorPolynomial(first, others[0], *others[2:])


@lru_cache(KEPT)
def _difference(expression: Any, point: SymbolValue) -> tuple[Any, _Validity]:
    """The divided difference, and where it is as good as what is stated."""
    differences = DividedDifferences(point)
    return differences._made(expression), differences.validity


@lru_cache(KEPT)
def _vanishes(expression: Any, point: SymbolValue) -> bool:
    return point.changes(expression) and _is_zero(point.of(expression))


def _is_zero(value: Any) -> bool:
    if value.has(*NO_VALUES):
        return False
    if value.is_number and not value.is_Rational:
        # log(4) is 2 log(2): a number stands for its first digits.
        digits = value.evalf(60)
        return bool(digits.is_Number and abs(digits) < _NEGLIGIBLE)
    return vanishes(value) or (bool(parts_of_kinds(value, (Stumpff,))) and vanishes(value.expand(func=True)))


def _in_others(function: Any) -> Any:
    """What it is in functions of which divided differences are known."""
    of = function.args[0]
    if type(function) in QUOTIENTS and not isinstance(function, sympy.tan):
        return QUOTIENTS[type(function)](of)
    written: Mapping[Any, Callable[[], Any]] = {
        expm1: lambda: sympy.exp(of) - 1,
        log1p: lambda: sympy.log(1 + of),
        sympy.sinc: lambda: sympy.sin(of) / of,
        sympy.acos: lambda: sympy.pi / 2 - sympy.asin(of),
    }
    return written[type(function)]() if type(function) in written else None


def _left(function: Any, a: Any) -> Any:
    return left_of(function, 1, sympy.S.One, a, square_of(a))


def _of_arcsine(u: Any, v: Any, d: Any) -> Any:
    above, below = sympy.sqrt(1 - u**2), sympy.sqrt(1 - v**2)
    slope = below + v * (u + v) / (above + below)
    return slope * _left(sympy.asin, d * slope)


def _of_area_sine(u: Any, v: Any, d: Any) -> Any:
    above, below = sympy.sqrt(1 + u**2), sympy.sqrt(1 + v**2)
    slope = (1 + (1 + u**2 + v**2) / (above * below + u * v)) / (above + below)
    return slope * _left(sympy.asinh, d * slope)


def _of_area_cosine(u: Any, v: Any, d: Any) -> Any:
    slope = (u + v) / (v * sympy.sqrt(u**2 - 1) + u * sympy.sqrt(v**2 - 1))
    return slope * _left(sympy.asinh, d * slope)


def _mean_slope(function: Any, u: Any, v: Any, d: Any) -> Any:
    """The mean of the rate between both, by the rule of Gauss and Legendre."""
    places, weights = gauss_legendre(8, 40)
    place = sympy.Dummy()
    rates = (function(place).fdiff().xreplace({place: (u + v) / 2 + sympy.Rational(at) * d / 2}) for at in places)
    return sympy.Add(*(sympy.Rational(weight) / 2 * rate for weight, rate in zip(weights, rates, strict=True)))


_RULES: Mapping[Any, Callable[[Any, Any, Any], Any]] = {
    sympy.exp: lambda u, v, d: sympy.exp((u + v) / 2) * _left(sympy.sinh, d / 2),
    sympy.log: lambda u, v, d: 2 * _left(sympy.atanh, d / (u + v)) / (u + v),
    sympy.sin: lambda u, v, d: sympy.cos((u + v) / 2) * _left(sympy.sin, d / 2),
    sympy.cos: lambda u, v, d: -sympy.sin((u + v) / 2) * _left(sympy.sin, d / 2),
    sympy.tan: lambda u, v, d: _left(sympy.sin, d) / (sympy.cos(u) * sympy.cos(v)),
    sympy.sinh: lambda u, v, d: sympy.cosh((u + v) / 2) * _left(sympy.sinh, d / 2),
    sympy.cosh: lambda u, v, d: sympy.sinh((u + v) / 2) * _left(sympy.sinh, d / 2),
    sympy.tanh: lambda u, v, d: _left(sympy.sinh, d) / (sympy.cosh(u) * sympy.cosh(v)),
    sympy.atan: lambda u, v, d: _left(sympy.atan, d / (1 + u * v)) / (1 + u * v),
    sympy.atanh: lambda u, v, d: _left(sympy.atanh, d / (1 - u * v)) / (1 - u * v),
    sympy.asin: _of_arcsine,
    sympy.asinh: _of_area_sine,
    sympy.acosh: _of_area_cosine,
    sympy.Abs: lambda u, v, d: (u + v) / (sympy.Abs(u) + sympy.Abs(v)),
} | {function: partial(_mean_slope, function) for function in _BY_QUADRATURE}
"""(f(u) - f(v))/d with u - v = d."""
