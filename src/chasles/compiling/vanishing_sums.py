"""Sums of several functions that vanish with an angle to a higher order than their terms, as sin(a) - a cos(a) does.

Where the angle is small such a sum is the polynomial that is left of its series, which has all digits; elsewhere it
stays as it is. What the terms have in common besides the angle is a factor of it.
"""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from contextlib import suppress
from fractions import Fraction
from typing import Any

import sympy

from chasles.compiling.angles import KNOWN, MOST_PARTS, WholeAngle, angle_of, parts_of_kinds, size_of
from chasles.compiling.power_series import Series, SeriesAtZero
from chasles.compiling.taylor import NearZero, TaylorPolynomial
from chasles.lowering.refusal import LoweringError

_SEEN, _ALL = 8, 50
"""So many coefficients show that terms cancel; so many are enough."""
_ENOUGH = Fraction(1, 2**60)
"""What is left out of a polynomial, in parts of its first term."""
_MOST_BESIDE = Fraction(3, 4)
"""So much all other terms may be, in parts of the first: then nothing cancels among them."""
_LIMITS = (Fraction(2), *(Fraction(1, k) for k in (1, 2, 3, 4, 8)))


def in_series(total: Any) -> Any:
    """The sum, in which what vanishes to a higher order than its terms do is a polynomial near zero."""
    if size_of(total) > MOST_PARTS:
        return total
    for angle in _angles(total):
        whole = None if angle.is_Symbol else WholeAngle(angle)
        symbol = angle if whole is None else whole.symbol
        groups = _by_factor((total if whole is None else whole.of(total)).args, symbol)
        for common, own in groups.items():
            stated = sympy.Add(*own)
            left = None if len(own) < 2 or all(map(_is_circular, own)) else _left(stated, symbol)
            if left is not None:
                near = NearZero((left, _is_near(left)), (stated, True), evaluate=False)
                rest = (other * part for other, parts in groups.items() if other != common for part in parts)
                terms = (common * near, *rest)
                return sympy.Add(*(terms if whole is None else map(whole.back, terms)))
    return total


def _angles(total: Any) -> Iterator[Any]:
    """What functions in the terms are taken of, times a number; the one symbol of what is no function of an angle."""
    factors = dict.fromkeys(f for term in total.args for f in sympy.Mul.make_args(term))
    found: dict[Any, None] = {}
    for f in factors:
        angle = angle_of(f) if isinstance(f, KNOWN) and not isinstance(f, sympy.atan2) else f
        if not f.is_number and not f.as_base_exp()[0].is_Symbol:
            nested = angle is f or bool(parts_of_kinds(angle, KNOWN))
            symbols = angle.free_symbols
            if not nested or len(symbols) == 1:
                found[next(iter(symbols)) if nested else angle] = None
    yield from found


def _by_factor(terms: Sequence[Any], symbol: Any) -> dict[Any, list[Any]]:
    """The terms without what they have besides the symbol, by that factor."""
    found: dict[Any, list[Any]] = {}
    for term in terms:
        factor, own = term.as_independent(symbol, as_Add=False)
        number, common = factor.as_coeff_Mul()
        found.setdefault(common, []).append(number * own)
    return found


def _is_circular(term: Any) -> bool:
    """Whether it is a product of sines and cosines: sums of these are written in lowest terms of half their angle."""
    bases = (factor.as_base_exp() for factor in sympy.Mul.make_args(term) if not factor.is_number)
    return all(
        isinstance(base, sympy.sin | sympy.cos) and exponent.is_Integer and exponent > 0 for base, exponent in bases
    )


def _left(stated: Any, symbol: Any) -> Any:
    """The polynomial that is left where the terms cancel; None where they do not, or have no series."""
    with suppress(LoweringError):
        first, lowest = _orders(stated, symbol, _SEEN)
        if lowest < first < _SEEN:
            series = SeriesAtZero(symbol, _ALL).of(stated)[first:]
            step = 2 if not any(series[1::2]) else 1
            for limit in _LIMITS:
                kept = _kept(series[::step], limit**step)
                if kept:
                    numbers = [sympy.Rational(each.numerator, each.denominator) for each in (limit**step, *kept)]
                    return symbol**first * TaylorPolynomial(symbol**step, *numbers)
    return None


def _orders(stated: Any, symbol: Any, length: int) -> tuple[int, int]:
    """Of the sum the first power that there is, and that of its terms."""
    series = SeriesAtZero(symbol, length)
    orders = [next((k for k, each in enumerate(series.of(part)) if each), length) for part in (stated, *stated.args)]
    return orders[0], min(orders[1:])


def _kept(series: Series, limit: Fraction) -> Series:
    """The coefficients that count up to the limit; none where they are too many, or the first is not most of all."""
    sizes = [abs(each) * limit**k / abs(series[0]) for k, each in enumerate(series)]
    count = 1 + max(k for k, size in enumerate(sizes) if size > _ENOUGH)
    return series[:count] if count < len(series) * 4 // 5 and sum(sizes[1:]) <= _MOST_BESIDE else []


def _is_near(left: Any) -> Any:
    [polynomial] = left.atoms(TaylorPolynomial)
    return sympy.Abs(polynomial.args[0], evaluate=False) < polynomial.args[1]
