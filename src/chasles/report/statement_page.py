"""One statement on a page: what it says and rests on, its verdict, what proves or refutes it; or how it is repaired."""

from __future__ import annotations

from collections.abc import Iterator, Mapping
from itertools import chain
from typing import Any

from rich.console import RenderableType
from rich.text import Text

from chasles.decisions.session import Decision
from chasles.repairs.repair import Repair
from chasles.report.details import (
    Lines,
    evidence,
    indented,
    number_in_words,
    objections,
    objections_to_print,
    printed,
    rests_on,
)
from chasles.report.emission_records import recorded
from chasles.report.equations import in_both
from chasles.report.screen import Screen
from chasles.report.words import labelled, said
from chasles.statements import Entry, Statement


def statement_page(
    screen: Screen,
    entry: Entry,
    decision: Decision,
    latex: bool,
    emitted: Mapping[str, Mapping[str, Any]] | None,
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


def repair_page(screen: Screen, entry: Entry, decision: Decision, latex: bool) -> Iterator[RenderableType]:
    """The printed equation, why it is wrong, and the repairs."""
    number = number_in_words(entry.number, entry.statement.part)
    yield Text.assemble((number, "bold"), "  ", labelled(decision.verdict, screen.signs))
    lines = [printed(entry, latex), objections_to_print(decision)]
    repairs = _repairs(decision)
    lines += [_repaired(entry, repair, latex) for repair in repairs]
    if not repairs:
        what = "it is right as printed" if decision.verdict.true else "nothing was found"
        lines.append(iter([("repair", what)]))
    yield indented(chain.from_iterable(lines))


def repair_record(entry: Entry, decision: Decision) -> dict[str, Any]:
    """The repairs of one statement for a program to read."""
    return {
        "number": entry.number,
        "part": entry.statement.part,
        "name": entry.name,
        "verdict": decision.verdict.name,
        "repairs": [_record(entry, repair) for repair in _repairs(decision)],
    }


def _repairs(decision: Decision) -> tuple[Repair, ...]:
    return () if decision.correction is None else decision.correction.repairs


def _repaired(entry: Entry, repair: Repair, latex: bool) -> Lines:
    assert isinstance(entry.statement, Statement)
    text, formula = in_both((repair.left, repair.right), entry.statement.sign)
    yield "repair", text
    if latex:
        yield "LaTeX", formula
    yield from (("change", change) for change in repair.changes)
    if repair.modulo is not None:
        yield "freedom", repair.modulo
    if repair.by:
        yield "then", f"{', '.join(map(number_in_words, repair.by))} hold"
    else:
        yield "then", f"it {said(repair.verdict)}"


def _record(entry: Entry, repair: Repair) -> dict[str, Any]:
    assert isinstance(entry.statement, Statement)
    text, formula = in_both((repair.left, repair.right), entry.statement.sign)
    return {
        "text": text,
        "latex": formula,
        "changes": list(repair.changes),
        "modulo": repair.modulo,
        "by": list(repair.by),
        "verdict": repair.verdict.name,
        "needs": list(repair.verdict.needs),
    }
