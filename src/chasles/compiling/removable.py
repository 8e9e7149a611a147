"""Quotients of functions of an angle that have a limit where the angle is zero, written so that nothing is divided.

A power of an angle times a function of a multiple of it is what its Taylor polynomial leaves: cos(a) is
1 - a^2/2 + a^4 c_4(a^2), sin(a) is a - a^3 c_3(a^2), with the functions of Stumpff (Himmelsmechanik I, 1959). What is
divided by cancels, and so do the polynomials, if there is a limit. Derivatives of these functions are sums of them, so
that a Jacobian is as good as what it is of. What is left of other functions, such as exp, is a polynomial where the
angle is small; elsewhere a quotient of them stays as it stands.
"""

from __future__ import annotations

from collections.abc import Collection, Iterator, Mapping
from functools import lru_cache
from typing import Any

import sympy
from sympy.concrete.expr_with_limits import ExprWithLimits

from chasles.compiling.growth import in_range
from chasles.compiling.many_points import with_points_together
from chasles.compiling.near_zero import near_zero, without_cancellation
from chasles.compiling.singular_points import without_singular_points
from chasles.compiling.sums_of_angles import (
    KEPT,
    KNOWN,
    MOST_ORDER,
    QUOTIENTS,
    Sum,
    angle_of,
    angles_in,
    degree_of_power,
    divisors,
    limited,
    order_of,
    parts_of,
    parts_of_kinds,
    square_of,
    sum_of,
    with_series,
)
from chasles.compiling.taylor import Stumpff, TaylorPolynomial
from chasles.compiling.variables import Substitution
from chasles.compiling.whole_angles import WholeAngle

LEFT = (Stumpff, TaylorPolynomial)


def without_removable(expression: sympy.Basic) -> sympy.Basic:
    """The same expression; it has a value where an angle is zero by which it divides, if it has a limit there."""
    parts = parts_of(expression, ())
    if any(isinstance(part, ExprWithLimits) for part in parts):
        # There is no program for it: what is said of it shall be said of what was given.
        return expression
    divided, found = divisors(parts), expression
    if divided or any(isinstance(part, tuple(QUOTIENTS)) for part in parts):
        table = dict(_by_roots(parts, divided))
        table |= {part: with_points_together(part) for part in parts if part.is_Add}
        found = _with_limits(Substitution(table).of(expression) if table else expression)
    return without_cancellation(in_range(without_singular_points(found)))


def _by_roots(parts: Collection[sympy.Basic], divided: Collection[sympy.Expr]) -> Iterator[tuple[Any, Any]]:
    """Inverse cosines by the root that vanishes with them, where it is divided by: arccos(a) with 1 - a^2."""
    for part in parts:
        if isinstance(part, sympy.acos | sympy.acosh):
            [of] = part.args
            square = 1 - of**2 if isinstance(part, sympy.acos) else of**2 - 1
            root = next((sympy.sqrt(d) for d in divided if d == square or (d - square).expand() == 0), None)
            if root is not None:
                yield part, sympy.atan2(root, of) if isinstance(part, sympy.acos) else sympy.asinh(root)


