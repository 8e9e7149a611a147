"""What changes its form with a sign: Max and Min, absolute values, signs, steps and cases; and signs that are seen."""

from __future__ import annotations

from collections.abc import Callable, Iterable, Iterator
from itertools import combinations
from typing import Any

import sympy
from sympy.core.relational import Relational

from chasles.checker.expressions.defined_functions import without_calls
from chasles.checker.expressions.enclosed import sign_of_number, truth

SWITCHES = (sympy.Max, sympy.Min, sympy.Piecewise, sympy.Heaviside, sympy.sign, sympy.Abs)
Sign = Callable[[Any], int | None]
"""The sign of an expression, where it is known."""


def written(part: Any, sign_of: Sign) -> Any:
    """What a part is that changes its form; None where that takes a sign that is not known."""
    if isinstance(part, sympy.Piecewise):
        for value, condition in part.args:
            holds = truth(condition, sign_of)
            if holds is None or holds:
                return value if holds else None
        return sympy.nan
    if isinstance(part, sympy.Max | sympy.Min):
        for one, other in combinations(sorted(part.args, key=str), 2):
            sign = sign_of(one - other)
            if sign is not None:
                first = sign >= 0 if isinstance(part, sympy.Max) else sign <= 0
                least = other if first else one
                return part.func(*(e for e in part.args if e != least))
        return None
    sign = sign_of(part.args[0])
    if sign is None:
        return None
    if isinstance(part, sympy.Abs):
        return sign * part.args[0]
    if isinstance(part, sympy.sign):
        return sympy.Integer(sign)
    return sympy.Integer(max(sign, 0)) if sign else part.args[1]


def deciding(parts: Iterable[Any]) -> Iterator[Any]:
    """Whose signs decide the form of the parts: the factors of differences, and these themselves."""
    for part in parts:
        if isinstance(part, sympy.Piecewise):
            differences = [r.lhs - r.rhs for _, condition in part.args for r in condition.atoms(Relational)]
        elif isinstance(part, sympy.Max | sympy.Min):
            differences = [one - other for one, other in combinations(sorted(part.args, key=str), 2)]
        else:
            differences = [part.args[0]]
        for difference in differences:
            plain = difference.is_polynomial(*difference.free_symbols)
            for e in (difference,) if plain else sympy.fraction(sympy.together(difference)):
                if e.free_symbols and not e.has(*SWITCHES) and e.is_polynomial(*e.free_symbols):
                    yield from (factor for factor, _ in factored(e)[1])
            yield difference


def factored(e: Any) -> tuple[Any, list[tuple[Any, int]]]:
    """A number and the factors of a polynomial with their powers; itself where SymPy does not know its numbers."""
    try:
        return sympy.factor_list(e, *sorted(e.free_symbols, key=str))  # type: ignore[no-any-return]
    except sympy.PolynomialError:
        return sympy.S.One, [(e, 1)]


def visible_sign(e: Any) -> int | None:
    """The sign that an expression has whatever its symbols are."""
    if not e.free_symbols:
        return sign_of_number(e)
    known = without_calls(e)
    seen = 1 if known.is_positive else -1 if known.is_negative else 0 if known.is_zero else None
    return _sign_of_quadratic(e) if seen is None else seen


def _sign_of_quadratic(e: Any) -> int | None:
    """The sign of a quadratic polynomial in its first symbol, if the discriminant is seen to be negative."""
    symbol = min(e.free_symbols, key=str)
    slope = sympy.diff(e, symbol) if e.is_polynomial(*e.free_symbols) else symbol**2
    twice, zero = sympy.diff(slope, symbol), {symbol: sympy.S.Zero}
    negative = not twice.has(symbol) and visible_sign(2 * twice * e.xreplace(zero) - slope.xreplace(zero) ** 2) == 1
    return visible_sign(twice) if negative else None


def excludes(e: Any, sign: int) -> bool:
    """Whether an expression has not this sign, whatever its symbols are."""
    visible, known = visible_sign(e), without_calls(e)
    return visible not in (None, sign) or bool(known.is_nonpositive if sign == 1 else sign and known.is_nonnegative)
