"""Quotients of functions of an angle that have a limit where the angle is zero, written so that nothing is divided.

A power of an angle times a sine or cosine of a multiple of it is what its Taylor polynomial leaves: cos(a) is
1 - a^2/2 + a^4 c_4(a^2), sin(a) is a - a^3 c_3(a^2), with the functions of Stumpff (Himmelsmechanik I, 1959). What is
divided by cancels, and so do the polynomials, if there is a limit. Derivatives of these functions are sums of them, so
that a Jacobian is as good as what it is of.
"""

from __future__ import annotations

from collections.abc import Collection, Iterable, Iterator
from functools import lru_cache, reduce
from math import factorial
from typing import Any

import sympy

Term = tuple[sympy.Rational, sympy.Rational, bool]
"""A power of the angle, which may be negative, times the cosine, or else the sine, of a multiple of the angle."""
Sum = dict[Term, sympy.Expr]
_CIRCULAR = (sympy.sin, sympy.cos)
_QUOTIENTS = (sympy.tan, sympy.cot, sympy.sec, sympy.csc)
_KNOWN = (*_CIRCULAR, *_QUOTIENTS)
_MOST_TERMS = 40
_MOST_ORDER = 8
_KEPT = 2**15
"""Parts of which it is known what they are: expressions share them, and each is met many times."""


class Stumpff(sympy.Function):  # type: ignore[misc]
    """The function c_k of the square of a: the sum of (-1)^n a^(2 n) / (2 n + k)!."""

    nargs = (2,)
    is_real = True


def without_removable(expression: sympy.Basic) -> sympy.Basic:
    """The same expression; it has a value where an angle is zero by which it divides, if it has a limit there."""
    parts = _parts(expression, ())
    divided = {part.base for part in parts if isinstance(part, sympy.Pow) and part.exp.is_number and part.exp < 0}
    quotients = {_angle_of(part) for part in parts if isinstance(part, _QUOTIENTS)}
    below = quotients.union(*map(_angles, divided))
    by_angle: dict[sympy.Expr, list[sympy.Expr]] = {}
    for part in parts:
        if isinstance(part, _KNOWN):
            by_angle.setdefault(_angle_of(part), []).append(part)
    for angle, functions in by_angle.items():
        if angle in divided or _square(angle) in divided or (angle in below and angle in _parts(expression, functions)):
            spelled = {f: f.rewrite(sympy.cos) for f in functions if isinstance(f, sympy.sec)}
            spelled |= {f: f.rewrite(sympy.sin) for f in functions if isinstance(f, sympy.csc)}
            for f in functions:
                if isinstance(f, sympy.tan | sympy.cot):
                    quotient = sympy.sin(f.args[0]) / sympy.cos(f.args[0])
                    spelled[f] = quotient if isinstance(f, sympy.tan) else 1 / quotient
            found = _regular(expression.xreplace(spelled) if spelled else expression, angle)
            expression = found if any(isinstance(part, Stumpff) for part in _parts(found, ())) else expression
    return expression


def _parts(expression: sympy.Basic, others: Collection[sympy.Basic]) -> dict[sympy.Basic, None]:
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


@lru_cache(_KEPT)
def _angles(expression: sympy.Basic) -> frozenset[sympy.Expr]:
    """The angles that vary of which functions occur."""
    own = frozenset([_angle_of(expression)] if isinstance(expression, _KNOWN) and not expression.is_number else [])
    return own.union(*map(_angles, expression.args))


def _angle_of(function: Any) -> sympy.Expr:
    return function.args[0].as_coeff_Mul()[1]


def _square(angle: sympy.Expr) -> sympy.Expr:
    """What an angle is the root of; its square, if it is no root."""
    return angle.base if isinstance(angle, sympy.Pow) and angle.exp == sympy.S.Half else angle**2


@lru_cache(_KEPT)
def _regular(expression: sympy.Basic, angle: sympy.Expr) -> Any:
    if angle not in _angles(expression):
        return expression
    match expression:
        case sympy.Piecewise():
            return _pieces(expression, angle)
        case sympy.Add():
            singular = [term for term in expression.args if _orders(term, angle)[0] < 0]
            whole = _together(singular, angle) if len(singular) > 1 else None
            if whole is not None:
                rest = [_regular(term, angle) for term in expression.args if term not in singular]
                return sympy.Add(whole, *rest)
        case sympy.Mul():
            return _product(expression, angle)
    changed = [_regular(part, angle) for part in expression.args]
    return expression if changed == list(expression.args) else expression.func(*changed)


def _pieces(expression: sympy.Piecewise, angle: sympy.Expr) -> Any:
    """One piece is enough where the other says what its limit is."""
    parts = [(_regular(piece, angle), condition) for piece, condition in expression.args]
    if len(parts) == 2:
        (first, where), (second, _) = parts
        general, value = (first, second) if isinstance(where, sympy.Ne) else (second, first)
        zeros = dict.fromkeys(angle.free_symbols, 0)
        if isinstance(where, sympy.Ne | sympy.Eq) and _says_zero(where, angle) and general.has(Stumpff):
            at_zero = general.replace(Stumpff, lambda k, a: sympy.Rational(1, factorial(int(k))))
            if (at_zero.subs(zeros) - sympy.sympify(value).subs(zeros)).equals(0):
                return general
    return sympy.Piecewise(*parts)


def _says_zero(where: Any, angle: sympy.Expr) -> bool:
    """Whether an equation says that the angle is zero, and with it all symbols that it is made of."""
    sides = {where.lhs, where.rhs} - {sympy.S.Zero}
    squares = sympy.Add.make_args(_square(angle))
    alone = all(isinstance(s, sympy.Pow) and s.base.is_Symbol and s.exp == 2 for s in squares)
    return len(sides) == 1 and alone and sides <= {angle, _square(angle)}


