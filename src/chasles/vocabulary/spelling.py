"""How is an expression written out? One walk over the nodes decides the brackets; a style spells the pieces.

A style is a table of spellings (LaTeX, plain text). Brackets are put where precedence asks for them, round inside
square inside curly, and where the author put them. Precedence, from loose to tight: sums; a leading minus; dots and
crosses; quotients on one line; products; powers. A quotient on one line is never a bare factor of a product: `1/2 a`
can be read in two ways. Nor do two numbers meet in a product, nor bars of a norm stand directly within another's.
"""

from __future__ import annotations

from collections.abc import Callable, Sequence
from dataclasses import dataclass
from enum import IntEnum
from typing import Protocol

from chasles.vocabulary.body import Integral
from chasles.vocabulary.families import Entry, Kronecker, Member
from chasles.vocabulary.layout import At, Block, Call, Group, Rate
from chasles.vocabulary.letters import Identity, Symbol, Zero
from chasles.vocabulary.nodes import Contract, Negative, Node, Number, Power, Quotient, Scale, Sum, Transpose
from chasles.vocabulary.shorthand import Shorthand
from chasles.vocabulary.spatial import Cofactor, Cross, Determinant, Dot, Inverse, Norm, Skew, Trace, Vect


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
    """A spelled expression: its text, how tightly it holds together, how deep brackets are nested in it."""

    text: str
    level: Precedence
    depth: int = 0


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
    def function(self, name: str, argument: Piece) -> Piece: ...
    def called(self, name: str, in_latex: str) -> str: ...
    def compared(self, sign: str) -> str: ...
    def cases(self, values: list[str], where: list[str]) -> str: ...
    def norm(self, of: Piece) -> Piece: ...
    def rate(self, of: Node, text: str, order: int) -> str: ...
    def derivative(self, text: str, order: int) -> str: ...
    def subscripted(self, text: str, subscript: str) -> str: ...
    def component(self, text: str, mark: str) -> str: ...
    def block(self, rows: list[list[str]]) -> str: ...
    def integral(self, of: Piece, body: str) -> Piece: ...


FUNCTIONS: dict[type[Node], str] = {
    Skew: "CPM",
    Vect: "vect",
    Trace: "tr",
    Determinant: "det",
    Cofactor: "cof",
}


