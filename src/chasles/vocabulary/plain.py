"""Expressions in plain text: for terminals, error messages and the heads of generated files."""

from __future__ import annotations

from chasles.vocabulary.nodes import Identity, Node, Number, Symbol, Zero
from chasles.vocabulary.spelling import Level, Piece, spell

__all__ = ["plain"]

BRACKETS = ("()", "[]", "{}")
INFIX = {"dot": ".", "cross": "x"}


class _Plain:
    def symbol(self, symbol: Symbol) -> str:
        return symbol.name

    def constant(self, node: Identity | Zero) -> str:
        return "1" if isinstance(node, Identity) else "0"

    def number(self, number: Number) -> Piece:
        value = number.value
        level = Level.NEGATIVE if value < 0 else Level.ATOM if value.denominator == 1 else Level.PRODUCT
        return Piece(str(value), level)

    def brackets(self, text: str, depth: int) -> str:
        opening, closing = BRACKETS[min(depth, 2)]
        return f"{opening}{text}{closing}"

    def product(self, factors: list[str]) -> str:
        return " ".join(factors)

    def fraction(self, numerator: Piece, denominator: Piece) -> Piece:
        above = numerator if numerator.level >= Level.PRODUCT else self._grouped(numerator)
        below = denominator if denominator.level >= Level.POWER else self._grouped(denominator)
        return Piece(f"{above.text} / {below.text}", Level.PRODUCT, max(above.depth, below.depth))

    def _grouped(self, piece: Piece) -> Piece:
        return Piece(self.brackets(piece.text, piece.depth), Level.ATOM, piece.depth + 1)

    def power(self, base: str, exponent: str) -> str:
        return f"{base}^{exponent}"

    def infix(self, sign: str, left: str, right: str) -> str:
        return f"{left} {INFIX[sign]} {right}"

    def function(self, name: str, argument: Piece) -> Piece:
        return Piece(f"{name}({argument.text})", Level.ATOM, argument.depth)

    def norm(self, text: str) -> str:
        return f"|{text}|"

    def rate(self, of: Node, text: str, order: int) -> str:
        return f"{text}_{'d' * order}ot" if isinstance(of, Symbol) else f"d{order if order > 1 else ''}/dt {text}"

    def subscripted(self, text: str, subscript: str) -> str:
        return f"{text}_{subscript}".replace("\\", "").replace("mathbf", "").replace("{", "").replace("}", "")

    def block(self, rows: list[list[str]]) -> str:
        return "[" + "; ".join(", ".join(row) for row in rows) + "]"


def plain(node: Node) -> str:
    """The expression in one line of plain text, spelled as its author did."""
    return spell(node, _Plain()).text
