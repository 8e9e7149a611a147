"""How is an expression written out? One walk over the nodes decides the brackets; a style spells the pieces.

A style is a table of spellings (LaTeX, plain text). Brackets are put where precedence asks for them, round inside
square inside curly, and where the author put them. Precedence, from loose to tight: sums; a leading minus; dots and
crosses; quotients on one line; products; powers. A quotient on one line is never a bare factor of a product: `1/2 a`
can be read in two ways. Nor do two numbers meet in a product, nor bars of a norm stand directly within another's.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass
from dataclasses import replace as with_fields

from chasles.vocabulary.families import Entry, Kronecker, Member
from chasles.vocabulary.layout import At, Block, Call, Group, Integral, Rate
from chasles.vocabulary.letters import Identity, Symbol, Zero
from chasles.vocabulary.nodes import Contract, Negative, Node, Number, Power, Quotient, Scale, Sum, Transpose
from chasles.vocabulary.pieces import Piece, Precedence, Style
from chasles.vocabulary.shorthand import Shorthand
from chasles.vocabulary.spatial import Cofactor, Cross, Determinant, Dot, Inverse, Norm, Skew, Trace, Vect
from chasles.vocabulary.tree import children, undotted

FUNCTIONS: dict[type[Node], str] = {Skew: "CPM", Vect: "vect", Trace: "tr", Determinant: "det", Cofactor: "cof"}
RATIOS = {"tan": "sin cos", "cot": "cos sin", "sec": "1 cos", "csc": "1 sin", "coth": "cosh sinh", "sech": "1 cosh"}


def spell(node: Node, style: Style) -> Piece:
    """The expression written out in the author's order."""
    return _Speller(style).piece(node)


