"""What do the letters of the chapter mean? A row for each, in the order in which the chapter brings them."""

from __future__ import annotations

from dataclasses import dataclass

from markupsafe import Markup

from chasles.report.equations import labelled_equations
from chasles.report.html.formulas import math
from chasles.statements import Chapter
from chasles.vocabulary import Symbol, latex, walk


@dataclass(frozen=True, slots=True)
class Letter:
    """A letter as the book prints it, its name in plain text, what it means, its shape and its unit."""

    math: Markup
    name: str
    means: str
    kind: str


def notation_of(chapter: Chapter) -> tuple[Letter, ...]:
    """The letters that mean something by themselves, each once."""
    sides = (side for entry in chapter for _, *both in labelled_equations(entry.statement) for side in both)
    found = dict.fromkeys(part for side in sides for part in walk(side) if isinstance(part, Symbol))
    return tuple(_letter(symbol) for symbol in found if symbol.meaning)


def _letter(symbol: Symbol) -> Letter:
    rows, columns = symbol.size.shape
    shape = "" if rows == columns == 1 else f"{rows} x {columns}" if columns != 1 else f"vector of {rows}"
    units = dict.fromkeys(str(dimension) for row in symbol.size.grid for dimension in row if dimension is not None)
    kind = ", ".join(filter(None, (shape, *(unit for unit in units if unit != "no dimension"))))
    return Letter(math(latex(symbol)), symbol.name, symbol.meaning, kind)
