"""Quotients with a limit where a symbol is another one, or a number, written so that nothing is divided there."""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from contextlib import suppress
from functools import lru_cache
from itertools import starmap
from operator import is_
from typing import Any

import sympy

from chasles.compiling.angles import KEPT, MOST_PARTS, QUOTIENTS, divisors, parts_of_kinds, size_of
from chasles.compiling.divided_differences import NO_VALUES, DividedDifferences, SymbolValue
from chasles.compiling.taylor import NearZero
from chasles.lowering.refusal import LoweringError

_MOST_SYMBOLS = 4
_MOST_ORDER = 4
_NUMBERS = tuple(map(sympy.sympify, (0, 1, -1)))
_ANGLES = tuple(number * sympy.pi / 2 for number in (1, -1, 2, -2))


def without_singular_points(expression: Any) -> Any:
    """The expression; where it divides by what vanishes as a symbol comes to a point, it has its limit."""
    whole = isinstance(expression, NearZero | sympy.logic.boolalg.Boolean)
    parts = parts_of_kinds(expression, (sympy.Pow, *QUOTIENTS))
    divides = divisors(parts) or any(type(part) in QUOTIENTS for part in parts)
    return _without(expression) if divides and not whole else expression


@lru_cache(KEPT)
def _without(expression: Any) -> Any:
    if isinstance(expression, sympy.Add | sympy.Mul | sympy.Pow):
        found = _regular(expression)
        if found is not None:
            return found
    if expression.is_Pow and not expression.exp.is_number:
        # Of 1 to the power of what is infinite there is a limit.
        logarithm = _regular(expression.exp * sympy.log(expression.base))
        if logarithm is not None:
            return sympy.exp(logarithm)
    parts = [without_singular_points(part) for part in expression.args]
    return expression if all(map(is_, parts, expression.args)) else expression.func(*parts)


def _regular(expression: Any) -> Any:
    """What it is with its limits; None where none is found."""
    join = sympy.Add if expression.is_Add else sympy.Mul
    parts = [part for part in join.make_args(expression) if size_of(part) <= MOST_PARTS]
    below = dict.fromkeys(base for part in parts for base in _divided(part)) if len(parts) > 1 else {}
    points = [point for divisor in below for point in _zeros(divisor)]
    limits: list[tuple[Any, Any, list[Any]]] = []
    for point in dict.fromkeys(points):
        if not any(point.hold(where) for _, where, _ in limits):
            differences = DividedDifferences(point)
            with suppress(LoweringError):
                near, singular = _near(join, parts, differences)
                limits.append((near, sympy.And(*differences.conditions_of(near)), singular))
    if not limits:
        return None
    # An exponential beside what is divided by is told with it how far both grow.
    own = [part for part in parts if isinstance(part, sympy.exp) or any(part in near for _, _, near in limits)]
    found = join(*own)
    for near, where, singular in limits:
        regular = without_singular_points(join(near, *(part for part in own if part not in singular)))
        # Without a condition it is what is stated, in other words.
        found = NearZero((regular, where), (found, True), evaluate=False) if where != sympy.true else regular
    rest = join(*(part for part in join.make_args(expression) if part not in own))
    return join(found, without_singular_points(rest))


def _near(join: Any, parts: Sequence[Any], differences: DividedDifferences) -> tuple[Any, list[Any]]:
    """What the singular parts are near the point, and these. Raises `LoweringError` where there is no limit."""
    point = differences.point
    own = [part for part in parts if _over_one(part, point)[1]]
    if join is sympy.Mul:
        own = [part for part in parts if part in own or point.vanish(part)]
    above, below = _over_one(join(*own), point)
    if not below or (join is sympy.Add and len(own) < 2):
        raise LoweringError("nothing is divided that vanishes")
    near, order = sympy.S.One, 0
    told = [_in_factors(part) if point.vanish(part) else part for part in sympy.Mul.make_args(above)]
    factors = [factor.as_base_exp() for part in told for factor in sympy.Mul.make_args(part)]
    for base, exponent in (*factors, *((base, -power) for base, power in below.items())):
        left, times = base, 0
        while exponent.is_Integer and times < _MOST_ORDER and point.vanish(left):
            left, times = differences.of(left), times + 1
        near *= left**exponent
        order += times * exponent
    near *= point.apart ** max(order, 0)
    if order < 0 or point.of(near).has(*NO_VALUES):
        raise LoweringError("there is no limit")
    return near, own


