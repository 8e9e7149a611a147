"""Quotients and logarithms of sums of exponentials and powers, of which only ratios are formed: none need overflow.

A sum of c exp(u) is exp(m) times the sum of c exp(u - m), with the largest u for m; exp(m) cancels, or is m as a
logarithm (Blanchard, Higham and Higham, Accurately computing the log-sum-exp and softmax functions, 2021).
"""

from __future__ import annotations

from collections.abc import Mapping
from functools import lru_cache
from itertools import combinations_with_replacement
from operator import is_
from typing import Any

import sympy
from sympy.codegen.cfunctions import expm1, log1p

from chasles.compiling.angles import KEPT, KNOWN, angle_of, parts_of_kinds, square_of
from chasles.compiling.elementary import PowerTimesLog
from chasles.compiling.exponentials import Apart, HeldLargest
from chasles.compiling.near_zero import without_cancellation
from chasles.compiling.taylor import NearZero, WholeChoice
from chasles.compiling.variables import HELD

_LARGE = 100
"""Products of gamma functions of less are in range."""
_MOST_POWER = 3
"""Of products of so many sums exponentials are shared."""


@lru_cache(KEPT)
def in_range(expression: Any, far: frozenset[Any] = frozenset()) -> Any:
    """The expression; what grows beyond all bounds in it, or a logarithm of zero, is no part of what has a value.

    Angles that are `far` from zero are those of what a `NearZero` states.
    """
    if not parts_of_kinds(expression, (sympy.exp, sympy.log, sympy.Pow)) or expression.is_Boolean:
        return expression
    if isinstance(expression, NearZero):
        (near, where), (stated, _) = expression.args
        known = far.union(_angle(part.args[0]) for part in parts_of_kinds(where, (sympy.Abs,)))
        held = in_range(stated, known)
        if held is stated and not all(_angle(angle_of(f)) in known for f in parts_of_kinds(stated, KNOWN)):
            held = without_cancellation(stated)
        return NearZero((in_range(near, far), where), (held, True), evaluate=False)
    parts = [_inside(part, far) if expression.is_Mul else in_range(part, far) for part in expression.args]
    held = {"evaluate": False} if isinstance(expression, HELD) else {}
    found = expression if all(map(is_, parts, expression.args)) else expression.func(*parts, **held)
    if isinstance(found, sympy.log):
        return _logarithm(found, far)
    if isinstance(found, sympy.Mul | sympy.Pow):
        return _of_gammas(_with_logarithm(_quotient(found, far)))
    return found


def _inside(factor: Any, far: frozenset[Any]) -> Any:
    """A factor; of a quotient what is divided by, which is looked at with what it divides."""
    if factor.is_Pow and factor.base.is_Add:
        return in_range(factor.base, far) ** factor.exp
    return in_range(factor, far)


def _angle(multiple: Any) -> Any:
    """It, whatever number it is multiplied by."""
    rest = multiple.expand().primitive()[1]
    return -rest if rest.could_extract_minus_sign() else rest


def _of_gammas(product: Any) -> Any:
    """The product; gamma functions and what they are divided by are one exponential where one of them may overflow."""
    powers = [factor.as_base_exp() for factor in sympy.Mul.make_args(product)]
    gammas = [(base, power) for base, power in powers if isinstance(base, sympy.gamma) and power.is_Integer]
    if len({power.is_positive for _, power in gammas}) < 2:
        return product
    args = [base.args[0] for base, _ in gammas]
    logarithm = sympy.Add(*(power * sympy.loggamma(base.args[0]) for base, power in gammas))
    is_large = sympy.And(*(of > 0 for of in args), sympy.Or(*(of > _LARGE for of in args)))
    stated = sympy.Mul(*(base**power for base, power in gammas))
    return product / stated * WholeChoice((sympy.exp(logarithm), is_large), (stated, True), evaluate=False)


def _with_logarithm(product: Any) -> Any:
    """The product, in which a power of what the logarithm is taken of, or of a factor of that, is one with it."""
    factors = sympy.Mul.make_args(product)
    for factor in factors:
        base, power = factor.as_base_exp()
        if not (power.is_Rational and power.is_positive) or base.is_number:
            continue
        rest = [other for other in factors if other is not factor]
        for k, other in enumerate(rest):
            left = sympy.Mul(*rest[:k], *rest[k + 1 :])
            if _is_log_of(other, base):
                return left * PowerTimesLog(base, power, other.args[0])
            if other.is_Add and any(_is_log_of(f, base) for term in other.args for f in sympy.Mul.make_args(term)):
                return sympy.Mul(
                    left, sympy.Add(*(_with_logarithm(factor * term) for term in other.args)), evaluate=False
                )
    return product


def _is_log_of(function: Any, base: Any) -> bool:
    return isinstance(function, sympy.log) and base in (function.args[0], *sympy.Mul.make_args(function.args[0]))


