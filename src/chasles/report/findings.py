"""What is to be said of a print that does not stand: what stands in, who found it, and whose slip it more likely is."""

from __future__ import annotations

from collections.abc import Callable, Iterable, Mapping, Sequence
from dataclasses import dataclass
from typing import TYPE_CHECKING

from chasles.proof.judge import Decision
from chasles.proof.verdict import Verdict
from chasles.report.lost_marks import lost_marks
from chasles.statements import Chapter, Entry, Statement
from chasles.vocabulary import Node, latex

if TYPE_CHECKING:
    from chasles.proof.repair import Repair

__all__ = ["Decisions", "Pairs", "Repairs", "Standing", "likely_slip", "ordered", "repairs_of", "stands_in"]

Decisions = Mapping[str, Decision]
"""By the name of the statement."""
Pairs = Sequence[tuple[Entry, Decision]]
Repairs = Mapping[str, Sequence["Repair"]]
"""By the name of the statement, the simplest first; a statement for which none was found may be left out."""
PATIENCE = 60.0
"""Seconds for the search of one repair: so many that what is found does not depend on the machine."""
Search = Callable[[Statement, Callable[[Statement], str], float, Iterable[Statement]], Sequence["Repair"]]


@dataclass(frozen=True, slots=True)
class Standing:
    """An equation that is true where the print is not: its sides, the verdict, how it was `found`, what was changed.

    `found` is "repair" or "declared"; `by` are the claims that show a definition to be the one that was meant.
    """

    left: Node
    right: Node
    sign: str
    verdict: Verdict
    found: str
    changes: tuple[str, ...] = ()
    modulo: str | None = None
    by: tuple[str, ...] = ()


def ordered(book: Chapter, decisions: Decisions) -> Pairs:
    """The statements of the book with the decisions on them, section by section in the order of their numbers."""
    place = {number: k for k, number in enumerate(book.numbers)}
    section = {known: k for k, known in enumerate(book.sections)}
    entries = sorted(book, key=lambda entry: (section[entry.section], place[entry.number], entry.statement.part))
    return [(entry, decisions[entry.name]) for entry in entries]


def stands_in(entry: Entry, decision: Decision, repairs: Repairs) -> tuple[Standing, ...]:
    """What stands in for a print that does not: the repairs, or else what is declared and true; it may be nothing."""
    statement, correction = entry.statement, decision.correction
    if decision.verdict.true or not isinstance(statement, Statement):
        return ()
    found = repairs.get(entry.name, ())
    if found:
        return tuple(
            Standing(r.left, r.right, statement.sign, r.verdict, "repair", r.changes, r.modulo, r.by) for r in found
        )
    if correction is None or not correction.verdict.true:
        return ()
    return (Standing(*statement.form(correction.form), statement.sign, correction.verdict, "declared"),)


def likely_slip(entry: Entry, decision: Decision) -> str:
    """Whose slip it more likely is: a `reading` restores what the scan has lost, anything else changes the print."""
    statement, correction = entry.statement, decision.correction
    if not isinstance(statement, Statement) or statement.reading is None:
        return "of the print"
    lost = lost_marks(*(_in_latex(statement, form) for form in ("printed", "reading")))
    said = [f"has lost {_listed(lost.marks)}"] if lost.marks else []
    said += [f"has {_listed(lost.letters)}"] if lost.letters else []
    if correction is not None and correction.form == "reading" and correction.verdict.true:
        return "of the scan" + (f", which {' and '.join(said)}" if said else "")
    return f"of the scan, which {' and '.join(said) or 'has lost a mark'}, and another of the print"


def _in_latex(statement: Statement, form: str) -> str:
    left, right = statement.form(form)
    return f"{latex(left)} {statement.sign} {latex(right)}"


def _listed(words: Sequence[str]) -> str:
    """As one says it: a, b and c."""
    *others, last = words
    return f"{', '.join(others)} and {last}" if others else last


def repairs_of(book: Chapter, decisions: Decisions, standing: Callable[[Statement], str], search: Search) -> Repairs:
    """The repairs of all prints that do not stand, by the name of the statement."""
    beside = [entry.statement for entry in book if isinstance(entry.statement, Statement)]
    return {
        entry.name: search(entry.statement, standing, PATIENCE, beside)
        for entry in book
        if not decisions[entry.name].verdict.true and isinstance(entry.statement, Statement)
    }
