"""Rates in problems about matrices of any size: each is said by the rates of symbols, which have letters."""

from __future__ import annotations

from collections.abc import Iterator, Mapping
from dataclasses import replace as with_fields
from functools import partial

from chasles import vocabulary as w
from chasles.statements.hypotheses import Hypothesis, symmetric
from chasles.statements.rules import rated
from chasles.vocabulary import Node
from chasles.vocabulary.differentiation import rate_of
from chasles.vocabulary.fitting import measured
from chasles.vocabulary.layout import At, Group, Rate
from chasles.vocabulary.spatial import Determinant, Inverse
from chasles.vocabulary.tree import with_parts


class SizedRates:
    """Carries out rates; the `rules` say what symbols stand for. Raises `NoRule` for what has no rate by its parts.

    `letters` are those for the rates of symbols that came up.
    """

    def __init__(self, rules: Mapping[Node, Node]) -> None:
        self.rules = rules
        self.letters: dict[Node, w.Symbol] = {}

    def __call__(self, node: Node) -> Node:
        """The expression in which each rate of a symbol is a letter."""
        return self._lettered(self._carried_out(node))

    def _carried_out(self, node: Node) -> Node:
        """The expression in which nothing but symbols has rates."""
        match node:
            case Rate(of):
                return self._rate(self._carried_out(of))
            case w.Symbol(stands_for=Node() as of):
                return self._carried_out(of)
            case _:
                return with_parts(node, self._carried_out)

    def _rate(self, node: Node) -> Node:
        match node:
            case _ if node in self.rules:
                return self._rate(self._carried_out(self.rules[node]))
            case w.Symbol(constant=True):
                return w.Zero(*node.shape)
            case w.Symbol() | Rate():
                return Rate(node)
            case Inverse(of):
                return -(node @ self._rate(of) @ node)
            case Determinant(of):
                return node * w.tr(w.inverse(of) @ self._rate(of))
            case Group(of) | At(of, "t"):
                return self._rate(of)
            case _:
                return self._resolved(rate_of(node))

    def _resolved(self, node: Node) -> Node:
        if isinstance(node, Rate):
            return self._rate(node.of)
        parts = w.children(node)
        return w.rebuilt(node, tuple(map(self._resolved, parts))) if parts else node

    def _lettered(self, node: Node) -> Node:
        if isinstance(node, Rate):
            base, _ = w.undotted(node)
            home, in_units = (base.home, base.has_units) if isinstance(base, w.Symbol) else ("", True)
            name = w.plain(node)
            made = w.Symbol(name, name, measured(node), f"the rate of {base}", home=home, has_units=in_units)
            return self.letters.setdefault(node, made)
        return with_parts(node, self._lettered)

    def bound(self, hypotheses: tuple[Hypothesis, ...]) -> Iterator[Hypothesis]:
        """What is assumed, and what it says of the rates that came up: the rate of each equation holds too."""
        yield from hypotheses
        highest = dict(sorted(map(w.undotted, self.letters), key=lambda each: each[1]))
        for base, order in ((base, order) for base, most in highest.items() for order in range(1, most + 1)):
            letter = self._lettered(rated(base, order))
            for hypothesis in hypotheses:
                if not any(base in w.walk(side) for side in hypothesis.sides):
                    continue
                if hypothesis.kind in ("symmetric", "definite"):
                    yield with_fields(symmetric(letter), text=hypothesis.text)
                elif hypothesis.kind == "skew-symmetric":
                    yield hypothesis.rewritten(partial(w.replace, values={base: letter}))
                else:
                    sides = ((rated(left, order), rated(right, order)) for left, right in hypothesis.equations)
                    equations = tuple((self(left), self(right)) for left, right in sides)
                    yield Hypothesis("of a rate", (letter,), equations, text=hypothesis.text)
