"""The short words in which declarations are written."""

from __future__ import annotations

import re
from collections.abc import Sequence
from fractions import Fraction
from math import inf

from chasles.vocabulary.arguments import WrongArgument, declaring, declaring_module, making
from chasles.vocabulary.dimension import NO_DIMENSION, Dimension, has_units
from chasles.vocabulary.layout import At, Block, Call, Group, Integral, Rate
from chasles.vocabulary.letters import Symbol, Zero
from chasles.vocabulary.measure import Extent, Measure, uniform
from chasles.vocabulary.nodes import Node, Quotient, lifted
from chasles.vocabulary.spatial import Cross, Determinant, Dot, Inverse, Norm, Skew, Trace, Vect

COMMAND = re.compile(r"\\[A-Za-z]+\s*\{")
PI = Symbol("pi", r"\pi", uniform((1, 1)), "ratio of a circle's circumference to its diameter", constant=True)


@declaring
def scalar(
    name: str, letter: str, meaning: str, dimension: Dimension = NO_DIMENSION, *, constant: bool = False
) -> Symbol:
    """A scalar quantity."""
    return declared(name, letter, (1, 1), dimension, meaning, constant)


@declaring
def vector(name: str, letter: str, meaning: str, dimension: Dimension = NO_DIMENSION, *, constant: bool = False,
           size: Extent = 3) -> Symbol:  # fmt: skip
    """A vector, a column of three or another `size`; its letter is printed bold."""
    return declared(name, boldface(letter), (size, 1), dimension, meaning, constant)


@declaring
def square(name: str, letter: str, meaning: str, dimension: Dimension = NO_DIMENSION, *, constant: bool = False,
           size: Extent = 3) -> Symbol:  # fmt: skip
    """A square matrix, 3 x 3 or of another `size`; its letter is printed bold."""
    return declared(name, boldface(letter), (size, size), dimension, meaning, constant)


@declaring
def array(name: str, letter: str, meaning: str, measure: Measure | Node) -> Symbol:
    """An array measured like the given expression, which says what its entries are; its letter is printed bold."""
    if isinstance(measure, Node):
        assert measure.measure is not None
        measure = measure.measure
    home = declaring_module()
    in_units = has_units(home)
    return Symbol(name, boldface(letter), measure if in_units else uniform(measure.shape), meaning,
                  home=home, has_units=in_units)  # fmt: skip


@declaring
def abbreviation(name: str, letter: str, stands_for: Node, meaning: str) -> Symbol:
    """A letter that stands for an expression wherever it occurs."""
    assert stands_for.measure is not None
    constant = isinstance(stands_for, Skew) and isinstance(stands_for.of, Symbol) and stands_for.of.constant
    home = declaring_module()
    return Symbol(name, boldface(letter), stands_for.measure, meaning, constant, stands_for, home, has_units(home))


def declared(
    name: str, letter: str, shape: tuple[Extent, Extent], dimension: Dimension, meaning: str, constant: bool
) -> Symbol:
    """A symbol of the module that declares it, in a chapter without units without dimension."""
    for extent in shape:
        if isinstance(extent, int) and extent < 1:
            raise WrongArgument(f"{extent} is no size: it is 1 or more")
    home = declaring_module()
    in_units = has_units(home)
    measure = uniform(shape, dimension if in_units else NO_DIMENSION)
    return Symbol(name, letter, measure, meaning, constant, home=home, has_units=in_units)


def boldface(letter: str) -> str:
    """The letter in bold, its decorations outside: of p_0' only the p is made bold.

    One that begins with a brace, or with a command that takes something in braces, is printed as it is.
    """
    if letter.startswith(("{", "[")) or COMMAND.match(letter):
        return letter
    cut = next((i for i, mark in enumerate(letter) if mark in "_^'"), len(letter))
    stem, rest = letter[:cut], letter[cut:]
    return (rf"\boldsymbol{{{stem}}}" if stem.startswith("\\") else rf"\mathbf{{{stem}}}") + rest


@declaring
def cos(angle: Node) -> Call:
    """The cosine of an angle in radians."""
    return Call("cos", angle)


@declaring
def sin(angle: Node) -> Call:
    """The sine of an angle in radians."""
    return Call("sin", angle)


@declaring
def cot(angle: Node) -> Quotient:
    """The cotangent of an angle in radians: its cosine divided by its sine, where that is not zero."""
    return Quotient(cos(angle), sin(angle), called="cot")


@declaring
def tan(angle: Node) -> Quotient:
    """The tangent of an angle in radians: its sine divided by its cosine, where that is not zero."""
    return Quotient(sin(angle), cos(angle), called="tan")


dot = making(Dot, "dot")
cross = making(Cross, "cross")
norm = making(Norm, "norm")
tr = making(Trace, "tr")
det = making(Determinant, "det")
vect = making(Vect, "vect")
CPM = making(Skew, "CPM")
inverse = making(Inverse, "inverse")
rate = making(Rate, "rate")


@declaring
def integral(of: Node, density: Symbol, *over: Symbol) -> Integral:
    """The integral over the body; the density and what it is taken `over` differ from element to element."""
    return Integral(of, density, over)


@declaring
def at(of: Node, argument: str = "t") -> At:
    """The quantity printed with its argument."""
    return At(of, argument)


@declaring
def number(value: int | Fraction) -> Node:
    """An exact number standing alone, as on the right side of an equation."""
    return lifted(value)


@declaring
def over(numerator: Node | int | Fraction, denominator: Node | int | Fraction) -> Quotient:
    """A quotient written on one line, with a slash."""
    return Quotient(lifted(numerator), lifted(denominator), slash=True)


@declaring
def paren(of: Node) -> Group:
    """The term in round brackets that the author chose to print."""
    return Group(of)


@declaring
def bracket(of: Node) -> Group:
    """The term in square brackets that the author chose to print."""
    return Group(of, "[]")


@declaring
def in_frame(of: Node, frame: str) -> Group:
    """The components in a coordinate frame, in square brackets that bear the frame's letter."""
    return Group(of, "[]", rf"\mathcal{{{frame}}}")


@declaring
def column(*blocks: Node | int) -> Block:
    """Blocks stacked one under the other."""
    return _blocks([[block] for block in blocks])


@declaring
def row(*blocks: Node | int) -> Block:
    """Blocks side by side."""
    return _blocks([blocks])


@declaring
def matrix(*rows: Sequence[Node | int]) -> Block:
    """A matrix of blocks, row by row; a 0 is a block of zeros as high as those beside it, as wide as those above it."""
    return _blocks(rows)


def _blocks(rows: Sequence[Sequence[Node | int]]) -> Block:
    made = [[lifted(block) for block in line] for line in rows]
    nothing = lifted(0)
    if len({len(line) for line in made}) == 1:
        heights = [
            max((b.shape[0] for b in line if b != nothing and not b.fault), key=_rank, default=1) for line in made
        ]
        columns = zip(*made, strict=True)
        widths = [
            max((b.shape[1] for b in line if b != nothing and not b.fault), key=_rank, default=1) for line in columns
        ]
        for line, height in zip(made, heights, strict=True):
            for place, width in enumerate(widths):
                if line[place] == nothing and (height, width) != (1, 1):
                    line[place] = Zero(height, width)
    return Block(tuple(map(tuple, made)))


def _rank(extent: Extent) -> float:
    return extent if isinstance(extent, int) else inf
