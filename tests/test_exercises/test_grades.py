"""Grades of answers in other forms, of wrong ones and of malformed ones, over all exercises."""

from __future__ import annotations

import json
from functools import cache
from random import Random
from typing import Any

import mpmath
import pytest

from chasles.exercises.answers import asked_for, template_of
from chasles.exercises.data import DataError
from chasles.exercises.grading import grade, graded, new_data
from chasles.exercises.solving import solved_on_sheet
from chasles.statements.exercises import exercise, exercise_numbers

from ..sampling import WHOLE, sample
from .forms import at_place, leaves, near, put, right_forms, spoiled

NUMBERS = [number for number in exercise_numbers() if exercise(number).instance is not None]
CASES = [(number, seed) for seed in range(24) for number in NUMBERS]
FORMS = 6 if WHOLE else 3
"""Of each case, right ones and wrong ones: more than 2,000 of each where all are tried."""


@cache
def solved(number: str, seed: int) -> tuple[Any, dict[str, Any]]:
    found = solved_on_sheet(exercise(number), new_data(exercise(number), seed))
    return found, json.loads(json.dumps(found[0].as_data()["answers"]))


@pytest.mark.sampled(4)
@pytest.mark.parametrize(("number", "seed"), sample(CASES, 25, 3))
def test_right_answers_in_other_forms(number: str, seed: int) -> None:
    found, answers = solved(number, seed)
    draw = Random(f"right {number} {seed}")
    for _ in range(FORMS):
        given = right_forms(draw, exercise(number), answers)
        marks = graded(exercise(number), found, given)
        assert marks.passed, (marks, given)


@pytest.mark.sampled(3)
@pytest.mark.parametrize(("number", "seed"), sample(CASES, 25, 3))
def test_wrong_answers(number: str, seed: int) -> None:
    found, answers = solved(number, seed)
    draw = Random(f"wrong {number} {seed}")
    for changed, name in filter(None, (spoiled(draw, exercise(number), answers) for _ in range(2 * FORMS))):
        marks = graded(exercise(number), found, changed)
        assert name in marks.wrong, (name, changed[name], answers[name])


@pytest.mark.sampled(5)
@pytest.mark.parametrize("number", NUMBERS)
@pytest.mark.parametrize("seed", [0, 3])
def test_what_is_declared_is_what_is_answered(number: str, seed: int) -> None:
    (solution, sheet), _ = solved(number, seed)
    assert asked_for(exercise(number), sheet.data, solution.status) == set(solution.answers)


MALFORMED = [
    *(None, True, "", "up", "1/0", "1e", "(", [], [[]], {}, 5, [1, 2], ["x"] * 3, [[1, 2, 3]] * 2, {"X=0": 1}, "1,5"),
    *({"root_of": []}, {"root_of": [1], "index": 0}, {"root_of": [1, 2], "index": True}, {"root_of": 1}, "nan", "e"),
    *("-" * 1999, "(" * 900, "2^" * 900 + "2", "sqrt(" * 300, "1" * 5000, "sqrt(2)+" * 249 + "1", [[[[[]]]]]),
]


@pytest.mark.sampled(4)
@pytest.mark.parametrize("number", NUMBERS)
def test_what_is_malformed_is_told_and_nothing_breaks(number: str) -> None:
    found, answers = solved(number, 0)
    for place, name in enumerate(answers):
        for thing in sample(MALFORMED, 6, place % 6):
            try:
                marks = graded(exercise(number), found, {**answers, name: thing})
            except DataError as error:
                told = str(error)
                assert told.startswith(name)
                assert "\n" not in told
                assert len(told) < 500
            else:
                assert name in marks.wrong or thing == answers[name]


@pytest.mark.sampled(3)
@pytest.mark.parametrize("number", NUMBERS)
def test_names_that_do_not_apply_tell_nothing(number: str) -> None:
    """Each name of the template is taken, and wrong where it does not apply: no message tells what is the case."""
    chosen = exercise(number)
    for seed in (0, 1, 2) if any(answer.only for answer in chosen.answers) else ():
        found, answers = solved(number, seed)
        for name in [answer.name for answer in chosen.answers if answer.name not in answers]:
            for twin in [solved(number, k)[1][name] for k in range(12) if name in solved(number, k)[1]][:1]:
                assert name in graded(chosen, found, {name: twin}).wrong
    assert set(template_of(chosen)) == {"status", *(answer.name for answer in chosen.answers)}


