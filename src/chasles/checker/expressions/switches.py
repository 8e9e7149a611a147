"""What changes its form with a sign: Max and Min, absolute values, signs, steps and cases; and signs that are seen."""

from __future__ import annotations

from collections.abc import Iterable, Iterator
from itertools import combinations
from typing import Any

import sympy
from sympy.core.relational import Relational

from chasles.checker.expressions.complexes import BY_SIGN
from chasles.checker.expressions.enclosed import sign_of_number
from chasles.checker.expressions.visible import signs_of

LARGEST_DEGREE = 60
SWITCHES = (*BY_SIGN, sympy.Piecewise)


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
    """A number and the factors of a polynomial with their powers; itself if its degree is high, or SymPy knows none."""
    if any(power.exp.is_Integer and power.exp > LARGEST_DEGREE for power in e.atoms(sympy.Pow)):
        return sympy.S.One, [(e, 1)]
    try:
        return sympy.factor_list(e, *sorted(e.free_symbols, key=str))  # type: ignore[no-any-return]
    except sympy.PolynomialError:
        return sympy.S.One, [(e, 1)]


def visible_signs(e: Any) -> frozenset[int]:
    """The signs that an expression may have, whatever its symbols are."""
    known = None if e.free_symbols else sign_of_number(e)
    return signs_of(e) if known is None else frozenset((known,))
