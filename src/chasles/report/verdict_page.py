"""The Markdown pages on the chapter: the verdict on every number, a line for each, and the errata."""

from __future__ import annotations

from collections.abc import Iterator

from chasles.decisions.decision import WORST_FIRST
from chasles.decisions.session import Session
from chasles.report.details import number_in_words
from chasles.report.equations import in_both
from chasles.report.errata_page import errata_page
from chasles.report.findings import (
    Decided,
    DecisionsByName,
    Pairs,
    Replacement,
    numbers_of,
    ordered,
    replaced_by,
    replacements,
    slips_in_words,
)
from chasles.report.markdown import escaped, table
from chasles.report.waiting import progress
from chasles.report.words import VERDICTS, counted, number_of
from chasles.statements import Chapter, Section

HEAD = ("number", "role", "verdict", "needs", "right instead")
ABOUT = """\
# Verdicts

Every equation of the chapter with its verdict. A number with several equations has the worst of
their verdicts. *Holds* is proved, for all values of the symbols; *holds under* is proved from the hypotheses in the
column *needs*; *fails* is refuted by an exact counterexample; what is *ill-formed* does not fit together as printed.
Definitions are *defined*, conditions *posed* (a point satisfies them), postulates *assumed*. Where the printed
equation is wrong, the last column says what is right, and whether the search for a repair found it or it had to be
declared: then it is marked as a gap of the search. [ERRATA.md](ERRATA.md) says why each of these is wrong.

`chasles emit` writes this page; `chasles decide` decides again."""


def pages(book: Chapter, session: Session) -> dict[str, str]:
    """The text of `VERDICTS.md` and `ERRATA.md`; what the session has decided already is not decided again."""
    decided = progress(session.decide_all(book), len(book.entries), "Deciding")
    decisions = {entry.name: decision for entry, decision in decided}
    return {"VERDICTS.md": verdict_page(book, decisions), "ERRATA.md": errata_page(book, decisions)}


def verdict_page(book: Chapter, decisions: DecisionsByName) -> str:
    """The page on the whole chapter; the same decisions and repairs give the same text."""
    decided = ordered(book, decisions)
    lines = [ABOUT, "", *_totals(book, decided)]
    for section, groups in _sections(decided):
        lines += ["", f"## {section.number} {escaped(section.title)}", ""]
        lines += table(HEAD, (_row(number, group) for number, group in groups.items()))
    return "\n".join(lines) + "\n"


def _totals(book: Chapter, decided: Pairs) -> Iterator[str]:
    count = numbers_of(book)
    earlier = f", {count.earlier} of earlier chapters," if count.earlier else ""
    yield f"{count.own} numbered equations{earlier} and {count.others} theorems, displays and exercises without one,"
    yield f"in {number_of(len(decided), 'statement')}: {counted(d.verdict for _, d in decided)}."
    found = replaced_by(decided)
    if wrong := found.total():
        yield (
            f"{wrong} {'is' if wrong == 1 else 'are'} not true as printed: {slips_in_words(decided)}. "
            f"{found['repair']} are repaired by the search, {found['declared']} by what is declared, "
            f"{found['nothing']} by nothing."
        )


def _sections(decided: Pairs) -> Iterator[tuple[Section, dict[str, list[Decided]]]]:
    """The statements of each section by their number."""
    sections: dict[Section, dict[str, list[Decided]]] = {}
    for entry, decision in decided:
        sections.setdefault(entry.section, {}).setdefault(entry.number, []).append((entry, decision))
    yield from sections.items()


def _row(number: str, group: list[Decided]) -> tuple[str, ...]:
    roles = dict.fromkeys(entry.statement.role for entry, _ in group)
    worst = min((decision.verdict.name for _, decision in group), key=WORST_FIRST.index)
    needs = dict.fromkeys(text for _, decision in group for text in decision.verdict.needs)
    parts = [
        (f"part {entry.statement.part}: " if len(group) > 1 else "") + _instead(replacements(entry, decision))
        for entry, decision in group
        if not decision.verdict.true
    ]
    verdict = VERDICTS[worst][2]
    return (
        escaped(number_in_words(number)),
        ", ".join(roles),
        verdict if worst not in WORST_FIRST[:4] else f"**{verdict}**",
        escaped(", ".join(needs)),
        "; ".join(parts),
    )


def _instead(found: tuple[Replacement, ...]) -> str:
    if not found:
        return "**nothing: a gap**"
    first = found[0]
    needs = ", ".join(first.verdict.needs)
    how = "found by repair" if first.found == "repair" else "declared: a gap of the search"
    others = f", with {len(found) - 1} more" if len(found) > 1 else ""
    says, _ = in_both((first.left, first.right), first.sign)
    return f"{escaped(says)} ({how}{others}{escaped(f'; under {needs}' if needs else '')})"
