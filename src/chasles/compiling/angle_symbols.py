"""Angles as symbols in expressions: what was replaced in one expression is known in the next that shares it."""

from __future__ import annotations

from collections.abc import Iterable, Mapping
from typing import Any

import sympy
from sympy.core.relational import Relational

from chasles.compiling.angles import ANGLE, ROOT, WholeAngle, divisors, parts_of, parts_of_kinds, square_of, with_series
from chasles.compiling.variables import Substitution, outermost

NORM = sympy.Dummy("norm", dummy_index=2, nonnegative=True)
"""The symbol in place of an angle that is a root."""
_ANGLES = {ANGLE, ROOT, NORM}


class AngleSymbol:
    """A symbol in place of an angle."""

    def __init__(self, angle: sympy.Expr) -> None:
        square = square_of(angle)
        self._square = square
        self._is_root = angle != square and angle.is_Pow and angle.exp == sympy.S.Half
        self._known = (square if square.is_Symbol else -square) if self._is_root and not square.is_Add else None
        self._whole = WholeAngle(square if self._is_root else angle)
        self._series, self._conditions = Substitution({}), Substitution({})
        inner = {} if self._known is None else {self._known: NORM**2 if self._known == square else -(NORM**2)}
        self._inner = Substitution(inner or {self._whole.symbol: NORM**2})
        self._back = Substitution({NORM: angle} if self._is_root else {})
        self._dummies: dict[Any, Any] = {}

    def in_series(self, expression: sympy.Basic, functions: Iterable[Any]) -> tuple[Any, Mapping[Any, Any]]:
        """The expression with the functions of the angle by those that have a series, and which these are."""
        table = {f: other for f in functions if (other := with_series(f)) != f}
        return self._series.learn(table).of(expression) if table else expression, table

    def as_stated(self, found: sympy.Basic, table: Mapping[Any, Any], stated: sympy.Basic) -> Any:
        """What is found, with functions as stated where they are left; an arctangent is one in the right half-plane."""
        kept = {other: f for f, other in table.items()}
        right = [f.args[1] > 0 for f in table if isinstance(f, sympy.atan2)]
        if right:
            less = (sympy.StrictLessThan,)
            made = parts_of_kinds(found, less) - parts_of_kinds(stated, less)
            kept |= {part: sympy.And(part, *right) for part in made}
        return Substitution(kept).of(found) if kept else found

    def of(self, stated: sympy.Basic) -> Any:
        """The expression in the symbol; None where nothing is divided by that vanishes with the angle."""
        # What is asked of signs is not asked of the symbol.
        conditions = [part for part in parts_of(stated, ()) if isinstance(part, Relational)]
        stated = self._conditions.learn(self._dummies_of(conditions)).of(stated)
        parts = parts_of(stated, ())
        divided = divisors(parts)
        if self._known is not None:
            if not self._known.is_Symbol or divided.isdisjoint((self._known, self._square, self._square**sympy.S.Half)):
                return None
            # Where there is the root there is none of the opposite.
            held = [part for part in parts if part.is_Pow and part.base == -self._square]
            return self._inner.learn(self._dummies_of(held, real=True)).of(stated)
        if not self._whole.occurs_in(divided):
            return None
        inner = self._whole.of(stated)
        return self._inner.of(inner) if self._is_root else inner

    def back(self, found: sympy.Basic) -> Any:
        """The expression with the angle again."""
        self._back.learn({dummy: part for part, dummy in self._dummies.items()})
        return self._back.of(found if self._is_root else self._whole.back(found))

    def _dummies_of(self, parts: Iterable[Any], **assumptions: bool) -> dict[Any, Any]:
        return {part: self._dummies.setdefault(part, sympy.Dummy(**assumptions)) for part in parts}


class AngleSymbols:
    """The symbols of all angles in some expressions, and those of what does not change with an angle."""

    def __init__(self) -> None:
        self._angles: dict[Any, AngleSymbol] = {}
        self._fixed: dict[Any, Any] = {}
        self._to_symbols, self._to_parts = Substitution({}), Substitution({})

    def of(self, angle: sympy.Expr) -> AngleSymbol:
        """That of an angle."""
        if angle not in self._angles:
            self._angles[angle] = AngleSymbol(angle)
        return self._angles[angle]

    def without_fixed(self, inner: Any) -> Any:
        """The expression with a symbol for what does not change with an angle, however long it is."""
        fixed = {part: self._fixed.setdefault(part, sympy.Dummy(real=True)) for part in outermost([inner], _is_fixed)}
        self._to_parts.learn({dummy: part for part, dummy in fixed.items()})
        return self._to_symbols.learn(fixed).of(inner)

    def with_fixed(self, found: Any) -> Any:
        """The expression with what the symbols stand for."""
        return self._to_parts.of(found)


def _is_fixed(part: Any) -> bool:
    return (
        isinstance(part, sympy.Add | sympy.Mul)
        and _ANGLES.isdisjoint(parts_of_kinds(part, (sympy.Symbol,)))
        and not part.is_number
    )
