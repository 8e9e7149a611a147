"""Where a form changes: points at which the argument of a sign is zero, or at which equations hold."""

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
    """The question where a factor of a sign's argument, or of a difference that is compared, is given to vanish."""
    conditions = [item for _, item in listed(given, "given")]
    parts = {part for e in expressions_in((lhs, rhs)) for part in e.atoms(sympy.sign, sympy.Eq, sympy.Ne)}
    for part in sorted(parts, key=str)[:MOST]:
        sides = with_values((lhs, rhs), {part: part.func(*(0 for _ in part.args))})
        difference = part.args[0] if isinstance(part, sympy.sign) else part.lhs - part.rhs
        factors = (factor for factor, power, _ in factors_of(difference) if power.is_positive and factor.free_symbols)
        for factor in islice(factors, MOST):
            yield (*sides, [*conditions, sympy.Eq(factor, 0, evaluate=False)], nonzero)
