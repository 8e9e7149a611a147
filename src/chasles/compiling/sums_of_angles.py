"""Sums of powers of an angle times functions of its multiples, with their limits where the angle is zero."""

from __future__ import annotations

from collections.abc import Callable, Collection, Iterable, Mapping
from functools import lru_cache, reduce
from itertools import islice
from random import Random
from typing import Any

import sympy
from sympy.codegen.cfunctions import log1p

from chasles.compiling.sharing import parts_before
from chasles.compiling.taylor import ANALYTIC, CIRCULAR, coefficient_of, left_of

Term = tuple[sympy.Rational, sympy.Rational, Any]
"""A power of the angle, which may be negative, times a function of a multiple of the angle; 1 is the cosine of zero."""
Sum = dict[Term, sympy.Expr]
QUOTIENTS: Mapping[Any, Callable[[Any], Any]] = {
    sympy.tan: lambda a: sympy.sin(a) / sympy.cos(a),
    sympy.cot: lambda a: sympy.cos(a) / sympy.sin(a),
    sympy.sec: lambda a: 1 / sympy.cos(a),
    sympy.csc: lambda a: 1 / sympy.sin(a),
    sympy.coth: lambda a: 1 / sympy.tanh(a),
    sympy.sech: lambda a: 1 / sympy.cosh(a),
    sympy.csch: lambda a: 1 / sympy.sinh(a),
}
"""What these are in others."""
KNOWN = (*ANALYTIC, *QUOTIENTS, sympy.log, sympy.atan2)
MOST_TERMS = 40
MOST_ORDER = 8
_PRIME = 2**61 - 1
_SEEDS = 64
"""So many points are tried; at half of them a root has a value."""
_POINTS = 8
KEPT = 2**15
"""Parts of which it is known what they are: expressions share them, and each is met many times."""


def parts_of(expression: sympy.Basic, others: Collection[sympy.Basic]) -> dict[sympy.Basic, None]:
    """The different parts of an expression, as they come, without the others and what is in them.

    SymPy's own ways to look for parts take a time that grows with the tree, in which what is shared stands many times.
    """
    found: dict[sympy.Basic, None] = {}
    waiting = [expression]
    while waiting:
        part = waiting.pop()
        if part not in found and part not in others:
            found[part] = None
            waiting += part.args
    return found


@lru_cache(KEPT)
def parts_of_kinds(expression: sympy.Basic, kinds: tuple[Any, ...], outside: tuple[Any, ...] = ()) -> frozenset[Any]:
    """The different parts of these kinds, those in such parts too, but none in parts of the kinds outside."""
    if isinstance(expression, outside):
        return frozenset()
    own = frozenset([expression] if isinstance(expression, kinds) else [])
    return own.union(*(parts_of_kinds(part, kinds, outside) for part in expression.args))


def divisors(parts: Iterable[sympy.Basic]) -> set[sympy.Expr]:
    """What the parts that are quotients divide by."""
    return {part.base for part in parts if isinstance(part, sympy.Pow) and part.exp.is_number and part.exp.is_negative}


@lru_cache(KEPT)
def angles_in(expression: sympy.Basic) -> frozenset[sympy.Expr]:
    """The angles that vary of which functions occur."""
    return frozenset(angle_of(part) for part in parts_of_kinds(expression, KNOWN) if not part.is_number)


def angle_of(function: Any) -> sympy.Expr:
    """The angle of which, times a number, a function is taken; of a logarithm what is added to 1, in parts of it."""
    return with_series(function).args[0].as_coeff_Mul()[1]


def with_series(function: Any) -> Any:
    """The function, or else one that has a series where the angle is zero; an arctangent in the right half-plane."""
    match function:
        case sympy.log():
            above, below = sympy.fraction(function.args[0])
            return log1p(sympy.Mul(above - below, 1 / below))
        case sympy.atan2(args=(y, x)) if not (slope := sympy.Mul(y, 1 / x)).is_number:
            return sympy.atan(slope)
    return function


def square_of(angle: sympy.Expr) -> sympy.Expr:
    """What an angle is the root of; its square, if it is no root."""
    return (
        angle.base
        if isinstance(angle, sympy.Pow) and angle.exp == sympy.S.Half
        else sympy.Pow(angle, 2, evaluate=not angle.is_Add)
    )


def degree_of_power(factor: sympy.Expr, angle: sympy.Expr) -> sympy.Rational | None:
    """The exponent of a power of the angle; None for what is none."""
    base, exponent = factor.as_base_exp()
    for known, times in ((angle, 1), (square_of(angle), 2)):
        if base == known and (times * exponent).is_Integer:
            return times * exponent
        if isinstance(known, sympy.Pow) and base == known.base and (exponent * times / known.exp).is_Integer:
            return exponent * times / known.exp
    return None


