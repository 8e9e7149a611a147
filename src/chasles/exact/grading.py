"""Is a student's answer right? Part by part, by exact equality, in whatever form and with either sign of an axis."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass
from itertools import permutations, product
from typing import Any

import sympy as sp

from chasles.exact.data import DataError
from chasles.exact.draw import Draw
from chasles.exact.evaluate import DividesByZero, NoValue, matrix_of
from chasles.exact.grammar import NotANumber, read_number
from chasles.exact.numbers import is_zero, normal
from chasles.exact.principal_axes import in_axes
from chasles.exact.roots import Root, X, place_of, same_number
from chasles.exact.sheet import Sheet, equal
from chasles.exact.solution import Solution, cited
from chasles.exact.solving import solved_on_sheet
from chasles.exact.spelling import text_of
from chasles.statements.exercise import Exercise
from chasles.vocabulary import Call

__all__ = ["Grade", "grade", "new_data"]

MOST_REORDERED = 4
MOST_COEFFICIENTS = 13
MOST_STEPS = 3
LONGEST_ANSWER = 2000
"""Characters; what is printed as an answer can be given back as one."""


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
    violated = [*_violated(exercise, sheet, answers), *_sources(solution, wrong)] if wrong else []
    return Grade(
        tuple(name for name in answers if name not in wrong),
        tuple(wrong),
        tuple(name for name in solution.answers if name not in answers),
        tuple(dict.fromkeys(violated)),
    )


def _sources(solution: Solution, wrong: list[str]) -> list[str]:
    """The steps whose equations give what is wrong: by its name if one does, else those that come to its value."""
    found = []
    for name in wrong:
        value = solution.answers.get(name)
        parts = [value, *value] if isinstance(value, list) else [value]
        endings = tuple(f" = {text_of(part)}" for part in parts)
        steps = [step for step in solution.steps if any(line.text.endswith(endings) for line in step.lines)]
        named = [step for step in steps if any(line.text.startswith(f"{name} = ") for line in step.lines)]
        found += [f"{name}: {step.says} {cited(step.cites)}".rstrip() for step in (named or steps)[:MOST_STEPS]]
    return found


def _fewest_wrong(exercise: Exercise, expected: Mapping[str, Any], answers: Mapping[str, Any]) -> list[str]:
    """What is wrong under the choice of signs, and of orders, under which least is."""
    signs = product((1, -1), repeat=len(exercise.signs))
    choices = product(signs, _reordered(exercise, expected))
    return min((_wrong(exercise, known, answers, turns) for turns, known in choices), key=len)


def _reordered(exercise: Exercise, expected: Mapping[str, Any]) -> list[Mapping[str, Any]]:
    """The expected answers with the lists of each group in every order that they have in common."""
    found = [expected]
    for group in exercise.orders:
        lists = {name: expected[name] for name in group if isinstance(expected.get(name), list)}
        size = max(map(len, lists.values()), default=0)
        if 1 < size <= MOST_REORDERED:
            found = [
                {**known, **{name: [whole[k] for k in order] for name, whole in lists.items()}}
                for known in found
                for order in permutations(range(size))
            ]
    return found


def _wrong(
    exercise: Exercise, expected: Mapping[str, Any], answers: Mapping[str, Any], turns: tuple[int, ...]
) -> list[str]:
    turned = {name: turn for group, turn in zip(exercise.signs, turns, strict=True) for name in group}
    return [
        name
        for name, value in answers.items()
        if not (
            _along_axes(expected[exercise.axes[name]], expected[name], value)
            if name in exercise.axes
            else _same(turned.get(name, 1), expected[name], value, name in exercise.turns)
        )
    ]


def _along_axes(matrix: Any, expected: Any, rows: Any) -> bool:
    """Whether the rows are principal axes of the matrix, of any length, normal to each other, in the same order."""
    if not hasattr(rows, "shape") or rows.shape != expected.shape:
        return False
    moments = (in_axes(matrix, expected), expected * expected.T)
    found = (in_axes(matrix, rows), rows * rows.T)
    sizes = [found[1][k, k] for k in range(rows.shape[0])]
    if any(map(is_zero, sizes)):
        return False
    lengths = sp.diag(*(size / moments[1][k, k] for k, size in enumerate(sizes)))
    return all(equal(mine, lengths * theirs) for mine, theirs in zip(found, moments, strict=True))


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
    if isinstance(expected, Root) or isinstance(value, Root):
        return turn == 1 and same_number(expected, value)
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
        case dict(), _ if "root_of" in value:
            return _read_root(value, name)
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
                return normal(read_number(value, LONGEST_ANSWER))
            except NotANumber as error:
                raise DataError(f"{name}: {error}") from None
        case _:
            if isinstance(value, list | dict) or not hasattr(value, "__abs__"):
                raise DataError(f"{name}: expected {'a number' if not isinstance(expected, str) else 'a word'}")
            return normal(read_number(str(value)))


def _read_root(value: Mapping[str, Any], name: str) -> Any:
    """A real root of an integer polynomial: a number where square roots express it, else the place of the root."""
    coefficients, index = value["root_of"], value.get("index")
    if not (
        isinstance(coefficients, list)
        and 2 <= len(coefficients) <= MOST_COEFFICIENTS
        and all(isinstance(c, int) and not isinstance(c, bool) for c in coefficients)
        and coefficients[0]
        and isinstance(index, int)
    ):
        raise DataError(f'{name}: expected {{"root_of": [integers, highest first], "index": from 0}}')
    polynomial = sp.Poly(coefficients, X)
    if not 0 <= index < polynomial.count_roots():
        raise DataError(f"{name}: index: expected 0 to {polynomial.count_roots() - 1}, and got {index}")
    root = sp.CRootOf(polynomial, index)
    found = place_of(polynomial, root.evalf) if root.has(sp.CRootOf) else root
    return found if isinstance(found, Root) and len(found.coefficients) > 3 else normal(root)
