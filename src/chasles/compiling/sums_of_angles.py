"""Sums of powers of an angle times sines and cosines of its multiples, with their limits where the angle is zero."""

from __future__ import annotations

from collections.abc import Collection, Iterable, Iterator
from functools import lru_cache, reduce
from math import factorial
from typing import Any

import sympy

Term = tuple[sympy.Rational, sympy.Rational, bool]
"""A power of the angle, which may be negative, times the cosine, or else the sine, of a multiple of the angle."""
Sum = dict[Term, sympy.Expr]
CIRCULAR = (sympy.sin, sympy.cos)
QUOTIENTS = (sympy.tan, sympy.cot, sympy.sec, sympy.csc)
KNOWN = (*CIRCULAR, *QUOTIENTS)
MOST_TERMS = 40
KEPT = 2**15
"""Parts of which it is known what they are: expressions share them, and each is met many times."""


class Stumpff(sympy.Function):  # type: ignore[misc]
    """The function c_k of the square of a: the sum of (-1)^n a^(2 n) / (2 n + k)!."""

    nargs = (2,)
    is_real = True


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
def angles_in(expression: sympy.Basic) -> frozenset[sympy.Expr]:
    """The angles that vary of which functions occur."""
    own = frozenset([angle_of(expression)] if isinstance(expression, KNOWN) and not expression.is_number else [])
    return own.union(*map(angles_in, expression.args))


def angle_of(function: Any) -> sympy.Expr:
    """The angle of which, times a number, a function is taken."""
    return function.args[0].as_coeff_Mul()[1]


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
        return {(degree, sympy.S.Zero, True): sympy.S.One}
    if isinstance(expression, CIRCULAR):
        times, of = expression.args[0].as_coeff_Mul()
        if of == angle:
            sign = -1 if times < 0 and isinstance(expression, sympy.sin) else 1
            return {(sympy.S.Zero, abs(times), isinstance(expression, sympy.cos)): sympy.Integer(sign)}
    if not angles_in(expression) and angle not in parts_of(expression, ()):
        return {(sympy.S.Zero, sympy.S.Zero, True): expression}
    if isinstance(expression, sympy.Add):
        parts = [sum_of(part, angle) for part in expression.args]
        return None if None in parts else _gathered(item for part in parts for item in (part or {}).items())
    power = isinstance(expression, sympy.Pow) and expression.exp.is_Integer and expression.exp > 0
    if not isinstance(expression, sympy.Mul) and not power:
        return None
    factors = [expression.base] * int(expression.exp) if power else expression.args
    total: Sum | None = {(sympy.S.Zero, sympy.S.Zero, True): sympy.S.One}
    for factor in factors:
        part = sum_of(factor, angle)
        if part is None or total is None or len(part) * len(total) > MOST_TERMS:
            return None
        total = _gathered(item for one in total.items() for other in part.items() for item in _times(one, other))
    return total


def _times(one: tuple[Term, Any], other: tuple[Term, Any]) -> Iterator[tuple[Term, Any]]:
    """The product of two terms, in sines and cosines of sums and differences."""
    ((i, m, even), p), ((j, n, even_), q) = one, other
    for multiple, sign in ((m + n, 1), (m - n, -1)):
        if even and even_:
            factor = sympy.S.Half
        elif not even and not even_:
            factor = -sign * sympy.S.Half
        else:
            # sin(m) cos(n) and cos(m) sin(n), of which the second is half of sin(m + n) - sin(m - n).
            factor = sympy.S.Half if even_ else sign * sympy.S.Half
            factor = -factor if multiple < 0 else factor
        yield (i + j, abs(multiple), even == even_), factor * p * q


def _gathered(terms: Iterable[tuple[Term, Any]]) -> Sum:
    found: Sum = {}
    for term, coefficient in terms:
        if term[1] or term[2]:
            found[term] = found.get(term, sympy.S.Zero) + coefficient
    return found


def limited(found: Sum | None, angle: sympy.Expr, divided: int = 0) -> Any:
    """The sum over so many powers of the angle without a quotient; None where there is no limit."""
    if found is None or not has_limit(found, divided):
        return None
    total = []
    for (degree, times, even), coefficient in found.items():
        singular = _singular(degree, divided, even=even)
        order = singular.start + 2 * len(singular)
        if times or not order:
            function = Stumpff(order, times * angle) if order else sympy.cos(times * angle)
            power = degree - divided + order
            total.append(coefficient * (-1) ** (order // 2) * times**order * angle**power * function)
    return reduce(sympy.Add, total, sympy.S.Zero)


def has_limit(found: Sum, divided: int) -> bool:
    """Whether the sum over so many powers of the angle has one: what is singular in its terms cancels."""
    return order_of(found, divided) == divided


def order_of(found: Sum, most: int) -> int:
    """The first power of the angle whose coefficient in the sum's series does not vanish, up to a largest one."""
    lowest = int(min((degree for degree, _, _ in found), default=most))
    return next((power for power in range(lowest, most) if not _vanishes(_coefficient(found, power))), most)


def _coefficient(found: Sum, power: int) -> Any:
    """What a power of the angle has for its coefficient in the sum's series."""
    terms = []
    for (degree, times, even), coefficient in found.items():
        order = int(power - degree)
        if order >= 0 and order % 2 != even:
            terms.append(sympy.Rational((-1) ** (order // 2), factorial(order)) * times**order * coefficient)
    return sympy.Add(*terms)


@lru_cache(KEPT)
def _vanishes(left: Any) -> bool:
    """Whether nothing is left once it is multiplied out; what holds no product or power of a sum is so already."""
    nested = any(
        isinstance(inner, sympy.Add)
        for part in parts_of(left, ())
        if isinstance(part, sympy.Mul | sympy.Pow | sympy.exp)
        for inner in part.args
    )
    return bool((sympy.expand(left) if nested else left) == 0)


def _singular(degree: sympy.Rational, divided: int, *, even: bool) -> range:
    """The orders of the terms of a sine's or cosine's series that are singular, times and over these powers."""
    return range(0 if even else 1, int(divided - degree), 2)
