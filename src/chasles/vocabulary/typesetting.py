"""Expressions in LaTeX, in the author's order."""

from __future__ import annotations

import re
from collections.abc import Callable, Iterator

from chasles.vocabulary.layout import At
from chasles.vocabulary.letters import Identity, Symbol, Zero
from chasles.vocabulary.nodes import Node, Number
from chasles.vocabulary.notation import BOOK, Notation, notation_of
from chasles.vocabulary.pieces import Piece, Precedence
from chasles.vocabulary.spelling import spell

BRACKETS = (("(", ")"), ("[", "]"), (r"\{", r"\}"))
NUMBER = r"(?:\d+|\\frac\{\d+\}\{\d+\})"
BEGINS_WITH_NUMBER = re.compile(NUMBER)
ENDS_WITH_NUMBER = re.compile(rf"(?:^|[ -]){NUMBER}$")
SUBSCRIPT = re.compile(r"\{(?:[^{}]|\{[^{}]*\})*\}|\\[A-Za-z]+|.")
ONE_MARK = re.compile(r".|\\[A-Za-z]+")
BEFORE = re.compile(r"(?:\{\}(?:[_^](?:\{(?:[^{}]|\{[^{}]*\})*\}|\\[A-Za-z]+|.))+)?")
"""Scripts before a letter, that of a frame: {}^A_B."""
CLOSED = (")", "]", r"\}", r"\|", r"\end{bmatrix}")
COMMANDS = ("sin", "cos", "tan", "cot", "sec", "csc", "coth", "det")
FUNCTION = re.compile(r"\\(?:sin|cos|tan|cot|sec|csc|log|exp|arc|det|text|sum|int)")
INFIX = {"dot": r"\cdot", "cross": r"\times"}


