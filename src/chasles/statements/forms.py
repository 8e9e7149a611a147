"""What a theorem may say: each form generates the equations which, once decided, prove it.

A minimum is an identity with explicit squares; "if and only if" carries the multiplier of each direction; existence is
a witness; uniqueness is a left inverse. Nothing is believed that is not one of these equations.
"""

from __future__ import annotations

from dataclasses import dataclass
from dataclasses import replace as with_fields
from typing import Protocol

from chasles.vocabulary import Contract, Dot, Negative, Node, Scale, Sum, Symbol, Zero, replace

__all__ = ["Always", "Exists", "Form", "Iff", "Minimum", "Unique"]


class Form(Protocol):
    """A kind of assertion that generates equations."""

    def equations(self) -> tuple[tuple[str, Node, Node], ...]:
        """What is to be decided: a label and two sides, for each equation."""
        ...


def _minus(left: Node, right: Node) -> Node:
    return Sum((left, Negative(right)))


def _times(matrix: Node, vector: Node) -> Node:
    return Scale(matrix, vector) if matrix.is_scalar else Contract((matrix, vector))


def _zero(like: Node) -> Node:
    return Zero(*like.shape)


@dataclass(frozen=True, slots=True)
class Always:
    """The two sides are equal."""

    left: Node
    right: Node

    def equations(self) -> tuple[tuple[str, Node, Node], ...]:
        return (("the two sides are equal", self.left, self.right),)


@dataclass(frozen=True, slots=True)
class Minimum:
    """Over all values of a symbol, `of` is least at `at`, where it takes `value`.

    Proved by of - value = sum of squares for every value of the symbol, each square vanishing at `at`.
    """

    of: Node
    value: Node
    over: Symbol
    at: Node
    squares: tuple[Node, ...]

    def equations(self) -> tuple[tuple[str, Node, Node], ...]:
        squares: list[Node] = [Dot(square, square) for square in self.squares]
        total = squares[0] if len(squares) == 1 else Sum(tuple(squares))
        excess = ("the excess over the least value is a sum of squares", _minus(self.of, self.value), total)
        there: dict[Node, Node] = {self.over: self.at}
        vanish = [("the square vanishes there", replace(s, there), _zero(s)) for s in self.squares]
        return (excess, *vanish)


@dataclass(frozen=True, slots=True)
class Iff:
    """`one` vanishes if and only if `other` does: other = forth one, and one = back other."""

    one: Node
    other: Node
    forth: Node
    back: Node

    def equations(self) -> tuple[tuple[str, Node, Node], ...]:
        return (
            ("if: the second is a multiple of the first", self.other, _times(self.forth, self.one)),
            ("only if: the first is a multiple of the second", self.one, _times(self.back, self.other)),
        )


@dataclass(frozen=True, slots=True)
class Exists:
    """There is a value of the symbol, `witness`, for which the two sides are equal."""

    symbol: Symbol
    witness: Node
    left: Node
    right: Node

    def equations(self) -> tuple[tuple[str, Node, Node], ...]:
        here: dict[Node, Node] = {self.symbol: self.witness}
        return (("the witness satisfies the equation", replace(self.left, here), replace(self.right, here)),)


@dataclass(frozen=True, slots=True)
class Unique:
    """At most one value of the symbol makes `residual` vanish: x - y = by (residual of x - residual of y)."""

    symbol: Symbol
    residual: Node
    by: Node

    def equations(self) -> tuple[tuple[str, Node, Node], ...]:
        other = with_fields(self.symbol, name=f"{self.symbol.name}_other", letter=rf"{self.symbol.letter}^*")
        there: dict[Node, Node] = {self.symbol: other}
        difference = _minus(self.residual, replace(self.residual, there))
        return (("two solutions coincide", _minus(self.symbol, other), _times(self.by, difference)),)
