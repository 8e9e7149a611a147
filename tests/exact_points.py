"""A point: exact values by name, as e_1, a_dot_2, cos(phi/2), |omega|, int(rho p_1 p_1)."""

from __future__ import annotations

import re
from collections.abc import Mapping
from fractions import Fraction

from chasles.vocabulary import Symbol

from .exact_series import Broken, rational_root

__all__ = ["STAND_IN", "Point", "entries"]

STAND_IN = Fraction(22, 7)
"""Stands for pi, and for an angle whose cosine and sine are given."""


class Point:
    """Values of the entries of symbols and of their rates, of cosines and sines, norms and moments.

    What the point does not name is zero; an angle of which it has the cosine or sine is the stand-in.
    """

    def __init__(self, values: Mapping[str, Fraction]) -> None:
        self.values = dict(values)

    def entry(self, symbol: Symbol, order: int, i: int, j: int) -> Fraction:
        """An entry of a symbol or of its rate."""
        name = _name(symbol, order, i, j)
        if name in self.values:
            return self.values[name]
        return STAND_IN if order == 0 and self._measures(symbol) else Fraction(0)

    def speaks_of(self, symbol: Symbol) -> bool:
        """Whether it has a value for an entry of the symbol, or for its cosine or sine."""
        return bool(self._measures(symbol)) or any(name in self.values for name in entries(symbol))

    def order(self, symbol: Symbol) -> int:
        """Up to which rate it has values for the symbol."""
        dots = re.compile(rf"{re.escape(symbol.name)}_(d+)ot(?:_\d+)?")
        return max((len(match[1]) for name in self.values if (match := dots.fullmatch(name))), default=0)

    def moments(self) -> dict[tuple[str, ...], Fraction]:
        """The integrals over the body, by the factors of what is integrated."""
        found = {}
        for name, value in self.values.items():
            if match := re.fullmatch(r"int\((.*)\)", name):
                found[tuple(match[1].split())] = value
        return found

    def circle(self, symbol: Symbol, multiple: Fraction) -> tuple[Fraction, Fraction]:
        """Cosine and sine of a multiple of an angle."""
        if not multiple:
            return Fraction(1), Fraction(0)
        for unit, name in self._measures(symbol).items():
            turns = multiple / unit
            if turns.denominator == 1:
                c, s = self._circle(name)
                cosine, sine = Fraction(1), Fraction(0)
                for _ in range(abs(int(turns))):
                    cosine, sine = cosine * c - sine * s, sine * c + cosine * s
                return cosine, sine if turns > 0 else -sine
        raise Broken(f"the point has no cosine of {multiple} {symbol}")

    def _measures(self, symbol: Symbol) -> dict[Fraction, str]:
        """What stands behind "cos" or "sin" for an angle, by the multiple of the angle."""
        found = {}
        for name in self.values:
            if match := re.fullmatch(rf"(?:cos|sin)\((\d*){re.escape(symbol.name)}(?:/(\d+))?\)", name):
                found[Fraction(int(match[1] or 1), int(match[2] or 1))] = name[3:]
        return found

    def _circle(self, name: str) -> tuple[Fraction, Fraction]:
        """Cosine and sine; one that the point leaves out does not matter, so the other gives it."""
        c, s = self.values.get("cos" + name), self.values.get("sin" + name)
        if c is None and s is not None:
            c = rational_root(1 - s * s)
        if s is None and c is not None:
            s = rational_root(1 - c * c)
        assert c is not None
        assert s is not None
        if c * c + s * s != 1:
            raise Broken(f"cosine and sine of {name} are not on the unit circle")
        return c, s


def entries(symbol: Symbol, order: int = 0) -> list[str]:
    """The names of the entries of a symbol, or of its rate of some order."""
    rows, columns = symbol.shape
    return [_name(symbol, order, i, j) for i in range(rows) for j in range(columns)]


def _name(symbol: Symbol, order: int, i: int, j: int) -> str:
    stem = symbol.name + (f"_{'d' * order}ot" if order else "")
    rows, columns = symbol.shape
    return stem if rows == columns == 1 else f"{stem}_{i + 1}" if columns == 1 else f"{stem}_{i + 1}{j + 1}"
