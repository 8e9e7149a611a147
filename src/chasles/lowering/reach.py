"""Which definitions does a kernel need? Those that its results lead to, each before the ones that use it."""

from __future__ import annotations

from collections.abc import Callable, Iterable, Mapping
from typing import Any

from chasles.lowering.cases import Choice
from chasles.lowering.named_functions import NamedFunction
from chasles.lowering.refusal import LoweringError
from chasles.lowering.rewriting import Angle
from chasles.statements.statement import bare
from chasles.vocabulary import PI, Node, Rate, Symbol, children, plain
from chasles.vocabulary.differentiation import NoRule, rate_of


class Reach:
    """The definitions that the expressions followed so far lead to."""

    def __init__(
        self,
        kernel: str,
        of: tuple[Node, ...],
        rules: Mapping[Node, Node],
        choices: Iterable[Choice],
        angles: Mapping[Symbol, Angle],
        functions: Mapping[Symbol, NamedFunction] | None = None,
    ) -> None:
        self._kernel = kernel
        self._of = of
        self._rules = rules
        self._choices = {symbol: choice for choice in choices for symbol in choice.symbols}
        self._angles = angles
        self._functions = functions or {}
        self._used: dict[Node, None] = {}
        self._done: dict[Node, bool] = {}
        self._found_rules: dict[Node, Node] = {}
        self._found_choices: dict[Choice, None] = {}
        self._found_angles: dict[Symbol, Angle] = {}
        self._found_functions: dict[NamedFunction, None] = {}

    @property
    def rules(self) -> tuple[tuple[Node, Node], ...]:
        """The rules that were applied, in the order in which they were met."""
        return tuple(self._found_rules.items())

    @property
    def choices(self) -> tuple[Choice, ...]:
        """The choices that were met, in order."""
        return tuple(self._found_choices)

    @property
    def angles(self) -> tuple[tuple[Symbol, Angle], ...]:
        """The angles that were met, with what they are."""
        return tuple(self._found_angles.items())

    @property
    def functions(self) -> tuple[NamedFunction, ...]:
        """The functions that were met, each after those in its arguments."""
        return tuple(self._found_functions)

    def is_used(self, node: Node) -> bool:
        """Whether a result depends on the value of a symbol or a rate."""
        return node in self._used

    def follow(self, node: Node) -> None:
        """Reach all that the expression needs."""
        node = bare(node)
        match node:
            case _ if node in self._of:
                self._used[node] = None
            case _ if self._done.get(node):
                return
            case Symbol() if node in self._choices:
                self._once(node, self._follow_choice)
            case Symbol() if node in self._angles:
                self._once(node, self._follow_angle)
            case Symbol() if node in self._functions:
                self._once(node, self._follow_function)
            case _ if node == PI:
                return
            case _ if node in self._rules:
                self._once(node, self._follow_rule)
            case Symbol(stands_for=Node() as inner):
                self.follow(inner)
            case Symbol():
                raise self._free(node)
            case Rate(of):
                self._follow_rate(bare(of))
            case _:
                for part in children(node):
                    self.follow(part)

    def _once(self, node: Node, follow: Callable[[Any], None]) -> None:
        if node in self._done:
            raise LoweringError(f"{self._kernel}: {plain(node)} is defined by itself")
        self._done[node] = False
        follow(node)
        self._done[node] = True

    def _follow_rule(self, node: Node) -> None:
        self.follow(self._rules[node])
        self._found_rules[node] = self._rules[node]

    def _follow_choice(self, symbol: Symbol) -> None:
        choice = self._choices[symbol]
        for case in choice.cases:
            for comparison in case.where:
                self.follow(comparison.left)
                self.follow(comparison.right)
            for value in case.values:
                self.follow(value)
        self._found_choices[choice] = None

    def _follow_angle(self, symbol: Symbol) -> None:
        self.follow(self._angles[symbol].cosine)
        self.follow(self._angles[symbol].sine)
        self._found_angles[symbol] = self._angles[symbol]

    def _follow_function(self, symbol: Symbol) -> None:
        for argument in self._functions[symbol].arguments:
            self.follow(argument)
        self._found_functions[self._functions[symbol]] = None

    def _follow_rate(self, of: Node) -> None:
        """A rate that is neither an argument nor defined is made of the rates of its parts."""
        match of:
            case _ if of in self._rules:
                self.follow(of)
                self._follow_rate_by_parts(self._rules[of])
            case Symbol(stands_for=Node() as inner):
                self._follow_rate_by_parts(inner)
            case Symbol(constant=True):
                return
            case Symbol() | Rate():
                raise self._free(Rate(of))
            case _:
                self._follow_rate_by_parts(of)

    def _follow_rate_by_parts(self, of: Node) -> None:
        try:
            self.follow(rate_of(of))
        except NoRule as error:
            raise LoweringError(str(error)) from None

    def _free(self, node: Node) -> LoweringError:
        arguments = ", ".join(map(plain, self._of))
        return LoweringError(
            f"{self._kernel}: {plain(node)} is free: it is not among the arguments ({arguments}), and nothing given "
            "says what it is"
        )
