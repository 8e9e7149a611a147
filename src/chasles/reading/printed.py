"""Displayed equations as a page prints them."""

from __future__ import annotations

from dataclasses import dataclass, field
from functools import cached_property
from typing import NamedTuple

from chasles.reading.alignment import atoms_of_equation
from chasles.reading.atoms import Atoms, marks_of
from chasles.reading.lexemes import BadPage


class Remark(NamedTuple):
    """A formula in a line of prose, its macros expanded, with some text before it and behind it.

    It `follows` so many equations, and `is_close` if it stands in the sentence of the last of these.
    """

    before: str
    latex: str
    after: str
    line: int = 1
    follows: int = 0
    is_close: bool = False


@dataclass(frozen=True)
class PrintedEquation:
    """A displayed equation: its LaTeX with macros expanded, where it stands in the page, and what it is called there.

    `fault` says why a display cannot be split, if so; the rows of one have the number of their `display`, and the text
    `before` it. What is named under a brace in it, or by the prose around it, is said `beside`.
    """

    latex: str
    line: int = 1
    column: int = 1
    number: str | None = None
    label: str | None = None
    section: str | None = None
    file: str = ""
    fault: str = ""
    display: int = 0
    found: Atoms = field(default=(), repr=False, compare=False)
    before: str = field(default="", repr=False, compare=False)
    beside: tuple[PrintedEquation, ...] = field(default=(), repr=False, compare=False)

    @cached_property
    def atoms(self) -> Atoms:
        """What is printed, with its places in the page; raises `BadPage` for a display that has a fault."""
        if self.fault:
            raise BadPage(self.fault, self.line, self.column)
        return self.found or atoms_of_equation(self.latex, self.line, self.column)

    @cached_property
    def text(self) -> str:
        """What is printed, lexeme by lexeme; nothing of a display that has a fault."""
        try:
            return " ".join(marks_of(self.atoms))
        except BadPage:
            return ""


class PrintedPage(NamedTuple):
    """The displayed equations of a page in its order, and the formulas in its prose."""

    equations: tuple[PrintedEquation, ...]
    remarks: tuple[Remark, ...] = ()
