"""The state of the chapter in one table, a row for each section: verdicts, kernels, time."""

from __future__ import annotations

from collections import Counter
from collections.abc import Iterator, Sequence
from dataclasses import dataclass, field
from typing import Any

from rich.console import RenderableType
from rich.table import Table
from rich.text import Text

from chasles.report.decisions import Decided
from chasles.report.details import number_in_words
from chasles.report.findings import SLIPS, slips
from chasles.report.screen import Screen
from chasles.report.words import VERDICTS, number_of, seconds

HEADERS = {
    "holds": "holds",
    "holds-under": "holds\nunder",
    "fails": "fails",
    "ill-formed": "ill-\nformed",
    "contradictory": "contra-\ndictory",
    "undecided": "un-\ndecided",
    "defined": "defi-\nnitions",
    "posed": "condi-\ntions",
    "assumed": "postu-\nlates",
}
ONLY_IF_ANY = ("contradictory", "undecided", "assumed")


@dataclass(slots=True)
class Tally:
    """What came out in one section, or in all: how many of each verdict, how many kernels, how long it took."""

    number: str
    title: str
    verdicts: Counter[str] = field(default_factory=Counter)
    kernels: int = 0
    milliseconds: float = 0.0

    def add(self, other: Tally) -> None:
        """Count what the other counts as well."""
        self.verdicts += other.verdicts
        self.kernels += other.kernels
        self.milliseconds += other.milliseconds

    def as_json(self) -> dict[str, Any]:
        """The tally as plain data; every verdict has its count."""
        counts = {name: self.verdicts[name] for name in VERDICTS}
        return {
            "section": self.number,
            "title": self.title,
            **counts,
            "kernels": self.kernels,
            "milliseconds": round(self.milliseconds, 3),
        }


def tallies(decided: Sequence[Decided]) -> list[Tally]:
    """A tally for each section, in the book's order."""
    found: dict[str, Tally] = {}
    for entry, decision in decided:
        section = found.setdefault(entry.section.number, Tally(entry.section.number, entry.section.title))
        kernels = len(entry.kernels)
        section.add(Tally("", "", Counter([decision.verdict.name]), kernels, decision.milliseconds))
    return list(found.values())


def summary_table(screen: Screen, sections: Sequence[Tally]) -> Iterator[RenderableType]:
    """The tallies and, below them, their total: as a table, or as a list where a table has no room."""
    total = Tally("", "all")
    for section in sections:
        total.add(section)
    shown = [name for name in HEADERS if name not in ONLY_IF_ANY or total.verdicts[name]]
    table = Table(box=None, pad_edge=False, padding=(0, 1, 0, 0), header_style="dim")
    table.add_column("", no_wrap=True)
    table.add_column("section")
    for name in shown:
        table.add_column(HEADERS[name], justify="right", no_wrap=True)
    table.add_column("ker-\nnels", justify="right", no_wrap=True)
    table.add_column("time", justify="right", no_wrap=True)
    for tally in sections:
        table.add_row(*_cells(tally, shown))
    table.add_row()
    table.add_row(*_cells(total, shown), style="bold")
    if screen.has_room_for(table):
        yield table
    else:
        yield from (_in_words(tally) for tally in (*sections, total))


def wrong_as_printed(decided: Sequence[Decided]) -> Iterator[RenderableType]:
    """The numbers of the equations that are wrong, on a line for each kind of slip; nothing if all are right."""
    found = slips(decided)
    for slip, pairs in found.items():
        numbers = (number_in_words(entry.number, entry.statement.part) for entry, _ in pairs)
        yield Text(f"{SLIPS[slip]}: {', '.join(numbers)}")
    if found:
        yield Text("`chasles show` says why, and what is right")


def _cells(tally: Tally, shown: Sequence[str]) -> list[Text]:
    counts = [_count(tally.verdicts[name], VERDICTS[name][3]) for name in shown]
    time = Text(seconds(tally.milliseconds / 1000))
    return [Text(tally.number), Text(tally.title), *counts, _count(tally.kernels, ""), time]


def _in_words(tally: Tally) -> Text:
    """The tally in a sentence."""
    said = [f"{tally.verdicts[name]} {VERDICTS[name][2]}" for name in HEADERS if tally.verdicts[name]]
    rest = f"{', '.join(said)}; {number_of(tally.kernels, 'kernel')}, {seconds(tally.milliseconds / 1000)}"
    return Text.assemble((f"{tally.number} {tally.title}".strip(), "bold"), ": ", rest, overflow="fold")


def _count(number: int, colour: str) -> Text:
    """The number; a dot where there is nothing to count."""
    return Text(str(number), colour) if number else Text(".", "dim")
