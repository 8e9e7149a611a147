"""Quotients with a limit where a symbol is another one, or a number, written so that nothing is divided there."""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from functools import lru_cache
from operator import is_
from typing import Any

import sympy

from chasles.compiling.divided_differences import NO_VALUES, DividedDifferences
from chasles.compiling.sums_of_angles import KEPT, divisors, parts_of_kinds
from chasles.compiling.taylor import NearZero
from chasles.lowering.refusal import LoweringError

_MOST_PARTS = 80
"""Larger quotients stay as they are."""
_MOST_SYMBOLS = 4
_MOST_ORDER = 4
_NUMBERS = tuple(map(sympy.sympify, (0, 1, -1)))
_ANGLES = tuple(number * sympy.pi / 2 for number in (1, -1, 2, -2))


def without_singular_points(expression: Any) -> Any:
    """The expression; where it divides by what vanishes as a symbol comes to a point, it has its limit."""
    whole = isinstance(expression, NearZero | sympy.logic.boolalg.Boolean)
    return expression if whole or not divisors(parts_of_kinds(expression, (sympy.Pow,))) else _without(expression)


@lru_cache(KEPT)
def _without(expression: Any) -> Any:
    if isinstance(expression, sympy.Add | sympy.Mul | sympy.Pow):
        found = _regular(expression)
        if found is not None:
            return found
    parts = [without_singular_points(part) for part in expression.args]
    return expression if all(map(is_, parts, expression.args)) else expression.func(*parts)


def _regular(expression: Any) -> Any:
    """What it is with a limit; None where none is found."""
    join, way = (sympy.Add, _of_sum) if expression.is_Add else (sympy.Mul, _of_product)
    parts = [part for part in join.make_args(expression) if _size(part) <= _MOST_PARTS]
    below = [base for part in parts for factor in sympy.Mul.make_args(part) for base in divisors([factor])]
    if not below or len(parts) < 2:
        return None
    points = [point for divisor in dict.fromkeys(below) for point in _zeros(divisor)]
    own: list[Any] = []
    found, known = None, sympy.false
    for symbol, point in dict.fromkeys(points):
        differences = DividedDifferences(symbol, point)
        if differences.at_point(known) == sympy.true:
            continue
        try:
            near, singular = way(parts, differences)
        except LoweringError:
            continue
        where = sympy.And(*differences.conditions_of(near))
        near = without_singular_points(near)
        if found is None:
            own, found = singular, join(*singular)
        if singular == own:
            found, known = NearZero((near, where), (found, True), evaluate=False), where
            if where == sympy.true:
                found = near
                break
    if found is None:
        return None
    rest = join(*(part for part in join.make_args(expression) if part not in own))
    return join(found, without_singular_points(rest))


def _of_product(factors: Sequence[Any], differences: DividedDifferences) -> tuple[Any, list[Any]]:
    """What is left of the factors that vanish, and these. Raises `LoweringError` where there is no limit."""
    split = {factor: factor.as_base_exp() for factor in factors}
    own = {factor: powers for factor, powers in split.items() if differences.vanish(powers[0])}
    if not all(e.is_Integer for _, e in own.values()) or not any(e > 0 for _, e in own.values()):
        raise LoweringError("there is no limit")
    found, order = [], 0
    for base, exponent in own.values():
        left, times = base, 0
        if exponent > 0:
            # What is a factor of all terms is no part of a sum that vanishes.
            left, *others = sorted(sympy.Mul.make_args(sympy.factor_terms(base)), key=differences.vanish, reverse=True)
            found.append(sympy.Mul(*others) ** exponent)
        while times < _MOST_ORDER and differences.vanish(left):
            left, times = differences.of(left), times + 1
        found.append(left**exponent)
        order += times * exponent
    near = sympy.Mul(*found, differences.apart**order)
    if order < 0 or differences.at_point(near).has(*NO_VALUES):
        raise LoweringError("there is no limit")
    return near, list(own)


