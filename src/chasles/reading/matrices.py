"""Matrices of blocks: zeros and identities take the heights of their rows and the widths of their columns."""

from __future__ import annotations

from collections.abc import Callable, Sequence
from dataclasses import replace
from itertools import islice, product

from chasles.reading.atoms import Atom, Atoms, Terms, single
from chasles.reading.context import FittingContext
from chasles.reading.fits import MOST, UNUSUAL, Fit, Shape
from chasles.reading.glyphs import latex_of
from chasles.vocabulary import Block, Determinant, Symbol, symbols_of
from chasles.vocabulary.measure import Extent
from chasles.vocabulary.pieces import Precedence

MOST_SIZES = 1000
MATRICES = ("bmatrix", "pmatrix", "Bmatrix", "matrix", "array", "smallmatrix", "bsmallmatrix", "psmallmatrix")


def grid_fits(grid: Atom, ctx: FittingContext, read: Callable[[Atoms, FittingContext], list[Fit]]) -> list[Fit]:
    """The readings of an environment with rows and columns."""
    name = grid.text.rstrip("*")
    if name not in (*MATRICES, "vmatrix"):
        ctx.note(f"the environment {grid.text} stands inside a formula", grid.place)
        return []
    rows, width = grid.rows, max(map(len, grid.rows), default=0)
    if len(rows) == width > 1 and all(row[at:] and row[at] for at, row in enumerate(rows)):  # what is left out is zero
        zero = (single(grid.place._replace(text="0")),)
        rows = tuple(tuple(cell or zero for cell in (*row, *[()] * (width - len(row)))) for row in rows)
    if not rows or not all(len(row) == width for row in rows):
        ctx.note("the rows of the matrix differ in length", grid.place)
        return []
    if not all(map(all, rows)):  # zeros, or places of a block beside them
        return ctx.of_its_own(latex_of(grid.bare))
    fits = block_fits([[read(cell, ctx) for cell in row] for row in rows], ctx)
    if name != "vmatrix":
        return fits
    return [new for fit in fits for new in ctx.made(Determinant, fit.node, cost=fit.cost)]


def block_fits(cells: list[list[list[Fit]]], ctx: FittingContext) -> list[Fit]:
    """The matrices that can be made of one reading for each cell."""
    if not all(all(row) for row in cells):
        return []
    found = []
    heights, widths = (
        [_extents(row, 0, ctx) for row in cells],
        [_extents(column, 1, ctx) for column in zip(*cells, strict=True)],
    )
    for sizes in islice(product(*heights, *widths), MOST_SIZES):
        high, wide = sizes[: len(cells)], sizes[len(cells) :]
        found += _of_sizes(cells, high, [wide] * len(cells), ctx)
        if ctx.level and len(cells) == 2 == len(set(wide)):  # blocks that do not stand below each other
            found += [
                replace(fit, cost=fit.cost + UNUSUAL)
                for turned in ([wide, wide[::-1]], [wide[::-1], wide])
                for fit in _of_sizes(cells, high, turned, ctx)
            ]
    if not found and ctx.tolerant:
        firsts = [_first(cell) for row in cells for cell in row]
        if all(fit.node is not None for fit in firsts):
            found = _block(tuple(firsts), len(cells[0]), ctx)
    return found


def _of_sizes(
    cells: list[list[list[Fit]]], high: Sequence[Extent], wide: Sequence[Sequence[Extent]], ctx: FittingContext
) -> list[Fit]:
    """The matrices with rows of these heights, and in each row blocks of these widths."""
    at = [[_at(cell, (high[i], wide[i][j])) for j, cell in enumerate(row)] for i, row in enumerate(cells)]
    if not all(all(row) for row in at):
        return []
    chosen = _consistent([cell for row in at for cell in row])
    return [fit for each in chosen for fit in _block(each, len(cells[0]), ctx)]


def _consistent(cells: list[list[Fit]]) -> list[tuple[Fit, ...]]:
    """One reading for each cell, so that no letter stands for two quantities."""
    found: list[tuple[tuple[Fit, ...], dict[str, Symbol]]] = [((), {})]
    for cell in cells:
        longer = []
        for chosen, letters in found:
            for fit in cell:
                own = {symbol.letter: symbol for symbol in symbols_of(fit.node)} if fit.node is not None else {}
                if all(letters.get(letter, symbol) == symbol for letter, symbol in own.items()):
                    longer.append(((*chosen, fit), {**letters, **own}))
        found = longer[:MOST]
    return [chosen for chosen, _ in found]


def _first(cell: list[Fit]) -> Fit:
    """The most usual reading of an entry that has a size, or the entry as a scalar."""
    known = next((fit for fit in cell if fit.node is not None), None)
    return known or cell[0].at((1, 1)) or cell[0]


def row_of_blocks(terms: Terms, ctx: FittingContext) -> list[Fit]:
    """Two blocks side by side without a mark between them, as in [A b]: wherever the terms can be cut."""
    found = []
    for k, (sign, row) in enumerate(zip(terms.signs, terms.rows, strict=True)):
        cuts = range(1 if sign != "-" or not k else 0, len(row))
        for cut in cuts if k or len(row) > 1 else ():
            before = (*terms.rows[:k], *((row[:cut],) if cut else ()))
            left = Terms(terms.signs[: len(before)], before)
            right = Terms(("" if cut else sign, *terms.signs[k + 1 :]), (row[cut:], *terms.rows[k + 1 :]))
            found += block_fits([[ctx.terms(left), ctx.terms(right)]], ctx)
    return [fit for fit in found if fit.shape and fit.shape[0] != 1]


def _at(cell: list[Fit], shape: Shape) -> list[Fit]:
    return [fit for each in cell if (fit := each.at(shape)) is not None]


def _extents(cells: list[list[Fit]] | tuple[list[Fit], ...], side: int, ctx: FittingContext) -> list[Extent]:
    """The heights of a row, or widths of a column, that its cells can have; where none says it, the usual ones."""
    known = [dict.fromkeys(fit.shape[side] for fit in cell if fit.shape) for cell in cells
             if all(fit.sized is None for fit in cell)]  # fmt: skip
    if known:
        return [extent for extent in known[0] if all(extent in each for each in known)]
    literal = dict.fromkeys(fit.shape[side] for cell in cells for fit in cell if fit.shape)
    if literal and not ctx.level:
        return list(literal)
    return list(dict.fromkeys((*literal, 1, *sorted(ctx.notation.sizes))))


def _block(chosen: tuple[Fit, ...], width: int, ctx: FittingContext) -> list[Fit]:
    parts = tuple(ctx.inside(fit, Precedence.SUM) for fit in chosen)
    rows = tuple(parts[k : k + width] for k in range(0, len(parts), width))
    return ctx.made(Block, rows, cost=sum(fit.cost for fit in chosen))
