"""Quotients of functions of an angle that have a limit where the angle is zero, written so that nothing is divided.

Where the angle is a root, a product or a sum it is a symbol meanwhile, and divided differences at zero are those by the
symbol: of sine and cosine functions of Stumpff (Himmelsmechanik I, 1959), whose derivatives are sums of them, so that a
Jacobian is as good as what it is of. What is left of other functions, such as exp, is a polynomial where the angle is
small; elsewhere a quotient of them stays as it is.
"""

from __future__ import annotations

from collections.abc import Collection, Iterator, Mapping
from typing import Any

import sympy
from sympy.concrete.expr_with_limits import ExprWithLimits
from sympy.core.relational import Relational

from chasles.compiling.angles import (
    ANGLE,
    KNOWN,
    QUOTIENTS,
    ROOT,
    WholeAngle,
    angle_of,
    divisors,
    parts_of,
    parts_of_kinds,
    square_of,
    with_series,
)
from chasles.compiling.complements import by_complements
from chasles.compiling.exponentials import with_points_together
from chasles.compiling.growth import in_range
from chasles.compiling.near_zero import in_squares, where_near, without_cancellation
from chasles.compiling.singular_points import without_singular_points
from chasles.compiling.taylor import NearZero, Stumpff, TaylorPolynomial
from chasles.compiling.variables import Substitution, outermost

LEFT = (Stumpff, TaylorPolynomial)
NORM = sympy.Dummy("norm", dummy_index=2, nonnegative=True)
"""The symbol in place of an angle that is a root."""
_ANGLES = {ANGLE, ROOT, NORM}


def without_removable(expression: sympy.Basic, symbols: dict[Any, Any] | None = None) -> sympy.Basic:
    """The same expression; it has a value where an angle is zero by which it divides, if it has a limit there.

    `symbols` has those that stand for what does not change with an angle, and gets more: expressions that have them in
    common are looked at once.
    """
    if any(isinstance(part, ExprWithLimits) for part in parts_of(expression, ())):
        # There is no program for it: what is said of it shall be said of what was given.
        return expression
    expression = by_complements(expression)
    parts = parts_of(expression, ())
    divided, found = divisors(parts), expression
    if divided or any(isinstance(part, tuple(QUOTIENTS)) for part in parts):
        table = dict(_by_roots(parts, divided))
        table |= {part: with_points_together(part) for part in parts if part.is_Add}
        found = _with_limits(
            Substitution(table).of(expression) if table else expression, {} if symbols is None else symbols
        )
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


def _with_limits(expression: sympy.Basic, symbols: dict[Any, Any]) -> sympy.Basic:
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
        table = {f: other for f in functions if (other := with_series(f)) != f}
        stated = Substitution(table).of(expression) if table else expression
        apart = _as_symbol(stated, angle)
        if apart is None:
            continue
        inner, back = apart
        # What does not change with the angle is a symbol, however long it is.
        rest = {part: symbols.setdefault(part, sympy.Dummy(real=True)) for part in outermost([inner], _is_fixed)}
        regular = _of_squares(without_singular_points(Substitution(rest).of(inner)))
        again = {dummy: part for part, dummy in rest.items()}
        found = back(Substitution(again).of(regular))
        # SymPy leaves the size of a square out, and what is put in for it may be negative.
        less = (sympy.StrictLessThan,)
        bare = {n for n in parts_of_kinds(found, less) - parts_of_kinds(stated, less) if n.rhs.is_number}
        sizes = {n: sympy.Abs(n.lhs, evaluate=False) < n.rhs for n in bare if not n.lhs.has(sympy.Abs)}
        found = Substitution(sizes).of(found) if sizes else found
        made = parts_of(found, ())
        if parts_of_kinds(found, LEFT) or len(divisors(made)) < len(divisors(parts)):
            expression = _as_stated(found, table, expression)
            parts = parts_of(expression, ())
    return expression


def _is_fixed(part: Any) -> bool:
    return (
        isinstance(part, sympy.Add | sympy.Mul)
        and _ANGLES.isdisjoint(parts_of_kinds(part, (sympy.Symbol,)))
        and not part.is_number
    )


def _as_symbol(stated: sympy.Basic, angle: sympy.Expr) -> Any:
    """The expression in a symbol for the angle, and the way back; None where nothing is divided by that vanishes."""
    # What is asked of signs is not asked of the symbol.
    conditions = {part: sympy.Dummy() for part in parts_of(stated, ()) if isinstance(part, Relational)}
    stated, again = Substitution(conditions).of(stated), {dummy: part for part, dummy in conditions.items()}
    square, parts = square_of(angle), parts_of(stated, ())
    divided, is_root = divisors(parts), angle != square and angle.is_Pow and angle.exp == sympy.S.Half
    if is_root and not square.is_Add:
        known = square if square.is_Symbol else -square
        if not known.is_Symbol or divided.isdisjoint((known, square, angle)):
            return None
        # Where there is the root there is none of the opposite.
        held = {part: sympy.Dummy(real=True) for part in parts if part.is_Pow and part.base == -square}
        table = {known: NORM**2 if known == square else -(NORM**2), **held}
        back = {NORM: angle, **again, **{dummy: part for part, dummy in held.items()}}
        return Substitution(table).of(stated), Substitution(back).of
    whole = WholeAngle(square if is_root else angle)
    if not whole.occurs_in(divided):
        return None
    inner = whole.of(stated)
    if is_root:
        return Substitution({whole.symbol: NORM**2}).of(inner), Substitution({NORM: angle, **again}).of
    return inner, lambda found: Substitution(again).of(whole.back(found))


def _as_stated(found: sympy.Basic, table: Mapping[Any, Any], stated: sympy.Basic) -> Any:
    """What is found, with functions as stated where they are left; an arctangent is one in the right half-plane."""
    kept = {other: f for f, other in table.items()}
    right = [f.args[1] > 0 for f in table if isinstance(f, sympy.atan2)]
    if right:
        less = (sympy.StrictLessThan,)
        made = parts_of_kinds(found, less) - parts_of_kinds(stated, less)
        kept |= {part: sympy.And(part, *right) for part in made}
    return Substitution(kept).of(found) if kept else found


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
