"""Does it fit? Shape and physical dimension of each entry, and the rules by which operations combine them.

A matrix has a dimension in each entry, because arrays of screw theory mix them: the upper half of a twist is an
angular velocity, its lower half a velocity. An entry that is zero by construction fits every dimension (`None`).
"""

from __future__ import annotations

from collections.abc import Callable, Sequence
from dataclasses import dataclass
from functools import lru_cache, reduce
from itertools import product
from typing import Any

from chasles.vocabulary.dimension import NO_DIMENSION, Dimension

Grid = tuple[tuple[Dimension | None, ...], ...]
Extent = Any
"""How many rows or columns there are: a whole number, or a `Size` of `chasles.vocabulary.sizes`, a letter for one."""


class Misfit(ValueError):
    """Two parts of an expression that cannot stand together: their shapes or their dimensions differ."""


@dataclass(frozen=True, slots=True)
class Measure:
    """The dimension of every entry; the shape is that of the grid, a scalar is 1 x 1.

    Where a letter says how many rows or columns there are, a place of the grid is a block, and the `partition` has the
    heights and the widths of the blocks.
    """

    grid: Grid
    partition: Any = None

    @property
    def shape(self) -> tuple[Extent, Extent]:
        """The numbers of rows and columns."""
        return (len(self.grid), len(self.grid[0])) if self.partition is None else self.partition.shape

    @property
    def transposed(self) -> Measure:
        """The measure of the transpose."""
        return Measure(tuple(zip(*self.grid, strict=True)), self.partition and self.partition.transposed)

    def the_dimension(self, what: object) -> Dimension | None:
        """The one dimension that all entries share; a `Misfit` naming `what` if they differ."""
        found = {d for row in self.grid for d in row if d is not None}
        if len(found) > 1:
            raise Misfit(f"{what} has entries of different dimensions: {', '.join(sorted(map(str, found)))}")
        return found.pop() if found else None


def uniform(shape: tuple[Extent, Extent], dimension: Dimension | None = NO_DIMENSION) -> Measure:
    """Every entry has the same dimension."""
    rows, columns = shape
    if type(rows) is type(columns) is int:
        return Measure(((dimension,) * columns,) * rows)
    from chasles.vocabulary.sizes import uniform_blocks  # few chapters have such letters

    return uniform_blocks(rows, columns, dimension)


def entrywise(rule: Callable[[Dimension], Dimension | None], measure: Measure) -> Measure:
    """Each entry's dimension is what the rule makes of it; zeros stay zeros."""
    return Measure(tuple(tuple(None if d is None else rule(d) for d in row) for row in measure.grid), measure.partition)


def scaled(measure: Measure, factor: Dimension | None) -> Measure:
    """Every entry is multiplied by a scalar of the given dimension."""
    if factor is None:
        return uniform(measure.shape, None)
    if factor == NO_DIMENSION:
        return measure
    return entrywise(lambda d: d * factor, measure)


def _joined(one: Dimension | None, other: Dimension | None) -> Dimension | None:
    if one is not None and other is not None and one != other:
        raise _Clash(one, other)
    return other if one is None else one


class _Clash(Exception):
    def __init__(self, one: Dimension, other: Dimension) -> None:
        self.one, self.other = one, other


def added(first: Measure, second: Measure, names: tuple[object, object], verb: str = "add") -> Measure:
    """The common measure of two terms of a sum, or of the two sides of an equation.

    Here and below, `names` are spelled only if there is a `Misfit` to report.
    """
    if first.shape != second.shape:
        raise Misfit(f"cannot {verb} {names[0]} ({_size(first)}) and {names[1]} ({_size(second)})")
    if first.grid == second.grid:
        return first
    try:
        rows = [tuple(map(_joined, one, other)) for one, other in zip(first.grid, second.grid, strict=True)]
    except _Clash as clash:
        raise Misfit(f"cannot {verb} {names[0]} [{clash.one}] and {names[1]} [{clash.other}]") from None
    return Measure(tuple(rows), first.partition)


