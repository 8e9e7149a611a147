"""The chapter, decided once in a process, for all tests that only ask for verdicts; claims decided one by one.

Who changes what decides makes a session of its own: whatever is decided here stays.
"""

from __future__ import annotations

import json
from functools import cache
from typing import Any

from chasles.checker.certificate import check
from chasles.checker.refutation import check_counterexample
from chasles.decisions.session import Session
from chasles.statements import Claim, Hypothesis, Statement, Theorem, load, problem_of
from chasles.statements.posing import default_sides
from chasles.statements.premises import with_all_premises
from chasles.verdict import Fails, Holds, HoldsUnder
from chasles.vocabulary.nodes import lifted

__all__ = ["chapter_session", "claim", "proved", "refuted"]


@cache
def chapter_session() -> Session:
    """A session that has decided every statement of the chapter, and recalled nothing from elsewhere."""
    session = Session(book=load())
    for _ in session.decide_all(load()):
        pass
    return session


def claim(left: Any, right: Any, *assuming: Hypothesis, given: tuple[Statement, ...] = ()) -> Claim:
    """A claim of its own, numbers taken as they are."""
    return Claim("1", lifted(left), lifted(right), assuming=assuming, given=given)


def proved(said: Claim | Theorem) -> Holds | HoldsUnder:
    """The verdict on what holds; its certificate is accepted, as it is read from a file."""
    verdict = Session().decide(said).verdict
    assert isinstance(verdict, Holds | HoldsUnder), verdict
    check(said, "printed", json.loads(json.dumps(verdict.certificate)))
    return verdict


def refuted(said: Claim | Theorem) -> Fails:
    """The verdict on what fails; its point is accepted."""
    verdict = Session().decide(said).verdict
    assert isinstance(verdict, Fails), verdict
    check_counterexample(problem_of(with_all_premises(said, default_sides)), verdict.counterexample)
    return verdict
