"""One statement on a page: the equation, what it says and rests on, its verdict, and what proves or refutes it."""

from __future__ import annotations

from collections.abc import Iterator, Mapping
from itertools import chain
from typing import Any

from rich.console import RenderableType
from rich.text import Text

from chasles.decisions.session import Decision
from chasles.report.details import evidence, indented, number_in_words, objections, printed, rests_on
from chasles.report.emission_records import recorded
from chasles.report.screen import Screen
from chasles.report.words import labelled
from chasles.statements import Entry


def statement_page(
    screen: Screen,
    entry: Entry,
    decision: Decision,
    latex: bool = False,
    emitted: Mapping[str, Mapping[str, Any]] | None = None,
) -> Iterator[RenderableType]:
    """The page of one statement, with what was recorded of its kernels where those that were `emitted` are given."""
    number = number_in_words(entry.number, entry.statement.part)
    verdict, needs = labelled(decision.verdict, screen.signs), ", ".join(decision.verdict.needs)
    yield Text.assemble((number, "bold"), "  ", verdict, " " if needs else "", needs)
    section = f"{entry.section.number} {entry.section.title}"
    yield Text(f"  {entry.name}, {entry.statement.role} in {section}", "dim")
    kernels = recorded(emitted or {}, tuple(kernel.name for kernel in entry.kernels))
    lines = printed(entry, latex), rests_on(entry, decision), kernels, objections(entry, decision), evidence(decision)
    yield indented(chain.from_iterable(lines))
