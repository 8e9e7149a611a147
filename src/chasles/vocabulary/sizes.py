"""What letters stand for: n rows, n + m columns, the n-th power. A matrix of such a size is measured in blocks."""

from __future__ import annotations

from collections.abc import Callable, Iterable, Iterator, Mapping, Sequence
from dataclasses import dataclass
from dataclasses import replace as with_fields
from functools import reduce
from math import prod

from chasles.vocabulary.arguments import Declared, WrongArgument, declaring
from chasles.vocabulary.dimension import NO_DIMENSION, Dimension
from chasles.vocabulary.letters import Identity, Symbol, Zero
from chasles.vocabulary.measure import Extent, Measure, Misfit
from chasles.vocabulary.nodes import Node, Power
from chasles.vocabulary.pieces import Piece, Style
from chasles.vocabulary.shorthand import opened
from chasles.vocabulary.tree import rebuilt


@dataclass(frozen=True, slots=True)
class Size(Declared):
    """A letter that stands for a whole number of rows or columns, or what is made of such: n, m + n, n + 1, m n.

    It is the sum of its `parts` or the product of its `factors`, where it has any.
    """

    name: str
    parts: tuple[Extent, ...] = ()
    factors: tuple[Extent, ...] = ()

    def __str__(self) -> str:
        return self.name

    def __add__(self, other: Extent) -> Extent:
        return _sum((*parts_of(self), *parts_of(other)))

    def __radd__(self, other: int) -> Extent:
        return _sum((*parts_of(other), *parts_of(self)))

    def __mul__(self, other: Extent) -> Extent:
        return times(self, other)

    __rmul__ = __mul__

    def __index__(self) -> int:
        raise Misfit(f"{self} stands for any number of rows or columns: entries are those of a matrix of a known size")

    def __le__(self, other: object) -> bool:
        return bool(self.__index__())

    __ge__ = __lt__ = __gt__ = __le__


def parts_of(extent: Extent) -> tuple[Extent, ...]:
    """The letters and numbers of which an extent is the sum; raises `WrongArgument` for what is none."""
    if isinstance(extent, Size):
        return extent.parts or (extent,)
    if not isinstance(extent, int) or isinstance(extent, bool) or extent < 0:
        shown = extent if isinstance(extent, Node) else repr(extent)
        raise WrongArgument(f"{shown} is no size: write a whole number, or a letter for one: n = Size('n')")
    return (extent,) if extent else ()


def times(one: Extent, other: Extent) -> Extent:
    """The product; the factors of each part are put in one order, for m n rows are as many as n m."""
    return _sum(_monomial(a, b) for a in parts_of(one) for b in parts_of(other))


def _monomial(*parts: Extent) -> Extent:
    factors = [f for part in parts for f in ((part.factors or (part,)) if isinstance(part, Size) else (part,))]
    number = prod(factor for factor in factors if isinstance(factor, int))
    letters = sorted((factor for factor in factors if isinstance(factor, Size)), key=lambda size: size.name)
    found = (*((number,) if number != 1 or not letters else ()), *letters)
    return found[0] if len(found) == 1 else Size(" ".join(map(str, found)), factors=found)


def _sum(extents: Iterable[Extent]) -> Extent:
    """The sum, numbers that meet taken together: those who write it otherwise mean other blocks."""
    parts: list[Extent] = []
    for extent in extents:
        if parts and isinstance(extent, int) and isinstance(parts[-1], int):
            parts[-1] += extent
        else:
            parts.append(extent)
    return parts[0] if len(parts) == 1 else Size(" + ".join(map(str, parts)), tuple(parts))


@dataclass(frozen=True, slots=True)
class Partition:
    """How high the rows of a grid of blocks are, and how wide its columns."""

    rows: tuple[Extent, ...]
    columns: tuple[Extent, ...]

    @property
    def shape(self) -> tuple[Extent, Extent]:
        """The numbers of rows and columns."""
        return _sum(self.rows), _sum(self.columns)

    @property
    def transposed(self) -> Partition:
        """The partition of the transpose."""
        return Partition(self.columns, self.rows)


def extents_of(measure: Measure) -> tuple[tuple[Extent, ...], tuple[Extent, ...]]:
    """The heights of the rows of the grid, and the widths of its columns."""
    if measure.partition is None:
        return (1,) * len(measure.grid), (1,) * len(measure.grid[0])
    return measure.partition.rows, measure.partition.columns


def blocks_of(measure: Measure) -> tuple[tuple[Extent, ...], tuple[Extent, ...]]:
    """The same with neighbouring single rows and columns taken together."""
    return parts_of(measure.shape[0]), parts_of(measure.shape[1])


def partition_beside(left: Sequence[Measure], above: Sequence[Measure]) -> Partition | None:
    """The partition of a grid with rows as high as those at the left and columns as wide as those above."""
    rows = sum((extents_of(each)[0] for each in left), ())
    return partition_of(rows, sum((extents_of(each)[1] for each in above), ()))


