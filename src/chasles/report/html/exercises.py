"""The exercises of the book, worked for their own data: what is asked, steps, answers, checks, pictures."""

from __future__ import annotations

from collections.abc import Iterator, Mapping, Sequence
from dataclasses import dataclass
from itertools import groupby
from typing import Any

from markupsafe import Markup

from chasles.decisions.decision import DoesNotStand
from chasles.decisions.processes import spread
from chasles.exact.spelling import decimal_text, latex_of, text_of
from chasles.exercises.solution import Citation, Formula, Solution, SolutionStep, cited
from chasles.exercises.solving import solve_with
from chasles.report.html.citing import Link, place_of_number, slug
from chasles.report.html.formulas import displayed
from chasles.report.html.pictures import drawn, inline, said_of
from chasles.report.html.shown import Equation
from chasles.statements import Chapter, load
from chasles.statements.exercise import Exercise
from chasles.statements.exercises import exercise, exercise_numbers

AN_EXERCISE = 0.5
"""About how many seconds one takes."""


@dataclass(frozen=True, slots=True)
class AnswerView:
    """What was found: its name, what it is, and the value as a formula, labelled with its decimals, or in `words`."""

    name: str
    says: str
    equations: tuple[Equation, ...]
    words: tuple[str, ...] = ()


@dataclass(frozen=True, slots=True)
class WorkedStep:
    """A step or a check: what is done, the numbers that it uses, the formulas, labelled with their decimals."""

    says: str
    cites: tuple[Link, ...]
    equations: tuple[Equation, ...]


@dataclass(frozen=True, slots=True)
class WorkedView:
    """An exercise with its solution; `pictures` are at most one, `without` says why there is none.

    `unsolved` says why there is no solution.
    """

    place: str
    number: str
    title: str
    outcome: str
    asked: tuple[str, ...]
    assumed: tuple[str, ...]
    given: tuple[tuple[str, str, str], ...]
    steps: tuple[WorkedStep, ...]
    answers: tuple[AnswerView, ...]
    checks: tuple[WorkedStep, ...]
    pictures: tuple[Markup, ...]
    captions: tuple[str, ...]
    without: tuple[str, ...]
    unsolved: str = ""


def worked_exercises(chapter: Chapter) -> tuple[WorkedView, ...]:
    """All exercises of the chapter; none where what it holds is not what its package declares."""
    book = {id(entry.statement) for entry in load(chapter.package)}
    if not all(id(entry.statement) in book for entry in chapter):
        return ()
    return tuple(spread(lambda number: worked_view(chapter, number), exercise_numbers(chapter.package), AN_EXERCISE))


def worked_view(chapter: Chapter, number: str) -> WorkedView:
    """The exercise of that number, solved for its default data, as far as what it rests on is known to be true."""
    asked = exercise(number, chapter.package)
    try:
        solution, unsolved = solve_with(number, {}, chapter.package), ""
    except DoesNotStand as error:
        solution = Solution(asked.number, asked.title, asked.asked, "unsolved", {}, {}, asked.assumed(()), (), ())
        unsolved = str(error)
    return view_of(solution, tuple(_given(asked, solution)), frozenset(chapter.numbers), unsolved)


def view_of(
    solution: Solution,
    given: tuple[tuple[str, str, str], ...] = (),
    known: frozenset[str] | None = None,
    unsolved: str = "",
) -> WorkedView:
    """What is shown of a solution: its data as `given`, and references to the numbers that are `known` on a page.

    Where there is no such page, numbers are cited in words.
    """
    place = f"exercise-{slug(solution.exercise)}"
    pictures, without = _picture(solution, place)
    return WorkedView(
        place=place,
        number=solution.exercise,
        title=solution.title,
        outcome=solution.outcome,
        asked=solution.asked,
        assumed=solution.assumptions,
        given=given,
        steps=tuple(_step(known, step) for step in solution.steps),
        answers=tuple(_answer(name, value, solution.means.get(name, "")) for name, value in solution.answers.items()),
        checks=tuple(_step(known, check) for check in solution.checks),
        pictures=pictures,
        captions=(solution.picture.title,) if solution.picture and pictures else (),
        without=without,
        unsolved=unsolved,
    )


def _given(asked: Exercise, solution: Solution) -> Iterator[tuple[str, str, str]]:
    """The data that have a value: the name of each, what it is, its value as text."""
    for datum in asked.data:
        if (value := solution.given.get(datum.key)) is not None:
            yield datum.key, datum.says, text_of(value)


def _answer(name: str, value: Any, says: str) -> AnswerView:
    if words := tuple(_words(value)):
        return AnswerView(name, says, (), words)
    latex = latex_of(value)
    return AnswerView(name, says, (Equation(displayed(latex), text_of(value), _decimals(decimal_text(value)), latex),))


def _words(value: Any) -> Iterator[str]:
    """The value line by line if it consists of words or truth values, or of what is told of them; else nothing."""
    match value:
        case None | bool() | str() | []:
            yield text_of(value) if value != [] else "none"
        case Mapping() if any(isinstance(part, bool | str) for part in value.values()):
            yield from (f"{key}: {text_of(part)}" for key, part in value.items())
        case [bool(), *_]:
            yield ", ".join(map(text_of, value))
        case [Mapping(), *_]:
            for told in value:
                yield "; ".join(text_of(part).rstrip(".") for part in told.values() if part)


def _step(known: frozenset[str] | None, step: SolutionStep) -> WorkedStep:
    words = (Link("", cited(step.cites)),) if step.cites else ()
    cites = words if known is None else tuple(_cites(known, step.cites))
    return WorkedStep(step.says, cites, tuple(map(_line, step.lines)))


def _line(line: Formula) -> Equation:
    return Equation(displayed(line.latex), line.text, _decimals(line.decimals), line.latex)


def _cites(known: frozenset[str], citations: Sequence[Citation]) -> Iterator[Link]:
    """A reference for each number that the page has."""
    for number, group in groupby(citations, lambda citation: citation.number):
        here = tuple(citation for citation in group if not citation.chapter)
        if here and number in known:
            yield Link(f"#{place_of_number(number)}", cited(here))


def _decimals(text: str) -> str:
    return f"≈ {text}" if text else ""


def _picture(solution: Solution, place: str) -> tuple[tuple[Markup, ...], tuple[str, ...]]:
    """The picture if there is one, or why there is none."""
    if solution.picture is None:
        return (), ()
    picture, name = solution.picture, f"{place}-picture"
    try:
        return (drawn(picture, name, lambda: inline(solution.figure(), name, picture.title, said_of(picture))),), ()
    except ImportError as error:
        return (), (str(error),)
