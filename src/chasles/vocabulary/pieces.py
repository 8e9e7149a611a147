"""A spelled expression, and what a language of formulas must spell."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass
from enum import IntEnum
from typing import TYPE_CHECKING, Protocol

if TYPE_CHECKING:
    from chasles.vocabulary.letters import Identity, Symbol, Zero
    from chasles.vocabulary.nodes import Node, Number


class Precedence(IntEnum):
    """How tightly a piece of text holds together."""

    SUM = 1
    NEGATIVE = 2
    DOT = 3
    QUOTIENT = 4
    PRODUCT = 5
    POWER = 6
    ATOM = 7


@dataclass(frozen=True, slots=True)
class Piece:
    """A spelled expression: its text, how tightly it holds together, how deep brackets are nested in it.

    A fraction with a `bar` needs no brackets behind a sign such as d/dt.
    """

    text: str
    level: Precedence
    depth: int = 0
    bar: bool = False

    def enclosed(self, style: Style) -> Piece:
        """The same in brackets."""
        return Piece(style.brackets(self.text, self.depth), Precedence.ATOM, self.depth + 1)

    def at_least(self, least: Precedence, style: Style) -> Piece:
        """The same, in brackets where it does not hold together as tightly."""
        return self if self.level >= least else self.enclosed(style)


class Style(Protocol):
    """What a language of formulas must spell; words that it spells on its `own` are not spelled by their parts."""

    def own(self, node: Node, spell: Callable[[Node], Piece]) -> Piece | None: ...
    def symbol(self, symbol: Symbol) -> str: ...
    def constant(self, node: Identity | Zero) -> str: ...
    def number(self, number: Number) -> Piece: ...
    def brackets(self, text: str, depth: int) -> str: ...
    def product(self, factors: list[str]) -> str: ...
    def numbers_meet(self, left: str, right: str) -> bool: ...
    def fraction(self, numerator: Piece, denominator: Piece) -> Piece: ...
    def power(self, base: str, exponent: str) -> str: ...
    def infix(self, sign: str, left: str, right: str) -> str: ...
    def function(self, name: str, argument: Piece, exponent: str = "") -> Piece: ...
    def called(self, name: str, in_latex: str) -> str: ...
    def compared(self, sign: str) -> str: ...
    def cases(self, values: list[str], where: list[str]) -> str: ...
    def norm(self, of: Piece) -> Piece: ...
    def rate(self, of: Node, text: str, order: int) -> str: ...
    def derivative(self, of: Piece, order: int) -> Piece: ...
    def subscripted(self, text: str, subscript: str) -> str: ...
    def component(self, text: str, mark: str) -> str: ...
    def block(self, rows: list[list[str]]) -> str: ...
    def integral(self, of: Piece, body: str) -> Piece: ...
