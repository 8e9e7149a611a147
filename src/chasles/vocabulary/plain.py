"""Expressions as text, in LaTeX or plain: for terminals, error messages and the heads of generated files."""

from __future__ import annotations

import re
from collections.abc import Callable

from chasles.vocabulary.layout import At
from chasles.vocabulary.letters import Identity, Symbol, Zero
from chasles.vocabulary.nodes import Node, Number
from chasles.vocabulary.pieces import Piece, Precedence
from chasles.vocabulary.spelling import spell

BRACKETS = (("(", ")"), ("[", "]"), ("{", "}"))
INFIX = {"dot": ".", "cross": "x"}
ENDS_WITH_NUMBER = re.compile(r"(?:^|[ /-])\d+$")


class _Plain:
    def own(self, node: Node, spell: Callable[[Node], Piece]) -> Piece | None:
        return None

    def symbol(self, symbol: Symbol) -> str:
        return symbol.name

    def constant(self, node: Identity | Zero) -> str:
        return "1" if isinstance(node, Identity) else "0"

    def number(self, number: Number) -> Piece:
        value = number.value
        level = Precedence.NEGATIVE if value < 0 else Precedence.ATOM if value.denominator == 1 else Precedence.QUOTIENT
        return Piece(str(value), level)

    def brackets(self, text: str, depth: int) -> str:
        return self.chosen_brackets(text, min(depth, 2))

    def chosen_brackets(self, text: str, kind: int) -> str:
        opening, closing = BRACKETS[kind]
        return f"{opening}{text}{closing}"

    def product(self, factors: list[str]) -> str:
        return " ".join(factors)

    def numbers_meet(self, left: str, right: str) -> bool:
        return bool(ENDS_WITH_NUMBER.search(left)) and right[0].isdigit()

    def fraction(self, numerator: Piece, denominator: Piece) -> Piece:
        above, below = numerator.at_least(Precedence.PRODUCT, self), denominator.at_least(Precedence.POWER, self)
        return Piece(f"{above.text} / {below.text}", Precedence.QUOTIENT, max(above.depth, below.depth))

    def power(self, base: str, exponent: str) -> str:
        return f"{base}^({exponent})" if " " in exponent else f"{base}^{exponent}"

    def infix(self, sign: str, left: str, right: str) -> str:
        return f"{left} {INFIX[sign]} {right}"

    def function(self, name: str, argument: Piece, exponent: str = "") -> Piece:
        called = Piece(f"{name}({argument.text})", Precedence.ATOM, argument.depth)
        return Piece(self.power(called.text, exponent), Precedence.POWER, argument.depth) if exponent else called

    def called(self, name: str, in_latex: str) -> str:
        return "|#|" if name == "abs" else name

    def compared(self, sign: str) -> str:
        return sign

    def cases(self, values: list[str], where: list[str]) -> str:
        said = [f"{value} if {condition}" for value, condition in zip(values, where, strict=False)]
        return f"({', '.join((*said, values[-1]))} otherwise)"

    def norm(self, of: Piece) -> Piece:
        inner = of.enclosed(self) if "|" in of.text else of
        return Piece(f"|{inner.text}|", Precedence.ATOM, inner.depth)

    def rate(self, of: Node, text: str, order: int) -> str:
        argument = f"({of.argument})" if isinstance(of, At) else ""
        return f"{text.removesuffix(argument)}_{'d' * order}ot{argument}"

    def derivative(self, of: Piece, order: int) -> Piece:
        power = f"^{order}" if order > 1 else ""
        shown = of.at_least(Precedence.ATOM, self)
        return Piece(f"d{power}/dt{power} {shown.text}", Precedence.DOT, shown.depth)

    def subscripted(self, text: str, subscript: str) -> str:
        return re.sub(r"\\(?:mathbf|boldsymbol|mathcal)?|[{}]", "", f"{text}_{subscript}")

    def component(self, text: str, mark: str) -> str:
        return f"{text}_{mark}"

    def integral(self, of: Piece, body: str) -> Piece:
        sign = self.subscripted("int", body) if body else "sum"
        return Piece(f"{sign}({of.text})", Precedence.ATOM, of.depth)

    def block(self, rows: list[list[str]]) -> str:
        return "[" + "; ".join(", ".join(row) for row in rows) + "]"


def plain(node: Node) -> str:
    """The expression in one line of plain text, spelled as its author did."""
    return spell(node, _Plain()).text


def latex(*sides: Node) -> str:
    """The sides of an equation, or one, in LaTeX as its author spelled them, in the notation of the first's chapter."""
    from chasles.vocabulary.typesetting import typeset

    return " = ".join(typeset(side, sides[0]) for side in sides)
