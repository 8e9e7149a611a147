"""The contents of the book: a line for each number, section by section."""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from itertools import groupby

from rich.console import RenderableType
from rich.table import Table
from rich.text import Text

from chasles.report.screen import Screen
from chasles.statements import Entry

SHOWN = 6
"""How many kernels of one number are named."""


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
    text = Text(parts[0].statement.says)
    if len(parts) > 1:
        text.append(f" ({len(parts)} parts)", "dim")
    names = [kernel.name for part in parts for kernel in part.kernels]
    for name in names[:SHOWN]:
        text.append(f"  kernel {name}", "cyan")
    if len(names) > SHOWN:
        text.append(f"  and {len(names) - SHOWN} more", "cyan")
    return text
