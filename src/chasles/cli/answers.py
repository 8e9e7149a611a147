"""What a chapter brings along: the answers on its statements, its derivations, and what its exercises state."""

from __future__ import annotations

from collections.abc import Callable, Iterator
from functools import partial
from typing import Any

from chasles.cli.derivations import all_derivations
from chasles.decisions.memory import Memory
from chasles.decisions.session import Session
from chasles.decisions.shipped import ANSWERS, as_text
from chasles.deriving import walk
from chasles.report.waiting import progress
from chasles.statements import Chapter
from chasles.statements.exercises import sentences_of_exercises


def answers(book: Chapter, session: Session) -> dict[str, str]:
    """The file of the answers, by its name: each stands with what asks for it first, in the order of the book.

    All is asked again of a session that knows only what is kept, so that what a check needs is kept too.
    """
    finding = list(_asking(book, session))
    for _, ask in progress(iter(finding), len(finding), "Deriving"):
        ask()
    memory = Memory(session.memory.everything)
    asking = list(_asking(book, Session(book=book, memory=memory)))
    known: set[str] = set()
    groups: dict[str, dict[str, Any]] = {}
    for name, ask in asking:
        memory.asked.clear()
        ask()
        new = [key for key in memory.asked if memory.knows(key) and key not in known]
        known.update(new)
        if new:
            groups[name] = {key: memory.data_of(key) for key in new}
    return {ANSWERS: as_text(groups)}


def _asking(book: Chapter, session: Session) -> Iterator[tuple[str, Callable[[], object]]]:
    """What asks questions: by name, and how it does."""
    for entry in book:
        yield f"({entry.number}) {entry.name}", partial(session.decide, entry.statement)
    for name, derivation in all_derivations(book).items():
        yield f"road {name}", partial(walk, derivation, session)
    for name, sentence in sentences_of_exercises(book.package).items():
        yield f"exercise {name}", partial(session.decide, sentence)
