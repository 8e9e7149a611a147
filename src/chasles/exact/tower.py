"""Towers of real square roots: each root is of a number of the field below it, and no square there.

An element is one of the ground field, or a + b sqrt(r) with the level of that root and b not zero, so that a number
has one form and only zero is zero. Whether a number is a square in the field is decided by the norm, level by level;
signs follow from a^2 - b^2 r. Nothing is rounded.
"""

from __future__ import annotations

from fractions import Fraction
from typing import Any

from chasles.exact.grounds import RationalFunctions, RationalNumbers

Surd = Any
"""An element of the ground field, or (level, a, b)."""
ZERO = Fraction(0)
MOST_ROOTS = 8


class TooManyRoots(ArithmeticError):
    """A number with more independent square roots than can be handled: each doubles the terms of all others."""


class NegativeRadicand(ValueError):
    """The square root of a number less than zero."""


class QuadraticTower:
    """The rational numbers, or another ground field, with the square roots that have been taken so far."""

    def __init__(self, ground: RationalNumbers | RationalFunctions | None = None) -> None:
        self.ground = ground or RationalNumbers()
        self.radicands: list[Surd] = []
        """The radicand of level k + 1 in place k."""
        self.known: dict[Any, Surd] = {}
        """Powers, as SymPy spells them, that were read before."""
        self.spelled: dict[Surd, Any] = {}
        """Radicands as SymPy spells them."""

    def add(self, x: Surd, y: Surd) -> Surd:
        """The sum."""
        if not x or not y:
            return x or y
        if not isinstance(x, tuple) and not isinstance(y, tuple):
            return x + y
        level = max(_level(x), _level(y))
        (a, b), (c, d) = _split(x, level), _split(y, level)
        return _made(level, self.add(a, c), self.add(b, d))

    def multiply(self, x: Surd, y: Surd) -> Surd:
        """The product."""
        if not isinstance(x, tuple) and not isinstance(y, tuple):
            return x * y
        level = max(_level(x), _level(y))
        (a, b), (c, d) = _split(x, level), _split(y, level)
        squares = self.add(self._times(a, c), self._by_radicand(self._times(b, d), level))
        return _made(level, squares, self.add(self._times(a, d), self._times(b, c)))

    def negative(self, x: Surd) -> Surd:
        """The number with the other sign."""
        return (x[0], self.negative(x[1]), self.negative(x[2])) if isinstance(x, tuple) else -x

    def inverse(self, x: Surd) -> Surd:
        """One over the number; raises ZeroDivisionError for zero."""
        if not isinstance(x, tuple):
            return 1 / x
        level, a, b = x
        below = self.inverse(self._norm(a, b, level))
        return _made(level, self.multiply(a, below), self.negative(self.multiply(b, below)))

    def sign(self, x: Surd) -> int:
        """1, 0 or -1."""
        if not isinstance(x, tuple):
            return self.ground.sign(x)
        level, a, b = x
        one, other = self.sign(a), self.sign(b)
        if one * other >= 0:
            return one or other
        return one * self.sign(self._norm(a, b, level))

    def length(self, x: Surd) -> int:
        """About how long the element is when it is written, where b sqrt(r) may be b r / sqrt(r)."""
        if not isinstance(x, tuple):
            return self.ground.length(x) if x else 0
        level, a, b = x
        forms = [b, self._by_radicand(b, level)] if isinstance(self.radicands[level - 1], tuple) else [b]
        return self.length(a) + min(map(self.length, forms))

    def root(self, x: Surd) -> Surd:
        """The square root that is not negative, taken into the field if it is not there yet.

        Raises NegativeRadicand for a negative number, TooManyRoots for one root more than can be handled.
        """
        if self.sign(x) < 0:
            raise NegativeRadicand("the square root of a negative number")
        found = self._root_within(x, len(self.radicands))
        if found is None and self._take_parts(x):
            found = self._root_within(x, len(self.radicands))
        if found is None and len(self.radicands) == MOST_ROOTS:
            raise TooManyRoots(f"a number has more than {MOST_ROOTS} independent square roots")
        if found is None:
            outside = self.ground.square_within(_coefficients(x))
            self.radicands.append(_scaled(x, 1 / outside**2))
            found = _made(len(self.radicands), ZERO, outside)
        return found if self.sign(found) >= 0 else self.negative(found)

    def _take_parts(self, x: Surd) -> bool:
        """Take in the roots of which sqrt(a + b sqrt(r)) is the sum, if a^2 - b^2 r is a square."""
        if not isinstance(x, tuple):
            return False
        level, a, b = x
        norm = self._root_within(self._norm(a, b, level), level - 1)
        if norm is None:
            return False
        norm = norm if self.sign(norm) >= 0 else self.negative(norm)
        self.root(_scaled(self.add(a, norm), Fraction(1, 2)))
        return True

    def _root_within(self, x: Surd, level: int) -> Surd | None:
        """A square root in the field up to that level, if there is one."""
        if not x:
            return ZERO
        if level == 0:
            return None if isinstance(x, tuple) else self.ground.root(x)
        a, b = _split(x, level)
        if not b:
            inside = self._root_within(a, level - 1)
            if inside is not None:
                return inside
            quotient = self._root_within(self.multiply(a, self.inverse(self.radicands[level - 1])), level - 1)
            return None if quotient is None else _made(level, ZERO, quotient)
        norm = self._root_within(self._norm(a, b, level), level - 1)
        if norm is None:
            return None
        for other in (norm, self.negative(norm)):
            half = self._root_within(_scaled(self.add(a, other), Fraction(1, 2)), level - 1)
            if half is not None and half:
                return _made(level, half, _scaled(self.multiply(b, self.inverse(half)), Fraction(1, 2)))
        return None

    def _norm(self, a: Surd, b: Surd, level: int) -> Surd:
        """a^2 - b^2 r."""
        return self.add(self.multiply(a, a), self.negative(self._by_radicand(self.multiply(b, b), level)))

    def _by_radicand(self, x: Surd, level: int) -> Surd:
        return self._times(x, self.radicands[level - 1])

    def _times(self, x: Surd, y: Surd) -> Surd:
        return self.multiply(x, y) if x and y else ZERO


def _level(x: Surd) -> int:
    return x[0] if isinstance(x, tuple) else 0


def _split(x: Surd, level: int) -> tuple[Surd, Surd]:
    return (x[1], x[2]) if isinstance(x, tuple) and x[0] == level else (x, ZERO)


def _made(level: int, a: Surd, b: Surd) -> Surd:
    return a if not b else (level, a, b)


def _coefficients(x: Surd) -> list[Any]:
    """The elements of the ground field that are not zero."""
    return _coefficients(x[1]) + _coefficients(x[2]) if isinstance(x, tuple) else [x] if x else []


def _scaled(x: Surd, factor: Any) -> Surd:
    return (x[0], _scaled(x[1], factor), _scaled(x[2], factor)) if isinstance(x, tuple) else x * factor