def spell(node: Node, style: Style) -> Piece:
    """The expression written out in the author's order."""

    def bracketed(part: Node, least: Precedence) -> Piece:
        piece = spell(part, style)
        return piece if piece.level >= least else grouped(piece, piece.depth)

    def grouped(piece: Piece, depth: int) -> Piece:
        return Piece(style.brackets(piece.text, depth), Precedence.ATOM, piece.depth + 1)

    def joined(pieces: list[Piece], text: str, level: Precedence) -> Piece:
        return Piece(text, level, max(piece.depth for piece in pieces))

    def product(factors: Sequence[Node]) -> Piece:
        pieces = [bracketed(factor, Precedence.PRODUCT) for factor in factors]
        for k in range(1, len(pieces)):
            if style.numbers_meet(pieces[k - 1].text, pieces[k].text):
                pieces[k] = grouped(pieces[k], pieces[k].depth)
        return joined(pieces, style.product([piece.text for piece in pieces]), Precedence.PRODUCT)

    def as_part(part: Node) -> Piece:
        return spell(part, style)

    own = style.own(node, as_part) or node.spelled(style, as_part)
    if own is not None:
        return own
    match node:
        case Symbol():
            return Piece(style.symbol(node), Precedence.ATOM)
        case Identity() | Zero():
            return Piece(style.constant(node), Precedence.ATOM)
        case Number():
            return style.number(node)
        case Sum(terms):
            text, depth = "", 0
            for term in terms:
                minus = isinstance(term, Negative) and text != ""
                shown = term.term if isinstance(term, Negative) and minus else term
                piece = bracketed(shown, Precedence.DOT if text else Precedence.NEGATIVE)
                text = f"{text} {'-' if minus else '+'} {piece.text}" if text else piece.text
                depth = max(depth, piece.depth)
            return Piece(text, Precedence.SUM, depth)
        case Negative(term):
            piece = bracketed(term, Precedence.DOT)
            return Piece(f"-{piece.text}", Precedence.NEGATIVE, piece.depth)
        case Scale(factor, term, trailing):
            return product((term, factor) if trailing else (factor, term))
        case Contract(factors):
            return product(factors)
        case Quotient(numerator, denominator, slash):
            if not slash:
                return style.fraction(spell(numerator, style), spell(denominator, style))
            pieces = [bracketed(numerator, Precedence.PRODUCT), bracketed(denominator, Precedence.POWER)]
            return joined(pieces, f"{pieces[0].text}/{pieces[1].text}", Precedence.QUOTIENT)
        case Power(base, exponent):
            piece = bracketed(base, Precedence.ATOM)
            return Piece(style.power(piece.text, str(exponent)), Precedence.POWER, piece.depth)
        case Transpose(of) | Inverse(of):
            piece = bracketed(of, Precedence.ATOM)
            return Piece(
                style.power(piece.text, "T" if isinstance(node, Transpose) else "-1"), Precedence.POWER, piece.depth
            )
        case Dot(left, right) | Cross(left, right):
            pieces = [bracketed(left, Precedence.PRODUCT), bracketed(right, Precedence.PRODUCT)]
            sign = "dot" if isinstance(node, Dot) else "cross"
            return joined(pieces, style.infix(sign, pieces[0].text, pieces[1].text), Precedence.DOT)
        case Norm(of):
            return style.norm(spell(of, style))
        case Call(function, argument):
            return style.function(function, spell(argument, style))
        case Shorthand() | Skew() | Vect() | Trace() | Determinant() | Cofactor():
            parts = [spell(part, style) for part in node.below]
            inner = joined(parts, ", ".join(part.text for part in parts), Precedence.SUM)
            name = node.function if isinstance(node, Shorthand) else FUNCTIONS[type(node)]
            return Piece(style.function(name, inner).text, Precedence.ATOM, inner.depth + 1)
        case Block(rows):
            spelled = [[spell(block, style) for block in row] for row in rows]
            depth = max(piece.depth for row in spelled for piece in row)
            return Piece(style.block([[piece.text for piece in row] for row in spelled]), Precedence.ATOM, depth)
        case Rate():
            order, of = 1, node.of
            while isinstance(of, Rate):
                order, of = order + 1, of.of
            if isinstance(of.of if isinstance(of, At) else of, Symbol | Member) or getattr(of, "is_letter", False):
                return Piece(style.rate(of, spell(of, style).text, order), Precedence.ATOM)
            piece = bracketed(of, Precedence.ATOM)
            return Piece(style.derivative(piece.text, order), Precedence.DOT, piece.depth)
        case At(of, argument):
            piece = bracketed(of, Precedence.ATOM)
            return Piece(f"{piece.text}({argument})", Precedence.ATOM, piece.depth)
        case Group(of, brackets, frame):
            piece = spell(of, style)
            if frame:
                return Piece(style.subscripted(style.brackets(piece.text, 1), frame), Precedence.ATOM, piece.depth)
            depth = {"()": 0, "[]": 1, "{}": 2}[brackets]
            return Piece(style.brackets(piece.text, depth), Precedence.ATOM, max(piece.depth, depth) + 1)
        case Integral(of, _, _, body):
            return style.integral(bracketed(of, Precedence.PRODUCT), body)
        case Member(family, index):
            return Piece(style.subscripted(family.letter, index.letter) + family.mark, Precedence.ATOM)
        case Entry(_, i, j, letter):
            return Piece(style.subscripted(letter, i.letter + j.letter), Precedence.ATOM)
        case Kronecker(i, j):
            return Piece(style.subscripted(r"\delta", i.letter + j.letter), Precedence.ATOM)
        case _:
            raise TypeError(f"no spelling for the node {type(node).__name__}")
