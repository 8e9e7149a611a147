"""Equations for every i and j: indexed members of a family, entries of a matrix, the Kronecker delta.

Such an equation is printed with its indices and means all its instances; `members_of` lists them.
"""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass
from fractions import Fraction
from itertools import product

from chasles.vocabulary.arguments import Declared
from chasles.vocabulary.dimension import NO_DIMENSION
from chasles.vocabulary.fitting import measured, word
from chasles.vocabulary.layout import Block
from chasles.vocabulary.letters import Zero
from chasles.vocabulary.measure import Measure, uniform
from chasles.vocabulary.nodes import Contract, Node, Number, Transpose
from chasles.vocabulary.tree import walk, with_parts


@dataclass(frozen=True, slots=True)
class Index(Declared):
    """An index that runs over 1, 2, 3."""

    letter: str


@dataclass(frozen=True, slots=True)
class Family(Declared):
    """Three quantities with one letter: e_1, e_2, e_3; `mark` is printed behind the index, as a prime is."""

    letter: str
    members: tuple[Node, Node, Node]
    mark: str = ""

    def __getitem__(self, index: Index) -> Member:
        return Member(self, index)


@word
class Member(Node):
    """The i-th quantity of a family."""

    family: Family
    index: Index

    def _measured(self) -> Measure:
        return measured(self.family.members[0])


@word
class Entry(Node):
    """The entry in row i and column j of a matrix, printed with a small letter."""

    of: Node
    i: Index
    j: Index
    letter_of_entry: str

    def _measured(self) -> Measure:
        return uniform((1, 1), measured(self.of).the_dimension(self.of))


@word
class Kronecker(Node):
    """One if the two indices are equal, else zero."""

    i: Index
    j: Index

    def _measured(self) -> Measure:
        return uniform((1, 1), NO_DIMENSION)


def indices_of(node: Node) -> tuple[Index, ...]:
    """The indices that occur, in reading order."""
    found: dict[Index, None] = {}
    for part in walk(node):
        match part:
            case Member(_, index):
                found[index] = None
            case Entry(_, i, j, _) | Kronecker(i, j):
                found |= {i: None, j: None}
    return tuple(found)


def members_of(*sides: Node) -> list[tuple[Node, ...]]:
    """The sides of an equation for all values of its indices; without indices, the sides themselves."""
    indices = tuple(dict.fromkeys(index for side in sides for index in indices_of(side)))
    values = [dict(zip(indices, numbers, strict=True)) for numbers in product(range(3), repeat=len(indices))]
    return [tuple(_instance(side, value) for side in sides) for value in values]


def _instance(node: Node, value: Mapping[Index, int]) -> Node:
    match node:
        case Member(family, index):
            return family.members[value[index]]
        case Entry(of, i, j, _):
            return Contract((Transpose(_unit_column(value[i])), of, _unit_column(value[j])))
        case Kronecker(i, j):
            return Number(Fraction(int(value[i] == value[j])))
        case _:
            return with_parts(node, lambda part: _instance(part, value))


def _unit_column(k: int) -> Node:
    return Block(tuple((Number(Fraction(int(i == k))) if i == k else Zero(1, 1),) for i in range(3)))
