"""The only place that touches the product: how a question is asked, and how its answer is checked again."""

from __future__ import annotations

from dataclasses import dataclass
from typing import Any

from chasles.prove import Rejected, Untreatable, prove, recheck

from .equations import Equation

__all__ = ["PATIENCE", "Answer", "ask", "rejection"]

PATIENCE = 3.0
"""Seconds for one question: what is undecided is counted and is no alarm."""


@dataclass(frozen=True)
class Answer:
    """What came back: a verdict by name, "untreatable", or "crash" with the exception in words."""

    name: str
    verdict: Any = None
    words: str = ""

    @property
    def needs(self) -> tuple[str, ...]:
        return tuple(getattr(self.verdict, "needs", ()))

    @property
    def true(self) -> bool:
        return self.name in ("holds", "holds-under")


def ask(question: Equation) -> Answer:
    """The product's answer; an exception other than a refusal is a crash."""
    try:
        verdict = prove(question.lhs, question.rhs, question.given, question.nonzero, budget=PATIENCE)
    except Untreatable as refused:
        return Answer("untreatable", None, str(refused))
    except Exception as error:
        return Answer("crash", None, f"{type(error).__name__}: {error}")
    return Answer(verdict.name, verdict)


def rejection(question: Equation, verdict: Any) -> str | None:
    """Why the checker does not accept the verdict on the question; None if it does."""
    try:
        recheck(verdict, question.lhs, question.rhs, question.given, question.nonzero)
    except Rejected as reason:
        return f"Rejected: {reason}"
    except Exception as error:
        return f"crash: {type(error).__name__}: {error}"
    return None
