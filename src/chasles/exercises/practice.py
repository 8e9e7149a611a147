"""`chasles.practice`: an exercise with new data as a task, whole enough to be handed out, and its answers graded."""

from __future__ import annotations

from collections.abc import Iterable, Iterator, Mapping
from dataclasses import dataclass
from functools import cached_property, lru_cache
from json import dumps
from os import PathLike
from shlex import quote
from typing import Any

from chasles.exact.spelling import as_data
from chasles.exercises.answers import shape_in_words, status_of, template_of
from chasles.exercises.data import DataError, exact_number, read_data, read_json
from chasles.exercises.grading import Grade, graded, new_data
from chasles.exercises.solution import Solution
from chasles.exercises.solving import solved_on_sheet
from chasles.exercises.worksheet import Worksheet
from chasles.statements.exercise import Exercise
from chasles.statements.exercises import UnknownExercise
from chasles.statements.exercises import exercise as find_exercise
from chasles.statements.packages import BOOK, imported

WARM = 256
"""Tasks whose solutions are kept."""
EXACT = (
    'Numbers are exact: integers, or text as "1/3", "-sqrt(2)/2", "pi/4", "2*atan(sqrt(3/2))", in any form; a decimal '
    'is what it shows. A root of a polynomial is {"root_of": [coefficients, highest first], "index": which, from 0}.'
)


@dataclass(frozen=True, repr=False)
class Practice:
    """A task: the exercise and which data are drawn. The same seed draws the same data.

    `chapter` is the package or folder that has the exercise, as it was asked for.
    """

    exercise: Exercise
    seed: int
    chapter: str = BOOK

    @cached_property
    def drawn(self) -> dict[str, Any]:
        """What is drawn, as a data file has it; the other data keep their defaults."""
        return new_data(self.exercise, self.seed)

    @cached_property
    def data(self) -> dict[str, Any]:
        """All data of the task, as a data file has them; what is left out of them is not asked about."""
        read = read_data(self.exercise, self.drawn)
        return {key: as_data(value) for key, value in read.items() if value is not None}

    @cached_property
    def _solved(self) -> tuple[Solution, Worksheet]:
        return solved_on_sheet(self.exercise, self.drawn)

    @property
    def solution(self) -> Solution:
        """The worked solution."""
        return self._solved[0]

    @property
    def template(self) -> dict[str, Any]:
        """A place for each answer. Names that do not apply to what is the case are to be left out."""
        return template_of(self.exercise)

    def as_data(self) -> dict[str, Any]:
        """The task for JSON: what is asked, all data, conventions, and each answer with its shape and what it is."""
        asked = (status_of(self.exercise), *self.exercise.answers)
        return {
            "exercise": self.exercise.number,
            "title": self.exercise.title,
            "seed": self.seed,
            "asked": list(self.exercise.asked),
            "data": self.data,
            "data_are": {datum.key: datum.says for datum in self.exercise.data if datum.key in self.data},
            "conventions": [*self.exercise.assumed(tuple(self.data)), EXACT],
            "answers": {answer.name: {"shape": shape_in_words(answer.shape), "is": answer.says} for answer in asked},
            "template": self.template,
        }

    @property
    def in_words(self) -> Iterator[str]:
        """The lines in which it is handed out."""
        whole = self.as_data()
        yield f"Exercise {whole['exercise']}  {whole['title']}, new data {self.seed}"
        yield from (f"  - {text}" for text in whole["asked"])
        yield "Data:"
        yield from (f"  {key} = {dumps(value)}: {whole['data_are'][key]}" for key, value in whole["data"].items())
        yield "Conventions:"
        yield from (f"  - {text}" for text in whole["conventions"])
        yield "Answers, those that apply:"
        yield from (f"  {name}: {answer['is']} ({answer['shape']})" for name, answer in whole["answers"].items())
        yield "As JSON, with ? replaced:"
        yield "{" + ",\n ".join(f"{dumps(name)}: {dumps(blank)}" for name, blank in whole["template"].items()) + "}"
        yield "Check an answer:"
        chapter = "" if self.chapter == BOOK else f" --chapter {quote(self.chapter)}"
        yield f"  chasles{chapter} practice {whole['exercise']} --seed {self.seed} --check answer.json"

    def __repr__(self) -> str:
        return "\n".join(self.in_words)

    def grade(self, answers: Mapping[str, Any], rtol: Any = None, digits: int | None = None) -> Grade:
        """The grade of these answers: exact, or, with a tolerance, of numbers as near as `rtol` or so many digits.

        Raises DataError, which names the part, for what is malformed.
        """
        if digits is not None and (isinstance(digits, bool) or not isinstance(digits, int) or not 1 <= digits <= 30):
            raise DataError(f"digits: expected an integer from 1 to 30, and got {digits!r}")
        if rtol is not None and digits is not None:
            raise DataError("rtol, digits: expected one of them, and got both")
        nearness = rtol if digits is None else exact_number(f"5/10^{digits}", "digits")
        return graded(self.exercise, self._solved, answers, nearness)


def practice(exercise: str, seed: int = 1, chapter: str | PathLike[str] = BOOK) -> Practice:
    """An exercise with new data, drawn by the seed: `as_data()` is to be handed out, `grade(answers)` to be called.

    `chapter` is the package or folder of another chapter than the book.

    Raises UnknownExercise, and DataError for an exercise without numbers.
    """
    if isinstance(seed, bool) or not isinstance(seed, int) or seed < 0:
        raise DataError(f"seed: expected an integer that is not negative, and got {seed!r}")
    return _task(str(exercise), seed, imported(chapter).__name__, str(chapter))


@lru_cache(maxsize=WARM)
def _task(exercise: str, seed: int, package: str, chapter: str) -> Practice:
    found = Practice(find_exercise(exercise, package), seed, chapter)
    new_data(found.exercise, seed)
    return found


def grade_lines(lines: Iterable[str], exercise: str, chapter: str = BOOK) -> Iterator[dict[str, Any]]:
    """The grade of each line of JSON, with whatever else the line holds; of one that is malformed, its `error`.

    A line has `answers`, and may have `seed`, `exercise`, `rtol` and `digits`.
    """
    for line in filter(str.strip, lines):
        kept: dict[str, Any] = {}
        try:
            given = read_json(line)
            kept = {key: _kept(value) for key, value in given.items() if key != "answers"}
            answers = given.get("answers")
            if not isinstance(answers, dict):
                raise DataError("answers: expected an object with the answers by their names")
            task = practice(given.get("exercise", exercise), given.get("seed", 1), chapter)
            yield kept | task.grade(answers, given.get("rtol"), given.get("digits")).as_data()
        except (DataError, UnknownExercise) as error:
            yield kept | {"error": str(error.args[0])}


def _kept(value: Any) -> Any:
    """What was read from JSON for JSON: decimals as text."""
    return value if value is None or isinstance(value, bool | int | str) else str(value)
