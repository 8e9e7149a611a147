"""The languages in which questions are asked, each with its generator, its judge and its ways to shrink."""

from __future__ import annotations

from collections.abc import Callable, Iterator
from dataclasses import dataclass
from itertools import islice
from random import Random
from typing import Any

from . import motions, scalars
from .asking import ask
from .equations import Equation, points
from .forging import accepted_forgery
from .judging import Alarm, Judged, judge, violations
from .shrinking import smaller
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
    if draw.random() < TWISTED:
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


def _turned(question: Equation, found: Judged, draw: Random) -> Alarm | None:
    """Whether a variant of the question has the opposite answer, or an answer that is wrong by itself."""
    ways = list(twisted(question, draw))
    for what, other in draw.sample(ways, min(2, len(ways))):
        answer = ask(other)
        if answer.name == "crash":
            return Alarm("crash", f"{what}: {other}: {answer.words}")
        names = {(found.answer.true and "holds") or found.answer.name, (answer.true and "holds") or answer.name}
        if names in ({"holds", "fails"}, {"contradictory", "holds"}, {"contradictory", "fails"}):
            return Alarm("turned", f"{found.answer.name}, and {what}: {answer.name}: {other}")
    return None


LANGUAGES: dict[str, Language] = {
    "scalars": Language(scalars.question, judged_again, smaller, Equation.source),
    "motions": Language(motions.question, judged_again, smaller, Equation.source),
}
