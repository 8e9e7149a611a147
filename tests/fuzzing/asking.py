"""The only place that touches the product: how a question is asked, and how its answer is checked again."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass
from typing import Any

from chasles.checker.certificate import check
from chasles.checker.refutation import check_counterexample
from chasles.decisions.session import Session
from chasles.prove import Rejected, Untreatable, prove, recheck
from chasles.statements import Statement, Theorem, problem_of
from chasles.statements.posing import default_sides
from chasles.statements.premises import with_all_premises
from chasles.verdict import Fails

from .equations import Equation

__all__ = ["Answer", "answer_of", "ask", "ask_statement", "rejection", "statement_rejection"]


WORK = 3e6
"""Products of terms for one statement."""


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


def answer_of(asked: Callable[[], Any]) -> Answer:
    """What comes of calling the product; an exception other than a refusal is a crash."""
    try:
        verdict = asked()
    except Untreatable as refused:
        return Answer("untreatable", None, str(refused))
    except Exception as error:
        return Answer("crash", None, f"{type(error).__name__}: {error}")
    return Answer(verdict.name, verdict)


def ask(question: Equation) -> Answer:
    """The product's answer to a question."""
    return answer_of(lambda: prove(question.lhs, question.rhs, (*question.given, *question.where), question.nonzero))


def rejection(question: Equation, verdict: Any) -> str | None:
    """Why the checker does not accept the verdict on the question; None if it does."""
    try:
        recheck(verdict, question.lhs, question.rhs, (*question.given, *question.where), question.nonzero)
    except Rejected as reason:
        return f"Rejected: {reason}"
    except Exception as error:
        return f"crash: {type(error).__name__}: {error}"
    return None


def ask_statement(statement: Statement | Theorem) -> Answer:
    """The product's verdict on a declared statement as it stands."""
    try:
        verdict = Session(budget=WORK).decide(statement).verdict
    except Exception as error:
        return Answer("crash", None, f"{type(error).__name__}: {error}")
    return Answer(verdict.name, verdict, getattr(verdict, "reason", ""))


def statement_rejection(statement: Statement | Theorem, verdict: Any) -> str | None:
    """Why the checker does not accept the verdict on a statement; None if it does."""
    try:
        if isinstance(verdict, Fails):
            check_counterexample(problem_of(with_all_premises(statement, default_sides)), verdict.counterexample)
        else:
            check(statement, "printed", verdict.certificate)
    except Rejected as reason:
        return f"Rejected: {reason}"
    except Exception as error:
        return f"crash: {type(error).__name__}: {error}"
    return None
