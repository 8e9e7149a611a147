"""What do the letters of the chapter mean? A row for each, in the order in which the chapter brings them."""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import dataclass

from markupsafe import Markup

from chasles.report.html.formulas import math
from chasles.statements import Chapter, Inverse, Theorem
from chasles.vocabulary import Node, Symbol, latex, walk


@dataclass(frozen=True, slots=True)
class Letter:
    """A letter as the book prints it, its name in plain text, what it means, its shape and its unit."""

    math: Markup
    name: str
    means: str
    kind: str


def notation_of(chapter: Chapter) -> tuple[Letter, ...]:
    """The letters that mean something by themselves, each once."""
    found = dict.fromkeys(part for side in _sides(chapter) for part in walk(side) if isinstance(part, Symbol))
    return tuple(_letter(symbol) for symbol in found if symbol.meaning)


def _sides(chapter: Chapter) -> Iterator[Node]:
    for entry in chapter:
        match entry.statement:
            case Theorem(forms=forms):
                yield from (side for form in forms for _, *sides in form.equations() for side in sides)
            case Inverse(branches=branches):
                yield from (side for branch in branches for sides in branch.values for side in sides)
            case statement:
                yield from statement.printed


def _letter(symbol: Symbol) -> Letter:
    rows, columns = symbol.size.shape
    shape = "" if rows == columns == 1 else f"{rows} x {columns}" if columns != 1 else f"vector of {rows}"
    units = dict.fromkeys(str(dimension) for row in symbol.size.grid for dimension in row if dimension is not None)
    kind = ", ".join(filter(None, (shape, *(unit for unit in units if unit != "no dimension"))))
    return Letter(math(latex(symbol)), symbol.name, symbol.meaning, kind)