def partition_of(rows: tuple[Extent, ...], columns: tuple[Extent, ...]) -> Partition | None:
    """The partition with these heights and widths; None where each of them is 1."""
    return None if {*rows, *columns} == {1} else Partition(rows, columns)


def _places(extent: Extent) -> Iterator[Extent]:
    for part in parts_of(extent):
        yield from (1,) * part if isinstance(part, int) else (part,)


def uniform_blocks(height: Extent, width: Extent, dimension: Dimension | None, diagonal: bool = False) -> Measure:
    """Every entry has the same dimension; off the `diagonal`, if only that is meant, there are zeros."""
    rows, columns = tuple(_places(height)), tuple(_places(width))
    grid = tuple(
        tuple(None if diagonal and i != j else dimension for j, _ in enumerate(columns)) for i, _ in enumerate(rows)
    )
    return Measure(grid, partition_of(rows, columns))


def sizes_of(nodes: Iterable[Node]) -> tuple[Size, ...]:
    """The letters for sizes and exponents that occur, in reading order, abbreviations opened."""
    found: dict[Size, None] = {}
    seen: set[Node] = set()
    waiting = [*nodes]
    while waiting:
        node = waiting.pop(0)
        if node in seen:
            continue
        seen.add(node)
        waiting += [node.stands_for] if isinstance(node, Symbol) and node.stands_for is not None else node.below
        partition = node.measure.partition if node.measure else None
        extents = (*partition.rows, *partition.columns) if partition is not None else ()
        extents += parts_of(node.exponent) if isinstance(node, Power) else ()
        letters = (part for extent in extents for part in (getattr(extent, "factors", ()) or (extent,)))
        found |= {part: None for part in letters if isinstance(part, Size)}
    return tuple(found)


class OfAnySize(Node):
    """What a defined word means where sizes are letters, and no simpler words say it."""

    __slots__ = ()

    @property
    def word(self) -> Node:
        """The defined word, which simpler words say where sizes are numbers."""
        raise NotImplementedError(type(self).__name__)

    def spelled(self, style: Style, spell: Callable[[Node], Piece]) -> Piece:
        return spell(self.word)


def at_sizes(node: Node, numbers: Mapping[str, int]) -> Node:
    """The expression with numbers for the letters of these names; raises KeyError for a letter that has none."""
    match node:
        case Symbol():
            inner = None if node.stands_for is None else at_sizes(node.stands_for, numbers)
            return with_fields(node, size=_numbered(node.size, numbers), stands_for=inner)
        case Identity(size):
            return with_fields(node, size=_count(size, numbers))
        case Zero(rows, columns):
            return with_fields(node, rows=_count(rows, numbers), columns=_count(columns, numbers))
        case Power(base, exponent):
            return Power(at_sizes(base, numbers), _count(exponent, numbers))
        case _:
            made = rebuilt(node, tuple(at_sizes(part, numbers) for part in node.below))
            return opened(made.word) if isinstance(made, OfAnySize) else made


def at_exponent(node: Node, letter: Size, exponent: Extent) -> Node:
    """The expression with another exponent wherever the letter is one."""
    if isinstance(node, Symbol):
        inner = None if node.stands_for is None else at_exponent(node.stands_for, letter, exponent)
        return node if inner is None or inner == node.stands_for else inner
    made = rebuilt(node, tuple(at_exponent(part, letter, exponent) for part in node.below)) if node.below else node
    if not isinstance(made, Power):
        return made
    parts = ((part.factors or (part,)) if isinstance(part, Size) else (part,) for part in parts_of(made.exponent))
    products = (reduce(times, (exponent if factor == letter else factor for factor in factors)) for factors in parts)
    return Power(made.base, _sum(each for product in products for each in parts_of(product)))


def _count(extent: Extent, numbers: Mapping[str, int]) -> int:
    def count(part: Extent) -> int:
        if isinstance(part, int):
            return part
        return prod(map(count, part.factors)) if part.factors else numbers[part.name]

    return sum(map(count, parts_of(extent)))


def _numbered(measure: Measure, numbers: Mapping[str, int]) -> Measure:
    rows, columns = ([_count(extent, numbers) for extent in extents] for extents in extents_of(measure))
    lines = (sum(((d,) * k for d, k in zip(row, columns, strict=True)), ()) for row in measure.grid)
    return Measure(sum(((line,) * k for line, k in zip(lines, rows, strict=True)), ()))


@declaring
def rectangular(
    name: str,
    letter: str,
    meaning: str,
    rows: Extent,
    columns: Extent,
    dimension: Dimension = NO_DIMENSION,
    *,
    constant: bool = False,
) -> Symbol:
    """A matrix of so many rows and columns, numbers or letters for numbers; its letter is printed bold."""
    from chasles.vocabulary.words import boldface, declared

    return declared(name, boldface(letter), (rows, columns), dimension, meaning, constant)