@lru_cache(KEPT)
def _over_one(expression: Any, point: SymbolValue) -> tuple[Any, dict[Any, int]]:
    """What stands over one denominator of what vanishes at the point, and its powers."""
    if not any(map(point.vanish, _divided(expression))):
        return expression, {}
    if type(expression) in QUOTIENTS:
        return _over_one(QUOTIENTS[type(expression)](expression.args[0]), point)
    base, exponent = expression.as_base_exp()
    if expression.is_Pow and exponent.is_Integer:
        above, below = _over_one(base, point)
        if exponent > 0:
            return above**exponent, {b: e * exponent for b, e in below.items()}
        split = _factors(above)
        found = {factor: -power * exponent for factor, power in split if point.vanish(factor)}
        others = [factor ** (power * exponent) for factor, power in split if factor not in found]
        return sympy.Mul(*others, *(b ** (-e * exponent) for b, e in below.items())), found
    if expression.is_Pow:
        return expression, {}
    parts = [_over_one(part, point) for part in expression.args]
    common: dict[Any, int] = {}
    for _, below in parts:
        for b, e in below.items():
            common[b] = max(common.get(b, 0), e) if expression.is_Add else common.get(b, 0) + e
    if not expression.is_Add:
        return sympy.Mul(*(above for above, _ in parts)), common
    missing = [sympy.Mul(*(b ** (e - below.get(b, 0)) for b, e in common.items())) for _, below in parts]
    return sympy.Add(*(above * by for (above, _), by in zip(parts, missing, strict=True))), common


@lru_cache(KEPT)
def _in_factors(expression: Any) -> Any:
    """The expression with powers that all terms of a sum have in common before it."""
    if not (expression.is_Add or expression.is_Mul or (expression.is_Pow and expression.exp.is_Integer)):
        return expression
    parts = [_in_factors(part) for part in expression.args]
    found = expression if all(map(is_, parts, expression.args)) else expression.func(*parts)
    if not found.is_Add:
        return found
    powers = [dict(factor.as_base_exp() for factor in sympy.Mul.make_args(term)) for term in found.args]
    shared = {base: min(each.get(base, 0) for each in powers) for base in powers[0] if _is_shared(base, powers)}
    common = sympy.Mul(*(base**power for base, power in shared.items()))
    return found if common is sympy.S.One else common * sympy.Add(*(term / common for term in found.args))


def _is_shared(base: Any, powers: Sequence[dict[Any, Any]]) -> bool:
    return not base.is_number and all(base in each and each[base].is_Rational for each in powers)


@lru_cache(KEPT)
def _factors(expression: Any) -> list[tuple[Any, Any]]:
    """Its factors and their powers, as far as they are seen term by term."""
    return [each for factor in sympy.Mul.make_args(_in_factors(expression)) for each in _primitive(factor)]


def _primitive(factor: Any) -> list[tuple[Any, Any]]:
    """A number and the power of a sum, the same one of a sum and of its multiples."""
    base, power = factor.as_base_exp()
    if not (base.is_Add and power.is_Integer):
        return [(base, power)]
    number, rest = base.primitive()
    sign = -1 if rest.could_extract_minus_sign() else 1
    return [(sign * number, power), (sign * rest, power)]


