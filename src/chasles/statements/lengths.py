"""Lengths said of simpler vectors: |2 a| is 2 |a|, |Q a| is |a| for a rotation Q, and |e| is 1 for a unit vector.

A norm is the nonnegative root. A factor leaves it where its spelling, or a hypothesis, says that it is not negative.
Expressions are visibly sums of squares, zero only where each square is, by their spelling: even powers, norms, scalar
products of an expression with itself, positive factors, integrals of such over a body. Nothing is computed.
"""

from __future__ import annotations

from collections.abc import Collection, Iterable, Iterator, Mapping
from dataclasses import replace as with_fields
from fractions import Fraction
from functools import lru_cache

from chasles import vocabulary as w
from chasles.statements.hypotheses import Hypothesis
from chasles.vocabulary import Node


def squared(square: Node) -> tuple[Node, ...]:
    """What vanishes when the square does; nothing for a positive number or symbol.

    Raises `Misfit` where it is no product of a square and of factors that cannot vanish: the integral of a square
    vanishes where the square does in every element of the body, which is no equation.
    """
    match square:
        case w.Number() | w.Symbol():
            return ()
        case w.Group(of):
            return squared(of)
        case w.Norm(of) | w.Power(w.Norm(of), _) | w.Power(of, _):
            return (of,)
        case w.Dot(left, right) if left == right:
            return (left,)
        case w.Contract((w.Transpose(left), *_, right)) if left == right:
            return (left,)
        case w.Scale(factor, term) | w.Quotient(term, factor):
            found = (*squared(factor), *squared(term))
            if len(found) < 2:
                return found
    raise w.Misfit(f"{square} is not one square times factors that do not vanish")


def relied_on(square: Node, hypotheses: Iterable[Hypothesis]) -> Iterator[Hypothesis]:
    """The hypotheses by which the expression is never negative; raises `Misfit` if it is not seen to be so."""
    match square:
        case w.Number(value) if value >= 0:
            return
        case w.Norm():
            return
        case w.Power(base, exponent) if base.is_scalar and exponent % 2 == 0:
            return
        case w.Dot(left, right) if left == right:
            return
        case w.Contract((w.Transpose(left), right)) | w.Trace(w.Contract((w.Transpose(left), right))) if left == right:
            return
        case w.Symbol():
            yield _named("positive", square, hypotheses)
        case w.Contract((w.Transpose(left), matrix, right)) if left == right:
            yield _named("definite", matrix, hypotheses)
        case w.Scale(factor, term) | w.Quotient(factor, term):
            yield from relied_on(factor, hypotheses)
            yield from relied_on(term, hypotheses)
        case w.Sum(terms):
            for term in terms:
                yield from relied_on(term, hypotheses)
        case w.Group(of) | w.Power(of, _):
            yield from relied_on(of, hypotheses)
        case w.Integral(of, density):
            yield _named("positive", density, hypotheses)
            yield from relied_on(of, hypotheses)
        case _:
            raise w.Misfit(f"{square} is not seen to be a square, or a sum of squares with positive factors")


def _named(kind: str, subject: Node, hypotheses: Iterable[Hypothesis]) -> Hypothesis:
    """The hypothesis of that kind on the subject."""
    for hypothesis in hypotheses:
        if hypothesis.kind == kind and subject in hypothesis.subjects:
            return hypothesis
    raise w.Misfit(f"{subject} is not assumed to be {kind}, so a sum with it is not seen to be one of squares")


@lru_cache(maxsize=4096)
def _has_length(node: Node) -> bool:
    return any(isinstance(part, w.Norm) for part in w.walk(node))


class Lengths:
    """Puts simpler lengths in the place of others; `used` are the hypotheses by which they are equal.

    Nothing is concluded from a hypothesis on what a rule replaces.
    """

    def __init__(self, hypotheses: Collection[Hypothesis], rules: Mapping[Node, Node]) -> None:
        self.used: dict[Hypothesis, None] = {}
        self._known = {(h.kind, s): h for h in hypotheses for s in h.subjects if s not in rules}

    def __call__(self, node: Node) -> Node:
        """The node with every length in it as simple as it is known."""
        if not _has_length(node):
            return node
        # An even power of a norm is a polynomial as it stands, whatever is known of the norm; what is divided by is
        # to be found among what does not vanish.
        divisors = {part for each in w.walk(node) if isinstance(each, w.Quotient) for part in w.walk(each.denominator)}
        squares: dict[Node, Node] = {part: part for part in w.walk(node) if _is_square(part) and part not in divisors}
        loose = [part for part in _outside(node, squares) if isinstance(part, w.Norm)]
        lengths = {part: self._length(part.of) for part in loose}
        changed: dict[Node, Node] = {old: new for old, new in lengths.items() if old != new}
        return w.replace(node, squares | changed) if changed else node

    def hypothesis(self, said: Hypothesis) -> Hypothesis:
        """The same said of simpler lengths."""
        found = with_fields(said.rewritten(self), equations=said.equations)
        return said if found.nonvanishing == said.nonvanishing else found

    def _length(self, of: Node) -> Node:
        match of:
            case w.Group(inner) | w.Negative(inner) | w.At(inner, "t"):
                return self._length(inner)
            case w.Scale(w.Number(value), inner):
                return w.Scale(w.Number(abs(value)), self._length(inner))
            case w.Scale(factor, inner) if self._is_nonnegative(factor):
                return w.Scale(factor, self._length(inner))
            case w.Quotient(inner, w.Number(value)):
                return w.Quotient(self._length(inner), w.Number(abs(value)))
            case w.Quotient(inner, divisor) if self._is_nonnegative(divisor):
                return w.Quotient(self._length(inner), divisor)
            case w.Contract((w.Scale(factor, matrix), *rest)):
                return self._length(w.Scale(factor, w.Contract((matrix, *rest))))
            case w.Contract((matrix, *rest)) if rest and self._turns(matrix):
                return self._length(rest[0] if len(rest) == 1 else w.Contract(tuple(rest)))
            case w.Symbol() if self._says("unit", of):
                return w.Number(Fraction(1))
        return w.Norm(of)

    def _is_nonnegative(self, factor: Node) -> bool:
        try:
            used = dict.fromkeys(relied_on(factor, self._known.values()))
        except w.Misfit:
            return False
        self.used |= used
        return True

    def _turns(self, matrix: Node) -> bool:
        return self._says("rotation", matrix.of if isinstance(matrix, w.Transpose | w.Group) else matrix)

    def _says(self, kind: str, subject: Node) -> bool:
        hypothesis = self._known.get((kind, subject))
        if hypothesis is not None:
            self.used[hypothesis] = None
        return hypothesis is not None


def _is_square(node: Node) -> bool:
    return isinstance(node, w.Power) and isinstance(node.base, w.Norm) and node.exponent % 2 == 0


def _outside(node: Node, squares: Collection[Node]) -> Iterator[Node]:
    """The node and what is below it, but not what is below an even power of a norm."""
    if node not in squares:
        yield node
        for part in w.children(node):
            yield from _outside(part, squares)
