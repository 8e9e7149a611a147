"""Numbers that square roots express, with operators: elements of one tower of square roots."""

from __future__ import annotations

from dataclasses import dataclass
from fractions import Fraction
from typing import Any

from chasles.exact.numbers import NotDecided
from chasles.exact.square_roots import NotInTower, in_tower, spelled
from chasles.exact.tower import Surd, Tower

__all__ = ["SurdField"]


@dataclass(frozen=True, slots=True)
class _Element:
    tower: Tower
    value: Surd

    def _other(self, other: Any) -> Surd:
        return other.value if isinstance(other, _Element) else Fraction(other)

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
    """The real numbers made by square roots that were taken so far; elements have one form, and exact signs."""

    def __init__(self) -> None:
        self.tower = Tower()

    def __call__(self, value: Any) -> _Element:
        """The element that a number stands for; NotDecided for one that square roots do not express."""
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
