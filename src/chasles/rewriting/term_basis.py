"""The terms that could be missing in an equation: all of its shape and dimension that its symbols can form.

Vectors, their products and dyads, cross-product matrices, matrices and products of two, scaled by invariants where the
dimension asks for it. The symbols are those of the statement, the rates among them those that occur; nothing is listed
for one equation or another.
"""

from __future__ import annotations

from collections.abc import Callable, Iterable, Iterator
from dataclasses import dataclass, field
from itertools import combinations, combinations_with_replacement, islice, pairwise, product

from chasles import vocabulary as w
from chasles.rewriting.coefficients import ONE
from chasles.rewriting.coefficients import product as product_of
from chasles.rewriting.product import chained
from chasles.vocabulary import Node
from chasles.vocabulary.fitting import measured
from chasles.vocabulary.measure import Measure, added
from chasles.vocabulary.shorthand import Shorthand

MOST_TERMS = 100
"""So many terms of one kind are tried, the simpler first."""
LONGEST = 5
"""So many factors has a product of which each factor is printed beside the next one somewhere."""
MOST_CHAINS = 400
"""So many such products of one length are looked at."""
VECTOR, SQUARE, SCALAR = (3, 1), (3, 3), (1, 1)
Shape = tuple[int, int]


def fit(one: Node, other: Node) -> bool:
    """Whether two expressions can be set equal, or added: one shape, one dimension in each entry."""
    if one.measure is None or other.measure is None:
        return False
    try:
        added(one.measure, other.measure, ("", ""))
    except w.Misfit:
        return False
    return True


def dimension_of(node: Node) -> w.Dimension | None:
    """The one dimension of all entries; None if they have several, or are all zero."""
    try:
        return measured(node).the_dimension(node)
    except w.Misfit:
        return None


@dataclass(slots=True)
class TermBasis:
    """What terms are made of: vectors, scalars, 3 x 3 matrices and other arrays, in the order in which they occur.

    What is `beside` a factor follows it in some product.
    """

    vectors: dict[Node, None] = field(default_factory=dict)
    scalars: dict[Node, None] = field(default_factory=dict)
    squares: dict[Node, None] = field(default_factory=dict)
    arrays: dict[Node, None] = field(default_factory=dict)
    beside: dict[Node, dict[Node, None]] = field(default_factory=dict)
    without: frozenset[Node] = frozenset()
    _weights: dict[w.Dimension, list[Node]] = field(default_factory=dict)
    _shaped: dict[Shape, list[tuple[Node, w.Dimension | None]]] = field(default_factory=dict)
    _terms: dict[Measure | None, tuple[Node, ...]] = field(default_factory=dict)

    @property
    def nodes(self) -> tuple[Node, ...]:
        """All of them: vectors, matrices, scalars, other arrays."""
        return (*self.vectors, *self.squares, *self.scalars, *self.arrays)

    def terms(self, like: Node) -> tuple[Node, ...]:
        """The terms that can be added to an expression, the simpler first; some are multiples or sums of others."""
        if like.measure not in self._terms:
            dimension, products = dimension_of(like), self._products(like.shape)
            fitting = (node for node in products if fit(node, like))
            found = fitting if dimension is None else self.of_dimension(like.shape, dimension)
            self._terms[like.measure] = tuple(node for node in islice(found, MOST_TERMS) if node not in self.without)
        return self._terms[like.measure]

    def of_dimension(self, shape: Shape, dimension: w.Dimension) -> Iterator[Node]:
        """The terms of a shape, a dimension common to all their entries."""
        if shape not in self._shaped:
            self._shaped[shape] = [(node, dimension_of(node)) for node in self._tensors(shape)]
        weighted = [(node, self._weights_of(dimension / own)) for node, own in self._shaped[shape] if own is not None]
        for rank in range(max((len(weights) for _, weights in weighted), default=0)):
            for tensor, weights in weighted:
                if rank < len(weights):
                    yield product_of(weights[rank], tensor)

    def _weights_of(self, dimension: w.Dimension) -> list[Node]:
        """Invariants of a dimension."""
        if not self._weights:
            self._weights[w.NO_DIMENSION] = [ONE]
            for weight in self._invariants():
                self._weights.setdefault(measured(weight).grid[0][0] or w.NO_DIMENSION, []).append(weight)
        return self._weights.get(dimension, [])

    def _invariants(self) -> Iterator[Node]:
        scalars = [node for node in self.scalars if dimension_of(node) != w.NO_DIMENSION]
        yield from scalars
        for one, other in combinations_with_replacement(self.vectors, 2):
            yield from _fitting(w.Dot, one, other)
        for one, other in combinations_with_replacement(scalars, 2):
            both = w.Power(one, 2) if one == other else w.Scale(one, other)
            if dimension_of(both) != w.NO_DIMENSION:
                yield both

    def _tensors(self, shape: Shape) -> Iterator[Node]:
        match shape:
            case (3, 1):
                yield from self._columns()
            case (1, 3):
                yield from (w.Transpose(column) for column in self._columns())
            case (3, 3):
                yield from self._matrices()
            case (1, 1):
                yield ONE
                yield from self._chains(shape)
                for one, square, other in product(self.vectors, self.squares, self.vectors):
                    yield from _fitting(_contracted, w.Transpose(one), w.Contract((square, other)))
            case _:
                yield from self._products(shape)

    def _columns(self) -> Iterator[Node]:
        yield from self.vectors
        yield from self._crosses()
        for square, vector in product((*self.squares, *map(w.Transpose, self.squares)), self.vectors):
            yield from _fitting(_contracted, square, vector)
        for one, cross in product(self.vectors, list(self._crosses())):
            yield from _fitting(w.Cross, one, cross)

    def _crosses(self) -> Iterator[Node]:
        for one, other in combinations(self.vectors, 2):
            yield from _fitting(w.Cross, one, other)

    def _matrices(self) -> Iterator[Node]:
        yield w.Identity(3)
        yield from self.squares
        vectors, crosses = list(self.vectors), list(self._crosses())
        yield from (w.Skew(vector) for vector in vectors)
        for one, other in (*product(vectors, vectors), *product(crosses, vectors), *product(vectors, crosses)):
            yield from _fitting(_contracted, one, w.Transpose(other))
        flipped = [w.Transpose(square) for square in self.squares]
        yield from flipped
        for one, other in (*product(self.squares, self.squares), *product(flipped, self.squares)):
            yield from _fitting(_contracted, one, other)

    def _products(self, shape: Shape) -> Iterator[Node]:
        """Arrays of a shape, and products of two and of three."""
        everything = [*self.arrays, *self.squares, *self.vectors]
        yield from (node for node in everything if node.shape == shape)
        yield from self._chains(shape)
        pairs = [made for one, other in product(everything, everything) for made in _fitting(_contracted, one, other)]
        yield from (node for node in pairs if node.shape == shape)
        flipped = [w.Transpose(node) for node in everything if isinstance(node, w.Symbol) and node.shape != VECTOR]
        yield from (node for node in flipped if node.shape == shape)
        transposed = *product(flipped, everything), *product(everything, flipped)
        for one, other in (*transposed, *product(self.arrays, pairs)):
            if (one.shape[0], other.shape[1]) == shape:
                yield from _fitting(_contracted, one, other)

    def _chains(self, shape: Shape) -> Iterator[Node]:
        """Products of a shape in which each factor stands beside one that it is printed beside, the shorter first."""
        chains: list[tuple[Node, ...]] = [(node,) for node in self.beside]
        for _ in range(1, LONGEST):
            chains = [(*chain, node) for chain in chains for node in self.beside.get(chain[-1], ())][:MOST_CHAINS]
            for chain in chains:
                if (chain[0].shape[0], chain[-1].shape[1]) == shape:
                    yield from _fitting(_contracted, chain[0], w.Contract(chain[1:]) if len(chain) > 2 else chain[1])