def _together(terms: list[sympy.Expr], angle: sympy.Expr) -> Any:
    """The sum of terms none of which has a limit; None where it has none either."""
    total = sympy.Add(*terms)
    whole = _limited(_sum(total, angle), angle)
    if whole is None:
        total = sympy.together(total)
        if isinstance(total, sympy.Mul) and _orders(total, angle)[0] >= 0:
            whole = _product(total, angle)
    return whole


Factor = tuple[sympy.Expr, sympy.Expr, Sum | None, int]
"""A base, its exponent, the base as a sum, and with which power of the angle it vanishes."""


@lru_cache(_KEPT)
def _orders(term: sympy.Expr, angle: sympy.Expr) -> tuple[Any, Any, list[Factor]]:
    """With which power of the angle a product vanishes, the powers of the angle in it, and its other factors."""
    left: Any = sympy.S.Zero
    others = []
    for factor in sympy.Mul.make_args(term):
        degree = _degree_of_power(factor, angle)
        if degree is None:
            others.append(factor.as_base_exp())
        else:
            left += degree
    whole = [exponent.is_Integer and angle in _angles(base) for base, exponent in others]
    if left >= 0 and not any(is_whole and exponent < 0 for is_whole, (_, exponent) in zip(whole, others, strict=True)):
        # Nothing is divided by what could vanish.
        return left, left, [(base, exponent, None, 0) for base, exponent in others]
    factors: list[Factor] = []
    for (base, exponent), is_whole in zip(others, whole, strict=True):
        part = _sum(base, angle) if is_whole else None
        order = 0
        while order < _MOST_ORDER and part is not None and _limited(part, angle, order + 1) is not None:
            order += 1
        factors.append((base, exponent, part, order))
    return left + sum(order * exponent for _, exponent, _, order in factors), left, factors


def _product(expression: sympy.Expr, angle: sympy.Expr) -> Any:
    """What vanishes with the angle above and below a line is divided by the angle on both sides."""
    _, left, factors = _orders(expression, angle)
    above = max(left, 0) + sum(order * exponent for _, exponent, _, order in factors if exponent.is_positive)
    taken = []
    for base, exponent, part, order in sorted(factors, key=lambda factor: bool(factor[1].is_positive)):
        repeated = abs(int(exponent)) if order else 0
        sign, rest = sympy.sign(exponent) if order else 1, exponent
        while repeated and above and (left < 0 or sign < 0):
            times = order if sign < 0 else min(order, -left)
            taken.append(_limited(part, angle, times) ** sign)
            repeated, rest, left = repeated - 1, rest - sign, left + sign * times
        taken.append(_regular(base, angle) ** (rest if rest.is_number else _regular(rest, angle)))
    return sympy.Mul(angle**left, *taken)


def _degree_of_power(factor: sympy.Expr, angle: sympy.Expr) -> sympy.Rational | None:
    """The exponent of a power of the angle; None for what is none."""
    base, exponent = factor.as_base_exp()
    for known, times in ((angle, 1), (_square(angle), 2)):
        if base == known and (times * exponent).is_Integer:
            return times * exponent
        if isinstance(known, sympy.Pow) and base == known.base and (exponent * times / known.exp).is_Integer:
            return exponent * times / known.exp
    return None


@lru_cache(_KEPT)
def _sum(expression: sympy.Expr, angle: sympy.Expr) -> Sum | None:
    """The expression as a sum; None where it is none, or too long a one."""
    degree = _degree_of_power(expression, angle)
    if degree is not None:
        return {(degree, sympy.S.Zero, True): sympy.S.One}
    if isinstance(expression, _CIRCULAR):
        times, of = expression.args[0].as_coeff_Mul()
        if of == angle:
            sign = -1 if times < 0 and isinstance(expression, sympy.sin) else 1
            return {(sympy.S.Zero, abs(times), isinstance(expression, sympy.cos)): sympy.Integer(sign)}
    if not _angles(expression) and angle not in _parts(expression, ()):
        return {(sympy.S.Zero, sympy.S.Zero, True): expression}
    if isinstance(expression, sympy.Add):
        parts = [_sum(part, angle) for part in expression.args]
        return None if None in parts else _gathered(item for part in parts for item in (part or {}).items())
    power = isinstance(expression, sympy.Pow) and expression.exp.is_Integer and expression.exp > 0
    if not isinstance(expression, sympy.Mul) and not power:
        return None
    factors = [expression.base] * int(expression.exp) if power else expression.args
    total: Sum | None = {(sympy.S.Zero, sympy.S.Zero, True): sympy.S.One}
    for factor in factors:
        part = _sum(factor, angle)
        if part is None or total is None or len(part) * len(total) > _MOST_TERMS:
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


def _limited(found: Sum | None, angle: sympy.Expr, divided: int = 0) -> Any:
    """The sum over so many powers of the angle without a quotient; None where there is no limit."""
    if found is None:
        return None
    polynomial: dict[Any, Any] = {}
    total = []
    for (degree, times, even), coefficient in found.items():
        power, order = degree - divided, 0 if even else 1
        while power + order < 0:
            term = coefficient * times**order * (-1) ** (order // 2) / factorial(order)
            polynomial[power + order] = polynomial.get(power + order, 0) + term
            order += 2
        if times or not order:
            function = Stumpff(order, times * angle) if order else sympy.cos(times * angle)
            total.append(coefficient * (-1) ** (order // 2) * times**order * angle ** (power + order) * function)
    if any(sympy.expand(left) != 0 for left in polynomial.values()):
        return None
    return reduce(sympy.Add, total, sympy.S.Zero)