def _of_sum(terms: Sequence[Any], differences: DividedDifferences) -> tuple[Any, list[Any]]:
    """What is left of terms without limits, over one denominator, and these. Raises `LoweringError` as above."""
    common: dict[Any, Any] = {}
    singular = []
    for term in terms:
        if any(map(differences.vanish, divisors(sympy.Mul.make_args(term)))):
            factors = [each for factor in sympy.Mul.make_args(term) for each in _split(*factor.as_base_exp())]
            powers = {base: -exponent for base, exponent in factors if differences.vanish(base) and exponent < 0}
            common |= {base: max(exponent, common.get(base, 0)) for base, exponent in powers.items()}
            singular.append((term, sympy.Mul(*(b**e for b, e in factors if b not in powers)), powers))
    if len(singular) < 2:
        raise LoweringError("there is no sum of them")
    above = sympy.Add(
        *(left * sympy.Mul(*(b ** (e - powers.get(b, 0)) for b, e in common.items())) for _, left, powers in singular)
    )
    near, _ = _of_product([above, *(base**-exponent for base, exponent in common.items())], differences)
    return near, [term for term, _, _ in singular]


def _split(base: Any, exponent: Any) -> Iterator[tuple[Any, Any]]:
    """The power of a sum as powers of factors, the same of a sum and of its multiples."""
    if not (base.is_Add and exponent.is_Integer):
        yield base, exponent
        return
    for factor in sympy.Mul.make_args(sympy.factor_terms(base)):
        number, rest = factor.primitive() if factor.is_Add else (sympy.S.One, factor)
        sign = -1 if rest.could_extract_minus_sign() and not rest.is_number else 1
        yield from ((sign * number, exponent), (sign * rest, exponent))


@lru_cache(KEPT)
def _size(expression: Any) -> int:
    return 1 + sum(map(_size, expression.args))


@lru_cache(KEPT)
def _zeros(divisor: Any) -> tuple[tuple[Any, Any], ...]:
    """Symbols, and values at which the divisor vanishes: numbers, and sums of other symbols."""
    large = _size(divisor) > _MOST_PARTS or len(divisor.free_symbols) > _MOST_SYMBOLS
    if large or (divisor.is_Add and _is_sum_of_squares(divisor)):
        return ()
    return tuple(point for point in _tried(divisor) if DividedDifferences(*point).vanish(divisor))


def _is_sum_of_squares(total: sympy.Add) -> bool:
    terms = [term.as_coeff_Mul() for term in total.args]
    factors = (factor for _, product in terms for factor in sympy.Mul.make_args(product))
    same = len({bool(number.is_positive) for number, _ in terms}) == 1
    return same and all(f is sympy.S.One or (f.is_Pow and f.exp.is_even) for f in factors)


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
            root = sympy.Mul(*(b ** (e / exponent) for b, e in map(_powers, sympy.Mul.make_args(-rest / number))))
            yield from ((symbol, root), (symbol, -root))
            return
    for apart in _sides_apart(divisor):
        yield from (point for factor in sympy.Mul.make_args(sympy.factor_terms(apart)) for point in _tried(factor))
    if len(symbols) == 1:
        numbers = _NUMBERS + (_ANGLES if parts_of_kinds(divisor, (sympy.sin, sympy.cos, sympy.tan)) else ())
        yield from ((symbols[0], number) for number in numbers)
    for k, symbol in enumerate(symbols):
        yield from ((symbol, sign * other) for other in symbols[k + 1 :] for sign in (1, -1))


def _sides_apart(divisor: Any) -> Iterator[Any]:
    """Where a function equals another value of it, or a number: what is zero there."""
    for term in divisor.args if divisor.is_Add and len(divisor.args) == 2 else ():
        number, f = term.as_coeff_Mul()
        value = (term - divisor) / number
        if isinstance(f, sympy.Function) and len(f.args) == 1:
            if type(value) is type(f):
                yield f.args[0] - value.args[0]
            elif value.is_number and hasattr(f, "inverse"):
                yield f.args[0] - f.inverse()(value)


def _powers(factor: Any) -> tuple[Any, Any]:
    return (factor, sympy.S.One) if factor.is_Number else factor.as_base_exp()