@lru_cache(KEPT)
def sum_of(expression: sympy.Expr, angle: sympy.Expr) -> Sum | None:
    """The expression as a sum; None where it is none, or too long a one."""
    degree = degree_of_power(expression, angle)
    if degree is not None:
        return {(degree, sympy.S.Zero, sympy.cos): sympy.S.One}
    if type(expression) in ANALYTIC:
        times, of = expression.args[0].as_coeff_Mul()
        if of == angle:
            return {(sympy.S.Zero, times, type(expression)): sympy.S.One}
    if angle not in angles_in(expression) and angle not in parts_of(expression, ()):
        return {(sympy.S.Zero, sympy.S.Zero, sympy.cos): expression}
    if isinstance(expression, sympy.Add):
        parts = [sum_of(part, angle) for part in expression.args]
        return None if None in parts else _gathered(item for part in parts for item in (part or {}).items())
    power = isinstance(expression, sympy.Pow) and expression.exp.is_Integer and expression.exp > 0
    if not isinstance(expression, sympy.Mul) and not power:
        return None
    factors = [expression.base] * int(expression.exp) if power else expression.args
    total: Sum | None = {(sympy.S.Zero, sympy.S.Zero, sympy.cos): sympy.S.One}
    for factor in factors:
        part = sum_of(factor, angle)
        if part is None or total is None or len(part) * len(total) > MOST_TERMS:
            return None
        products = [_times(one, other) for one in total.items() for other in part.items()]
        total = None if None in products else _gathered(item for found in products for item in found or ())
    return total


def _times(one: tuple[Term, Any], other: tuple[Term, Any]) -> list[tuple[Term, Any]] | None:
    """The product of two terms, in functions of sums and differences; None where it is none of these."""
    ((i, m, f), p), ((j, n, g), q) = one, other
    if not m or not n:
        return [((i + j, m or n, f if m else g), p * q)]
    if f is g is sympy.exp:
        return [((i + j, m + n, f), p * q)]
    for odd, even, of_two_odd in ((sympy.sin, sympy.cos, -1), (sympy.sinh, sympy.cosh, 1)):
        if {f, g} <= {odd, even}:
            product = even if f is g else odd
            first, second = (of_two_odd, -of_two_odd) if f is g is odd else (1, -1 if g is odd and f is even else 1)
            half = p * q / 2
            return [((i + j, m + n, product), first * half), ((i + j, m - n, product), second * half)]
    return None


def _gathered(terms: Iterable[tuple[Term, Any]]) -> Sum:
    """The terms by what they are times numbers, the multiples of angles of odd and even functions not negative."""
    found: Sum = {}
    for (degree, times, function), coefficient in terms:
        kind = ANALYTIC[function]
        turned = times < 0 and kind.step == 2
        term = degree, abs(times) if turned else times, function if times else sympy.cos
        if times or not kind.first:
            found[term] = found.get(term, sympy.S.Zero) + (-coefficient if turned and kind.first else coefficient)
    return found


def limited(found: Sum | None, angle: sympy.Expr, divided: int = 0) -> Any:
    """The sum over so many powers of the angle without a quotient; None where there is no limit."""
    order = divided if found is None else order_of(found, MOST_ORDER)
    if found is None or order < divided:
        return None
    total = []
    for (degree, times, function), coefficient in found.items():
        kind = ANALYTIC[function]
        singular = range(kind.first, int(order - degree), kind.step)
        first = singular.start + kind.step * len(singular)
        if times and degree >= order and function not in CIRCULAR:
            total.append(coefficient * angle ** (degree - divided) * function(times * angle))
        elif times or not first:
            left = left_of(function, first, times, angle, square_of(angle))
            total.append(coefficient * angle ** (degree - divided + first) * left)
    return reduce(sympy.Add, total, sympy.S.Zero)


def order_of(found: Sum, most: int) -> int:
    """The first power of the angle whose coefficient in the sum's series does not vanish, up to a largest one."""
    lowest = int(min((degree for degree, _, _ in found), default=most))
    return next((power for power in range(lowest, most) if not vanishes(_coefficient(found, power))), most)


def _coefficient(found: Sum, power: int) -> Any:
    """What a power of the angle has for its coefficient in the sum's series."""
    terms = []
    for (degree, times, function), coefficient in found.items():
        if power >= degree:
            order = int(power - degree)
            terms.append(coefficient_of(function, order) * times**order * coefficient)
    return sympy.Add(*terms)


@lru_cache(KEPT)
def vanishes(left: Any) -> bool:
    """Whether it is zero modulo a prime at points where symbols and functions have random values (Schwartz, 1980)."""
    residues = (_residue(left, Random(seed)) for seed in range(_SEEDS))
    known = (residue for residue in residues if residue is not None)
    return next(known, 1) == 0 and not any(islice(known, _POINTS))


def _residue(expression: Any, draw: Random) -> int | None:
    """The value modulo the prime, with one of both values of a root; None where a root or a reciprocal has none."""
    known: dict[sympy.Basic, int] = {}

    def of(part: Any) -> int:
        if part not in known:
            above, below = sympy.Rational(part).as_numer_denom() if part.is_Rational or part.is_Float else (0, 0)
            known[part] = int(above) * pow(int(below), -1, _PRIME) if below else draw.randrange(_PRIME)
        return known[part]

    for part in parts_before([expression]):
        match part:
            case sympy.Add():
                known[part] = sum(map(of, part.args)) % _PRIME
            case sympy.Mul():
                known[part] = reduce(lambda product, each: product * of(each) % _PRIME, part.args, 1)
            case sympy.Pow(args=(base, sympy.Rational() as exponent)) if exponent.q < 3:
                root = of(base)
                if exponent.q == 2:
                    root = pow(root, (_PRIME + 1) // 4, _PRIME) * draw.choice((1, -1))
                if (root**exponent.q - of(base)) % _PRIME or (exponent < 0 and root == 0):
                    return None
                known[part] = pow(root, int(exponent.p), _PRIME)
    return of(expression)
