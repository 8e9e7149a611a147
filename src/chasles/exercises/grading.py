"""Grading of a student's answers: part by part, by exact equality, in any form and up to what the exercise leaves open.

Equality is decided, or the part is undecided: no decimals make an answer right, unless a tolerance is asked for.
"""

from __future__ import annotations

from collections.abc import Iterator, Mapping
from dataclasses import dataclass, field
from itertools import permutations
from typing import Any

import sympy as sp

from chasles.exact.evaluate import DividesByZero, NoValue
from chasles.exact.numbers import NotDecided
from chasles.exact.spelling import text_of
from chasles.exact.tower import TooManyRoots
from chasles.exercises.agreement import Equality, agree, are_along_axes, in_lists, opposite
from chasles.exercises.answers import asked_for, read_answers
from chasles.exercises.data import DataError, exact_number
from chasles.exercises.draw import Draw
from chasles.exercises.solution import Solution, cited
from chasles.exercises.solving import solved_on_sheet
from chasles.exercises.worksheet import Worksheet, equal
from chasles.statements.exercise import Exercise
from chasles.vocabulary import Call

MOST_REORDERED = 4
MOST_STEPS = 3


@dataclass(frozen=True, slots=True, repr=False)
class Grade:
    """What is right, what is wrong and what nothing decides, by the names of the answers, and what is missing.

    `violated` says what a wrong answer does not satisfy, `feedback` which steps give each wrong one.
    """

    right: tuple[str, ...]
    wrong: tuple[str, ...]
    missing: tuple[str, ...]
    violated: tuple[str, ...]
    undecided: tuple[str, ...] = ()
    feedback: Mapping[str, tuple[str, ...]] = field(default_factory=dict)

    @property
    def passed(self) -> bool:
        """Whether no part is wrong, missing or undecided."""
        return not self.wrong and not self.missing and not self.undecided

    @property
    def score(self) -> float:
        """The right parts among all, from 0 to 1."""
        parts = sum(map(len, (self.right, self.wrong, self.missing, self.undecided)))
        return len(self.right) / parts if parts else 1.0

    @property
    def in_words(self) -> Iterator[str]:
        """The lines in which it is told."""
        for word in ("right", "wrong", "undecided", "missing"):
            if names := getattr(self, word):
                yield f"{word}: {', '.join(names)}"
        if not self.passed:
            yield f"score: {self.score:.0%}"
        yield from (f"not satisfied: {says}" for says in self.violated)

    def __repr__(self) -> str:
        return "\n".join(self.in_words)

    def as_data(self) -> dict[str, Any]:
        """What `chasles practice --json` prints of it."""
        names = {name: list(getattr(self, name)) for name in ("right", "wrong", "undecided", "missing", "violated")}
        feedback = {name: list(says) for name, says in self.feedback.items()}
        return {"passed": self.passed, "score": round(self.score, 6), **names, "feedback": feedback}


def new_data(exercise: Exercise, seed: int) -> dict[str, Any]:
    """New data for an exercise, as a data file has them. Raises DataError for an exercise without numbers."""
    if exercise.instance is None:
        raise DataError(f"exercise {exercise.number} has no data to practise with: it has no `instance`")
    drawn: Any = exercise.instance(Draw(f"{exercise.number} {seed}"))
    if not isinstance(drawn, dict) or not drawn.keys() <= {*exercise.keys}:
        got = f"data named {', '.join(map(str, drawn))}" if isinstance(drawn, dict) else f"{drawn!r}"
        raise DataError(
            f"`instance` of exercise {exercise.number} returns {got}, and must return draw.written(...) "
            f"of what the exercise takes: {', '.join(exercise.keys)}"
        )
    return drawn


def grade(exercise: Exercise, data: Mapping[str, Any], given: Mapping[str, Any], rtol: Any = None) -> Grade:
    """The grade of a student's answers for these data; with `rtol`, numbers are right that are as near as that.

    Numbers are read by the grammar of data. A number is near if it differs by at most `rtol` times the largest number
    in that answer, or times one where that is zero; angles are compared up to whole turns. Raises DataError for a name
    that is no answer of the exercise, and for what does not have the shape of that answer.
    """
    return graded(exercise, solved_on_sheet(exercise, data), given, rtol)


def graded(exercise: Exercise, solved: tuple[Solution, Worksheet], given: Mapping[str, Any], rtol: Any = None) -> Grade:
    """The same where the exercise has been solved for these data."""
    solution, sheet = solved
    tolerance = None if rtol is None else exact_number(rtol, "rtol")
    if tolerance is not None and not (tolerance.is_Rational and 0 < tolerance < 1):
        raise DataError(f"rtol: expected a number between 0 and 1, and got {rtol}")
    answers = read_answers(exercise, given)
    verdicts = _GradedAnswer(exercise, solution, sheet, tolerance).verdicts(answers)
    of: dict[bool | None, list[str]] = {True: [], False: [], None: []}
    for name in answers:
        of[verdicts[name]].append(name)
    feedback = {name: found for name in of[False] if (found := _sources(solution, name))}
    violated = _violated(exercise, sheet, answers) if of[False] and tolerance is None else []
    return Grade(
        tuple(of[True]),
        tuple(of[False]),
        _missing(exercise, sheet.data, answers),
        tuple(dict.fromkeys([*violated, *(f"{name}: {says}" for name in feedback for says in feedback[name])])),
        tuple(of[None]),
        feedback,
    )


