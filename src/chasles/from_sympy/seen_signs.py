"""Signs as the checker sees them: what it sees not to be negative needs no further proof."""

from __future__ import annotations

from contextlib import suppress
from typing import Any

import sympy

from chasles.checker.expressions.signs import SignedReading, is_nonnegative
from chasles.checker.sparse import Polynomial, Rejected, limited

MOST_PRODUCTS = 100_000
"""So many products of terms are formed for one sign: completed squares in sums of roots have no other bound."""


class _Signs(SignedReading):
    """Reads expressions in variables, roots of numbers being numbers."""

    def __init__(self) -> None:
        super().__init__({}, {})
        self.numeric.add(self.place(sympy.pi))

    def root(self, value: Polynomial) -> Polynomial:
        """The nonnegative square root, as a variable."""
        root = super().root(value)
        self.numeric |= {place for place in root.places if self.squares[place].places <= self.numeric}
        return root


def sees_nonnegative(expression: Any) -> bool:
    """Whether the checker sees by itself that a real expression is not negative."""
    reading = _Signs()
    with suppress(Rejected), limited(MOST_PRODUCTS):
        return is_nonnegative(reading, reading(expression))
    return False
