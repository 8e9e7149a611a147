"""Questions with complex expressions, said of their real and imaginary parts."""

from __future__ import annotations

from typing import Any

import sympy

from chasles.checker.expressions.complexes import OF_COMPLEX, Pair, Parts
from chasles.checker.sparse import Rejected
from chasles.from_sympy.opening import Entries
from chasles.problems.variables import Untreatable


class RealParts(Parts):
    """Says equations of complex expressions, and that they do not vanish, by real ones."""

    def equal(self, left: Entries, right: Entries) -> tuple[Entries, Entries]:
        """Two sides that are equal where the given ones are: imaginary parts, if there are any, are further rows."""
        parts = [tuple(tuple(map(self._of, row)) for row in side.rows) for side in (left, right)]
        count = 2 if any(im != 0 for rows in parts for row in rows for _, im in row) else 1
        one, other = (tuple(tuple(z[k] for z in row) for k in range(count) for row in rows) for rows in parts)
        return Entries(one, left.is_matrix), Entries(other, right.is_matrix)

    def pairs(self, one: Any, other: Any) -> list[Pair]:
        """The equations between real expressions that an equation says."""
        (a, b), (c, d) = self._of(one), self._of(other)
        return [(a, c)] if b == d == 0 else [(a, c), (b, d)]

    def nonzero(self, expression: Any) -> Any:
        """A real expression that vanishes where the given one does."""
        a, b = self._of(expression)
        return a if b == 0 else a**2 + b**2

    def _of(self, expression: Any) -> Pair:
        """The parts of what is read as a whole: if it is real, nothing of it is dropped."""
        if not expression.has(*OF_COMPLEX):
            return expression, sympy.S.Zero
        try:
            return self(expression)
        except Rejected as reason:
            raise Untreatable(str(reason)) from None
