"""Words that no other words make up: named quantities, the identity, zero."""

from __future__ import annotations

from dataclasses import field
from fractions import Fraction

from chasles.vocabulary.dimension import NO_DIMENSION
from chasles.vocabulary.fitting import word
from chasles.vocabulary.measure import Extent, Measure, uniform
from chasles.vocabulary.nodes import Node, Number


@word
class Symbol(Node):
    """A named quantity. `stands_for` makes it an abbreviation, as E is for the cross-product matrix of e.

    `constant` says that it does not change with time. Two symbols of different `name` are different even where the
    book prints the same letter. `home` is the module that declares it, whose notation it is printed in; without
    `has_units` its rate has no dimension either.
    """

    name: str
    letter: str
    size: Measure
    meaning: str = ""
    constant: bool = False
    stands_for: Node | None = None
    home: str = field(default="", compare=False, repr=False)
    has_units: bool = field(default=True, repr=False)

    def _measured(self) -> Measure:
        return self.size


def entry_names(stem: str, rows: int, columns: int) -> list[list[str]]:
    """The names of the entries of a quantity, row by row: e_1, Q_12, Q_1,12, phi."""
    if columns == 1:
        return [[f"{stem}_{i + 1}" if rows > 1 else stem] for i in range(rows)]
    return [[f"{stem}_{i + 1}{',' * (max(i, j) > 8)}{j + 1}" for j in range(columns)] for i in range(rows)]


@word
class Identity(Node):
    """The identity matrix of the given size."""

    size: Extent
    letter: str = r"\mathbf{1}"

    def _measured(self) -> Measure:
        if not isinstance(self.size, int):
            from chasles.vocabulary.sizes import uniform_blocks  # few chapters have such letters

            return uniform_blocks(self.size, self.size, NO_DIMENSION, diagonal=True)
        one_on_the_diagonal = tuple(
            tuple(NO_DIMENSION if i == j else None for j in range(self.size)) for i in range(self.size)
        )
        return Measure(one_on_the_diagonal)


@word
class Zero(Node):
    """A zero matrix; it fits every dimension."""

    rows: Extent
    columns: Extent
    letter: str = r"\mathbf{O}"

    def _measured(self) -> Measure:
        return uniform((self.rows, self.columns), None)


def zero_of(shape: tuple[Extent, Extent]) -> Node:
    """The zero of a shape: a number, or a matrix."""
    return Number(Fraction(0)) if shape == (1, 1) else Zero(*shape)


def is_measured(node: Node) -> bool:
    """Whether the chapter that declares the first symbol of an expression has units."""
    waiting = [node]
    while waiting:
        part = waiting.pop()
        if isinstance(part, Symbol) and part.home:
            return part.has_units
        waiting.extend(reversed(part._parts()))
    return True


def has_no_letter(node: Node) -> bool:
    """Whether an expression is made of numbers alone, pi among them: its rate is zero, in every dimension."""
    return node.constant and not node.home if isinstance(node, Symbol) else all(map(has_no_letter, node.below))
