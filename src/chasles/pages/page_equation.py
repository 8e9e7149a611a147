"""One relation of a displayed equation, with what was read and found of it."""

from __future__ import annotations

from dataclasses import dataclass

from chasles.display import Displayed
from chasles.pages.finding import PageFinding
from chasles.reading.printed import PrintedEquation
from chasles.reading.reading import Part, ReadEquation


@dataclass(frozen=True, slots=True)
class PageEquation(Displayed):
    """One relation of a displayed equation; an equation that is not read has one, without `part` and `finding`.

    `others` are the verdicts of other readings, each with the reading in LaTeX, where they differ.
    """

    read: ReadEquation
    number: str
    place: int = 1
    part: Part | None = None
    finding: PageFinding | None = None
    others: tuple[tuple[str, str], ...] = ()

    @property
    def printed(self) -> PrintedEquation:
        """The equation of the page."""
        return self.read.printed

    @property
    def line(self) -> int:
        """The line of the page on which the relation stands."""
        return (self.part.line if self.part else 0) or self.printed.line

    @property
    def verdict(self) -> str:
        """The verdict in one word: what was not decided is "open", "ambiguous" or "unread"."""
        if self.finding is None:
            return "unread"
        if self.others or self.finding.doubt:
            return "ambiguous"
        return "open" if self.finding.open else self.finding.verdict.name

    @property
    def is_decided(self) -> bool:
        """Whether nothing is left to ask of a person."""
        return self.verdict not in ("open", "ambiguous", "unread", "undecided", "contradictory")
