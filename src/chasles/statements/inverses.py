"""Inverses in other words: the transpose of a rotation, of a product the product of inverses, else cofactors.

A matrix has an inverse where its determinant is not zero, and it is then the transpose of its cofactor matrix over the
determinant (Cramer). That it is not zero is assumed wherever it does not follow from what a hypothesis says.
"""

from __future__ import annotations

from collections.abc import Collection, Iterable, Mapping
from fractions import Fraction
from functools import lru_cache
from typing import Any

from chasles import vocabulary as w
from chasles.statements.hypotheses import Hypothesis, nonzero
from chasles.statements.varied import opened_parts
from chasles.vocabulary import Node


class Inverses:
    """Puts other words in the place of inverses; `used` are the hypotheses by which they say the same.

    Those among them that nobody has assumed yet are `needed` too. Beside letters for sizes, inverses of matrices stay.
    Nothing is concluded from a hypothesis on what a rule replaces.
    """

    def __init__(self, hypotheses: Collection[Hypothesis], rules: Mapping[Node, Node], *, any_size: bool) -> None:
        self.used: dict[Hypothesis, None] = {}
        self.needed: dict[Hypothesis, None] = {}
        self._rules = rules
        self._any_size = any_size
        self._known = {(h.kind, h.subjects): h for h in hypotheses if not rules.keys() & {*h.subjects}}
        self._nonzero = {node: hypothesis for hypothesis in hypotheses for node in hypothesis.nonvanishing}

    def __call__(self, node: Node) -> Node:
        """The node with every inverse in it said in other words."""
        found = _inverses(node)
        return w.replace(node, {inverse: self._inverse(inverse.of) for inverse in found}) if found else node

    def hypothesis(self, said: Hypothesis) -> Hypothesis:
        """The same said without inverses."""
        found = said.rewritten(self)
        return said if (found.nonvanishing, found.equations) == (said.nonvanishing, said.equations) else found

    def _inverse(self, of: Node) -> Node:
        """The inverse of a scalar or a matrix."""
        found = self._by_parts(of)
        if found is not None:
            return found
        if of.is_scalar:
            self._need(self(of))
            return w.Quotient(w.Number(Fraction(1)), self(of))
        said = self(of)
        self._need(w.Determinant(said))
        if self._any_size:
            return w.Inverse(said)
        return w.Quotient(w.Transpose(w.Cofactor(said)), w.Determinant(said))

    def _by_parts(self, of: Node) -> Node | None:
        """The inverse of what is made of others that have one, or is a rotation; None for anything else."""
        match of:
            case w.Group(inner) | w.At(inner) | w.Symbol(stands_for=Node() as inner):
                return self._inverse(inner)
            case w.Inverse(inner):
                self._inverse(inner)
                return self(inner)
            case w.Identity():
                return of
            case w.Transpose(inner):
                return w.Transpose(self._inverse(inner))
            case w.Negative(term):
                return w.Negative(self._inverse(term))
            case w.Scale(factor, term) if not of.is_scalar:
                return w.Scale(self._inverse(factor), self._inverse(term))
            case w.Quotient(numerator, divisor) if not of.is_scalar:
                return w.Scale(self(divisor), self._inverse(numerator))
            case w.Power(base, exponent):
                return w.Power(self._inverse(base), exponent)
            case w.Contract(factors) if all(factor.shape == of.shape for factor in factors) and not of.is_scalar:
                return w.Contract(tuple(map(self._inverse, reversed(factors))))
            case w.Number(value) if value:
                return w.Number(1 / value)
            case w.Block(((a, b), (c, d))) if a.shape[0] == a.shape[1] and (_is_zero(b) or _is_zero(c)):
                first, last = self._inverse(a), self._inverse(d)
                upper = b if _is_zero(b) else w.Negative(w.Contract((first, self(b), last)))
                lower = c if _is_zero(c) else w.Negative(w.Contract((last, self(c), first)))
                return w.Block(((first, upper), (lower, last)))
            case _ if of in self._rules and not isinstance(self._rules[of], w.Symbol):
                return self._by_parts(self._rules[of])
            case _:
                return self._of_rotation(of)

    def _of_rotation(self, of: Node) -> Node | None:
        """The transpose, where a hypothesis says that the matrix, or the triad of its columns, is a rotation."""
        said: list[tuple[Any, Any]] = [("rotation", (of,)), ("half_turn", (of,)), ("orthogonal", (of,))]
        if isinstance(of, w.Block) and len(of.rows) == 1:
            said.append(("orthonormal", of.rows[0]))
        for key in said:
            if key in self._known:
                self.used[self._known[key]] = None
                return w.Transpose(of)
        return None

    def _need(self, divisor: Node) -> None:
        """The divisor is not zero: that is assumed, if it is not yet."""
        known = self._nonzero.get(divisor)
        if known is None:
            known = self._nonzero[divisor] = nonzero(divisor)
            self.needed[known] = None
        self.used[known] = None


@lru_cache(maxsize=4096)
def _inverses(node: Node) -> tuple[w.Inverse, ...]:
    return tuple(dict.fromkeys(part for part in opened_parts(node) if isinstance(part, w.Inverse)))


def _is_zero(block: Node) -> bool:
    return isinstance(block, w.Zero) or (isinstance(block, w.Number) and not block.value)


def reached(sides: Iterable[Node], rules: Mapping[Node, Node]) -> set[Node]:
    """The left sides of the rules that are applied where these sides are read, rates of what occurs among them."""
    found: set[Node] = set()
    seen: set[Node] = set()
    ahead = list(sides)
    while ahead:
        seen.update(opened_parts(ahead.pop()))
        more = {left for left in rules if left not in found and not seen.isdisjoint(opened_parts(left))}
        found |= more
        ahead += [rules[left] for left in more]
    return found
