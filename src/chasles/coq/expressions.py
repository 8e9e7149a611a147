"""Expressions in Coq, spelled as the theories spell them, with brackets only where precedence asks for them."""

from __future__ import annotations

from collections.abc import Callable, Mapping

from chasles import vocabulary as w
from chasles.coq.names import CoqNames, bare_of

ATOM, APPLIED, POWER, MINUS, TIMES, PLUS, LOOSE = 0, 10, 30, 35, 40, 50, 200
"""How tightly the parts of a spelling hold together, as Coq counts it."""
Spelled = tuple[str, int]
EntryOf = tuple[w.Node, int, int]
"""A matrix, a row and a column, counted from 0."""
EMPTY: Mapping[w.Node, EntryOf] = {}
WORDS: Mapping[type[w.Node], str] = {
    w.Norm: "norm", w.Dot: "dot", w.Trace: "trace", w.Determinant: "det", w.Skew: "CPM", w.Cross: "cross",
    w.Vect: "vect", w.Cofactor: "cofactor",
}  # fmt: skip
"""What the theories call what is made of matrices."""


class Unsaid(Exception):
    """Something is not said in Coq; the message says what."""


class Spelling:
    """How expressions are spelled: numbers as reals, the rest as matrices, what moves at the instant t.

    `entries` are expressions that are entries of a matrix, and are spelled so.
    """

    def __init__(
        self, names: CoqNames, applied: Callable[[w.Node, str], str], entries: Mapping[w.Node, EntryOf] = EMPTY
    ) -> None:
        self.names, self.entries = names, entries
        self._applied = applied

    def side(self, node: w.Node) -> str:
        """One side of an equation."""
        return self.number(node) if node.is_scalar else self.matrix(node)

    def function(self, node: w.Node) -> str:
        """An expression as a function of time."""
        return f"(fun t => {self.number(node)})" if node.shape == (1, 1) else f"(fun t => ({self.matrix(node)})%M)"

    def equation(self, left: w.Node, right: w.Node) -> str:
        """Two sides that are said to be equal."""
        if left.is_scalar and right.is_scalar:
            return f"{self.number(left)} = {self.number(right)}"
        return f"({self.side(left)} = {self.side(right)})%M"

    def number(self, node: w.Node, most: int = LOOSE) -> str:
        """A scalar, in brackets if it is looser than `most`."""
        return held(self._number(node), most)

    def matrix(self, node: w.Node, most: int = LOOSE) -> str:
        """A matrix, in brackets if it is looser than `most`; what is 1 x 1 as one."""
        return held(self._matrix(node), most)

    def _number(self, node: w.Node) -> Spelled:
        node = bare_of(node)
        if not node.is_scalar:
            raise Unsaid(f"{node} is no number")
        if node in self.entries:
            of, i, j = self.entries[node]
            return f"entry {self.matrix(of, ATOM)} {i} {j}", APPLIED
        match node:
            case w.Number(value):
                text = f"{abs(value.numerator)}" + f" / {value.denominator}" * (value.denominator > 1)
                level = ATOM if value.denominator == 1 else TIMES
                return (text, level) if value >= 0 else (f"- {text}", max(level, MINUS))
            case w.Zero():
                return "0", ATOM
            case w.Identity():
                return "1", ATOM
            case w.Call("cos" | "sin" as function, argument):
                return f"{function} {self.number(argument, ATOM)}", APPLIED
            case w.Scale(factor, term):
                return f"{self.number(factor, TIMES)} * {self.number(term, TIMES - 1)}", TIMES
            case w.Transpose(of):
                return self._number(of)
            case w.Contract() | w.Block():
                return f"the {self.matrix(node, ATOM)}", APPLIED
            case w.Integral(of):
                return f"integral (fun b => {self.number(of)})", APPLIED
        return self._either(node, self.number)

    def _matrix(self, node: w.Node) -> Spelled:
        node = bare_of(node)
        if node.is_scalar and (node in self.entries or not isinstance(node, w.Contract | w.Block)):
            return f"number {self.number(node, ATOM)}", APPLIED
        match node:
            case w.Zero(int() as rows, int() as columns):
                return f"zero {rows} {columns}", APPLIED
            case w.Identity(int() as size):
                return f"one {size}", APPLIED
            case w.Scale(factor, term):
                return f"{self.number(factor, TIMES - 1)} *: {self.matrix(term, TIMES - 1)}", TIMES
            case w.Transpose(of):
                return f"{self.matrix(of, ATOM)}^T", ATOM + 1
            case w.Contract((first, *others)):
                factors = [self.matrix(first, TIMES), *(self.matrix(factor, TIMES - 1) for factor in others)]
                return " * ".join(factors), TIMES
            case w.Block(rows):
                lines = [_folded("beside", [self._matrix(block) for block in row]) for row in rows]
                return _folded("below", lines)
            case w.Integral(of):
                return f"integrated integral (fun b => ({self.matrix(of)})%M)", APPLIED
        return self._either(node, self.matrix)

    def _either(self, node: w.Node, part: Callable[[w.Node, int], str]) -> Spelled:
        """What is said alike of numbers and of matrices."""
        match node:
            case w.Symbol() if node == w.PI:
                return "PI", ATOM
            case w.Symbol():
                return _application(self._applied(node, self.names.symbol(node)))
            case w.Rate():
                return _application(self._applied(node, self.names.rate(node)))
            case w.Negative(term):
                return f"- {part(term, MINUS)}", MINUS
            case w.Quotient(numerator, denominator):
                return f"{part(numerator, TIMES)} / {self.number(denominator, TIMES - 1)}", TIMES
            case w.Power(base, exponent):
                return f"{part(base, POWER - 1)} ^ {exponent}", POWER
            case w.Sum((first, *others)):
                text = part(first, PLUS)
                for term in others:
                    sign, other = ("-", term.term) if isinstance(term, w.Negative) else ("+", term)
                    text += f" {sign} {part(other, PLUS - 1)}"
                return text, PLUS
        if type(node) in WORDS:
            return " ".join((WORDS[type(node)], *(self.matrix(of, ATOM) for of in w.children(node)))), APPLIED
        raise Unsaid(f"{getattr(node, 'function', type(node).__name__)} is no word of the theories")


def held(spelled: Spelled, most: int) -> str:
    """What is spelled, in brackets if it is looser than `most`."""
    text, level = spelled
    return text if level <= most else f"({text})"


def _application(text: str) -> Spelled:
    return text, APPLIED if " " in text else ATOM


def _folded(word: str, parts: list[Spelled]) -> Spelled:
    """Blocks put together two by two, from the last."""
    folded = parts[-1]
    for part in reversed(parts[:-1]):
        folded = f"{word} {held(part, ATOM)} {held(folded, ATOM)}", APPLIED
    return folded
