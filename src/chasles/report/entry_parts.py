"""What goes into one entry of an expression: symbols and their rates, with the entry of theirs that counts."""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from itertools import accumulate

from chasles.vocabulary import (
    At,
    Block,
    Group,
    Identity,
    Negative,
    Node,
    Number,
    Quotient,
    Rate,
    Scale,
    Skew,
    Sum,
    Symbol,
    Transpose,
    Zero,
    symbols_of,
)

Place = tuple[int, int]
EntryPart = tuple[Symbol, int, Place | None]
"""A symbol, which rate of it, and the entry that counts, row and column from zero; None where several count."""


def parts_of_entry(node: Node, place: Place, order: int = 0) -> Iterator[EntryPart]:
    """What the entry of the expression's rate of that order is made of; some of it may cancel."""
    row, column = place
    match node:
        case Symbol(stands_for=Node() as of) | At(of) | Group(of):
            yield from parts_of_entry(of, place, order)
        case Symbol():
            yield node, order, place
        case Number() | Identity() | Zero():
            return
        case Rate(of):
            yield from parts_of_entry(of, place, order + 1)
        case Sum(terms):
            for term in terms:
                yield from parts_of_entry(term, place, order)
        case Negative(term):
            yield from parts_of_entry(term, place, order)
        case Transpose(of):
            yield from parts_of_entry(of, (column, row), order)
        case Skew(of):
            if row != column:
                yield from parts_of_entry(of, (3 - row - column, 0), order)
        case Block(rows):
            yield from _of_block(rows, place, order)
        case Scale(factor, term) | Quotient(term, factor):
            for k in range(order + 1):
                yield from parts_of_entry(factor, (0, 0), k)
                yield from parts_of_entry(term, place, k)
        case _:
            yield from ((symbol, k, None) for symbol in symbols_of(node) for k in range(order + 1))


def _of_block(rows: Sequence[Sequence[Node]], place: Place, order: int) -> Iterator[EntryPart]:
    """The block in which the entry is, and where in it."""
    heights, widths = [line[0].shape[0] for line in rows], [block.shape[1] for block in rows[0]]
    (i, row), (j, column) = _within(heights, place[0]), _within(widths, place[1])
    yield from parts_of_entry(rows[i][j], (row, column), order)


def _within(sizes: Sequence[int], index: int) -> tuple[int, int]:
    """Into which of the parts of these sizes an index falls, and where in it."""
    for part, (size, end) in enumerate(zip(sizes, accumulate(sizes), strict=True)):
        if index < end:
            return part, index - end + size
    raise IndexError(f"there is no entry {index + 1} among {sum(sizes)}")
