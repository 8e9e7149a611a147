"""`chasles.decide`, `chasles.repair` and `chasles.derive`: the book asked by number.

Answers that come with the chapter, or were found before, are checked; new ones are searched for, and remembered.
"""

from __future__ import annotations

from functools import cache

from chasles.decisions.decision import Decisions
from chasles.decisions.recalled import retained, session_of
from chasles.decisions.session import Session
from chasles.deriving import CheckedDerivation, walk
from chasles.repairs.repair import Repair
from chasles.several import Several
from chasles.statements import Chapter, load
from chasles.statements.citing import UnknownNumber, derivations_cited, statements_cited
from chasles.statements.derivations import declared_derivations
from chasles.statements.packages import BOOK

Named = str | Chapter
"""A chapter, or what `chasles.load` reads one from."""


def decide(number: str, chapter: Named = BOOK) -> Decisions:
    """The decisions on what has this number, part by part: the verdict, and what is right instead where it is wrong.

    Args:
        number: as the book cites it, "3.18", "(3.18)" or "Thm 3.2.2"; "3.4/2" is one part; or the name of a statement.
        chapter: another chapter than the book: what `chasles.load` reads, or its package or folder.

    Raises:
        LookupError: if the chapter has no such number; those near it are named.
        TypeError: for a number that is no text.
    """
    book, session = _asked(number, chapter)
    decided = Decisions(session.decide(entry.statement) for entry in statements_cited(book, [number]))
    retained(session.memory)
    return decided


def repair(number: str, chapter: Named = BOOK) -> Several[Repair]:
    """The nearest true equations to one that is wrong, the nearest first; none where it is right as printed.

    Takes what `decide` takes, and raises what it raises.
    """
    corrections = (decision.correction for decision in decide(number, chapter) if not decision.verdict.true)
    return Several(found for correction in corrections if correction is not None for found in correction.repairs)


def derive(number: str, chapter: Named = BOOK) -> CheckedDerivation:
    """A derivation of an equation: each step's result is computed and decided, the last compared with the printed one.

    Takes what `decide` takes, and the name of a derivation. Raises LookupError if none leads there, or several do,
    which are named.
    """
    book, session = _asked(number, chapter)
    found = derivations_cited(declared_derivations(book.package), [number])
    if len(found) > 1:
        raise UnknownNumber(f"{len(found)} derivations lead to {number}: name one of {', '.join(found)}")
    [derivation] = found.values()
    walked = walk(derivation, session)
    retained(session.memory)
    return walked


def __getattr__(name: str) -> Chapter:
    if name == "chapter":
        return _loaded(BOOK)
    raise AttributeError(f"module 'chasles.asking' has no attribute {name!r}")


def _asked(number: str, chapter: Named) -> tuple[Chapter, Session]:
    """The chapter, and the session that decides its statements."""
    if not isinstance(number, str):
        raise TypeError(f"a number is given as text, since 3.1 is not 3.10: {str(number)!r}, and not {number!r}")
    book = chapter if isinstance(chapter, Chapter) else _loaded(chapter)
    known = _sessions.get(id(book))
    if known is None:
        known = _sessions[id(book)] = (book, session_of(book))
    return known


_sessions: dict[int, tuple[Chapter, Session]] = {}
_loaded = cache(load)
