"""The Markdown pages on the chapter, each by the name of its file."""

from __future__ import annotations

from chasles.decisions.session import Session
from chasles.report.errata_page import errata_page
from chasles.report.verdict_page import verdict_page
from chasles.report.waiting import progress
from chasles.statements import Chapter


def pages(book: Chapter, session: Session) -> dict[str, str]:
    """The text of `VERDICTS.md` and `ERRATA.md`; what the session has decided already is not decided again."""
    decided = progress(session.decide_all(book), len(book.entries), "Deciding")
    decisions = {entry.name: decision for entry, decision in decided}
    return {
        "VERDICTS.md": verdict_page(book, decisions),
        "ERRATA.md": errata_page(book, decisions),
    }
