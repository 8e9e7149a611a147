"""What a theorem may say: each form generates the equations which, once decided, prove it.

A minimum is an identity with explicit squares; "if and only if" carries the multiplier of each direction; existence is
a witness; uniqueness is a left inverse. Nothing is believed that is not one of these equations.
"""

from __future__ import annotations

from dataclasses import dataclass
from dataclasses import replace as with_fields
from typing import Protocol

from chasles import vocabulary as w
from chasles.statements.lengths import squared
from chasles.vocabulary import Node
from chasles.vocabulary.arguments import Declared


class Form(Protocol):
    """A kind of assertion that generates equations."""

    def equations(self) -> tuple[tuple[str, Node, Node], ...]:
        """What is to be decided: a label and two sides, for each equation."""
        ...


def _minus(left: Node, right: Node) -> Node:
    return w.Sum((left, w.Negative(right)))


def _times(matrix: Node, vector: Node) -> Node:
    return w.Scale(matrix, vector) if matrix.is_scalar else w.Contract((matrix, vector))


def total(terms: tuple[Node, ...]) -> Node:
    """The sum of the terms; the term itself where there is one."""
    return terms[0] if len(terms) == 1 else w.Sum(terms)


@dataclass(frozen=True, slots=True)
class Always(Declared):
    """The two sides are equal."""

    left: Node
    right: Node

    def equations(self) -> tuple[tuple[str, Node, Node], ...]:
        return (("the two sides are equal", self.left, self.right),)


@dataclass(frozen=True, slots=True)
class Minimum(Declared):
    """Over all values of a symbol, `of` is least at `at`, where it takes `value`.

    Proved by of - value = sum of squares for every value of the symbol, each square vanishing at `at`.
    """

    of: Node
    value: Node
    over: w.Symbol
    at: Node
    squares: tuple[Node, ...]

    def __post_init__(self) -> None:
        if not self.squares:
            raise TypeError("a minimum needs the squares that make up the excess: with none, state it with Always")

    def equations(self) -> tuple[tuple[str, Node, Node], ...]:
        squares = total(tuple(w.Dot(square, square) for square in self.squares))
        excess = ("the excess over the least value is a sum of squares", _minus(self.of, self.value), squares)
        there: dict[Node, Node] = {self.over: self.at}
        return (excess, *(("the square vanishes there", w.replace(s, there), w.Zero(*s.shape)) for s in self.squares))


@dataclass(frozen=True, slots=True)
class Definite(Declared):
    """`of` is never negative: it is a sum of squares. With `by`, it vanishes only where all symbols `over` do.

    Proved by of = sum of squares, which are seen to be squares by their spelling, and by column(over) = by @ what is
    squared. Where an integral of squares vanishes, the square does in every element of the body.
    """

    of: Node
    squares: tuple[Node, ...]
    over: tuple[Node, ...] = ()
    by: Node | None = None

    def equations(self) -> tuple[tuple[str, Node, Node], ...]:
        is_sum = ("it is a sum of squares", self.of, total(self.squares))
        if self.by is None:
            return (is_sum,)
        vanishing = w.column(*(vector for square in self.squares for vector in squared(square)))
        return (is_sum, ("it vanishes only where they do", w.column(*self.over), _times(self.by, vanishing)))


@dataclass(frozen=True, slots=True)
class OnlyWhere(Declared):
    """The two sides can be equal only where all squares vanish: tr(by^T (left - right) by) = -(sum of squares).

    Whatever is free in the sides is so in the squares: no value of it makes the sides equal elsewhere.
    """

    left: Node
    right: Node
    by: Node
    squares: tuple[Node, ...]

    def equations(self) -> tuple[tuple[str, Node, Node], ...]:
        probed = w.Trace(w.Contract((w.Transpose(self.by), _minus(self.left, self.right), self.by)))
        return (("their difference is less than zero by squares", probed, w.Negative(total(self.squares))),)


@dataclass(frozen=True, slots=True)
class Iff(Declared):
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
class Exists(Declared):
    """There is a value of the symbol, `witness`, for which the two sides are equal."""

    symbol: w.Symbol
    witness: Node
    left: Node
    right: Node

    def equations(self) -> tuple[tuple[str, Node, Node], ...]:
        here: dict[Node, Node] = {self.symbol: self.witness}
        return (("the witness satisfies the equation", w.replace(self.left, here), w.replace(self.right, here)),)


@dataclass(frozen=True, slots=True)
class Unique(Declared):
    """At most one value of the symbol makes `residual` vanish: x - y = by (residual of x - residual of y)."""

    symbol: w.Symbol
    residual: Node
    by: Node

    def equations(self) -> tuple[tuple[str, Node, Node], ...]:
        other = with_fields(self.symbol, name=f"{self.symbol.name}_other", letter=rf"{self.symbol.letter}^*")
        there: dict[Node, Node] = {self.symbol: other}
        difference = _minus(self.residual, w.replace(self.residual, there))
        return (("two solutions coincide", _minus(self.symbol, other), _times(self.by, difference)),)
