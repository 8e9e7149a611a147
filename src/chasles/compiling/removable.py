"""Quotients of functions of an angle that have a limit where the angle is zero, written so that nothing is divided.

Where the angle is a root, a product or a sum it is a symbol meanwhile, and divided differences at zero are those by the
symbol: of sine and cosine functions of Stumpff (Himmelsmechanik I, 1959), whose derivatives are sums of them, so that a
Jacobian is as good as what it is of. What is left of other functions, such as exp, is a polynomial where the angle is
small; elsewhere a quotient of them stays as it is.
"""

from __future__ import annotations

from collections.abc import Collection, Iterator
from typing import Any

import sympy
from sympy.concrete.expr_with_limits import ExprWithLimits

from chasles.compiling.angle_symbols import NORM, AngleSymbols
from chasles.compiling.angles import KNOWN, QUOTIENTS, ROOT, angle_of, divisors, parts_of, parts_of_kinds
from chasles.compiling.complements import by_complements
from chasles.compiling.exponentials import with_points_together
from chasles.compiling.growth import in_range
from chasles.compiling.near_zero import in_squares, where_near, without_cancellation
from chasles.compiling.singular_points import without_singular_points
from chasles.compiling.taylor import NearZero, Stumpff, TaylorPolynomial
from chasles.compiling.variables import Substitution

LEFT = (Stumpff, TaylorPolynomial)


def without_removable(expression: sympy.Basic, symbols: AngleSymbols | None = None) -> sympy.Basic:
    """The same expression; it has a value where an angle is zero by which it divides, if it has a limit there.

    Expressions that are given the same `symbols` are looked at once where they have parts in common.
    """
    if any(isinstance(part, ExprWithLimits | sympy.Limit) for part in parts_of(expression, ())):
        # There is no program for it: what is said of it shall be said of what was given.
        return expression
    expression = by_complements(expression)
    parts = parts_of(expression, ())
    divided, found = divisors(parts), expression
    if divided or any(isinstance(part, tuple(QUOTIENTS)) for part in parts):
        table = dict(_by_roots(parts, divided))
        table |= {part: with_points_together(part) for part in parts if part.is_Add}
        found = _with_limits(Substitution(table).of(expression) if table else expression, symbols or AngleSymbols())
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


def _with_limits(expression: sympy.Basic, symbols: AngleSymbols) -> sympy.Basic:
    """The expression, one angle after the other."""
    parts = parts_of(expression, ())
    divided = divisors(parts)
    by_angle: dict[sympy.Expr, list[sympy.Expr]] = {}
    for part in parts:
        if isinstance(part, KNOWN):
            by_angle.setdefault(angle_of(part), []).append(part)
    for angle, functions in by_angle.items():
        if angle.is_Symbol or not divided:
            continue
        symbol = symbols.of(angle)
        stated, table = symbol.in_series(expression, functions)
        inner = symbol.of(stated)
        if inner is None:
            continue
        regular = _of_squares(without_singular_points(symbols.without_fixed(inner)))
        found = symbol.back(symbols.with_fixed(regular))
        # SymPy leaves the size of a square out, and what is put in for it may be negative.
        less = (sympy.StrictLessThan,)
        bare = {n for n in parts_of_kinds(found, less) - parts_of_kinds(stated, less) if n.rhs.is_number}
        sizes = {n: sympy.Abs(n.lhs, evaluate=False) < n.rhs for n in bare if not n.lhs.has(sympy.Abs)}
        found = Substitution(sizes).of(found) if sizes else found
        made = parts_of(found, ())
        if parts_of_kinds(found, LEFT) or len(divisors(made)) < len(divisors(parts)):
            expression = symbol.as_stated(found, table, expression)
            parts = parts_of(expression, ())
    return expression


def _of_squares(expression: Any) -> Any:
    """The expression, near zero in functions of the squares of roots, what is beside a case too."""
    table = {}
    for product in parts_of_kinds(expression, (sympy.Mul, NearZero)):
        factors = sympy.Mul.make_args(product)
        for case in (factor for factor in factors if isinstance(factor, NearZero)):
            (near, where), (stated, _) = case.args
            beside = sympy.Mul(*(f for f in factors if f is not case and _in_squares(f) != f))
            found = _in_squares(near * beside)
            if found != near:
                new = NearZero((found, sympy.And(where, where_near(found))), (stated * beside, True), evaluate=False)
                table[product] = product / case / beside * new
    return Substitution(table).of(expression) if table else expression


def _in_squares(expression: Any) -> Any:
    return in_squares(in_squares(expression, NORM), ROOT)
