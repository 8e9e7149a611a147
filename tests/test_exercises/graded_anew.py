"""Grades of answers for data that are solved for each."""

from __future__ import annotations

from collections.abc import Mapping
from typing import Any

from chasles.exercises.grading import Grade, graded
from chasles.exercises.solving import solved_on_sheet
from chasles.statements.exercise import Exercise


def grade(exercise: Exercise, data: Mapping[str, Any], given: Mapping[str, Any], rtol: Any = None) -> Grade:
    """The grade of answers for these data; with `rtol`, numbers are right that are as near as that."""
    return graded(exercise, solved_on_sheet(exercise, data), given, rtol)
