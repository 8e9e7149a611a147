"""Expansions: what holds up to terms of an order, O(phi^3), and limits."""

from __future__ import annotations

from collections.abc import Callable
from fractions import Fraction
from typing import ClassVar

from chasles.vocabulary.arguments import declaring, making
from chasles.vocabulary.fitting import measured, word
from chasles.vocabulary.letters import Symbol
from chasles.vocabulary.measure import Measure, Misfit
from chasles.vocabulary.nodes import Node, lifted
from chasles.vocabulary.pieces import Piece, Precedence, Style


@word
class UpTo(Node):
    """An expression up to terms of an order in a small scalar or vector; it is the right side of a claim.

    Printed with O(phi^3) behind it, with dots, or, where the claim's sign says that it is no equation, with neither.
    """

    of: Node
    small: Node
    exponent: int
    printed: str = "O"
    has_no_polynomial_form: ClassVar[bool] = True
    expands: ClassVar[bool] = True

    def _measured(self) -> Measure:
        _require_symbol(self.small)
        if self.exponent < 1:
            raise Misfit(f"the order of what is left out is {self.exponent}; it is at least 1")
        return measured(self.of)

    def spelled(self, style: Style, spell: Callable[[Node], Piece]) -> Piece:
        piece, small = spell(self.of), spell(self.small)
        if not self.printed:
            return piece
        size = small.text if self.small.is_scalar else style.norm(small).text
        power = size if self.exponent == 1 else style.power(size, str(self.exponent))
        rest = f"O{style.brackets(power, 0)}" if self.printed == "O" else style.called("...", r"\cdots")
        return Piece(f"{piece.text} + {rest}", Precedence.SUM, piece.depth + 1)


@word
class Limit(Node):
    """The limit of an expression where a scalar or a vector goes to zero; it is the left side of a claim."""

    of: Node
    small: Node
    has_no_polynomial_form: ClassVar[bool] = True
    expands: ClassVar[bool] = True

    def _measured(self) -> Measure:
        _require_symbol(self.small)
        return measured(self.of)

    def spelled(self, style: Style, spell: Callable[[Node], Piece]) -> Piece:
        piece = spell(self.of)
        text = piece.at_least(Precedence.QUOTIENT, style).text
        to_zero = style.called(f"lim {self.small} -> 0", rf"\lim_{{{spell(self.small).text} \to 0}}")
        return Piece(f"{to_zero} {text}", Precedence.DOT, piece.depth + 1)


def _require_symbol(small: Node) -> None:
    if not isinstance(small, Symbol) or small.stands_for is not None:
        raise Misfit(f"what goes to zero is a symbol, and {small} is an expression")


@declaring
def up_to(of: Node | int | Fraction, small: Node, exponent: int, printed: str = "O") -> UpTo:
    """The expression up to terms of an order in what is small, printed with "O", with "..." or with "" nothing."""
    return UpTo(lifted(of), small, exponent, printed)


limit = making(Limit, "limit")
