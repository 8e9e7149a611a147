"""Products of two factors side by side: of numbers, matrices and vectors, and what columns of vectors mean in them."""

from __future__ import annotations

from collections.abc import Iterator

from chasles.reading.context import FittingContext
from chasles.reading.fits import Fit, made
from chasles.reading.spellings import multiplied
from chasles.vocabulary import Block, Misfit, Node, Scale, Sum
from chasles.vocabulary.parts import part
from chasles.vocabulary.pieces import Precedence


def times(left: Fit, right: Fit, ctx: FittingContext) -> Iterator[Fit]:
    """The product of two factors, if it fits; an identity takes its size from what it multiplies."""
    if left.node is None or right.node is None:
        yield from _times_sized(left, right, ctx)
        return
    parts = ctx.inside(left, Precedence.PRODUCT), ctx.inside(right, Precedence.PRODUCT)
    for make in (multiplied, *ctx.notation.spellings.infixes.get("", ()), _mixed):
        if (node := made(make, *parts)) is not None:
            yield Fit(node, left.cost + right.cost)


def _mixed(a: Node, column: Node) -> Node:
    """A matrix times a column of vectors: what the columns of numbers would be, with vectors for the numbers."""
    if not isinstance(column, Block) or not _stacks_vectors(column) or a.is_scalar or a.shape[1] != len(column.rows):
        raise Misfit("no column of vectors")
    rows, columns = a.shape
    entries = a.rows if isinstance(a, Block) and len(a.rows) == rows else None
    sums = []
    for i in range(rows):
        row = [entries[i][j] if entries else part(a, (i + 1, j + 1)) for j in range(columns)]
        terms = [Scale(factor, vector) for factor, (vector,) in zip(row, column.rows, strict=True)]
        sums.append((Sum(tuple(terms)),))
    return Block(tuple(sums))


def _times_sized(left: Fit, right: Fit, ctx: FittingContext) -> Iterator[Fit]:
    known, open_one = (left, right) if left.node is not None else (right, left)
    if known.node is None or known.shape == (1, 1):
        yield ctx.of_open_size(multiplied, Precedence.PRODUCT, left, right)
    elif known.shape is not None:
        side = known.shape[1] if known is left else known.shape[0]
        for shape in ((side, side), (side, 1) if known is left else (1, side), (1, 1)):
            if (other := open_one.at(shape)) is not None:
                yield from times(known, other, ctx) if known is left else times(other, known, ctx)


def _stacks_vectors(column: Block) -> bool:
    shapes = {row[0].shape for row in column.rows}
    return all(len(row) == 1 for row in column.rows) and len(shapes) == 1 and shapes != {(1, 1)}
