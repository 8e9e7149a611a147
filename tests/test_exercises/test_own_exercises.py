"""Exercises of an author's own: what they say of their answers is checked, and graded as those of the book are."""

from __future__ import annotations

import sys
from pathlib import Path
from typing import Any

import pytest
import sympy as sp

import chasles
from chasles.exact.principal_axes import principal_axes
from chasles.exact.spectra import each_eigenvalue
from chasles.exercises.grading import grade
from chasles.statements.exercise import Answer, Datum, Exercise, matrix_shape, vector_shape
from chasles.statements.exercises import exercise
from chasles.statements.loading import unlisted
from chasles.statements.packages import DeclarationError

DECLARED = """
from chasles.statements.exercise import Answer, Datum, Exercise, Scalar, vector_shape


def solve(sheet):
    sheet.answer(y=2 * sheet["x"])
    return "ok"


exercise = Exercise("1", "Twice", asked=("Double it.",), solve=solve, {0}, data=(Datum("x", Scalar(), 1, "a number"),),
    answers=(Answer("y", Scalar(), "twice", {1}),))
"""


def solve(sheet: Any) -> str:
    matrix = sheet["M"]
    sheet.answer(moments=each_eigenvalue(matrix), axes=principal_axes(matrix))
    return "ok"


AXES = Exercise(
    "1",
    "Axes",
    asked=("Find the eigenvalues and axes.",),
    data=(Datum("M", matrix_shape(), [[2, 1, 0], [1, 2, 0], [0, 0, 5]], "a symmetric matrix"),),
    solve=solve,
    axes={"axes": ("M", "moments")},
    orders=(("moments", "axes"),),
    answers=(Answer("moments", vector_shape(), "eigenvalues"), Answer("axes", matrix_shape(), "axes as rows")),
)


@pytest.mark.parametrize(
    ("moments", "axes", "wrong"),
    [
        ([1, 3, 5], [[1, -1, 0], [3, 3, 0], [0, 0, -1]], ()),
        ([5, 1, 3], [[0, 0, 1], ["sqrt(2)/2", "-sqrt(2)/2", 0], [1, 1, 0]], ()),
        ([1, 3, 5], [[1, 1, 0], [1, -1, 0], [0, 0, 1]], ("axes",)),
    ],
)
def test_axes_of_a_matrix_that_is_given(moments: list[int], axes: list[list[Any]], wrong: tuple[str, ...]) -> None:
    assert grade(AXES, {}, {"moments": moments, "axes": axes}).wrong == wrong


@pytest.mark.parametrize(
    ("says", "answer", "told"),
    [
        ('signs=(("z",),)', "", "signs: there is no 'z'; there are: y"),
        ('turns=("z",)', "", "turns: there is no 'z'"),
        ('axes={"y": ("x", "z")}', "", "axes: there is no 'z'; there are: x, y"),
        ("turns=()", 'only=("good",)', "only: there is no 'good'; there are: ok"),
        ("turns=()", 'given="z"', "given: there is no 'z'; there are: x"),
    ],
)
def test_names_that_there_are_not(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch, says: str, answer: str, told: str
) -> None:
    book = tmp_path / "ownbook"
    (book / "exercises").mkdir(parents=True)
    (book / "__init__.py").write_text("SECTIONS = ()\n")
    (book / "exercises" / "__init__.py").write_text("")
    (book / "exercises" / "x1.py").write_text(DECLARED.replace("{0}", says).replace("{1}", answer))
    monkeypatch.syspath_prepend(tmp_path)
    try:
        with pytest.raises(DeclarationError, match="x1.py.*" + told.replace("(", r"\(")):
            exercise("1", "ownbook")
    finally:
        for name in [name for name in sys.modules if name.partition(".")[0] == "ownbook"]:
            del sys.modules[name]


def test_a_section_that_is_not_listed_is_told(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    book = tmp_path / "partbook"
    book.mkdir()
    (book / "__init__.py").write_text('SECTIONS = ("s1_listed",)\n')
    for name in ("s1_listed", "s2_new", "notation", "scratch"):
        (book / f"{name}.py").write_text("")
    monkeypatch.syspath_prepend(tmp_path)
    import partbook  # type: ignore[import-not-found]

    assert unlisted(partbook) == ["s2_new"]


def test_a_task_and_a_grade_are_told_in_words() -> None:
    task = chasles.practice("3.5", 7)
    assert str(task).splitlines()[0] == "Exercise 3.5  The Plücker coordinates of a joint axis, new data 7"
    assert str(task.grade({"d": sp.Integer(1)})).splitlines()[:2] == ["wrong: d", "missing: p"]