AMBIGUOUS = {"a": [2, 0, 0], "b": [0, 0, 0], "nA": [0, 0, 1], "nB": [0, 0, 2]}


def test_what_is_missing_follows_what_is_claimed() -> None:
    chosen = exercise("3.7")
    for data in ({}, AMBIGUOUS, {"nB": [0, 1, 3]}):
        assert grade(chosen, data, {}).missing == ("status",)
        assert grade(chosen, data, {"status": "compatible"}).missing == ("e", "p", "n0", "d")
        assert grade(chosen, data, {"e": [1, 0, 0]}).missing == ("p", "n0", "d")
    marks = grade(chosen, AMBIGUOUS, {"e": [1, 0, 0], "p": [0, 0, 0], "n0": [0, 0, 0], "d": 0})
    assert (marks.passed, marks.wrong, marks.score) == (False, ("e", "p", "n0", "d"), 0)


def test_only_what_was_given_is_found_not_to_satisfy_something() -> None:
    marks = grade(exercise("3.7"), AMBIGUOUS, {"e_candidates": [[1, 0, 0]]})
    assert marks.wrong == ("e_candidates",)
    assert all(says.startswith("e_candidates: ") for says in marks.violated)


def own(number: str, data: dict[str, Any]) -> dict[str, Any]:
    solution, _ = solved_on_sheet(exercise(number), data)
    return json.loads(json.dumps(solution.as_data()["answers"]))


def test_the_other_equation_of_a_quadric() -> None:
    chosen, answers = exercise("3.3"), own("3.3", {})
    turned: dict[str, Any] = {
        "M": [[f"-({x})" for x in row] for row in answers["M"]],
        "g": [f"-({x})" for x in answers["g"]],
        "signature_M": answers["signature_M"][::-1],
        **{name: f"-({answers[name]})" for name in ("h", "det_M", "f_centre")},
        "wording": answers["wording"]
        | {
            "h > 0": not answers["wording"]["h > 0"],
            "det(M) < 0": not answers["wording"]["det(M) < 0"],
            "M has two positive and one negative eigenvalues": answers["signature_M"] == ["1", "2"],
        },
    }
    assert grade(chosen, {}, answers | turned).passed
    assert grade(chosen, {}, answers | {"kind": "Hyperboloid of one sheet"}).passed
    assert grade(chosen, {}, answers | {"M": turned["M"]}).wrong == ("M",)
    assert grade(chosen, {}, answers | turned | {"h": answers["h"]}).wrong == ("h",)
    assert grade(chosen, {}, answers | {"kind": "hyperbolic paraboloid"}).wrong == ("kind",)


@pytest.mark.sampled(2)
@pytest.mark.parametrize("seed", range(4))
def test_a_factor_up_to_rotations(seed: int) -> None:
    chosen = exercise("3.20")
    found, answers = solved("3.20", seed)
    factor = answers["P"]
    turns = [
        [[f"-({x})" for x in row] for row in factor],
        [[row[1], row[0], row[2]] for row in factor],
        [[row[0], f"-({row[1]})", row[2]] for row in factor],
        [[f"3*({x})/5+4*({y})/5", f"3*({y})/5-4*({x})/5", z] for x, y, z in factor],
    ]
    for turned in turns:
        assert graded(chosen, found, {**answers, "P": turned}).passed
    for wrong in ([[f"2*({x})" for x in row] for row in factor], [factor[1], factor[0], *factor[2:]]):
        marks = graded(chosen, found, {**answers, "P": wrong})
        assert marks.wrong == ("P",) or wrong == factor


WRENCH = {"n1": [0, 0, 2], "f1": [0, 0, 4], "n2": [2, 0, 0], "f2": [4, 0, 0]}


