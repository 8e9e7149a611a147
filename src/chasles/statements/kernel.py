"""Inputs and outputs of an emitted function: symbols, scalars in one array, a symmetric matrix as six numbers."""

from __future__ import annotations

from dataclasses import dataclass

from chasles.statements.hypotheses import Hypothesis
from chasles.vocabulary import Node, plain
from chasles.vocabulary.arguments import Declared


@dataclass(frozen=True, slots=True)
class Stack(Declared):
    """An argument that holds several scalars, one below the other; raises TypeError if one of them is no scalar."""

    name: str
    parts: tuple[Node, ...]
    meaning: str = ""

    def __post_init__(self) -> None:
        for part in self.parts:
            if not part.is_scalar:
                raise TypeError(f"{self.name} stacks scalars, and {plain(part)} is {part.shape[0]} x {part.shape[1]}")


@dataclass(frozen=True, slots=True)
class Packed(Declared):
    """A symmetric 3 x 3 matrix as (xx, xy, xz, yy, yz, zz), its own entries; raises TypeError for another shape."""

    matrix: Node

    def __post_init__(self) -> None:
        if self.matrix.shape != (3, 3):
            raise TypeError(f"six numbers stand for a 3 x 3 matrix, and {plain(self.matrix)} is no such")


Argument = Node | Stack | Packed


@dataclass(frozen=True, slots=True)
class Kernel(Declared):
    """A request to emit the right side as a function `of` the given symbols and rates of symbols.

    `name` defaults to the statement's. With several `results`, the right side is a column of blocks, one for each.
    `symmetric` matrices, among the arguments or the left side, are also taken or given as six numbers, by a second
    kernel. What is `expected` of the arguments gives the result its meaning, whether or not the proof needs it.
    `form` says the right side in other words, better ones for a machine; a kernel is made of it only once it is proved
    equal to what stands.
    """

    of: tuple[Argument, ...]
    name: str = ""
    results: tuple[str, ...] = ()
    symmetric: tuple[Node, ...] = ()
    expected: tuple[Hypothesis, ...] = ()
    form: Node | None = None


def nodes_of(argument: Argument) -> tuple[Node, ...]:
    """The symbols whose entries an argument holds."""
    match argument:
        case Stack(parts=parts):
            return parts
        case Packed(matrix):
            return (matrix,)
        case _:
            return (argument,)
