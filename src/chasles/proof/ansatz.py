"""Which terms could be missing? All of a given shape and physical dimension that the symbols at hand make up.

Vectors, their products and dyads, cross-product matrices, matrices and products of two, scaled by invariants where the
dimension asks for it. The symbols are those of the statement, the rates among them those that occur; nothing is listed
for one equation or another.
"""

from __future__ import annotations

from collections.abc import Callable, Iterable, Iterator
from dataclasses import dataclass, field
from itertools import product

from chasles.proof.coefficients import ONE
from chasles.vocabulary import (
    NO_DIMENSION,
    Block,
    Contract,
    Cross,
    Dimension,
    Dot,
    Group,
    Identity,
    Misfit,
    Negative,
    Node,
    Norm,
    Power,
    Quotient,
    Rate,
    Scale,
    Skew,
    Sum,
    Symbol,
    Transpose,
    children,
    walk,
)
from chasles.vocabulary.nodes import measured

__all__ = ["Palette", "dimension_of", "palette_of"]

VECTOR = (3, 1)


@dataclass(slots=True)
class Palette:
    """The vectors, scalars and 3 x 3 matrices that terms are made of, those that occur first among the first."""

    vectors: dict[Node, None] = field(default_factory=dict)
    scalars: dict[Node, None] = field(default_factory=dict)
    squares: dict[Node, None] = field(default_factory=dict)
    _weights: dict[Dimension, list[Node]] = field(default_factory=dict)
    _shaped: dict[tuple[int, int], list[tuple[Node, Dimension | None]]] = field(default_factory=dict)
    _terms: dict[tuple[tuple[int, int], Dimension], tuple[Node, ...]] = field(default_factory=dict)

    @property
    def nodes(self) -> tuple[Node, ...]:
        return (*self.vectors, *self.squares, *self.scalars)

    def terms(self, shape: tuple[int, int], dimension: Dimension) -> tuple[Node, ...]:
        """The terms of that shape and dimension, the simpler first; some are multiples or sums of others."""
        if (shape, dimension) not in self._terms:
            self._terms[shape, dimension] = tuple(self._weighted(shape, dimension))
        return self._terms[shape, dimension]

    def _weighted(self, shape: tuple[int, int], dimension: Dimension) -> Iterator[Node]:
        if shape not in self._shaped:
            self._shaped[shape] = [(node, dimension_of(node)) for node in self._tensors(shape)]
        for tensor, own in self._shaped[shape]:
            for weight in [] if own is None else self._weights_of(dimension / own):
                yield tensor if weight == ONE else Scale(weight, tensor)

    def _weights_of(self, dimension: Dimension) -> list[Node]:
        """Invariants of a dimension; of no dimension, the number one alone: other factors are coefficients."""
        if not self._weights:
            self._weights[NO_DIMENSION] = [ONE]
            for weight in self._invariants():
                own = dimension_of(weight)
                if own is not None and own != NO_DIMENSION:
                    known = self._weights.setdefault(own, [])
                    if weight not in known:
                        known.append(weight)
        return self._weights.get(dimension, [])

    def _invariants(self) -> Iterator[Node]:
        yield from self.scalars
        vectors = list(self.vectors)
        for k, one in enumerate(vectors):
            for other in vectors[k + 1 :]:
                yield from _fitting(Dot, one, other)
            if dimension_of(one) != NO_DIMENSION:
                yield Dot(one, one)

    def _tensors(self, shape: tuple[int, int]) -> Iterator[Node]:
        match shape:
            case (3, 1):
                yield from self._columns()
            case (1, 3):
                yield from (Transpose(column) for column in self._columns())
            case (3, 3):
                yield from self._matrices()
            case (1, 1):
                yield ONE

    def _columns(self) -> Iterator[Node]:
        yield from self.vectors
        yield from self._crosses()
        for square, vector in product(self.squares, self.vectors):
            yield from _fitting(_contracted, square, vector)
        for one, cross in product(self.vectors, list(self._crosses())):
            yield from _fitting(Cross, one, cross)

    def _crosses(self) -> Iterator[Node]:
        vectors = list(self.vectors)
        for k, one in enumerate(vectors):
            for other in vectors[k + 1 :]:
                yield from _fitting(Cross, one, other)

    def _matrices(self) -> Iterator[Node]:
        yield Identity(3)
        yield from self.squares
        vectors, crosses = list(self.vectors), list(self._crosses())
        yield from (Skew(vector) for vector in vectors)
        for one, other in (*product(vectors, vectors), *product(crosses, vectors), *product(vectors, crosses)):
            yield from _fitting(_contracted, one, Transpose(other))
        for square in self.squares:
            yield Transpose(square)
        for one, other in product(self.squares, self.squares):
            yield from _fitting(_contracted, one, other)


def palette_of(nodes: Iterable[Node], without: frozenset[Node] = frozenset()) -> Palette:
    """What the expressions are written with: their symbols, the rates and sums that occur as factors; not `without`."""
    palette = Palette()
    for node in nodes:
        _collect(palette, node, without, factor=False)
    for square in list(palette.squares):
        if isinstance(square, Symbol) and isinstance(square.stands_for, Skew):
            vector = square.stands_for.of
            palette.vectors.setdefault(vector)
            if Rate(vector) in palette.vectors:
                palette.squares.setdefault(Rate(square))
    return palette


def _collect(palette: Palette, node: Node, without: frozenset[Node], *, factor: bool) -> None:
    match node:
        case _ if node in without or node.measure is None:
            return
        case Symbol() | Rate(Symbol()) | Rate(Rate(Symbol())):
            _enter(palette, node)
            if isinstance(node, Rate):
                _collect(palette, node.of, without, factor=factor)
            return
        case Norm(of) if of.shape == VECTOR:
            palette.scalars.setdefault(Power(node, 2))
        case Quotient(_, denominator) if dimension_of(denominator) != NO_DIMENSION:
            palette.scalars.setdefault(Quotient(ONE, denominator))
        case Sum() if factor and not any(part in without for part in walk(node)):
            _enter(palette, node)
        case _:
            pass
    grouped = isinstance(node, Group | Sum | Negative | Block)
    for part in children(node):
        _collect(palette, part, without, factor=factor if grouped else True)


def _enter(palette: Palette, node: Node) -> None:
    match node.shape:
        case (3, 1):
            palette.vectors.setdefault(node)
        case (3, 3):
            palette.squares.setdefault(node)
        case (1, 1) if dimension_of(node) != NO_DIMENSION:
            palette.scalars.setdefault(node)


def dimension_of(node: Node) -> Dimension | None:
    """The one dimension of all entries; None if they have several, or are all zero."""
    try:
        return measured(node).the_dimension(node)
    except Misfit:
        return None


def _contracted(left: Node, right: Node) -> Node:
    return Contract((left, right))


def _fitting(make: Callable[[Node, Node], Node], left: Node, right: Node) -> Iterator[Node]:
    try:
        yield make(left, right)
    except Misfit:
        return
