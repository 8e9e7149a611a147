"""What goes into one entry of an expression: symbols and their rates, with the entry of theirs that counts."""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from itertools import accumulate

from chasles import vocabulary as w

Place = tuple[int, int]
EntryPart = tuple[w.Symbol, int, Place | None]
"""A symbol, which rate of it, and the entry that counts, row and column from zero; None where several count."""


def parts_of_entry(node: w.Node, place: Place, order: int = 0) -> Iterator[EntryPart]:
    """What the entry of the expression's rate of that order is made of; some of it may cancel."""
    row, column = place
    match node:
        case w.Symbol(stands_for=w.Node() as of) | w.At(of) | w.Group(of):
            yield from parts_of_entry(of, place, order)
        case w.Symbol():
            yield node, order, place
        case w.Number() | w.Identity() | w.Zero():
            return
        case w.Rate(of):
            yield from parts_of_entry(of, place, order + 1)
        case w.Sum(terms):
            for term in terms:
                yield from parts_of_entry(term, place, order)
        case w.Negative(term):
            yield from parts_of_entry(term, place, order)
        case w.Transpose(of):
            yield from parts_of_entry(of, (column, row), order)
        case w.Skew(of):
            if row != column:
                yield from parts_of_entry(of, (3 - row - column, 0), order)
        case w.Block(rows):
            yield from _of_block(rows, place, order)
        case w.Scale(factor, term) | w.Quotient(term, factor):
            for k in range(order + 1):
                yield from parts_of_entry(factor, (0, 0), k)
                yield from parts_of_entry(term, place, k)
        case _:
            yield from ((symbol, k, None) for symbol in w.symbols_of(node) for k in range(order + 1))


def _of_block(rows: Sequence[Sequence[w.Node]], place: Place, order: int) -> Iterator[EntryPart]:
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