def _with_limits(expression: sympy.Basic) -> sympy.Basic:
    """The expression, one angle after the other."""
    parts = parts_of(expression, ())
    divided = divisors(parts)
    quotients = {angle_of(part) for part in parts if isinstance(part, tuple(QUOTIENTS))}
    below = quotients.union(*map(angles_in, divided))
    by_angle: dict[sympy.Expr, list[sympy.Expr]] = {}
    for part in parts:
        if isinstance(part, KNOWN):
            by_angle.setdefault(angle_of(part), []).append(part)
    innermost = {f for functions in by_angle.values() for f in functions if not any(map(angles_in, f.args))}
    for angle, functions in by_angle.items():
        square = square_of(angle)
        # Of the root of -x the limits are those of the root of x with the other sign.
        turned = {-square: square} if (-square).is_Symbol else {}
        # Of a root of a sum the terms may be among others.
        whole = None
        if divided and (square.is_Add or not _is_root(angle)):
            whole = WholeAngle(square if square.is_Add else angle)
        held = {*divided, *parts_of(expression, innermost.union(functions))} if angle in below else divided
        if angle in held or not divided.isdisjoint((square, *turned)) or (whole and whole.occurs_in(held)):
            table = {f: other for f in functions if (other := with_series(f)) != f}
            stated = Substitution(table).of(expression) if table else expression
            if whole:
                symbol = sympy.sqrt(whole.symbol) if square.is_Add else whole.symbol
                found = whole.back(_regular(whole.of(stated), symbol))
            elif turned:
                turn = Substitution(turned).of
                found = turn(_regular(turn(stated), turn(angle)))
            else:
                found = _regular(stated, angle)
            made = parts_of(found, ())
            if parts_of_kinds(found, LEFT) or len(divisors(made)) < len(divisors(parts)):
                expression = _as_stated(found, table, expression)
                parts = parts_of(expression, ())
    return expression


def _as_stated(found: sympy.Basic, table: Mapping[Any, Any], stated: sympy.Basic) -> Any:
    """What is found, with functions as stated where they are left; an arctangent is one in the right half-plane."""
    kept = {other: f for f, other in table.items()}
    right = [f.args[1] > 0 for f in table if isinstance(f, sympy.atan2)]
    if right:
        less = (sympy.StrictLessThan,)
        made = parts_of_kinds(found, less) - parts_of_kinds(stated, less)
        kept |= {part: sympy.And(part, *right) for part in made}
    return Substitution(kept).of(found) if kept else found


def _is_root(angle: sympy.Expr) -> bool:
    """Whether it is a root, whose square SymPy keeps as a whole, or a function."""
    return not isinstance(angle, sympy.Add | sympy.Mul | sympy.Pow) or square_of(angle) == angle.args[0]


@lru_cache(KEPT)
def _regular(expression: sympy.Basic, angle: sympy.Expr) -> Any:
    if angle not in angles_in(expression):
        return expression
    singular: list[Any] = []
    match expression:
        case sympy.Piecewise():
            return _pieces(expression, angle)
        case sympy.Add():
            singular = [term for term in expression.args if _orders(term, angle)[0] < 0]
            whole = _together(singular, angle) if len(singular) > 1 else None
            if whole is not None:
                rest = [_regular(term, angle) for term in expression.args if term not in singular]
                return sympy.Add(near_zero(whole, sympy.Add(*singular), angle), *rest)
        case sympy.Mul():
            found = _product(expression, angle)
            near = near_zero(found, expression, angle)
            if near is not found and _orders(expression, angle)[0] >= 0:
                return near
            if near is found and (parts_of_kinds(found, (Stumpff,)) or _spelled(expression, angle) == expression):
                return found
    changed = [_regular(part, angle) for part in expression.args]
    if changed == list(expression.args):
        return expression
    found = expression.func(*changed)
    # What stays singular gains nothing by polynomials for the rest of it.
    vain = isinstance(expression, sympy.Add) and singular and parts_of_kinds(found, (TaylorPolynomial,))
    return expression if vain else found


@lru_cache(KEPT)
def _spelled(expression: sympy.Basic, angle: sympy.Expr) -> Any:
    """The expression with quotients of sines and cosines, or hyperbolic ones, of the angle written as such."""
    functions = parts_of_kinds(expression, tuple(QUOTIENTS))
    table = {f: QUOTIENTS[type(f)](f.args[0]) for f in functions if angle_of(f) == angle}
    return Substitution(table).of(expression) if table else expression


def _pieces(expression: sympy.Piecewise, angle: sympy.Expr) -> Any:
    """One piece is enough where the other says what its limit is."""
    parts = [(_regular(piece, angle), condition) for piece, condition in expression.args]
    if len(parts) == 2:
        (first, where), (second, _) = parts
        general, value = (first, second) if isinstance(where, sympy.Ne) else (second, first)
        zeros = dict.fromkeys(angle.free_symbols, 0)
        says = isinstance(where, sympy.Ne | sympy.Eq) and _says_zero(where, angle) and parts_of_kinds(general, LEFT)
        if says and (general.subs(zeros) - sympy.sympify(value).subs(zeros)).equals(0):
            return general
    return expression.func(*parts, evaluate=False)


