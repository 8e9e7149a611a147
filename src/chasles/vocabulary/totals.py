"""Sums over the members of a collection, as many as a letter says: the masses and the positions of n particles."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass
from fractions import Fraction

from chasles.vocabulary.arguments import Declared, WrongArgument, declaring
from chasles.vocabulary.fitting import word
from chasles.vocabulary.layout import Integral
from chasles.vocabulary.letters import Symbol
from chasles.vocabulary.measure import uniform
from chasles.vocabulary.nodes import Node, Number, lifted
from chasles.vocabulary.pieces import Piece, Precedence, Style
from chasles.vocabulary.shorthand import Shorthand

MEMBER = Symbol("member", "1", uniform((1, 1)), "what each member counts for", constant=True)


@dataclass(frozen=True, slots=True)
class Members(Declared):
    """An index that runs from 1 to a letter; the `symbols` differ from member to member, as what is said of them does.

    Raises `WrongArgument` for a number that is no symbol without dimension, and where nothing differs.
    """

    letter: str
    number: Symbol
    symbols: tuple[Symbol, ...]

    def __post_init__(self) -> None:
        letters = all(isinstance(each, Symbol) and each.stands_for is None for each in (self.number, *self.symbols))
        if not letters or not self.symbols or self.number.size != uniform((1, 1)):
            raise WrongArgument(
                "members(letter, number, *symbols) takes an index, a scalar for how many there are, and the symbols "
                "that differ: i = members('i', n, m_i, r_i)"
            )

    @property
    def counted(self) -> Node:
        """How many members there are, as a sum."""
        return Total(Number(Fraction(1)), self).definition


@word
class Total(Shorthand):
    """The sum over all members of a collection."""

    of: Node
    index: Members

    @property
    def definition(self) -> Node:
        return Integral(self.of, MEMBER, self.index.symbols, "")

    @property
    def running(self) -> frozenset[Symbol]:
        """The symbols that differ from member to member."""
        return frozenset(self.index.symbols)

    def spelled(self, style: Style, spell: Callable[[Node], Piece]) -> Piece:
        piece = spell(self.of).at_least(Precedence.QUOTIENT, style)
        number = spell(self.index.number).text
        letter = self.index.letter
        sign = style.called(f"sum over {letter} to {number} of", rf"\sum_{{{letter}=1}}^{{{number}}}")
        return Piece(f"{sign} {piece.text}", Precedence.DOT, piece.depth)


@declaring
def members(letter: str, number: Symbol, *symbols: Symbol) -> Members:
    """An index that runs from 1 to a number; all symbols are named that differ from member to member."""
    return Members(letter, number, symbols)


@declaring
def total(of: Node | int | Fraction, index: Members) -> Total:
    """The sum of an expression over all members."""
    return Total(lifted(of), index)
