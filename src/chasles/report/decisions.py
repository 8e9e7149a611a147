"""Tables of statements: the contents of a book, verdicts, why an equation is wrong as printed and what is right.

And the state of a chapter, a row for each section: verdicts, kernels, time.
"""

from __future__ import annotations

from collections import Counter
from collections.abc import Iterator, Sequence
from dataclasses import dataclass, field
from itertools import groupby
from typing import Any

from rich.console import RenderableType
from rich.padding import Padding
from rich.table import Table
from rich.text import Text

from chasles.decisions.session import Decision
from chasles.report.details import indented, number_in_words, objections, printed, said_of
from chasles.report.findings import SLIPS, Pairs, slips
from chasles.report.screen import Screen
from chasles.report.words import VERDICTS, labelled, number_of, seconds
from chasles.statements import Entry

SHOWN = 6
"""How many kernels of one number are named."""
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


def verdict_table(screen: Screen, decided: Pairs) -> Iterator[RenderableType]:
    """Number, verdict, what the statement says and needs, section by section; a list where a table has no room."""
    if screen.narrow:
        yield from _list(screen, decided)
        return
    table = Table(box=None, pad_edge=False, header_style="dim", padding=(0, 2, 0, 0))
    table.add_column("number", no_wrap=True)
    table.add_column("verdict", no_wrap=True)
    table.add_column("says", ratio=3, min_width=20)
    table.add_column("needs", ratio=1, overflow="fold")
    section = None
    for entry, decision in decided:
        if entry.section != section:
            section = entry.section
            table.add_row()
            table.add_row(Text(f"Section {section.number}", "bold"), "", Text(section.title, "bold"))
        verdict = labelled(decision.verdict, screen.signs)
        table.add_row(Text(_short(entry)), verdict, Text(said_of(entry)), Text(_needs(decision)))
    yield table


def is_finding(decision: Decision) -> bool:
    """Whether there is more to say than the verdict: it is wrong as printed, or assumes what it does not need."""
    return not decision.verdict.true or bool(decision.verdict.unused)


def findings(screen: Screen, decided: Pairs) -> Iterator[RenderableType]:
    """For each equation that is wrong as printed: what it says, why, and what is right; and hypotheses not needed."""
    for entry, decision in decided:
        if is_finding(decision):
            number = number_in_words(entry.number, entry.statement.part)
            yield Text.assemble("\n", (number, "bold"), "  ", labelled(decision.verdict, screen.signs))
            yield indented(line for lines in (printed(entry), objections(entry, decision)) for line in lines)


def _list(screen: Screen, decided: Pairs) -> Iterator[RenderableType]:
    section = None
    for entry, decision in decided:
        if entry.section != section:
            section = entry.section
            yield Text.assemble("\n", (f"Section {section.number} {section.title}", "bold"))
        verdict, needs = labelled(decision.verdict, screen.signs), _needs(decision)
        yield Text.assemble((_short(entry), "bold"), "  ", verdict, " " if needs else "", needs)
        yield Padding(Text(said_of(entry)), (0, 0, 0, 2))


def _needs(decision: Decision) -> str:
    return ", ".join(decision.verdict.needs)


def _short(entry: Entry) -> str:
    """The number in a column of numbers; the second part of (3.4) is 3.4/2."""
    return f"{entry.number}/{entry.statement.part}" if entry.statement.part > 1 else entry.number


def contents(screen: Screen, entries: Sequence[Entry]) -> Iterator[RenderableType]:
    """Number, role and what it says; the parts of one number share a line, which says how many they are."""
    table = Table(box=None, pad_edge=False, show_header=False, padding=(0, 2, 0, 0))
    table.add_column("number", no_wrap=True)
    if not screen.narrow:
        table.add_column("role", no_wrap=True, style="dim")
    table.add_column("says", overflow="fold")
    for section, members in groupby(entries, lambda entry: entry.section):
        if table.row_count:
            table.add_row()
        _add(table, (Text(f"Section {section.number}", "bold"), Text(), Text(section.title, "bold")))
        by_number: dict[str, list[Entry]] = {}
        for entry in members:
            by_number.setdefault(entry.number, []).append(entry)
        for number, parts in by_number.items():
            roles = ", ".join(dict.fromkeys(part.statement.role for part in parts))
            _add(table, (Text(number), Text(roles), _said(parts)))
    yield table


def _add(table: Table, cells: tuple[Text, Text, Text]) -> None:
    table.add_row(*(cells if len(table.columns) == 3 else (cells[0], cells[2])))


def _said(parts: list[Entry]) -> Text:
    text = Text(said_of(parts[0]))
    if len(parts) > 1:
        text.append(f" ({len(parts)} parts)", "dim")
    names = [kernel.name for part in parts for kernel in part.kernels]
    for name in names[:SHOWN]:
        text.append(f"  kernel {name}", "cyan")
    if len(names) > SHOWN:
        text.append(f"  and {len(names) - SHOWN} more", "cyan")
    return text


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


def tallies(decided: Pairs) -> list[Tally]:
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


def wrong_as_printed(decided: Pairs) -> Iterator[RenderableType]:
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
