"""Is a student's answer right? Part by part, by exact equality, in whatever form and with either sign of an axis."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass
from itertools import product
from typing import Any

import sympy as sp

from chasles.exact.data import DataError
from chasles.exact.draw import Draw
from chasles.exact.evaluate import DividesByZero, NoValue, matrix_of
from chasles.exact.grammar import NotANumber, read_number
from chasles.exact.numbers import is_zero, normal
from chasles.exact.sheet import Sheet, equal
from chasles.exact.solving import solved_on_sheet
from chasles.statements.exercise import Exercise
from chasles.vocabulary import Call

__all__ = ["Grade", "grade", "new_data"]


@dataclass(frozen=True, slots=True)
class Grade:
    """What is right and what is wrong, by the names of the answers, what is missing, and what a wrong one violates."""

    right: tuple[str, ...]
    wrong: tuple[str, ...]
    missing: tuple[str, ...]
    violated: tuple[str, ...]

    @property
    def passed(self) -> bool:
        return not self.wrong and not self.missing


def new_data(exercise: Exercise, seed: int) -> dict[str, Any]:
    """New data for an exercise, as a data file has them. Raises DataError for an exercise without numbers."""
    if exercise.instance is None:
        raise DataError(f"exercise {exercise.number} has no data to practise with")
    drawn: dict[str, Any] = exercise.instance(Draw(f"{exercise.number} {seed}"))
    return drawn


def grade(exercise: Exercise, data: Mapping[str, Any], given: Mapping[str, Any]) -> Grade:
    """The grade of a student's answers for these data.

    Numbers are read by the grammar of data. Raises DataError for a name that is no answer, and for what is no number.
    """
    solution, sheet = solved_on_sheet(exercise, data)
    expected = {"status": solution.status, **solution.answers}
    for name in given:
        if name not in expected:
            raise DataError(f"{name!r} is no answer of exercise {exercise.number}: {', '.join(expected)} are")
    answers = {name: _read(value, expected[name], name) for name, value in given.items()}
    wrong = _fewest_wrong(exercise, expected, answers)
    return Grade(
        tuple(name for name in answers if name not in wrong),
        tuple(wrong),
        tuple(name for name in solution.answers if name not in answers),
        tuple(_violated(exercise, sheet, answers)) if wrong else (),
    )


def _fewest_wrong(exercise: Exercise, expected: Mapping[str, Any], answers: Mapping[str, Any]) -> list[str]:
    """What is wrong under the choice of signs under which least is."""
    choices = product((1, -1), repeat=len(exercise.signs))
    return min((_wrong(exercise, expected, answers, turns) for turns in choices), key=len)


def _wrong(
    exercise: Exercise, expected: Mapping[str, Any], answers: Mapping[str, Any], turns: tuple[int, ...]
) -> list[str]:
    turned = {name: turn for group, turn in zip(exercise.signs, turns, strict=True) for name in group}
    return [
        name
        for name, value in answers.items()
        if not _same(turned.get(name, 1), expected[name], value, name in exercise.turns)
    ]


def _same(turn: int, expected: Any, value: Any, is_angle: bool) -> bool:
    """Whether the answer is the expected one, or its opposite; of angles, whole turns apart."""
    match expected:
        case None | bool() | str():
            return bool(expected == value)
        case dict():
            return set(expected) == set(value) and all(_same(turn, expected[k], value[k], is_angle) for k in expected)
        case list():
            return len(expected) == len(value) and all(
                _same(turn, a, b, is_angle) for a, b in zip(expected, value, strict=True)
            )
        case sp.MatrixBase():
            return not isinstance(value, str | dict | list) and value is not None and equal(expected * turn, value)
    if is_angle:
        return bool((normal(value - turn * expected) / (2 * sp.pi)).is_integer)
    return value is not None and is_zero(value - turn * expected)


def _violated(exercise: Exercise, sheet: Sheet, answers: Mapping[str, Any]) -> list[str]:
    """What the student's answers, substituted into what was asked, do not satisfy."""
    values = {node: answers[name] for name, nodes in exercise.symbols.items() if name in answers for node in nodes}
    for node in sheet.values:
        if isinstance(node, Call) and node.argument in values:
            values[node] = getattr(sp, node.function)(values[node.argument])
    found = []
    for left, right, at, says in sheet.tests:
        sides = (sheet.value(side, {**at, **values}) for side in (left, right))
        try:
            if not equal(*sides):
                found.append(says)
        except (DividesByZero, NoValue, ValueError):
            found.append(says)
    return found


def _read(value: Any, expected: Any, name: str) -> Any:
    """A student's answer, in the shape of the expected one."""
    match value, expected:
        case (None | bool(), _) | (str(), str()):
            return value
        case str(), sp.MatrixBase():
            return value
        case dict(), dict():
            return {key: _read(part, expected.get(key), f"{name}.{key}") for key, part in value.items()}
        case list(), sp.MatrixBase():
            rows = [row if isinstance(row, list) else [row] for row in value]
            if [len(row) for row in rows] != [expected.shape[1]] * expected.shape[0]:
                raise DataError(f"{name}: expected {expected.shape[0]} x {expected.shape[1]} numbers")
            return matrix_of([[_read(entry, 0, name) for entry in row] for row in rows])
        case list(), list():
            parts = expected if len(expected) == len(value) else [expected[0] if expected else 0] * len(value)
            return [_read(part, like, name) for part, like in zip(value, parts, strict=True)]
        case str(), _:
            try:
                return normal(read_number(value))
            except NotANumber as error:
                raise DataError(f"{name}: {error}") from None
        case _:
            if isinstance(value, list | dict) or not hasattr(value, "__abs__"):
                raise DataError(f"{name}: expected {'a number' if not isinstance(expected, str) else 'a word'}")
            return normal(read_number(str(value)))