def _says_zero(where: Any, angle: sympy.Expr) -> bool:
    """Whether an equation says that the angle is zero, and with it all symbols that it is made of."""
    sides = {where.lhs, where.rhs} - {sympy.S.Zero}
    squares = sympy.Add.make_args(square_of(angle))
    alone = all(isinstance(s, sympy.Pow) and s.base.is_Symbol and s.exp == 2 for s in squares)
    return len(sides) == 1 and alone and sides <= {angle, square_of(angle)}


def _together(terms: list[sympy.Expr], angle: sympy.Expr) -> Any:
    """The sum of terms none of which has a limit; None where it has none either."""
    total = _spelled(sympy.Add(*terms), angle)
    found = sum_of(total, angle)
    whole = limited(found, angle)
    # Of a sum in which what is singular stands for itself the same would come out again.
    if found is None:
        total = sympy.together(total)
        if isinstance(total, sympy.Mul) and _orders(total, angle)[0] >= 0:
            whole = _product(total, angle)
    return whole


Factor = tuple[sympy.Expr, sympy.Expr, Sum | None, int]
"""A base, its exponent, the base as a sum, and with which power of the angle it vanishes."""


@lru_cache(KEPT)
def _orders(term: sympy.Expr, angle: sympy.Expr) -> tuple[Any, Any, list[Factor]]:
    """With which power of the angle a product vanishes, the powers of the angle in it, and its other factors."""
    left: Any = sympy.S.Zero
    others = []
    for factor in sympy.Mul.make_args(_spelled(term, angle)):
        degree = degree_of_power(factor, angle)
        if degree is None:
            others.append(factor.as_base_exp())
        else:
            left += degree
    whole = [exponent.is_Integer and angle in angles_in(base) for base, exponent in others]
    if left >= 0 and not any(is_whole and exponent < 0 for is_whole, (_, exponent) in zip(whole, others, strict=True)):
        # Nothing is divided by what could vanish.
        return left, left, [(base, exponent, None, 0) for base, exponent in others]
    factors: list[Factor] = []
    for (base, exponent), is_whole in zip(others, whole, strict=True):
        sides = [(base, exponent)]
        if is_whole and base.is_Add and sum_of(base, angle) is None:
            above, below = _fraction(base, angle)
            if _order(above, angle) > 0:
                sides = [(above, exponent), (below, -exponent)]
        for side, power in sides:
            known = (sum_of(side, angle), _order(side, angle)) if is_whole else (None, 0)
            factors.append((side, power, *known))
    return left + sum(order * exponent for _, exponent, _, order in factors), left, factors


def _fraction(total: sympy.Add, angle: sympy.Expr) -> tuple[Any, Any]:
    """The sum over one denominator, of what its terms are divided by that holds the angle."""
    powers: dict[Any, Any] = {}
    for factor in (factor for term in total.args for factor in sympy.Mul.make_args(term)):
        base, exponent = factor.as_base_exp()
        if exponent.is_Integer and angle in angles_in(base):
            powers[base] = min(powers.get(base, 0), exponent)
    below = sympy.Mul(*(base**-exponent for base, exponent in powers.items()))
    return sympy.Add(*(term * below for term in total.args)), below


def _order(base: sympy.Expr, angle: sympy.Expr) -> int:
    """With which power of the angle a sum vanishes; nothing is known of what is none."""
    part = sum_of(base, angle)
    return 0 if part is None else max(order_of(part, MOST_ORDER), 0)


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
            taken.append(limited(part, angle, times) ** sign)
            repeated, rest, left = repeated - 1, rest - sign, left + sign * times
        taken.append(_regular(base, angle) ** (rest if rest.is_number else _regular(rest, angle)))
    return sympy.Mul(angle**left, *taken)
