"""Values of expressions at points, between rational numbers as the checker has them: exact where all is rational."""

from __future__ import annotations

from collections.abc import Mapping
from typing import Any

import sympy

from chasles.algebra.work_limit import check, spend
from chasles.checker.expressions.enclosed import LARGEST_EXPONENT, EnclosedValues
from chasles.checker.expressions.intervals import Enclosure

NODE = 2_000
"""What a node of an expression that SymPy multiplies out at a point counts as, in products."""


class Enclosures(EnclosedValues):
    """Encloses values, atoms having those of the given expressions; raises `Rejected` where there may be none."""

    def __init__(self, values: Mapping[Any, Any]) -> None:
        super().__init__({atom: _resolved(sympy.sympify(value), values) for atom, value in values.items()})
        self._rational: dict[Any, Any] = {}

    def _of(self, e: Any) -> Enclosure:
        check()
        exact = self._exactly(e)
        return super()._of(e if exact is None else exact)

    def sign(self, e: Any) -> int:
        """The sign; raises `Rejected` where it is not clear."""
        exact = self._exactly(e)
        return super().sign(e) if exact is None else int(sympy.sign(exact))

    def exactly(self, e: Any) -> Any:
        """The expression at the point, as SymPy writes it out: counted as work."""
        exact = super().exactly(e)
        spend(0 if exact.is_Rational else NODE * sum(1 for _ in sympy.preorder_traversal(exact)))
        return exact

    def _exactly(self, e: Any) -> Any:
        """The value, if it is rational by rational arithmetic alone; else None."""
        if e not in self._rational:
            self._rational[e] = self._by_arithmetic(self.point.get(e, e))
        return self._rational[e]

    def _by_arithmetic(self, e: Any) -> Any:
        if e.is_Rational or not (e.is_Add or e.is_Mul or (e.is_Pow and e.exp.is_Integer)):
            return e if e.is_Rational else None
        parts = [self._exactly(part) for part in e.args]
        if None in parts or (e.is_Pow and (abs(parts[1]) > LARGEST_EXPONENT or (parts[0] == 0 and parts[1] < 0))):
            return None
        return e.func(*parts)


def _resolved(e: Any, values: Mapping[Any, Any]) -> Any:
    """An expression without what has a value."""
    while e.has(*values):
        e = e.xreplace(values)
    return e
