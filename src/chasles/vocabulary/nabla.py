"""Gradients, divergences, curls and Laplacians, by partial derivatives: what nabla stands for."""

from __future__ import annotations

from collections.abc import Callable
from typing import ClassVar

from chasles.vocabulary.arguments import WrongArgument, declaring
from chasles.vocabulary.fields import fields_of
from chasles.vocabulary.fitting import word
from chasles.vocabulary.layout import Block
from chasles.vocabulary.letters import Symbol
from chasles.vocabulary.measure import Misfit
from chasles.vocabulary.nodes import Contract, Node, Scale, Sum, Transpose, lifted
from chasles.vocabulary.partial import PartialDerivative
from chasles.vocabulary.pieces import Piece, Precedence, Style
from chasles.vocabulary.shorthand import Shorthand
from chasles.vocabulary.spatial import Vect

Position = Symbol | Block
SIGNS = {"grad": r"\nabla", "div": r"\nabla \cdot", "curl": r"\nabla \times", "laplacian": r"\nabla^2"}


@word
class Nabla(Shorthand):
    """An operator of vector calculus, called by its `function`, on what depends on a position, `by` which it is taken.

    The gradient of a column has its derivatives by the j-th coordinate in column j; the divergence of a matrix is that
    of each row.
    """

    function: str  # type: ignore[misc]
    of: Node
    by: Position
    has_no_polynomial_form: ClassVar[bool] = True

    @property
    def definition(self) -> Node:
        match self.function:
            case "grad" | "curl":
                slopes = PartialDerivative(self.of, self.by)
                turned = Transpose(slopes) if self.of.is_scalar else slopes
                return turned if self.function == "grad" else Scale(lifted(2), Vect(slopes))
            case "laplacian":
                return Sum(tuple(PartialDerivative(PartialDerivative(self.of, by), by) for by in self._coordinates))
        rows, columns = self.of.shape
        if (rows if columns == 1 else columns) != len(self._coordinates):
            raise Misfit(f"the divergence of {self.of} ({rows} x {columns}) by {self.by} has no meaning")
        parts = (self.of[j + 1] if columns == 1 else self.of[1:rows, j + 1] for j in range(len(self._coordinates)))
        return Sum(tuple(map(PartialDerivative, parts, self._coordinates)))

    @property
    def _coordinates(self) -> tuple[Node, ...]:
        by = self.by
        return tuple(by[k + 1] for k in range(by.shape[0])) if isinstance(by, Symbol) else by.below

    def spelled(self, style: Style, spell: Callable[[Node], Piece]) -> Piece:
        piece = spell(self.of).at_least(Precedence.POWER, style)
        return Piece(f"{style.called(self.function, SIGNS[self.function])} {piece.text}", Precedence.DOT, piece.depth)


@word
class Convection(Shorthand):
    """The derivative of a column along a direction: (v . nabla) w."""

    along: Node
    of: Node
    by: Position
    has_no_polynomial_form: ClassVar[bool] = True

    @property
    def definition(self) -> Node:
        return Contract((PartialDerivative(self.of, self.by), self.along))

    def spelled(self, style: Style, spell: Callable[[Node], Piece]) -> Piece:
        along, of = (spell(part).at_least(Precedence.POWER, style) for part in (self.along, self.of))
        sign = style.brackets(style.infix("dot", along.text, style.called("grad", SIGNS["grad"])), 0)
        return Piece(f"{sign} {of.text}", Precedence.DOT, max(along.depth, of.depth) + 1)


def _position(of: Node) -> Position:
    """What a field depends on first: a column, or up to three scalars."""
    for each in fields_of((of,)):
        first = each.variables[0]
        column = isinstance(first, Symbol) and not first.is_scalar
        return first if column else Block(tuple((by,) for by in each.variables[:3]))  # type: ignore[return-value]
    raise WrongArgument(f"{of} has no field in it: say by what, as in div({of}, x)")


def _operator(name: str, meaning: str) -> Callable[..., Nabla]:
    def operator(of: Node, by: Position | None = None) -> Nabla:
        return Nabla(name, of, _position(of) if by is None else by)

    operator.__name__, operator.__doc__ = name, meaning
    return declaring(operator)


grad = _operator(
    "grad", "The gradient of a scalar, a column; of a column the matrix whose columns are its derivatives."
)
div = _operator("div", "The divergence of a column; of a matrix that of each row.")
curl = _operator("curl", "The curl of a vector.")
laplacian = _operator("laplacian", "The Laplacian of a scalar, or of each entry.")


@declaring
def convection(along: Node, of: Node, by: Position | None = None) -> Convection:
    """The derivative of a column along a direction: (v . nabla) w."""
    return Convection(along, of, _position(of) if by is None else by)