def contracted(first: Measure, second: Measure, names: tuple[object, object]) -> Measure:
    """The measure of a matrix product: inner sizes agree, and every product in one entry's sum has one dimension."""
    if first.shape[1] != second.shape[0]:
        raise Misfit(f"cannot multiply {names[0]} ({_size(first)}) by {names[1]} ({_size(second)})")
    try:
        rows = _product(first.grid, second.grid)
    except _Clash as clash:
        raise Misfit(
            f"multiplying {names[0]} by {names[1]} would add [{clash.one}] and [{clash.other}] in one entry"
        ) from None
    return _laid_out(rows, [first], [second])


@lru_cache(maxsize=4096)
def _product(first: Grid, second: Grid) -> Grid:
    columns = tuple(zip(*second, strict=True))
    pairs = ([zip(line, column, strict=True) for column in columns] for line in first)
    known = ([(a * b for a, b in each if a is not None and b is not None) for each in line] for line in pairs)
    return tuple(tuple(reduce(_joined, each, None) for each in line) for line in known)


def stacked(rows: Sequence[Sequence[Measure]], names: Sequence[Sequence[object]]) -> Measure:
    """The measure of a matrix of blocks: blocks of one row have one height, all rows have one width."""
    if not rows or not all(rows):
        raise Misfit("a matrix of blocks has at least one block in each row")
    lines: list[tuple[Dimension | None, ...]] = []
    width = sum(block.shape[1] for block in rows[0])
    for row, row_names in zip(rows, names, strict=True):
        for block, name in zip(row, row_names, strict=True):
            if block.shape[0] != row[0].shape[0]:
                raise Misfit(f"in one row of blocks, {row_names[0]} is {_size(row[0])} and {name} is {_size(block)}")
        if sum(block.shape[1] for block in row) != width:
            first = ", ".join(f"{name} is {_size(block)}" for name, block in zip(names[0], rows[0], strict=True))
            here = ", ".join(f"{name} is {_size(block)}" for name, block in zip(row_names, row, strict=True))
            raise Misfit(f"rows of blocks differ in width: {first}; but {here}")
        lines += [sum(parts, ()) for parts in zip(*(block.grid for block in row), strict=True)]
    return _laid_out(tuple(lines), [row[0] for row in rows], rows[0])


def _laid_out(grid: Grid, left: Sequence[Measure], above: Sequence[Measure]) -> Measure:
    """The grid with rows as high as those at the left and columns as wide as those above."""
    if all(each.partition is None for each in (*left, *above)):
        return Measure(grid)
    from chasles.vocabulary.sizes import partition_beside  # few chapters have such letters

    return Measure(grid, partition_beside(left, above))


def completed(measure: Measure, what: object) -> Measure:
    """The measure with the dimension of a zero filled in where the entries around it fix it.

    The entries of a map from one array to another have the product of a row's and a column's dimension; a `Misfit`
    naming `what` if they have not. Then neither a determinant nor an inverse has a meaning.
    """
    grid = [list(row) for row in measure.grid]
    rows, columns = len(grid), len(grid[0])
    places = [*product(range(rows), range(columns))]
    corners = [(i, j, k, m) for (i, j), (k, m) in product(places, repeat=2) if i != k and j != m]
    before: list[list[Dimension | None]] = []
    while grid != before:
        before = [list(row) for row in grid]
        for i, j, k, m in corners:
            one, other, opposite = grid[i][m], grid[k][j], grid[k][m]
            if one is None or other is None or opposite is None:
                continue
            expected = one * other / opposite
            if grid[i][j] not in (None, expected):
                raise Misfit(f"{what} has entries whose dimensions do not go together: [{grid[i][j]}] and [{expected}]")
            grid[i][j] = expected
    return Measure(tuple(map(tuple, grid)), measure.partition)


def _size(measure: Measure) -> str:
    rows, columns = measure.shape
    return "a scalar" if (rows, columns) == (1, 1) else f"{rows} x {columns}"