class Latex:
    """The spellings of LaTeX in a chapter's notation; a dialect of it spells some of them otherwise."""

    def __init__(self, notation: Notation = BOOK) -> None:
        self.notation = notation

    def own(self, node: Node, spell: Callable[[Node], Piece]) -> Piece | None:
        return self.notation.spelled(node, self, spell)

    def symbol(self, symbol: Symbol) -> str:
        return symbol.letter

    def constant(self, node: Identity | Zero) -> str:
        return node.letter

    def number(self, number: Number) -> Piece:
        value = number.value
        if value.denominator == 1:
            return Piece(str(value), Precedence.NEGATIVE if value < 0 else Precedence.ATOM)
        sign = "-" if value < 0 else ""
        text = rf"{sign}\frac{{{abs(value.numerator)}}}{{{value.denominator}}}"
        return Piece(text, Precedence.NEGATIVE if sign else Precedence.PRODUCT)

    def brackets(self, text: str, depth: int) -> str:
        return self.chosen_brackets(text, 0 if self.notation.round_brackets else min(depth, 2))

    def chosen_brackets(self, text: str, kind: int) -> str:
        opening, closing = BRACKETS[kind]
        return rf"\left{opening} {text} \right{closing}"

    def product(self, factors: list[str]) -> str:
        return " ".join(factors)

    def numbers_meet(self, left: str, right: str) -> bool:
        return bool(ENDS_WITH_NUMBER.search(left) and BEGINS_WITH_NUMBER.match(right))

    def fraction(self, numerator: Piece, denominator: Piece) -> Piece:
        depth = max(numerator.depth, denominator.depth)
        return Piece(rf"\frac{{{numerator.text}}}{{{denominator.text}}}", Precedence.PRODUCT, depth, bar=True)

    def power(self, base: str, exponent: str) -> str:
        if not base.endswith(CLOSED) and _takes_no_superscript(base):
            base = f"{{{base}}}"
        return f"{base}^{exponent}" if ONE_MARK.fullmatch(exponent) else f"{base}^{{{exponent}}}"

    def infix(self, sign: str, left: str, right: str) -> str:
        return f"{left} {INFIX[sign]} {right}"

    def function(self, name: str, argument: Piece, exponent: str = "") -> Piece:
        stem, _, mark = name.partition("_")
        command = rf"\{name}" if name in COMMANDS else rf"\text{{{stem}}}" + f"_{mark}" * bool(mark)
        command = name if name.startswith("\\") else command
        command = self.power(command, exponent) if exponent else command
        closed = f"{command}{self.brackets(argument.text, argument.depth)}"
        if self._is_bare(argument):
            closed = closed if argument.level is not Precedence.ATOM and not argument.bar else ""
            return Piece(f"{command} {argument.text}", Precedence.PRODUCT, closed=closed)
        return Piece(closed, Precedence.POWER, argument.depth + 1)

    def _is_bare(self, argument: Piece) -> bool:
        """Whether an argument has no brackets: a letter, and if the chapter prints it so a fraction or a product."""
        bare = self.notation.bare_arguments
        is_letter = argument.level is Precedence.ATOM and argument.depth == 0 and (bare or "{" not in argument.text)
        is_product = argument.level >= Precedence.PRODUCT and argument.depth == 0 and not FUNCTION.search(argument.text)
        usual = is_letter and bare is not False and not argument.text[0].isdigit()
        return usual or (bool(bare) and (argument.bar or is_product))

    def called(self, name: str, in_latex: str) -> str:
        return in_latex

    def compared(self, sign: str) -> str:
        return {"<=": r"\leq", ">=": r"\geq"}.get(sign, sign)

    def cases(self, values: list[str], where: list[str]) -> str:
        lines = [f"{value} & {said}" for value, said in zip(values, where, strict=False)]
        lines.append(rf"{values[-1]} & \text{{otherwise}}")
        return r"\begin{cases} " + r" \\ ".join(lines) + r" \end{cases}"

    def norm(self, of: Piece) -> Piece:
        if r"\|" in of.text:
            of = of.enclosed(self)
        return Piece(rf"\|{of.text}\|", Precedence.ATOM, of.depth)

    def rate(self, of: Node, text: str, order: int) -> str:
        dots = r"\d" + "d" * (order - 1) + "ot"
        argument = f"({of.argument})" if isinstance(of, At) else ""
        frame, stem = _without_frame(text.removesuffix(argument) if argument else text)
        cut = _end_of_stem(stem)
        return f"{frame}{dots}{{{stem[:cut]}}}{stem[cut:]}{argument}"

    def derivative(self, of: Piece, order: int) -> Piece:
        power = f"^{order}" if order > 1 else ""
        shown = of if of.bar else of.at_least(Precedence.ATOM, self)
        return Piece(rf"\frac{{d{power}}}{{dt{power}}} {shown.text}", Precedence.DOT, shown.depth)

    def subscripted(self, text: str, subscript: str) -> str:
        return f"{text}_{{{subscript}}}" if len(subscript) > 1 else f"{text}_{subscript}"

    def component(self, text: str, mark: str) -> str:
        """The letter with the mark in its subscript, behind what stands there."""
        frame, text = _without_frame(text)
        before = next((place for place, sign in _decorations(text) if sign == "_"), None)
        if before is None:
            end = next((place for place, sign in _decorations(text) if sign == "'" or place), len(text))
            return frame + self.subscripted(text[:end], mark) + text[end:]
        old = SUBSCRIPT.match(text, before + 1)
        assert old is not None
        stands = old[0][1:-1] if old[0].startswith("{") else old[0]
        return frame + text[:before] + self.subscripted("", f"{stands},{mark}") + text[old.end() :]

    def integral(self, of: Piece, body: str) -> Piece:
        text = rf"\int_{{{body}}} {of.text} \, d{body}" if body else rf"\sum {of.text}"
        return Piece(text, Precedence.PRODUCT, of.depth)

    def block(self, rows: list[list[str]]) -> str:
        # A bracket that begins a line would be read as an option.
        lines = r" \\ ".join("{}" * row[0].startswith("[") + " & ".join(row) for row in rows)
        return rf"\begin{{bmatrix}} {lines} \end{{bmatrix}}"


def _without_frame(text: str) -> tuple[str, str]:
    """The scripts before a letter, and the letter with those behind it."""
    found = BEFORE.match(text)
    end = found.end() if found else 0
    return text[:end], text[end:]


def _end_of_stem(text: str) -> int:
    """Where a letter's subscripts and primes begin: the dot of a rate stands over what comes before."""
    return next((position for position, _ in _decorations(text) if position), len(text))


def _takes_no_superscript(text: str) -> bool:
    """Whether the letter has a superscript already; TeX takes a second one directly behind a prime only."""
    marks = "".join(mark for _, mark in _decorations(_without_frame(text)[1]))
    return "^" in marks or "'_" in marks


def _decorations(text: str) -> Iterator[tuple[int, str]]:
    """The places of subscripts, superscripts and primes outside all braces."""
    depth = 0
    for position, mark in enumerate(text):
        depth += {"{": 1, "}": -1}.get(mark, 0)
        if depth == 0 and mark in "_^'":
            yield position, mark


def typeset(node: Node, beside: Node) -> str:
    """The expression in LaTeX, spelled as its author did, in the notation of the chapter of what it stands beside."""
    return spell(node, Latex(notation_of(beside))).text
