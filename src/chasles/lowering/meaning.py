"""What does a symbol stand for? An argument, a rule's right side, the values of a case, an angle."""

from __future__ import annotations

from collections.abc import Mapping
from typing import Protocol

from chasles.lowering.builder import Builder
from chasles.lowering.cases import Choice, Comparison
from chasles.lowering.matrices import Rows
from chasles.lowering.refusal import LoweringError
from chasles.lowering.request import Request
from chasles.statements import Packed
from chasles.statements.arrays import Place, places_of
from chasles.statements.kernel import nodes_of
from chasles.statements.statement import bare
from chasles.vocabulary import PI, Group, Node, Rate, Symbol, Zero, plain
from chasles.vocabulary.differentiation import rate_of
from chasles.vocabulary.shorthand import Shorthand


class Expander(Protocol):
    """What writes an expression in steps."""

    builder: Builder

    def scalar(self, node: Node) -> int: ...
    def rows(self, node: Node) -> Rows: ...


class Meanings:
    """The symbols of a request; arguments, choices and angles are known by their entries, others by an expression."""

    def __init__(self, request: Request, expander: Expander) -> None:
        self._expander = expander
        self._rules = dict(request.rules)
        self._angles = dict(request.angles)
        self._functions = {known.symbol: known for known in request.functions}
        self._choices = {symbol: choice for choice in request.choices for symbol in choice.symbols}
        self._known: dict[Node, Rows] = {PI: ((expander.builder.half_turn(),),)}
        for number, argument in enumerate(request.arguments):
            steps = {place: expander.builder.input(number, entry) for entry, place in enumerate(places_of(argument))}
            for node in nodes_of(argument):
                self._known[node] = _arranged(node, steps, mirrored=isinstance(argument, Packed))

    def of(self, node: Node) -> Node:
        """The expression that the node stands for, or the node itself."""
        while True:
            node = bare(node)
            if self.is_known(node):
                return node
            match node:
                case _ if node in self._rules:
                    node = self._rules[node]
                case Symbol(stands_for=Node() as inner) | Group(inner):
                    node = inner
                case Shorthand():
                    node = node.definition
                case Rate(of):
                    node = self._rate(self.of(of))
                case Symbol():
                    raise LoweringError(f"{plain(node)} is free: it is neither an argument nor defined")
                case _:
                    return node

    def is_known(self, node: Node) -> bool:
        """Whether it is an argument, a choice, an angle or a function, whose entries are steps and no expressions."""
        return any(node in each for each in (self._known, self._choices, self._angles, self._functions))

    def is_ruled(self, node: Node) -> bool:
        """Whether the node is a symbol that a rule defines."""
        node = bare(node)
        return node in self._rules and not self.is_known(node)

    def rows(self, node: Node) -> Rows:
        """The steps that hold the entries of an argument, of a choice or of an angle."""
        if node not in self._known:
            assert isinstance(node, Symbol)
            if node in self._choices:
                self._choose(self._choices[node])
            elif node in self._functions:
                function = self._functions[node]
                operands = [self._expander.scalar(argument) for argument in function.arguments]
                self._known[node] = ((function.made(self._expander.builder, operands),),)
            else:
                self._known[node] = ((self._angle(node),),)
        return self._known[node]

    def _rate(self, of: Node) -> Node:
        if isinstance(of, Symbol) and of.constant:
            return Zero(*of.shape)
        if self.is_known(of):
            raise LoweringError(f"the rate of {plain(of)} is free: it is neither an argument nor given")
        return rate_of(of)

    def _angle(self, symbol: Symbol) -> int:
        angle, build, scalar = self._angles[symbol], self._expander.builder, self._expander.scalar
        principal = build.arctangent2(scalar(angle.sine), scalar(angle.cosine))
        return build.multiply(build.constant(angle.times), principal)

    def _choose(self, choice: Choice) -> None:
        """The entries of a choice's symbols: those of the last case, replaced by those of the cases before it."""
        build = self._expander.builder
        for place, symbol in enumerate(choice.symbols):
            rows, columns = symbol.shape
            chosen = nothing = ((build.not_a_number(),) * columns,) * rows
            for case in reversed(choice.cases):
                values = self._expander.rows(case.values[place]) if case.values else nothing
                for comparison in reversed(case.where):
                    values = self._selected(comparison, values, chosen)
                chosen = values
            self._known[symbol] = chosen

    def _selected(self, comparison: Comparison, if_so: Rows, otherwise: Rows) -> Rows:
        build, scalar = self._expander.builder, self._expander.scalar
        test = build.less if comparison.kind == "less" else build.equal
        condition = test(scalar(comparison.left), scalar(comparison.right))
        first, second = (if_so, otherwise) if comparison.holds else (otherwise, if_so)
        return tuple(
            tuple(build.select(condition, a, b) for a, b in zip(one, other, strict=True))
            for one, other in zip(first, second, strict=True)
        )


def _arranged(node: Node, steps: Mapping[Place, int], *, mirrored: bool) -> Rows:
    """The entries of a node; of a symmetric one those below the diagonal are those above it."""
    rows, columns = node.shape
    return tuple(
        tuple(steps[node, *(sorted((i, j)) if mirrored else (i, j))] for j in range(columns)) for i in range(rows)
    )