@lru_cache(KEPT)
def _divided(expression: Any) -> tuple[Any, ...]:
    """What is divided by in it, outside of functions that are no quotients."""
    if type(expression) in QUOTIENTS:
        return _divided(QUOTIENTS[type(expression)](expression.args[0]))
    inner = expression.args if isinstance(expression, sympy.Add | sympy.Mul | sympy.Pow) else ()
    own = tuple(divisors([expression]))
    return tuple(dict.fromkeys((*own, *(base for part in inner for base in _divided(part)))))


@lru_cache(KEPT)
def _zeros(divisor: Any) -> tuple[SymbolValue, ...]:
    """Values of symbols, at which the divisor vanishes: numbers, and sums of other symbols."""
    if size_of(divisor) > MOST_PARTS or len(divisor.free_symbols) > _MOST_SYMBOLS:
        return ()
    together = _vanishing_together(divisor)
    tried = (point for factor in sympy.Mul.make_args(together[0]) for point in _tried(factor))
    return tuple(point for point in starmap(SymbolValue, tried) if all(map(point.vanish, together)))


def _vanishing_together(divisor: Any) -> list[Any]:
    """What is zero wherever the divisor is: in a sum of squares each of what is squared."""
    terms = [term.as_coeff_Mul() for term in divisor.args] if divisor.is_Add else []
    powers = [[factor.as_base_exp() for factor in sympy.Mul.make_args(product)] for _, product in terms]
    same = len({bool(number.is_positive) for number, _ in terms}) == 1
    if same and all(base is sympy.S.One or (exp.is_even and exp.is_positive) for of in powers for base, exp in of):
        return [sympy.Mul(*(base for base, _ in of)) for of in powers]
    return [divisor]


def _tried(divisor: Any) -> Iterator[tuple[Any, Any]]:
    symbols = sorted(divisor.free_symbols, key=sympy.default_sort_key)
    for symbol in symbols if divisor.is_Add else ():
        rest, term = divisor.as_independent(symbol, as_Add=True)
        number, power = term.as_coeff_Mul()
        base, exponent = power.as_base_exp()
        if base == symbol and exponent == 1 and rest.is_polynomial():
            yield symbol, -rest / number
            return
        if base == symbol and exponent.is_Integer and rest.is_polynomial() and not rest.is_Add:
            size, *others = (-rest / number).as_coeff_mul()
            powers = (factor.as_base_exp() for factor in (abs(size), *others[0]))
            root = sympy.Mul(*(b ** (e / exponent) for b, e in powers)) * (1 if size.is_positive else -1)
            yield from ((symbol, sign * root) for sign in ((1,) if exponent.is_odd else (1, -1)))
            return
    for apart in _sides_apart(divisor):
        yield from (point for factor in sympy.Mul.make_args(_in_factors(apart)) for point in _tried(factor))
    numbers = _NUMBERS + (_ANGLES if parts_of_kinds(divisor, (sympy.sin, sympy.cos, sympy.tan)) else ())
    for k, symbol in enumerate(symbols):
        yield from ((symbol, number) for number in numbers)
        yield from ((symbol, sign * other) for other in symbols[k + 1 :] for sign in (1, -1))


def _sides_apart(divisor: Any) -> Iterator[Any]:
    """Where a function equals another value of it, or a number: what is zero there."""
    terms = divisor.args if divisor.is_Add and len(divisor.args) == 2 else ()
    for term in (divisor,) if isinstance(divisor, sympy.log) else terms:
        number, f = term.as_coeff_Mul()
        value = (term - divisor) / number
        if isinstance(f, sympy.Function) and len(f.args) == 1 and f.free_symbols:
            if type(value) is type(f):
                yield f.args[0] - value.args[0]
            elif value.is_number and hasattr(f, "inverse"):
                with suppress(ValueError):
                    at = f.inverse()(value)
                    # SymPy says so here of a value that there is not.
                    at.evalf()
                    yield sympy.together(f.args[0] - at)
