"""Answers that are right in another order, at another length, or as roots; and what a wrong one violates."""

from __future__ import annotations

import json

import pytest

from chasles.exercises.data import DataError
from chasles.exercises.grading import grade, new_data
from chasles.exercises.solving import solve_with
from chasles.statements.exercises import exercise

TWO_LINES = {"a": [2, 0, 0], "b": [0, 0, 0], "nA": [0, 0, 1], "nB": [0, 0, 2]}
CUBE_ROOTS = {"I_C": [[3, 0, 0], [0, 4, 0], [0, 0, 5]], "m": 1, "d": [[1, 1, 1]]}


def own_answers(number: str, data: dict) -> dict:
    return json.loads(json.dumps(solve_with(number, data).as_data()["answers"]))


def test_candidates_in_any_one_order() -> None:
    found, answers = exercise("3.7"), own_answers("3.7", TWO_LINES)
    swapped = {name: candidates[::-1] for name, candidates in answers.items()}
    assert grade(found, TWO_LINES, swapped).passed
    marks = grade(found, TWO_LINES, {**answers, "e_candidates": swapped["e_candidates"]})
    assert not marks.passed
    assert grade(found, TWO_LINES, {**answers, "e_candidates": answers["e_candidates"][:1]}).wrong == ("e_candidates",)


def test_axes_of_any_length_and_either_sign() -> None:
    data = {"side": 2, "height": 9, "angle_deg": 45}
    found, answers = exercise("3.12"), own_answers("3.12", data)
    first, second, third = answers["wedge.axes"]
    longer = [[f"-3*({x})" for x in first], [f"({x})/2" for x in second], third]
    assert grade(found, data, {**answers, "wedge.axes": longer}).passed
    for wrong in ([second, first, third], [first, second, [0, 0, 0]], [first, second, [1, 1, 1]], [first] * 3):
        assert grade(found, data, {**answers, "wedge.axes": wrong}).wrong == ("wedge.axes",)


@pytest.mark.parametrize("factor", [1, -2])
def test_roots_as_places_of_any_multiple_of_the_polynomial(factor: int) -> None:
    found, answers = exercise("3.16"), own_answers("3.16", CUBE_ROOTS)
    roots = answers["moments_P"][0]
    assert [place["index"] for place in roots] == [0, 1, 2]
    given = [{"root_of": [factor * c for c in place["root_of"]], "index": place["index"]} for place in roots]
    assert grade(found, CUBE_ROOTS, {**answers, "moments_P": [given]}).passed
    marks = grade(found, CUBE_ROOTS, {**answers, "moments_P": [[given[1], given[0], given[2]]]})
    assert marks.wrong == ("moments_P",)


def test_a_place_may_stand_for_what_square_roots_express() -> None:
    found, answers = exercise("3.16"), own_answers("3.16", CUBE_ROOTS)
    given = [{"root_of": [1, -7, 12], "index": 0}, 4, {"root_of": [1, -5, 0], "index": 1}]
    assert grade(found, CUBE_ROOTS, {**answers, "moments_C": given}).passed


@pytest.mark.parametrize(
    "root",
    [{"root_of": [1, 0, 1], "index": 0}, {"root_of": [0, 1], "index": 0}, {"root_of": [1, -1], "index": 1},
     {"root_of": "x", "index": 0}, {"root_of": [1, "exit()"], "index": 0}, {"root_of": [1, -1]}],
)  # fmt: skip
def test_malformed_places_are_named(root: dict) -> None:
    with pytest.raises(DataError, match=r"^moments_C\[1\]: "):
        grade(exercise("3.16"), CUBE_ROOTS, {"moments_C": [root, 4, 5]})


NAMED = [
    ("3.11", "centroid", "(3.125)"), ("3.13", "I_O", "Ex 3.13 part 2"), ("3.14", "eigenvalues_A", "principal moments"),
    ("3.15", "I_P", "(3.133a)"), ("3.19", "n_P_in_S", "(3.106)"),
    ("3.20", "M_A", "congruent"), ("3.20", "det", "does not depend on the point"), ("3.21", "norm_O2", "The norms"),
]  # fmt: skip


@pytest.mark.parametrize(("number", "name", "says"), NAMED)
def test_a_wrong_answer_names_the_equation_it_violates(number: str, name: str, says: str) -> None:
    found = exercise(number)
    data = new_data(found, 1)
    answers = own_answers(number, data)

    def spoiled(value: object) -> object:
        return [spoiled(value[0]), *value[1:]] if isinstance(value, list) else f"({value})+1"

    marks = grade(found, data, {**answers, name: spoiled(answers[name])})
    assert marks.wrong == (name,)
    assert any(says in text for text in marks.violated), marks.violated
