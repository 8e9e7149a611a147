"""What changes its form with a sign: Max and Min, absolute values, signs, steps and cases; and signs that are seen."""

from __future__ import annotations

from collections.abc import Callable, Iterable, Mapping
from typing import Any

import sympy
from sympy.core.relational import Relational

from chasles.from_sympy.enclosed_functions import NotEnclosed
from chasles.from_sympy.enclosures import ends_of
from chasles.from_sympy.opening import parts_of

SWITCHES = (sympy.Max, sympy.Min, sympy.Piecewise, sympy.Heaviside, sympy.sign, sympy.Abs)
BITS = 200
MOST_SYMBOLS = 3
"""Of quadratic polynomials in more symbols no sign is seen."""


def switches_in(expressions: Iterable[Any], *kinds: type) -> list[Any]:
    """The parts of some kinds, or of any that change with a sign, innermost first."""
    found = {part for e in expressions for part in parts_of(e) if isinstance(part, kinds or SWITCHES)}
    return sorted(found, key=lambda part: (len(part.atoms(*SWITCHES)), str(part)))


def powers_in(expressions: Iterable[Any], within: bool) -> list[Any]:
    """The powers with rational exponents within conditions, or those outside."""
    found: set[Any] = set()
    for e in expressions:
        outside = e.replace(lambda part: isinstance(part, sympy.Piecewise), lambda _: sympy.S.Zero)
        parts = e.atoms(sympy.Piecewise) if within else {outside}
        found |= {power for part in parts for power in part.atoms(sympy.Pow) if power.exp.is_Rational}
    return sorted(found, key=str)


def deciding(part: Any) -> list[Any]:
    """Whose signs decide the form of a part."""
    if isinstance(part, sympy.Piecewise):
        relations = [r for _, condition in part.args for r in sorted(condition.atoms(Relational), key=str)]
        return [r.lhs - r.rhs for r in relations]
    if isinstance(part, sympy.Max | sympy.Min):
        one, other = sorted(part.args, key=str)[:2]
        return [one - other]
    return [part.args[0]]


def _larger(arguments: tuple[Any, ...], sign: int | None, function: Any) -> Any:
    one, other, *rest = sorted(arguments, key=str)
    first = (sign or 0) >= 0 if function is sympy.Max else (sign or 0) <= 0
    return function(one if first else other, *rest)


HOLDING = {"==": (0,), "!=": (1, -1), ">": (1,), ">=": (0, 1), "<": (-1,), "<=": (0, -1)}
WRITTEN: Mapping[Any, Callable[[Any, Any], Any]] = {
    sympy.Max: lambda arguments, sign: _larger(arguments, sign, sympy.Max),
    sympy.Min: lambda arguments, sign: _larger(arguments, sign, sympy.Min),
    sympy.Abs: lambda arguments, sign: sign * arguments[0],
    sympy.sign: lambda _, sign: sympy.Integer(sign),
    sympy.Heaviside: lambda arguments, sign: sympy.Integer((sign + 1) // 2) if sign else arguments[1],
}


def factors_of(e: Any) -> list[Any]:
    """The irreducible factors of a quotient of polynomials, each as often as it occurs; else the expression itself."""
    above, below = sympy.fraction(sympy.together(e))
    if below.free_symbols:
        return [*factors_of(above), *factors_of(below)]
    symbols = sorted(e.free_symbols, key=str)
    if not symbols or not e.is_polynomial(*symbols) or e.has(*SWITCHES):
        return [e]
    return [factor for factor, power in sympy.factor_list(e)[1] for _ in range(int(power))]


def ratio_of(e: Any, other: Any) -> int | None:
    """The sign of a rational number by which one expression is a multiple of another; None if it is none."""
    one, rest = sympy.expand(e).as_content_primitive()
    two, same = sympy.expand(other).as_content_primitive()
    if sympy.expand(rest - same) == 0:
        return int(sympy.sign(one * two))
    return int(-sympy.sign(one * two)) if sympy.expand(rest + same) == 0 else None


def visible_sign(e: Any) -> int | None:
    """The sign that is seen from an expression alone."""
    if not e.free_symbols:
        if e == 0:
            return 0
        try:
            least, most = ends_of(e, BITS)
        except NotEnclosed:
            return None
        return 1 if least > 0 else -1 if most < 0 else None
    seen = 1 if e.is_positive else -1 if e.is_negative else 0 if e.is_zero else None
    return _sign_of_quadratic(e) if seen is None else seen


def _sign_of_quadratic(e: Any) -> int | None:
    """The sign of a quadratic polynomial in a symbol, if its discriminant is seen to be negative."""
    symbols = sorted(e.free_symbols, key=str)
    for symbol in symbols if len(symbols) <= MOST_SYMBOLS and e.is_polynomial(*symbols) else ():
        slope = sympy.diff(e, symbol)
        square, zero = sympy.diff(slope, symbol), {symbol: sympy.S.Zero}
        if not square.has(symbol) and visible_sign(2 * square * e.xreplace(zero) - slope.xreplace(zero) ** 2) == 1:
            return visible_sign(square)
    return None


def excludes(e: Any, sign: int) -> bool:
    """Whether it is seen from an expression alone that it has not this sign."""
    visible = visible_sign(e)
    return visible not in (None, sign) or bool(e.is_nonpositive if sign == 1 else sign and e.is_nonnegative)
