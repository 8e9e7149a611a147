"""Entries of matrices and components of vectors: R_{12}, omega_x, and blocks of them, T_{1:3,4}."""

from __future__ import annotations

import re
from collections.abc import Callable
from fractions import Fraction
from itertools import takewhile
from typing import ClassVar

from chasles.vocabulary.fitting import word
from chasles.vocabulary.layout import Block
from chasles.vocabulary.letters import Identity, Symbol, Zero
from chasles.vocabulary.measure import Misfit
from chasles.vocabulary.nodes import Contract, Node, Number, Transpose
from chasles.vocabulary.pieces import Piece, Precedence, Style
from chasles.vocabulary.shorthand import Shorthand
from chasles.vocabulary.tree import children, rebuilt, undotted

BOLD = re.compile(r"\\(?:mathbf|boldsymbol)\{(\\?[A-Za-z]+)\}")
Range = tuple[int, int]


@word
class Submatrix(Shorthand):
    """The entries of a matrix in the given `rows` and `columns`, counted from 1, first and last; printed as `mark`."""

    of: Node
    rows: Range
    columns: Range
    mark: str
    is_letter: ClassVar[bool] = True

    @property
    def definition(self) -> Node:
        height, width = self.of.shape
        for (first, last), size, line in ((self.rows, height, "row"), (self.columns, width, "column")):
            if not 1 <= first <= last <= size:
                asked = first if first == last else f"{first} to {last}"
                raise Misfit(f"{self.of} is {height} x {width} and has no {line} {asked}: they are counted from 1")
        factors = [] if self.rows == (1, height) else [_selection(self.rows, height)]
        factors.append(self.of)
        if self.columns != (1, width):
            factors.append(_selection(self.columns, width).T)
        return factors[0] if len(factors) == 1 else Contract(tuple(factors))

    def spelled(self, style: Style, spell: Callable[[Node], Piece]) -> Piece:
        piece = spell(self.of)
        if isinstance(undotted(self.of)[0], Symbol) and piece.level is Precedence.ATOM:
            letter = BOLD.sub(r"\1", piece.text) if self.is_scalar else piece.text
            return Piece(style.component(letter, self.mark), Precedence.ATOM)
        text = piece.text if isinstance(self.of, Block) else style.chosen_brackets(piece.text, 1)
        return Piece(style.subscripted(text, self.mark), Precedence.ATOM, max(piece.depth, 1) + 1)


def _selection(places: Range, size: int) -> Node:
    """The rows of the identity in the given places, between columns of zeros."""
    first, last = places
    count = last - first + 1
    kept: Node = Number(Fraction(1)) if count == 1 else Identity(count)
    blocks = (Zero(count, first - 1), kept, Zero(count, size - last))
    return Block((tuple(block for block in blocks if block.shape[1]),))


def with_entries(node: Node) -> Node:
    """The expression with an entry, as its author wrote it, for each product with rows of an identity."""
    if isinstance(node, Contract) and len(node.factors) in (2, 3):
        first, last = node.factors[0], node.factors[-1]
        row, column = _place(first), _place(last.of) if isinstance(last, Transpose) else 0
        match node.factors:
            case (_, of, _) if row and column:
                return of[row, column]
            case (_, of) if row and of.shape[1] == 1:
                return of[row]
            case (of, _) if column and of.shape[0] == 1:
                return of[column]
    parts = children(node)
    return rebuilt(node, tuple(map(with_entries, parts))) if parts else node


def _place(row: Node) -> int:
    """Which row of an identity it is; 0 if it is none."""
    blocks = row.rows[0] if isinstance(row, Block) and row.shape[0] == 1 else ()
    before = tuple(takewhile(lambda block: isinstance(block, Zero), blocks))
    rest = [block for block in blocks[len(before) :] if not isinstance(block, Zero)]
    return 1 + sum(block.shape[1] for block in before) if rest == [Number(Fraction(1))] else 0


def part(of: Node, places: int | slice | tuple[int | slice, int | slice] | str) -> Submatrix:
    """The entry or block in the given rows and columns; of a column or a row, one place is enough."""
    height, width = of.shape
    if isinstance(places, str):
        if len(places) != (1 if width == 1 else 2):
            raise Misfit(f"{of} is {height} x {width}: a component is that of a column, an entry has two letters")
        row, column = (*("xyz".find(letter) + 1 for letter in places), 1)[:2]
        return Submatrix(of, (row, row), (column, column), places)
    if not isinstance(places, tuple):
        if 1 not in (height, width):
            raise Misfit(f"{of} is {height} x {width}: an entry of it has a row and a column, as in A[1, 2]")
        rows, columns = (_range(places, height), (1, 1)) if width == 1 else ((1, 1), _range(places, width))
        return Submatrix(of, rows, columns, _mark(rows if width == 1 else columns))
    if len(places) != 2:
        raise Misfit(f"{places!r} are the places of no entry: it has a row and a column")
    rows, columns = _range(places[0], height), _range(places[1], width)
    marks = _mark(rows), _mark(columns)
    return Submatrix(of, rows, columns, ("" if all(len(mark) == 1 for mark in marks) else ",").join(marks))


def _range(places: int | slice, size: int) -> Range:
    match places:
        case slice(start=first, stop=last, step=None):
            return first if first is not None else 1, last if last is not None else size
        case int():
            return places, places
        case _:
            raise Misfit(f"{places!r} is no row or column: write a number, or a range such as 1:3")


def _mark(places: Range) -> str:
    first, last = places
    return str(first) if first == last else f"{first}:{last}"
