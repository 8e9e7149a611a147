"""Questions with complex expressions, said of their real and imaginary parts."""

from __future__ import annotations

from collections.abc import Sequence
from typing import Any

from chasles.checker.expressions.asked import valued
from chasles.checker.expressions.complexes import Pair, Parts
from chasles.checker.expressions.unevaluated import hidden_in
from chasles.checker.sparse import Rejected
from chasles.from_sympy.complex_symbols import expressions_in
from chasles.from_sympy.opening import Entries, written
from chasles.problems.variables import Untreatable


class RealParts(Parts):
    """Splits what a question speaks of into real and imaginary parts; raises `Untreatable` where it cannot."""

    def equal(self, left: Entries, right: Entries) -> tuple[Entries, Entries]:
        """Two sides that are equal where the given ones are: imaginary parts, if there are any, are further rows."""
        found = self.sides(*([e for row in side.rows for e in row] for side in (left, right)))
        one, other = (in_rows(entries, side) for entries, side in zip(found, (left, right), strict=True))
        return one, other

    def require(self, said: Any) -> None:
        """What is cancelled where something is written out has to be defined, too."""
        for e in expressions_in(said):
            self.met |= {part: None for hidden in written(hidden_in, e) for part in self.of(written(valued, hidden))}

    def of(self, expression: Any) -> Pair:
        """The parts of what is read as a whole."""
        try:
            return super().of(expression)
        except Rejected as reason:
            raise Untreatable(str(reason)) from None


def in_rows(entries: Sequence[Any], like: Entries) -> Entries:
    """The entries row by row, in as many columns as others."""
    width = like.shape[1]
    return Entries(tuple(tuple(entries[k : k + width]) for k in range(0, len(entries), width)), like.is_matrix)
