"""References on the page: anchors and links of numbers and statements, hypotheses as formulas."""

from __future__ import annotations

import re
from collections.abc import Iterable
from dataclasses import dataclass
from functools import cached_property

from markupsafe import Markup

from chasles.report.details import number_in_words
from chasles.report.equations import hypotheses_in_latex
from chasles.report.html.formulas import math
from chasles.statements import Chapter, Entry, Statement
from chasles.statements.chapter import bases
from chasles.statements.elsewhere import chapter_of, other_chapter


@dataclass(frozen=True, slots=True)
class Link:
    """A reference within the page: where it leads, as "#n-3-18", and its words."""

    to: str
    words: str


def slug(text: str) -> str:
    """The text as part of the name of a place: letters, digits and hyphens."""
    return re.sub(r"[^a-z0-9]+", "-", text.casefold()).strip("-")


def place_of_number(number: str) -> str:
    """The place of a number on the page."""
    return f"n-{slug(number)}"


class Book:
    """The chapter as the page refers to it."""

    def __init__(self, chapter: Chapter) -> None:
        self.chapter = chapter

    @cached_property
    def used_by(self) -> dict[tuple[str, int], list[Entry]]:
        """The statements that rest on a statement, by its number and part."""
        found: dict[tuple[str, int], list[Entry]] = {}
        for entry in self.chapter:
            for basis in self.bases(entry):
                found.setdefault((basis.number, basis.part), []).append(entry)
        return found

    @staticmethod
    def bases(entry: Entry) -> tuple[Statement, ...]:
        """What a statement rests on in its chapter, each once."""
        other = Book.elsewhere(entry)
        return tuple(basis for basis in dict.fromkeys(bases(entry.statement)) if basis not in other)

    @staticmethod
    def elsewhere(entry: Entry) -> tuple[Statement, ...]:
        """What a statement rests on in other chapters, each once."""
        here = chapter_of(entry.statement)
        return tuple(basis for basis in dict.fromkeys(bases(entry.statement)) if other_chapter(basis, here))

    def links(self, keys: Iterable[tuple[str, int]]) -> tuple[Link, ...]:
        """References to statements, in the book's order, one for each number."""
        numbers = {number for number, _ in keys}
        known = [number for number in self.chapter.numbers if number in numbers]
        return tuple(Link(f"#{place_of_number(number)}", number_in_words(number)) for number in known)

    @cached_property
    def hypotheses(self) -> dict[str, str]:
        """The hypotheses in LaTeX, by their text."""
        return hypotheses_in_latex(self.chapter)

    def condition(self, text: str) -> Markup:
        """A hypothesis as a formula, by its text; what is not told as a formula stays in words."""
        latex = self.hypotheses.get(text, "")
        return math(latex) if latex else Markup.escape(text)
