"""Displayed equations as a page prints them."""

from __future__ import annotations

from dataclasses import dataclass, field
from functools import cached_property

from chasles.reading.alignment import tokens_of_equation
from chasles.reading.lexemes import BadPage, Token


@dataclass(frozen=True)
class PrintedEquation:
    """A displayed equation: its LaTeX with macros expanded, where it stands in the page, and what it is called there.

    `fault` says why a display cannot be split into tokens, if so; the rows of one have the number of their `display`.
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
    found: tuple[Token, ...] = field(default=(), repr=False, compare=False)

    @cached_property
    def tokens(self) -> tuple[Token, ...]:
        """The equation's tokens with their places in the page; raises `BadPage` for a display that has a fault."""
        if self.fault:
            raise BadPage(self.fault, self.line, self.column)
        return self.found or tokens_of_equation(self.latex, self.line, self.column)