def term_basis(nodes: Iterable[Node], without: frozenset[Node] = frozenset(), order: int = 0) -> TermBasis:
    """What the expressions are written with: their symbols, the rates and sums that occur as factors; not `without`.

    With an `order`, the rates of all symbols up to that one too.
    """
    basis = TermBasis(without=without)
    for node in nodes:
        _collect(basis, node, without, factor=False)
    for node in basis.nodes:
        rate = node
        for _ in range(order if isinstance(node, w.Rate) or (isinstance(node, w.Symbol) and not node.constant) else 0):
            rate = w.Rate(rate)
            if rate not in without:
                _enter(basis, rate)
    for square in list(basis.squares):
        if isinstance(square, w.Symbol) and isinstance(square.stands_for, w.Skew):
            vector = square.stands_for.of
            basis.vectors.setdefault(vector)
            if w.Rate(vector) in basis.vectors:
                basis.squares.setdefault(w.Rate(square))
    return basis


def _collect(basis: TermBasis, node: Node, without: frozenset[Node], *, factor: bool) -> None:
    match node:
        case w.Rate(w.At(of)):
            node = w.Rate(of)
        case w.At(of):
            node = of
    if node.measure is None:
        return
    match node:
        case w.Symbol() | w.Rate(w.Symbol()) | w.Rate(w.Rate(w.Symbol())):
            if node not in without:
                _enter(basis, node)
            if isinstance(node, w.Rate):
                _collect(basis, node.of, without, factor=factor)
            return
        case Shorthand() if not node.is_scalar and not any(part in without for part in w.walk(node)):
            _enter(basis, node)
        case w.Norm(of) if of.shape == VECTOR:
            basis.scalars.setdefault(w.Power(node, 2))
        case w.Quotient(_, denominator) if dimension_of(denominator) != w.NO_DIMENSION:
            basis.scalars.setdefault(w.Quotient(ONE, denominator))
        case w.Sum() if factor and not node.is_scalar and not any(part in without for part in w.walk(node)):
            _enter(basis, node)
        case w.Inverse() | w.Transpose(w.Symbol()) if _is_array(node) and without.isdisjoint(w.walk(node)):
            _enter(basis, node)
        case w.Contract(factors):
            for one, other in pairwise(factors):
                if not any(part in without for factor in (one, other) for part in w.walk(factor)):
                    basis.beside.setdefault(one, {})[other] = None
    grouped = isinstance(node, w.Group | w.Sum | w.Negative | w.Block)
    for part in w.children(node):
        _collect(basis, part, without, factor=factor if grouped else True)


def _enter(basis: TermBasis, node: Node) -> None:
    kinds = {VECTOR: basis.vectors, SQUARE: basis.squares, SCALAR: basis.scalars}
    kinds.get(node.shape, basis.arrays).setdefault(node)


def _is_array(node: Node) -> bool:
    """Whether its shape is not that of the vectors of space, of what acts on them, or of numbers."""
    return not {node.shape, node.shape[::-1]} & {VECTOR, SQUARE, SCALAR} or isinstance(node, w.Inverse)


def _contracted(left: Node, right: Node) -> Node:
    return chained((left, right))


def _fitting(make: Callable[[Node, Node], Node], left: Node, right: Node) -> Iterator[Node]:
    try:
        yield make(left, right)
    except w.Misfit:
        return
