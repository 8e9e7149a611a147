"""Where a form changes: points at which the argument of a sign is zero, equations hold, or an angle is a half turn."""

from __future__ import annotations

from collections.abc import Iterator
from itertools import islice
from typing import Any

import sympy

from chasles.from_sympy.complex_symbols import expressions_in
from chasles.from_sympy.decimals import with_values
from chasles.from_sympy.factors import factors_of
from chasles.from_sympy.side_conditions import listed

MOST = 4
"""So many forms are looked at, and so many factors of each."""


def where_forms_change(lhs: Any, rhs: Any, given: Any, nonzero: Any) -> Iterator[tuple[Any, Any, Any, Any]]:
    """The question where a factor of a sign's argument, or of a difference that is compared, is given to vanish.

    And where an angle is a half turn: half of it has no tangent there by which it could be read.
    """
    conditions = [item for _, item in listed(given, "given")]
    yield from _half_turns((lhs, rhs), conditions, nonzero)
    parts = {part for e in expressions_in((lhs, rhs)) for part in e.atoms(sympy.sign, sympy.Eq, sympy.Ne)}
    for part in sorted(parts, key=str)[:MOST]:
        sides = with_values((lhs, rhs), {part: part.func(*(0 for _ in part.args))})
        difference = part.args[0] if isinstance(part, sympy.sign) else part.lhs - part.rhs
        factors = (factor for factor, power, _ in factors_of(difference) if power.is_positive and factor.free_symbols)
        for factor in islice(factors, MOST):
            yield (*sides, [*conditions, sympy.Eq(factor, 0, evaluate=False)], nonzero)


def _half_turns(sides: tuple[Any, Any], conditions: list[Any], nonzero: Any) -> Iterator[tuple[Any, Any, Any, Any]]:
    parts = {part for e in expressions_in(sides) for part in e.atoms(sympy.atan2, sympy.arg)}
    for part in sorted(parts, key=str)[:MOST]:
        y, x = part.args if isinstance(part, sympy.atan2) else (sympy.im(part.args[0]), sympy.re(part.args[0]))
        behind = [sympy.Eq(y, 0, evaluate=False), sympy.Eq(sympy.Abs(x), -x, evaluate=False)]
        apart = [*(item for _, item in listed(nonzero, "nonzero")), x]
        yield (*with_values(sides, {part: sympy.pi}), [*conditions, *behind], apart)
