"""Exercises 3.8 and 3.9: what is proved for all k, and for all angles."""

from __future__ import annotations

from random import Random

import pytest
import sympy as sp
from chasles.derivations.exercises.x3_08 import even, formula_of_even, power, sign, squared, twice
from chasles.derivations.notation import p

from chasles.decisions.session import Session
from chasles.exercises.data import DataError
from chasles.exercises.solving import solve
from chasles.report.notebook.html import worked
from chasles.statements import Theorem
from chasles.statements.exercises import exercise_numbers
from chasles.statements.induction import ForAllK
from chasles.vocabulary import number

from .known import plain, same, vector


@pytest.mark.parametrize("factors", [0, 1, 2, 3, 4, 7, 64])
def test_products_over_and_over(factors: int) -> None:
    draw = Random(factors)
    omega, start = vector(draw), vector(draw)
    solution = solve("3.8", omega=plain(omega), p=plain(start), factors=factors)
    expected = start
    for _ in range(factors):
        expected = omega.cross(expected)
    assert same(solution.answers["value"], expected)
    assert solution.answers["even_formula_holds_for"] == "k >= 1"
    assert solution.answers["odd_formula_holds_for"] == "k >= 0"


def test_nothing_is_turned_by_zero() -> None:
    assert same(solve("3.8", omega=[0, 0, 0], factors=2).answers["value"], sp.zeros(3, 1))
    assert same(solve("3.8", omega=[0, 0, 0], factors=0, p=[1, 2, 3]).answers["value"], sp.Matrix([1, 2, 3]))


@pytest.mark.parametrize("factors", [-1, 65, "1/2", "pi", 1.5, "three"])
def test_a_malformed_number_of_factors(factors: object) -> None:
    with pytest.raises(DataError, match=r"^factors: "):
        solve("3.8", factors=factors)


@pytest.mark.parametrize(
    "change",
    [
        {"at_first": ((sign, number(1)), (power, number(1)))},
        {"afterwards": ((sign, sign), (power, power * squared))},
        {"afterwards": ((sign, -sign), (power, power))},
        {"first": twice[p] * 2},
    ],
)
def test_an_induction_with_a_wrong_base_or_step_fails(change: dict) -> None:
    right = {
        "first": twice[p],
        "following": twice[even],
        "at_first": ((sign, number(-1)), (power, number(1))),
        "afterwards": ((sign, -sign), (power, power * squared)),
    }
    for form, holds in (
        (ForAllK(even, formula_of_even, **right), True),
        (ForAllK(even, formula_of_even, **right | change), False),
    ):
        assert Session().decide(Theorem("9.1", "A try.", (form,))).verdict.true is holds


def test_letters_need_both_values() -> None:
    with pytest.raises(TypeError, match="give both for each"):
        ForAllK(even, formula_of_even, twice[p], twice[even], ((sign, number(1)),), ())


def test_a_leading_term_says_what_is_left_out() -> None:
    lines = [line.text for step in solve("3.9").steps for line in step.lines]
    assert "sin(phi) - phi = -phi^3/6 + O(phi^5)" in lines
    assert "1 - cos(phi) = phi^2/2 + O(phi^4)" in lines


@pytest.mark.parametrize("number", ["3.17", "3.18"])
def test_proofs_are_lines_and_not_records(number: str) -> None:
    proofs = solve(number).answers["proofs"]
    lines = proofs.as_text().split("\n")
    assert len(lines) == len(proofs)
    assert all("{" not in line and "verdict" not in line and " It holds" in line for line in lines)
    assert worked(solve(number)).count("; holds") == len(proofs)


@pytest.mark.sampled(4)
@pytest.mark.parametrize("number", exercise_numbers())
def test_no_line_says_that_something_is_itself(number: str) -> None:
    solution = solve(number)
    for line in (line.text for part in (*solution.steps, *solution.checks) for line in part.lines):
        sides = line.split(" = ")
        assert len(sides) == len(set(sides)) or len(sides) > 2, line


def test_small_rotations() -> None:
    solution = solve("3.9")
    assert solution.as_data()["answers"] == {"vector": "phi*e", "order": "2"}
    with pytest.raises(DataError, match=r"exercise 3\.9 has no datum 'phi'; it takes none"):
        solve("3.9", phi=1)