def test_any_rotation_that_does_it_where_it_is_not_the_only_one() -> None:
    chosen, answers = exercise("3.4"), own("3.4", WRENCH)
    assert answers["unique"] is False
    cyclic = {"R": [[0, 1, 0], [0, 0, 1], [1, 0, 0]], "phi": "2*pi/3", "e": ["-1/sqrt(3)"] * 3}
    assert grade(chosen, WRENCH, answers | cyclic).passed
    assert grade(chosen, WRENCH, answers | {"R": cyclic["R"]}).wrong == ("R",)
    assert grade(chosen, WRENCH, answers | cyclic | {"e": [1, 0, 0]}).wrong == ("e",)
    mirror = {"R": [[0, 1, 0], [0, 0, -1], [1, 0, 0]]}
    assert "R" in grade(chosen, WRENCH, answers | mirror).wrong
    assert "R" in grade(chosen, WRENCH, answers | {"R": [[1, 0, 0], [0, 1, 0], [0, 0, 1]]}).wrong


def test_moments_and_axes_in_any_one_order() -> None:
    chosen, data = exercise("3.12"), {"side": 2, "height": 9, "angle_deg": 45}
    answers = own("3.12", data)
    names = ("wedge.moments_over_rho", "wedge.k2", "wedge.axes")
    turned = {name: [answers[name][k] for k in (2, 0, 1)] for name in names}
    assert grade(chosen, data, answers | turned).passed
    assert grade(chosen, data, {"wedge.axes": turned["wedge.axes"]}).right == ("wedge.axes",)
    for name in names:
        assert grade(chosen, data, answers | {name: turned[name]}).wrong == (name,)


NEAR = {
    ("3.5", "d"): ["1.4142", "1.41421356", "1.414"],
    ("3.5", "p"): [["1", "0", "1"], ["1.0004", 0, 1], ["0.9995", "0.0005", "1"]],
}


@pytest.mark.parametrize(("place", "given"), [(place, value) for place, many in NEAR.items() for value in many])
def test_decimals_are_right_within_a_tolerance_that_is_asked_for(place: tuple[str, str], given: Any) -> None:
    number, name = place
    answers = own(number, {}) | {name: given}
    assert grade(exercise(number), {}, answers, rtol="0.001").passed
    assert grade(exercise(number), {}, answers, rtol=1e-3).passed
    exact = given == ["1", "0", "1"]
    assert grade(exercise(number), {}, answers).passed is exact
    assert grade(exercise(number), {}, answers, rtol="1/10^12").passed is exact


def decimal(number: mpmath.mpf) -> str:
    return mpmath.nstr(number, 9, min_fixed=-40, max_fixed=40)


@pytest.mark.sampled(3)
@pytest.mark.parametrize("number", NUMBERS)
def test_answers_to_six_digits(number: str) -> None:
    found, answers = solved(number, 1)
    rounded = answers
    for place in leaves(answers):
        rounded = put(rounded, place, decimal(near(at_place(answers, place))))
    assert graded(exercise(number), found, rounded, "1/10^6").passed
    for place in list(leaves(answers))[:6]:
        size = max(abs(near(at_place(answers, other))) for other in leaves(answers) if other[0] == place[0]) or 1
        wrong = put(rounded, place, f"{at_place(rounded, place)}+{decimal(size)}/1000")
        assert place[0] in graded(exercise(number), found, wrong, "1/10^6").wrong


@pytest.mark.parametrize("rtol", [0, 1, -1, "2", "x", True, None])
def test_tolerances(rtol: Any) -> None:
    if rtol is None:
        assert grade(exercise("3.5"), {}, own("3.5", {}), rtol).passed
    else:
        with pytest.raises(DataError, match=r"^rtol: "):
            grade(exercise("3.5"), {}, own("3.5", {}), rtol)


def test_what_nothing_decides_is_neither_right_nor_wrong() -> None:
    answers = own("3.5", {})
    marks = grade(
        exercise("3.5"), {}, answers | {"d": f"{answers['d']} + sin(2*sqrt(2)) - 2*sin(sqrt(2))*cos(sqrt(2))"}
    )
    assert (marks.passed, marks.undecided, marks.wrong, marks.score) == (False, ("d",), (), 0.5)