@dataclass(frozen=True, slots=True)
class _Speller:
    style: Style

    def piece(self, node: Node) -> Piece:
        own = self.style.own(node, self.piece) or node.spelled(self.style, self.piece)
        return self._letter(node) if own is None else own

    def bracketed(self, part: Node, least: Precedence) -> Piece:
        return self.piece(part).at_least(least, self.style)

    def _letter(self, node: Node) -> Piece:
        match node:
            case Symbol():
                return Piece(self.style.symbol(node), Precedence.ATOM)
            case Identity() | Zero():
                return Piece(self.style.constant(node), Precedence.ATOM)
            case Number():
                return self.style.number(node)
            case Member(family, index):
                return Piece(self.style.subscripted(family.letter, index.letter) + family.mark, Precedence.ATOM)
            case Entry(_, i, j, letter):
                return Piece(self.style.subscripted(letter, i.letter + j.letter), Precedence.ATOM)
            case Kronecker(i, j):
                return Piece(self.style.subscripted(r"\delta", i.letter + j.letter), Precedence.ATOM)
            case _:
                return self._operation(node)

    def _operation(self, node: Node) -> Piece:
        if named := self._named(node):
            return self.style.function(named[0], self.piece(named[1]))
        match node:
            case Sum(terms):
                return self._sum(terms)
            case Negative(term):
                piece = self.bracketed(term, Precedence.DOT)
                return Piece(f"-{piece.text}", Precedence.NEGATIVE, piece.depth)
            case Scale(factor, term, trailing):
                return self._product((term, factor) if trailing else (factor, term))
            case Contract(factors):
                return self._product(factors)
            case Quotient(numerator, denominator, slash):
                if not slash:
                    return self.style.fraction(self.piece(numerator), self.piece(denominator))
                pieces = [self.bracketed(numerator, Precedence.PRODUCT), self.bracketed(denominator, Precedence.POWER)]
                return _joined(pieces, f"{pieces[0].text}/{pieces[1].text}", Precedence.QUOTIENT)
            case Power(base, exponent):
                return self._power(base, str(exponent))
            case Transpose(of):
                return self._power(of, "T")
            case Inverse(of):
                return self._power(of, "-1")
            case Dot(left, right) | Cross(left, right):
                pieces = [self.bracketed(left, Precedence.PRODUCT), self.bracketed(right, Precedence.PRODUCT)]
                sign = "dot" if isinstance(node, Dot) else "cross"
                return _joined(pieces, self.style.infix(sign, pieces[0].text, pieces[1].text), Precedence.DOT)
            case Norm(of):
                return self.style.norm(self.piece(of))
            case _:
                return self._laid_out(node)

    def _sum(self, terms: Sequence[Node]) -> Piece:
        text, depth = "", 0
        for term in terms:
            minus = isinstance(term, Negative) and text != ""
            shown = term.term if isinstance(term, Negative) and minus else term
            piece = self.bracketed(shown, Precedence.DOT if text else Precedence.NEGATIVE)
            text = f"{text} {'-' if minus else '+'} {piece.text}" if text else piece.text
            depth = max(depth, piece.depth)
        return Piece(text, Precedence.SUM, depth)

    def _product(self, factors: Sequence[Node]) -> Piece:
        pieces = [self.bracketed(factor, Precedence.PRODUCT) for factor in factors]
        for k in range(1, len(pieces)):
            if self.style.numbers_meet(pieces[k - 1].text, pieces[k].text):
                pieces[k] = pieces[k].enclosed(self.style)
            if pieces[k - 1].closed and not self._named(getattr(factors[k], "base", factors[k])):
                pieces[k - 1] = with_fields(pieces[k - 1], text=pieces[k - 1].closed)
        texts = [piece.text for piece in pieces]
        closed = pieces[-1].closed and self.style.product([*texts[:-1], pieces[-1].closed])
        depth = max(piece.depth for piece in pieces)
        return Piece(self.style.product(texts), Precedence.PRODUCT, depth, closed=closed)

    def _power(self, base: Node, exponent: str) -> Piece:
        if exponent.isdigit() and (named := self._named(base)):
            return self.style.function(named[0], self.piece(named[1]), exponent)
        piece = self.bracketed(base, Precedence.ATOM)
        return Piece(self.style.power(piece.text, exponent), Precedence.POWER, piece.depth)

    def _named(self, node: Node) -> tuple[str, Node] | None:
        """The name and the argument of a function whose powers are written behind its name."""
        match node:
            case Call(function, argument):
                return function, argument
            case Quotient(a, b, _, c) if c and RATIOS[c] == f"{getattr(a, 'function', a)} {getattr(b, 'function', b)}":
                return (c, children(b)[0]) if children(a) in ((), children(b)) else None
            case _ if (name := getattr(node, "function", "")) in ("sinh", "cosh", "tanh"):
                return self.style.called(name, rf"\{name}"), children(node)[0]
            case _:
                return None

    def _laid_out(self, node: Node) -> Piece:
        match node:
            case Shorthand() | Skew() | Vect() | Trace() | Determinant() | Cofactor():
                parts = [self.piece(part) for part in node.below]
                inner = _joined(parts, ", ".join(part.text for part in parts), Precedence.SUM)
                name = node.function if isinstance(node, Shorthand) else FUNCTIONS[type(node)]
                return Piece(self.style.function(name, inner).text, Precedence.ATOM, inner.depth + 1)
            case Block(rows):
                spelled = [[self.piece(block) for block in row] for row in rows]
                depth = max(piece.depth for row in spelled for piece in row)
                return Piece(self.style.block([[p.text for p in row] for row in spelled]), Precedence.ATOM, depth)
            case Rate():
                return self._rate(node)
            case At(of, argument):
                piece = self.bracketed(of, Precedence.ATOM)
                return Piece(f"{piece.text}({argument})", Precedence.ATOM, piece.depth)
            case Group(of, brackets, frame):
                return self._group(self.piece(of), {"()": 0, "[]": 1, "{}": 2}[brackets], frame)
            case Integral(of, _, _, body):
                return self.style.integral(self.bracketed(of, Precedence.PRODUCT), body)
            case _:
                raise TypeError(f"no spelling for the node {type(node).__name__}")

    def _rate(self, node: Rate) -> Piece:
        of, order = undotted(node)
        if isinstance(of.of if isinstance(of, At) else of, Symbol | Member) or getattr(of, "is_letter", False):
            return Piece(self.style.rate(of, self.piece(of).text, order), Precedence.ATOM)
        return self.style.derivative(self.piece(of), order)

    def _group(self, piece: Piece, depth: int, frame: str) -> Piece:
        if frame:
            text = self.style.subscripted(self.style.chosen_brackets(piece.text, 1), frame)
            return Piece(text, Precedence.ATOM, piece.depth)
        return Piece(self.style.chosen_brackets(piece.text, depth), Precedence.ATOM, max(piece.depth, depth) + 1)


def _joined(pieces: list[Piece], text: str, level: Precedence) -> Piece:
    return Piece(text, level, max(piece.depth for piece in pieces))
