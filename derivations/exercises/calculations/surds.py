"""Numbers made by square roots, and of what else there is, with operators: elements of one tower of square roots."""

from __future__ import annotations

from dataclasses import dataclass
from typing import Any

import sympy as sp

from chasles.exact.grounds import NotDecided, RationalFunctions
from chasles.exact.tower import QuadraticTower, Surd
from chasles.exact.tower_elements import NotInTower, in_tower, independent_atoms, spelled


@dataclass(frozen=True, slots=True)
class _Element:
    tower: QuadraticTower
    value: Surd

    def _other(self, other: Any) -> Surd:
        return other.value if isinstance(other, _Element) else self.tower.ground(sp.sympify(other))

    def __add__(self, other: Any) -> _Element:
        return _Element(self.tower, self.tower.add(self.value, self._other(other)))

    def __radd__(self, other: Any) -> _Element:
        return _Element(self.tower, self.tower.add(self._other(other), self.value))

    def __neg__(self) -> _Element:
        return _Element(self.tower, self.tower.negative(self.value))

    def __sub__(self, other: Any) -> _Element:
        return _Element(self.tower, self.tower.add(self.value, self.tower.negative(self._other(other))))

    def __mul__(self, other: Any) -> _Element:
        return _Element(self.tower, self.tower.multiply(self.value, self._other(other)))

    def __truediv__(self, other: Any) -> _Element:
        return _Element(self.tower, self.tower.multiply(self.value, self.tower.inverse(self._other(other))))


class SurdField:
    """The real numbers made of some by square roots; elements have one form, and exact signs.

    Raises NotDecided where sines and cosines are among the numbers that square roots do not make.
    """

    def __init__(self, *values: Any) -> None:
        atoms = independent_atoms(*values)
        if atoms is None:
            raise NotDecided("sines and cosines that are no square roots are not told apart")
        self.tower = QuadraticTower(RationalFunctions(atoms) if atoms else None)

    def __call__(self, value: Any) -> _Element:
        """The element that a number stands for; NotDecided for one that is not made of those of the field."""
        try:
            return _Element(self.tower, in_tower(self.tower, value))
        except NotInTower:
            raise NotDecided(f"{value} is not made by square roots") from None

    def expression(self, element: _Element) -> Any:
        """The number as SymPy spells it."""
        return spelled(self.tower, element.value)

    def sign(self, element: _Element) -> int:
        """-1, 0 or 1."""
        return self.tower.sign(element.value)
