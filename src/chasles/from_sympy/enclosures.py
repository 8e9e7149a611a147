"""Values of expressions at rational points: exact, or enclosed in intervals."""

from __future__ import annotations

from collections.abc import Mapping
from fractions import Fraction
from functools import reduce
from typing import Any

import sympy
from sympy.functions.elementary.piecewise import ExprCondPair

from chasles.algebra.work_limit import check
from chasles.from_sympy.enclosed_functions import (
    BITS,
    FUNCTIONS,
    NotEnclosed,
    Value,
    ends,
    iv,
    plus,
    power,
    sign_of,
    times,
)
from chasles.from_sympy.opening import is_atom


class Enclosures:
    """Encloses values, atoms having the given rational values, or those of the given expressions."""

    def __init__(self, values: Mapping[Any, Any]) -> None:
        self.values = values
        self._known: dict[Any, Value] = {}

    def __call__(self, e: Any) -> Value:
        """The value of an expression; raises `NotEnclosed` where it is not known to be defined."""
        known = self._known.get(e)
        if known is None:
            check()
            known = self._known[e] = self._value(e)
        return known

    def _value(self, e: Any) -> Value:
        if e in self.values:
            return self(self.values[e])
        if isinstance(e, sympy.Rational):
            return Fraction(int(e.p), int(e.q))
        if e is sympy.pi:
            return iv.pi + 0
        if e is sympy.E:
            return iv.exp(1)
        if is_atom(e):
            raise NotEnclosed
        if isinstance(e, sympy.Add | sympy.Mul):
            return reduce(plus if isinstance(e, sympy.Add) else times, map(self, e.args))
        if isinstance(e, sympy.Pow):
            return power(self(e.base), self(e.exp))
        if isinstance(e, sympy.Piecewise):
            return self._by_cases(e)
        if e.func not in FUNCTIONS:
            raise NotEnclosed
        return FUNCTIONS[e.func](*map(self, e.args))

    def _by_cases(self, e: Any) -> Value:
        for case in e.args:
            assert isinstance(case, ExprCondPair)
            if self.is_true(case.cond):
                return self(case.expr)
        raise NotEnclosed

    def is_true(self, condition: Any) -> bool:
        """Whether a condition holds at the point; raises `NotEnclosed` if that is not clear."""
        if condition in (sympy.true, sympy.false):
            return condition is sympy.true
        if isinstance(condition, sympy.And | sympy.Or):
            found = [self.is_true(part) for part in condition.args]
            return all(found) if isinstance(condition, sympy.And) else any(found)
        if isinstance(condition, sympy.Not):
            return not self.is_true(condition.args[0])
        if not isinstance(condition, sympy.core.relational.Relational):
            raise NotEnclosed
        sign = sign_of(plus(self(condition.lhs), -self(condition.rhs)))
        return {"==": sign == 0, "!=": sign != 0, "<": sign < 0, "<=": sign <= 0, ">": sign > 0, ">=": sign >= 0}[
            condition.rel_op
        ]


def ends_of(number: Any, bits: int) -> tuple[Fraction, Fraction]:
    """Between which rational numbers a number lies, computed with so many binary digits; raises `NotEnclosed`."""
    iv.prec = bits
    try:
        value = Enclosures({})(number)
        return (value, value) if isinstance(value, Fraction) else ends(value)
    finally:
        iv.prec = BITS
