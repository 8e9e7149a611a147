"""What a chapter brings along: its derivations, the answers on its statements, and what its exercises state."""

from __future__ import annotations

from collections.abc import Callable, Iterator, Sequence
from functools import partial
from typing import Any

from chasles.cli.failures import BAD_INPUT, Failure, failing
from chasles.decisions.memory import Memory
from chasles.decisions.recalled import ANSWERS, as_text
from chasles.decisions.session import Session
from chasles.deriving import walk
from chasles.report.waiting import progress
from chasles.statements import Chapter, DeclarationError
from chasles.statements.citing import UnknownNumber, derivations_cited
from chasles.statements.derivation import Derivation
from chasles.statements.derivations import declared_derivations
from chasles.statements.exercises import sentences_of_exercises
from chasles.vocabulary.arguments import WrongArgument


def all_derivations(book: Chapter) -> dict[str, Derivation]:
    """The derivations by name, in the book's order. Raises Failure for declarations that contradict each other."""
    contradict = failing(DeclarationError, before="the declarations contradict each other: ", status=BAD_INPUT)
    with contradict, failing(WrongArgument, status=BAD_INPUT):
        return declared_derivations(book.package)


def chosen_derivations(book: Chapter, words: Sequence[str]) -> dict[str, Derivation]:
    """The derivations that end at these numbers, or compare with them where none ends there; all without a number.

    Raises Failure naming a number that no derivation leads to, and those near it, and where the book has none.
    """
    known = all_derivations(book)
    if not known:
        raise Failure(f"{book.package} declares no derivations: those in its package `roads` would be taken", BAD_INPUT)
    if not words:
        return known
    try:
        return derivations_cited(known, words)
    except UnknownNumber as error:
        raise Failure(f"{error}; `chasles derive` lists all derivations", BAD_INPUT) from error


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
