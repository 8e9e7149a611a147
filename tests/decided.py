"""The chapter, decided once in a process, for all tests that only ask for verdicts or build on them.

Who changes what decides makes a session of its own: whatever is decided here stays.
"""

from __future__ import annotations

from functools import cache

from chasles.decisions.session import Session
from chasles.statements import load

__all__ = ["chapter_session"]


@cache
def chapter_session() -> Session:
    """A session that has decided every statement of the chapter, and recalled nothing from elsewhere."""
    session = Session(book=load())
    for _ in session.decide_all(load()):
        pass
    return session
