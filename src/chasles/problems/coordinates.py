"""The fraction for each quantity of a problem: an entry of a symbol or rate, a cosine, a sine, a norm."""

from __future__ import annotations

from collections.abc import Sequence
from fractions import Fraction

from chasles.algebra.localization import Localization, Ratio
from chasles.problems.variables import Variable
from chasles.vocabulary import Node, Symbol


class Coordinates:
    """One for each of `variables`, in their order."""

    def __init__(self, field: Localization, variables: Sequence[Variable]) -> None:
        self._field = field
        self._entries: dict[tuple[Symbol | None, int, int, int], int] = {}
        self._circular: dict[tuple[str, Symbol | None], int] = {}
        self._norms: dict[Node | None, int] = {}
        self._units: dict[Symbol | None, Fraction] = {}
        for place, variable in enumerate(variables):
            match variable.kind:
                case "entry":
                    self._entries[variable.symbol, variable.order, variable.row, variable.column] = place
                case "cos" | "sin":
                    self._circular[variable.kind, variable.symbol] = place
                    self._units[variable.symbol] = variable.unit
                case "norm":
                    self._norms[variable.node] = place

    def entry(self, symbol: Symbol, order: int, row: int, column: int) -> Ratio | None:
        """An entry of a symbol's `order`-th rate; None if there is no variable for it."""
        place = self._entries.get((symbol, order, row, column))
        return None if place is None else self._at(place)

    def unit(self, angle: Symbol) -> Fraction:
        """The variables are the cosine and sine of this multiple of the angle."""
        return self._units[angle]

    def circular(self, angle: Symbol) -> tuple[Ratio, Ratio]:
        """The cosine and sine of an angle's unit."""
        return self._at(self._circular["cos", angle]), self._at(self._circular["sin", angle])

    def norm(self, of: Node) -> Ratio:
        """The norm of an expression."""
        return self._at(self._norms[of])

    def _at(self, place: int) -> Ratio:
        return self._field.ratio(self._field.ring.generators[place])
