"""Expressions in LaTeX, in the author's order."""

from __future__ import annotations

from chasles.vocabulary.nodes import At, Identity, Node, Number, Symbol, Zero
from chasles.vocabulary.spelling import Level, Piece, spell

__all__ = ["latex"]

BRACKETS = (("(", ")"), ("[", "]"), (r"\{", r"\}"))
INFIX = {"dot": r"\cdot", "cross": r"\times"}


class _Latex:
    def symbol(self, symbol: Symbol) -> str:
        return symbol.letter

    def constant(self, node: Identity | Zero) -> str:
        return node.letter

    def number(self, number: Number) -> Piece:
        value = number.value
        if value.denominator == 1:
            return Piece(str(value), Level.NEGATIVE if value < 0 else Level.ATOM)
        sign = "-" if value < 0 else ""
        text = rf"{sign}\frac{{{abs(value.numerator)}}}{{{value.denominator}}}"
        return Piece(text, Level.NEGATIVE if sign else Level.PRODUCT)

    def brackets(self, text: str, depth: int) -> str:
        opening, closing = BRACKETS[min(depth, 2)]
        return rf"\left{opening} {text} \right{closing}"

    def product(self, factors: list[str]) -> str:
        return " ".join(factors)

    def fraction(self, numerator: Piece, denominator: Piece) -> Piece:
        depth = max(numerator.depth, denominator.depth)
        return Piece(rf"\frac{{{numerator.text}}}{{{denominator.text}}}", Level.PRODUCT, depth)

    def power(self, base: str, exponent: str) -> str:
        return f"{base}^{exponent}" if len(exponent) == 1 else f"{base}^{{{exponent}}}"

    def infix(self, sign: str, left: str, right: str) -> str:
        return f"{left} {INFIX[sign]} {right}"

    def function(self, name: str, argument: Piece) -> Piece:
        command = rf"\{name}" if name in ("sin", "cos", "det") else rf"\text{{{name}}}"
        if argument.level is Level.ATOM and argument.depth == 0 and "{" not in argument.text:
            return Piece(f"{command} {argument.text}", Level.PRODUCT)
        return Piece(f"{command}{self.brackets(argument.text, argument.depth)}", Level.ATOM, argument.depth + 1)

    def norm(self, text: str) -> str:
        return rf"\|{text}\|"

    def rate(self, of: Node, text: str, order: int) -> str:
        dots = r"\d" + "d" * (order - 1) + "ot"
        argument = f"({of.argument})" if isinstance(of, At) else ""
        stem = text.removesuffix(argument) if argument else text
        cut = _end_of_stem(stem)
        return f"{dots}{{{stem[:cut]}}}{stem[cut:]}{argument}"

    def subscripted(self, text: str, subscript: str) -> str:
        return f"{text}_{{{subscript}}}" if len(subscript) > 1 else f"{text}_{subscript}"

    def block(self, rows: list[list[str]]) -> str:
        lines = r" \\ ".join(" & ".join(row) for row in rows)
        return rf"\begin{{bmatrix}} {lines} \end{{bmatrix}}"


def _end_of_stem(text: str) -> int:
    """Where a letter's subscripts and primes begin: the dot of a rate stands over what comes before."""
    depth = 0
    for position, mark in enumerate(text):
        depth += {"{": 1, "}": -1}.get(mark, 0)
        if depth == 0 and position and mark in "_^'":
            return position
    return len(text)


def latex(node: Node) -> str:
    """The expression in LaTeX, spelled as its author did."""
    return spell(node, _Latex()).text
