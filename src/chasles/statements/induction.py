"""Statements for all k, proved by induction: a base and a step, each an equation that is decided."""

from __future__ import annotations

from dataclasses import dataclass

from chasles.vocabulary import Node, Symbol, replace
from chasles.vocabulary.arguments import Declared


@dataclass(frozen=True, slots=True)
class ForAllK(Declared):
    """For every k from the first on, the `value` is the `formula`, in which k stands in letters such as (-1)^k.

    The value is `first` to begin with, and each step makes `following`, an expression in the value, of it. The letters
    are `at_first` to begin with, and become `afterwards` with each step. Proved by first = formula there, and by
    following = the formula with the letters moved on, the value being replaced by the formula.
    """

    value: Symbol
    formula: Node
    first: Node
    following: Node
    at_first: tuple[tuple[Symbol, Node], ...]
    afterwards: tuple[tuple[Symbol, Node], ...]

    def __post_init__(self) -> None:
        begun, moved = ({letter for letter, _ in letters} for letters in (self.at_first, self.afterwards))
        if begun != moved:
            raise TypeError("a letter in which k stands has a first value and becomes another: give both for each")

    def equations(self) -> tuple[tuple[str, Node, Node], ...]:
        """The base and the step."""
        base = ("it holds for the first k", self.first, replace(self.formula, dict(self.at_first)))
        before: dict[Node, Node] = {self.value: self.formula}
        step = replace(self.following, before), replace(self.formula, dict(self.afterwards))
        return base, ("if it holds for k, it does for the next", *step)