def _logarithm(function: Any, far: frozenset[Any]) -> Any:
    """That of 1 - exp(a) by the smaller of both terms; that of a sum of exponentials by the largest."""
    [of] = function.args
    sums = _Exponentials(of, far)
    if sums.coefficients.get(sympy.S.Zero) == 1 and list(sums.coefficients.values()).count(-1) == 1 == len(of.args) - 1:
        [a] = (exponent for exponent, own in sums.coefficients.items() if own == -1)
        return sympy.Piecewise((log1p(-sympy.exp(a)), a < -1), (sympy.log(-expm1(a)), True), evaluate=False)
    if not sums.are_several:
        return function
    if set(sums.coefficients.values()) == {sympy.S.One} and len(sums.scaled) == 2:
        return sums.largest + log1p(sums.small)
    if sums.coefficients.get(sympy.S.Zero) == 1 and len(sums.scaled) > 2:
        # Where the others are small the sum is close to 1.
        return sums.largest + log1p(sums.total - sums.scaled[sympy.S.Zero] + expm1(-sums.largest))
    return sums.largest + sympy.log(sums.total)


def _quotient(product: Any, far: frozenset[Any]) -> Any:
    """The product, in which a sum that is divided by and what is divided are taken in parts of the largest term."""
    for factor in sympy.Mul.make_args(product):
        base, power = factor.as_base_exp()
        if not (base.is_Add and power.is_number and power.is_negative):
            continue
        rest = product / factor
        sums = _Exponentials(base, far)
        if sums.are_several:
            return _quotient(sums.times(rest, -power), far) * sums.total**power
        if power == -1 and len(base.args) == 2:
            found = _of_power(rest, *base.args) or _of_power(rest, *reversed(base.args))
            if found is not None:
                return found
    return product


def _of_power(above: Any, one: Any, power: Any) -> Any:
    """The numerator over the sum of 1, or of a power, and of another power; None if it is no multiple of either."""
    base, exponent = power.as_base_exp()
    other, same = one.as_base_exp()
    if exponent.is_number or not (one == 1 or same == exponent):
        return None
    less = exponent * (base - (1 if one == 1 else other)) < 0
    if one == 1:
        share = base ** sympy.Piecewise((exponent, less), (-exponent, True))
    else:
        share = WholeChoice((power, less), (one, True)) / WholeChoice((one, less), (power, True))
    factors = sympy.Mul.make_args(above)
    if power in factors:
        return above / power * sympy.Piecewise((share, less), (1, True)) / (1 + share)
    if one == 1 or one in factors:
        return above / one * sympy.Piecewise((1, less), (share, True)) / (1 + share)
    return None


class _Exponentials:
    """A sum in which exponentials of several exponents occur, each in parts of the largest."""

    def __init__(self, total: Any, far: frozenset[Any] = frozenset()) -> None:
        self.coefficients: dict[Any, Any] = {}
        for term in sympy.Add.make_args(total):
            own, exponent = _split(term)
            self.coefficients[exponent] = self.coefficients.get(exponent, sympy.S.Zero) + own
        exponents = list(self.coefficients)
        self.are_several = len(exponents) > 1 and not any((a - exponents[0]).is_number for a in exponents[1:])
        if not self.are_several:
            return
        self._apart = exponents[1] - exponents[0]
        self._are_far = not far.isdisjoint(map(_angle, (self._apart, square_of(self._apart))))
        if 0 not in exponents:
            self._apart = Apart(exponents[1], exponents[0])
        if len(exponents) == 2:
            self._less = sympy.Piecewise((-self._apart, self._apart > 0), (self._apart, True))
            self.small = sympy.exp(self._less)
            cases = ((self.small, sympy.S.One), (sympy.S.One, self.small), exponents[::-1])
            *scaled, self.largest = (self._chosen(*case) for case in cases)
        else:
            self.largest = HeldLargest(*exponents)
            scaled = [sympy.exp(exponent - self.largest, evaluate=False) for exponent in exponents]
        self.scaled: Mapping[Any, Any] = dict(zip(exponents, scaled, strict=True))
        self.total = self._with_scaled(self.coefficients)

    def _chosen(self, if_second_is_larger: Any, otherwise: Any) -> Any:
        return sympy.Piecewise((if_second_is_larger, self._apart > 0), (otherwise, True))

    def _with_scaled(self, coefficients: Mapping[Any, Any]) -> Any:
        if len(self.scaled) == len(coefficients) == 2:
            first, second = (coefficients[exponent] for exponent in self.scaled)
            if first == second:
                return first * (1 + self.small)
            if first == -second:
                left = self.small - 1 if self._are_far else expm1(self._less)
                return first * self._chosen(left, -left)
        return sympy.Add(*(c * self.scaled[exponent] for exponent, c in coefficients.items()))

    def times(self, above: Any, power: Any) -> Any:
        """The numerator, over so many powers of the largest exponential."""
        own, exponent = _split(above)
        for factor in sympy.Mul.make_args(own):
            inner = _Exponentials(factor)
            if power == 1 and inner.are_several and set(inner.coefficients) <= set(self.scaled) and exponent == 0:
                return own / factor * self._with_scaled(inner.coefficients)
        whole = int(power) if power.is_Integer and power <= _MOST_POWER else 0
        for chosen in combinations_with_replacement(self.scaled, whole) if whole else ():
            if (sympy.Add(*chosen) - exponent).expand() == 0:
                return own * sympy.Mul(*(self.scaled[each] for each in chosen))
        return own * sympy.exp(exponent - power * self.largest, evaluate=False)


def _split(term: Any) -> tuple[Any, Any]:
    """A term without its exponentials of what varies, and the sum of their exponents."""
    varying: list[Any] = [f for f in sympy.Mul.make_args(term) if isinstance(f, sympy.exp) and not f.is_number]
    return sympy.Mul(*(f for f in sympy.Mul.make_args(term) if f not in varying)), sympy.Add(*(f.exp for f in varying))
