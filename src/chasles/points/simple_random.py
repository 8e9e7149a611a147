"""Draws that prefer what is easy to calculate with."""

from __future__ import annotations

from collections.abc import Sequence
from random import Random
from typing import TypeVar

_T = TypeVar("_T")


class SimpleRandom(Random):
    """Draws as a person would: the first of a list half of the time, zero and one rather than other numbers."""

    def choice(self, items: Sequence[_T]) -> _T:  # type: ignore[override]
        """An item, each half as likely as the one before it."""
        return items[self._place(len(items))]

    def randint(self, lowest: int, highest: int) -> int:
        """A whole number, each half as likely as the next smaller one."""
        numbers = sorted(range(lowest, highest + 1), key=lambda number: (abs(number), -number))
        return numbers[self._place(len(numbers))]

    def _place(self, size: int) -> int:
        place = 0
        while place < size - 1 and self.random() < 0.5:
            place += 1
        return place
