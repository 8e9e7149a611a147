"""The product of two matrices entry by entry."""

from __future__ import annotations

from typing import ClassVar

from chasles.vocabulary.arguments import making
from chasles.vocabulary.fitting import measured, word
from chasles.vocabulary.layout import Block
from chasles.vocabulary.measure import Misfit
from chasles.vocabulary.nodes import Node, Scale
from chasles.vocabulary.shorthand import Shorthand
from chasles.vocabulary.sizes import sizes_of


@word
class HadamardProduct(Shorthand):
    """The matrix of the products of the entries of two matrices of one size, each with that in its place."""

    left: Node
    right: Node
    function: ClassVar[str] = "hadamard"

    @property
    def definition(self) -> Node:
        rows, columns = measured(self.left).shape
        if (rows, columns) != self.right.shape or sizes_of([self.left, self.right]):
            raise Misfit(f"{self.left} and {self.right} are multiplied entry by entry: they need one size, in numbers")
        lines = ([(i + 1, j + 1) for j in range(columns)] for i in range(rows))
        return Block(tuple(tuple(Scale(self.left[place], self.right[place]) for place in line) for line in lines))


hadamard_product = making(HadamardProduct, "hadamard_product")
