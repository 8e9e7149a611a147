"""The worked exercises as the LaTeX document shows them: text escaped, formulas as they are."""

from __future__ import annotations

from collections.abc import Iterable, Iterator
from dataclasses import dataclass

from chasles.report.html.exercises import AnswerView, WorkedStep, WorkedView
from chasles.report.html.shown import Equation
from chasles.report.latex_text import escaped


@dataclass(frozen=True, slots=True)
class Sentence:
    """Words, the formulas below them, and each formula's decimals, which may be empty."""

    says: str
    formulas: tuple[tuple[str, str], ...]


@dataclass(frozen=True, slots=True)
class ExercisePage:
    """An exercise in LaTeX."""

    number: str
    title: str
    outcome: str
    asked: tuple[str, ...]
    assumed: tuple[str, ...]
    steps: tuple[Sentence, ...]
    answers: tuple[Sentence, ...]
    checks: tuple[Sentence, ...]


def exercises_in_latex(worked: Iterable[WorkedView]) -> Iterator[ExercisePage]:
    """The same exercises, for LaTeX."""
    for view in worked:
        yield ExercisePage(
            number=escaped(view.number),
            title=escaped(view.title),
            outcome=escaped(view.outcome),
            asked=tuple(map(escaped, view.asked)),
            assumed=tuple(map(escaped, view.assumed)),
            steps=tuple(map(_step, view.steps)),
            answers=tuple(map(_answer, view.answers)),
            checks=tuple(map(_step, view.checks)),
        )


def _step(step: WorkedStep) -> Sentence:
    cites = "; ".join(link.words for link in step.cites)
    return Sentence(escaped(f"{step.says} {cites}".strip()), tuple(map(_formula, step.equations)))


def _answer(answer: AnswerView) -> Sentence:
    words = "; ".join(answer.words)
    return Sentence(
        escaped(f"{answer.name}, {answer.says}: {words}".rstrip(": ")), tuple(map(_formula, answer.equations))
    )


def _formula(equation: Equation) -> tuple[str, str]:
    return equation.latex, escaped(equation.label.removeprefix("≈ "))
