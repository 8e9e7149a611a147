"""The errata: each equation that is wrong as printed, why, and what is right, as a Markdown page for its author."""

from __future__ import annotations

from collections.abc import Iterable, Iterator

from chasles.decisions.session import Decision
from chasles.report.by_hand import Refutation, refutations
from chasles.report.details import number_in_words
from chasles.report.equations import in_both, in_latex, in_words
from chasles.report.findings import (
    SLIPS,
    DecisionsByName,
    Replacement,
    likely_slip,
    ordered,
    replacements,
    slips,
    slips_in_words,
)
from chasles.report.markdown import code, displayed, escaped
from chasles.report.words import entry_in_words, point_in_words
from chasles.statements import Chapter, Entry, Statement
from chasles.statements.elsewhere import chapter_of, cited
from chasles.verdict import IllFormed

ABOUT = """\
# Errata

Each equation of the chapter that is wrong as printed: the printed equation, why it is wrong, and what is right. A
counterexample is exact and can be evaluated by hand: every symbol that is not named in it may have any value that
satisfies the hypotheses. What is said to be right is proved.

`chasles emit` writes this page; [VERDICTS.md](VERDICTS.md) has all the other equations."""


def errata_page(book: Chapter, decisions: DecisionsByName) -> str:
    """The page on all equations that are wrong as printed; the same decisions and repairs give the same text."""
    decided = ordered(book, decisions)
    found = slips(decided)
    wrong = sum(map(len, found.values()))
    are = "is" if wrong == 1 else "are"
    count = f"{wrong} of {len(decided)} statements {are} not true as printed: {slips_in_words(decided)}."
    lines = [ABOUT, "", *([f"The book: {book.source}.", ""] if book.source else ())]
    lines += [count if found else "There are none."]
    for slip, pairs in found.items():
        lines += ["", f"## {SLIPS[slip].capitalize()}"]
        for entry, decision in pairs:
            lines += ["", *_slip(entry, decision)]
    return "\n".join(lines) + "\n"


def _slip(entry: Entry, decision: Decision) -> Iterator[str]:
    number = number_in_words(entry.number, entry.statement.part)
    yield f"### {escaped(number)}"
    yield ""
    yield f"Section {entry.section.number}. {escaped(entry.statement.says)}"
    yield ""
    yield "Printed:"
    yield ""
    for words, formula in zip(in_words(entry.statement), in_latex(entry.statement), strict=True):
        yield from _equation(words, formula)
    yield from _why(decision)
    found = replacements(entry, decision)
    if not found:
        yield from ("No correct form has been found.", "")
    for place, replacement in enumerate(found):
        yield from _instead(replacement, first=place == 0)
    yield likely_slip(entry, decision)


def _why(decision: Decision) -> Iterator[str]:
    if isinstance(decision.verdict, IllFormed):
        yield from (f"It does not fit together: {escaped(decision.verdict.reason)}.", "")
    for refuted in refutations(decision):
        if refuted.form == "printed":
            yield "It fails:"
        else:
            yield "With the marks that the scan may have lost, it reads" if refuted.form == "reading" else "Corrected:"
            yield ""
            yield from _equation(*in_both(refuted.statement.printed, refuted.statement.sign))
            yield "and fails:"
        yield ""
        yield from _by_hand(refuted, chapter_of(decision.statement))
        yield ""


def _by_hand(refuted: Refutation, here: str) -> Iterator[str]:
    """The values, the left side and the right side there, and by which definitions."""
    found, by_hand = refuted.found, refuted.by_hand
    which = entry_in_words(found, refuted.statement)
    so = f", so that {code(point_in_words(by_hand.values))}" if by_hand.values else ""
    if found.goal:
        yield f"- {escaped(found.goal)}:"
    yield f"- at {code(point_in_words(found.at) or 'every point')}{so}"
    yield f"- the left side is {code(found.left)}{which and f' in {which}'}{_by(by_hand.left, here)}"
    yield f"- the right side is {code(found.right)}{_by(by_hand.right, here)}"


def _by(definitions: Iterable[Statement], here: str) -> str:
    listed = ", ".join(_definition(each, here) for each in definitions)
    return f", by {listed}" if listed else ""


def _definition(given: Statement, here: str) -> str:
    """The number of a definition; if the book does not number it, what it says."""
    if given.number[0].isdigit():
        return escaped(cited(given, here))
    return code(in_both(given.printed, given.sign)[0])


def _instead(replacement: Replacement, *, first: bool) -> Iterator[str]:
    yield "Right is" if first else "or"
    yield ""
    yield from _equation(*in_both((replacement.left, replacement.right), replacement.sign))
    freedom = f" {escaped(replacement.modulo)}." if replacement.modulo else ""
    yield f"which {escaped(replacement.in_words)}. {replacement.who_found}{freedom}"
    if replacement.changes:
        yield ""
        yield from (f"- {escaped(change)}" for change in replacement.changes)
    yield ""


def _equation(words: str, formula: str) -> Iterator[str]:
    yield displayed(formula)
    yield ""
    yield code(words)
    yield ""
