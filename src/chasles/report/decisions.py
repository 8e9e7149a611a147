"""What came out? A table of verdicts, and below it, for each print that does not stand, why and what is right."""

from __future__ import annotations

from collections.abc import Iterator, Sequence

from rich.console import RenderableType
from rich.padding import Padding
from rich.table import Table
from rich.text import Text

from chasles.proof.judge import Decision
from chasles.proof.verdict import Counterexample, Fails, Verdict
from chasles.report.equations import in_words, standing_in
from chasles.report.screen import Screen
from chasles.report.words import labelled, point_in_words, reason, said
from chasles.statements import Entry, Statement

__all__ = ["Decided", "findings", "is_finding", "number_in_words", "verdict_table"]

Decided = tuple[Entry, Decision]


def number_in_words(entry: Entry, parts: bool = True) -> str:
    """The number as a reader looks for it: "(3.16)", "Thm 3.2.2", "(3.4) part 2"."""
    number = f"({entry.number})" if entry.number[:1].isdecimal() else entry.number
    return f"{number} part {entry.statement.part}" if parts and entry.statement.part > 1 else number


def verdict_table(screen: Screen, decided: Sequence[Decided]) -> Iterator[RenderableType]:
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
            table.add_row(Text(section.number, "bold"), "", Text(section.title, "bold"))
        table.add_row(
            Text(_short(entry)),
            labelled(decision.verdict, screen.signs),
            Text(entry.statement.says),
            Text(", ".join(getattr(decision.verdict, "needs", ()))),
        )
    yield table


def is_finding(decision: Decision) -> bool:
    """Whether there is more to say than the verdict: the print does not stand, or assumes what it does not need."""
    return not decision.verdict.true or bool(_unused(decision))


def findings(screen: Screen, decided: Sequence[Decided]) -> Iterator[RenderableType]:
    """For each print that does not stand: what it says, why not, and what stands in; and hypotheses not needed."""
    for entry, decision in decided:
        if is_finding(decision):
            yield Text()
            yield Text.assemble((number_in_words(entry), "bold"), "  ", labelled(decision.verdict, screen.signs))
            yield _indented(_explained(entry, decision))


def _explained(entry: Entry, decision: Decision) -> list[tuple[str, str]]:
    """What there is to say beside the verdict, as labels and texts."""
    lines = [("printed", equation) for equation in in_words(entry.statement)]
    lines += [("says", entry.statement.says)]
    if why := reason(decision.verdict):
        lines.append(("because", why))
    if isinstance(decision.verdict, Fails):
        lines += _at_point(decision.verdict.counterexample)
    if decision.correction is not None and isinstance(entry.statement, Statement):
        lines += _instead(entry.statement, decision.correction.form, decision.correction.verdict)
    if unused := _unused(decision):
        lines.append(("unused", f"assumes {', '.join(unused)}, which it does not need"))
    return lines


def _at_point(found: Counterexample) -> list[tuple[str, str]]:
    row, column = found.entry
    return [
        ("at", point_in_words(found.at) or "every point"),
        ("left", f"{found.left}   in row {row}, column {column}{f' of: {found.goal}' if found.goal else ''}"),
        ("right", found.right),
    ]


def _instead(statement: Statement, form: str, verdict: Verdict) -> list[tuple[str, str]]:
    text, _ = standing_in(statement, form)
    how = "as read" if form == "reading" else "corrected"
    lines = [("instead", text), ("", f"{how}, {said(verdict)}{'. '.join(('', reason(verdict)))}")]
    return lines + (_at_point(verdict.counterexample) if isinstance(verdict, Fails) else [])


def _unused(decision: Decision) -> tuple[str, ...]:
    return tuple(getattr(decision.verdict, "unused", ()))


def _indented(lines: list[tuple[str, str]]) -> RenderableType:
    grid = Table.grid(padding=(0, 2, 0, 0))
    grid.add_column(style="dim", no_wrap=True)
    grid.add_column(overflow="fold")
    for label, text in lines:
        grid.add_row(label, Text(text))
    return Padding(grid, (0, 0, 0, 2))


def _list(screen: Screen, decided: Sequence[Decided]) -> Iterator[RenderableType]:
    section = None
    for entry, decision in decided:
        if entry.section != section:
            section = entry.section
            yield Text.assemble("\n", (f"{section.number} {section.title}", "bold"))
        verdict = labelled(decision.verdict, screen.signs)
        needs = ", ".join(getattr(decision.verdict, "needs", ()))
        yield Text.assemble((_short(entry), "bold"), "  ", verdict, " " if needs else "", needs)
        yield Padding(Text(entry.statement.says), (0, 0, 0, 2))


def _short(entry: Entry) -> str:
    """The number in a column of numbers; the second part of (3.4) is 3.4/2."""
    return f"{entry.number}/{entry.statement.part}" if entry.statement.part > 1 else entry.number
