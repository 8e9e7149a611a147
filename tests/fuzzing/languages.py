"""The languages in which questions are asked, each with its generator, its judge and its ways to shrink."""

from __future__ import annotations

from collections.abc import Callable, Iterator
from dataclasses import dataclass
from itertools import islice
from random import Random
from typing import Any

from chasles.vocabulary import Misfit

from . import declared, inequalities, motions, scalars
from .asking import Answer, ask, ask_statement
from .equations import Equation, points
from .forging import accepted_forgery
from .judging import Alarm, Judged, judge, violations
from .shrinking import smaller
from .statement_judging import judge_statement
from .statement_variants import accepted_forgery_of, smaller_statements, twisted_statements
from .statements import Asked
from .twisting import twisted

__all__ = ["LANGUAGES", "Language", "draw_for", "judged_again"]

TWISTED, FORGED = 0.2, 0.25
"""Shares of the questions that are asked otherwise, and of the proofs that are forged."""


@dataclass(frozen=True)
class Language:
    """How questions of a language are made up, judged, made smaller and printed."""

    question: Callable[[Random], Any]
    judge: Callable[[Any, Random], Judged]
    smaller: Callable[[Any], Iterator[Any]]
    source: Callable[[Any], str]


def draw_for(language: str, seed: int, number: int) -> Random:
    """The random numbers of one question; they depend on nothing else."""
    return Random(f"{language}/{seed}/{number}")


def judged_again(question: Equation, draw: Random) -> Judged:
    """The judgement; some questions are also asked otherwise, and some certificates forged."""
    found = judge(question, draw)
    if found.alarm is not None or found.answer.name in ("untreatable", "undecided"):
        return found
    if not question.where and draw.random() < TWISTED:
        alarm = _turned(question, found, draw)
        if alarm is not None:
            return Judged(found.answer, alarm, found.found)
    if found.answer.true and found.found and draw.random() < FORGED:

        def false(other: Equation) -> bool:
            return next(violations(other, list(islice(points(other, Random(0), 4), 2))), None) is not None

        said = accepted_forgery(question, found.answer.verdict, draw, false)
        if said is not None:
            return Judged(found.answer, Alarm("forgery", said), found.found)
    return found


def statement_judged_again(asked: Asked, draw: Random) -> Judged:
    """The judgement; some statements are also asked otherwise, and some verdicts forged."""
    found = judge_statement(asked, draw)
    if found.alarm is not None or not (found.answer.true or found.answer.name in ("fails", "contradictory")):
        return found
    if draw.random() < TWISTED:
        ways = list(twisted_statements(asked, draw))
        for what, other in draw.sample(ways, min(2, len(ways))):
            alarm = _opposite(found.answer, ask_statement(other.statement), what, other)
            if alarm is not None:
                return Judged(found.answer, alarm, found.found)
    if found.answer.name != "contradictory" and found.found and draw.random() < FORGED:
        try:
            said = accepted_forgery_of(asked, found.answer.verdict, draw)
        except Misfit:
            said = None
        if said is not None:
            return Judged(found.answer, Alarm("forgery", said), found.found)
    return found


def _turned(question: Equation, found: Judged, draw: Random) -> Alarm | None:
    """Whether a variant of the question has the opposite answer."""
    ways = list(twisted(question, draw))
    for what, other in draw.sample(ways, min(2, len(ways))):
        alarm = _opposite(found.answer, ask(other), what, other)
        if alarm is not None:
            return alarm
    return None


def _opposite(one: Answer, other: Answer, what: str, asked: object) -> Alarm | None:
    if other.name == "crash":
        return Alarm("crash", f"{what}: {asked}: {other.words}")
    names = {"holds" if answer.true else answer.name for answer in (one, other)}
    if len(names & {"holds", "fails", "contradictory"}) == 2:
        return Alarm("turned", f"{one.name}, and {what}: {other.name}: {asked}")
    return None


LANGUAGES: dict[str, Language] = {
    "declared": Language(declared.question, statement_judged_again, smaller_statements, Asked.source),
    "scalars": Language(scalars.question, judged_again, smaller, Equation.source),
    "inequalities": Language(inequalities.question, judged_again, smaller, Equation.source),
    "motions": Language(motions.question, judged_again, smaller, Equation.source),
}