def _missing(exercise: Exercise, data: Mapping[str, Any], answers: Mapping[str, Any]) -> tuple[str, ...]:
    """What was to be answered, by what the student says is the case: this does not tell what is."""
    claimed = [answers["status"]] if "status" in answers else exercise.statuses
    asked = [names for status in claimed if (names := asked_for(exercise, data, status)) >= set(answers) - {"status"}]
    certain = [name for name in (answer.name for answer in exercise.answers) if all(name in names for names in asked)]
    left = tuple(name for name in certain if asked and name not in answers)
    return left or (("status",) if len(set(asked)) > 1 else ())


def _sources(solution: Solution, name: str) -> tuple[str, ...]:
    """The steps whose equations give the answer: by its name if one does, else those that come to its value."""
    value = solution.answers.get(name)
    if value is None:
        return ()
    parts = [value, *value] if isinstance(value, list) else [value]
    endings = tuple(f" = {text_of(part)}" for part in parts)
    steps = [step for step in solution.steps if any(line.text.endswith(endings) for line in step.lines)]
    named = [step for step in steps if any(line.text.startswith(f"{name} = ") for line in step.lines)]
    return tuple(f"{step.says} {cited(step.cites)}".rstrip() for step in (named or steps)[:MOST_STEPS])


@dataclass(frozen=True)
class _GradedAnswer:
    exercise: Exercise
    solution: Solution
    sheet: Worksheet
    tolerance: Any

    def verdicts(self, answers: dict[str, Any]) -> dict[str, bool | None]:
        """Of each answer, under the choice of signs, orders and alternatives under which least is wrong."""
        expected = {name: in_lists(value) for name, value in self.solution.answers.items()}
        expected["status"] = self.solution.status
        given = {name: in_lists(value) for name, value in answers.items()}
        found = {name: name in expected and self._verdict(name, expected, given[name]) for name in given}
        try:
            for choices in self._choices(expected, answers):
                for choice in choices:
                    before = _badness({name: found[name] for name in choice if name in given})
                    if not any(before):
                        break
                    known = {**expected, **choice}
                    other = {name: self._verdict(name, known, given[name]) for name in choice if name in given}
                    if _badness(other) < before:
                        found |= other
        except (NotDecided, TooManyRoots):
            return {name: verdict or None for name, verdict in found.items()}
        return found

    def _choices(self, expected: Mapping[str, Any], answers: dict[str, Any]) -> Iterator[list[dict[str, Any]]]:
        """For each group of answers, what they may be instead, all together."""
        for group in self.exercise.signs:
            yield [{name: opposite(expected[name]) for name in group if name in expected}]
        for group in self.exercise.orders:
            lists = {name: expected[name] for name in group if isinstance(expected.get(name), list)}
            size = max(map(len, lists.values()), default=0)
            orders = permutations(range(size)) if 1 < size <= MOST_REORDERED else ()
            yield [{name: [whole[k] for k in order] for name, whole in lists.items()} for order in orders]
        if self.exercise.alternatives is not None:
            found = self.exercise.alternatives(self.sheet, answers)
            yield [{name: in_lists(value) for name, value in choice.items()} for choice in found]

    def _verdict(self, name: str, expected: Mapping[str, Any], given: Any) -> bool | None:
        if name in self.exercise.axes:
            known = {key: in_lists(value) for key, value in self.sheet.data.items()} | dict(expected)
            matrix, moments = (known[of] for of in self.exercise.axes[name])
            return are_along_axes(matrix, moments, given, Equality(self.tolerance, moments))
        is_angle = name in self.exercise.turns
        return agree(expected[name], given, Equality(self.tolerance, expected[name], is_angle))


def _badness(verdicts: Mapping[str, bool | None]) -> tuple[int, int]:
    marks = list(verdicts.values())
    return marks.count(False), marks.count(None)


def _violated(exercise: Exercise, sheet: Worksheet, answers: Mapping[str, Any]) -> list[str]:
    """What the student's answers, substituted into what was asked, do not satisfy."""
    values = {
        node: answers[name]
        for name, nodes in exercise.symbols.items()
        for node in nodes
        if isinstance(answers.get(name), sp.Basic)
    }
    if not values:
        return []
    for node in sheet.values:
        if isinstance(node, Call) and node.argument in values:
            values[node] = getattr(sp, node.function)(values[node.argument])
    found = []
    for left, right, at, says in sheet.tests:
        try:
            holds = equal(*(sheet.value(side, {**at, **values}) for side in (left, right)))
        except (NotDecided, TooManyRoots):
            continue
        except (DividesByZero, NoValue, ValueError):
            holds = False
        if not holds:
            found.append(says)
    return found
