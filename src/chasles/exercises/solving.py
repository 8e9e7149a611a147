"""`chasles.solve`: an exercise of the book, worked for the book's data or for others."""

from __future__ import annotations

from collections.abc import Mapping
from os import PathLike
from typing import Any

from sympy.polys.polyerrors import BasePolynomialError

from chasles.exact.numbers import NotDecided
from chasles.exact.tower import TooManyRoots
from chasles.exercises.data import DataError, read_data
from chasles.exercises.solution import Solution
from chasles.exercises.worksheet import Worksheet
from chasles.statements.elsewhere import chapter_of
from chasles.statements.exercise import Exercise
from chasles.statements.exercises import exercise as find_exercise
from chasles.statements.packages import BOOK, DeclarationError, imported


def solve(exercise: str, chapter: str | PathLike[str] = BOOK, /, **data: Any) -> Solution:
    """The worked solution of an exercise, exact: steps, answers, checks, picture.

    `exercise` is its number, "3.7"; `chapter` the package or folder of another chapter than the book. Data are numbers,
    exact or decimal, or text such as "sqrt(2)/2"; keys that are left out keep their defaults. Raises UnknownExercise,
    DataError for data that are malformed, and DoesNotStand where an equation that is used is not known to be true.
    """
    return solve_with(exercise, data, imported(chapter).__name__)


def solve_with(number: str, data: Mapping[str, Any], chapter: str = BOOK) -> Solution:
    """The same with the data in a dictionary."""
    return solved_on_sheet(find_exercise(number, chapter), data)[0]


def solved_on_sheet(exercise: Exercise, data: Mapping[str, Any]) -> tuple[Solution, Worksheet]:
    """The solution, and the sheet on which it was found."""
    try:
        values = read_data(exercise, data)
        sheet = Worksheet(values, chapter_of(exercise))
        status = exercise.solve(sheet)
    except NotDecided as error:
        raise DataError(f"{error}; give numbers that square roots express") from error
    except TooManyRoots as error:
        raise DataError(f"{error}; give simpler numbers") from error
    except OverflowError as error:
        raise DataError("a number grows too large; give smaller ones") from error
    except ValueError as error:
        # SymPy 1.14 does not take the square root of an integer with two large factors that are close.
        if "is not a prime factor of" not in str(error):
            raise
        raise DataError("the square root of an integer is not found; give smaller numbers") from error
    except BasePolynomialError as error:
        raise DataError("polynomials in these numbers are not known; give numbers that square roots express") from error
    if status not in exercise.statuses:
        expected = ", ".join(map(repr, exercise.statuses))
        raise DeclarationError(f"`solve` of exercise {exercise.number} returns {status!r}, and must return {expected}")
    solution = Solution(
        exercise.number,
        exercise.title,
        exercise.asked,
        status,
        values,
        sheet.answers,
        exercise.assumed(tuple(data)),
        tuple(sheet.steps),
        tuple(sheet.checks),
        sheet.picture,
        {answer.name: answer.says for answer in exercise.answers},
    )
    return solution, sheet
