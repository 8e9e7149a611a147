"""Slips planted in a chapter that is not the book's, all entries written out: nearly all of them are repaired."""

from __future__ import annotations

from fractions import Fraction
from pathlib import Path
from statistics import median
from typing import Any

import pytest

from chasles.decisions.session import Session
from chasles.repairs.repair import repair
from chasles.statements import Claim, Definition, Hypothesis, load, nonzero, perpendicular, unit
from chasles.statements.inequalities import inequality
from chasles.vocabulary import (
    Node,
    Zero,
    array,
    column,
    cos,
    cross,
    matrix,
    norm,
    number,
    plain,
    rate,
    scalar,
    sin,
    square,
    tr,
    vector,
)
from chasles.vocabulary.functions import sqrt
from chasles.vocabulary.motions import homogeneous
from chasles.vocabulary.partial import partial
from chasles.vocabulary.quaternions import quaternion_product, rotation_of_quaternion

from .counted import at_most
from .planted import outcome_of, planted, table
from .sampling import WHOLE, sample

ARMS = Path(__file__).parent / "arms"
REPAIRED, FIRST = Fraction(95, 100), Fraction(85, 100)


@pytest.mark.slow
def test_slips_in_entries_are_repaired_and_the_original_comes_first() -> None:
    chapter, session = load(ARMS), Session()
    cases = sample(planted(chapter, session, each=6 if WHOLE else 1), 4)
    outcomes = [outcome_of(case, chapter, session) for case in cases]
    report = "\n".join([*map(str, outcomes), *table(outcomes)])
    assert sum(bool(each.repairs) for each in outcomes) >= REPAIRED * len(outcomes), report
    assert sum(each.place == 0 for each in outcomes) >= FIRST * len(outcomes), report
    assert median(each.seconds for each in outcomes) < 1, report


x, y = (scalar(name, name, "an angle") for name in "xy")
g = scalar("g", "g", "a factor", constant=True)
a, b = (vector(name, name, "a vector") for name in "ab")
A, B = (square(name, name, "a matrix") for name in "AB")
turn = matrix((cos(x), -sin(x)), (sin(x), cos(x)))
moved = column(g * cos(x + y), g * sin(x + y))

PRINTED: list[tuple[Node, Node, str]] = [
    (turn.T, matrix((cos(x), sin(x)), (sin(x), cos(x))), "the sign of sin(x) is turned"),
    (turn.T, matrix((cos(x), sin(x)), (-sin(x), sin(x))), "cos(x) instead of sin(x)"),
    (turn.T, matrix((cos(x), sin(x)), (-sin(y), cos(x))), "x instead of y"),
    (turn.T, matrix((cos(x), sin(x)), (cos(x), -sin(x))), "[cos(x), sin(x); -sin(x), cos(x)] instead of"),
    (turn.T, matrix((cos(x), sin(x)), (0, cos(x))), "-sin(x) instead of 0"),
    (turn.T, matrix((cos(x), sin(x)), (-sin(2 * x), cos(x))), "sin(x) instead of sin(2 x)"),
    (turn.T @ turn.T, matrix((cos(2 * x), sin(2 * x)), (-2 * sin(x), cos(2 * x))), "the factor cos(x) is added"),
    (moved, column(g * cos(x - y), g * sin(x + y)), "x + y instead of x - y"),
    (moved, column(g * cos(x), g * sin(x + y)), "cos(x + y) instead of cos(x)"),
    (rate(moved), (rate(x) + rate(y)) * column(-g * cos(x + y), g * cos(x + y)), "sin(x + y) instead of cos(x + y)"),
    (rate(moved), rate(x) * column(-g * sin(x + y), g * cos(x + y)), "the term y_dot is added"),
    (rate(g * cos(x)), -g * rate(x) * cos(x), "sin(x) instead of cos(x)"),
    ((a.T @ b) * a, (b.T @ b) * a, "a instead of b"),
    (A @ (a + b), A @ a + b, "A (a + b) instead of A a + b"),
    ((A @ B).T, A.T @ B.T, "B^T A^T instead of A^T B^T"),
    (A.T @ B @ a + B @ a, A.T @ a + B @ a, "the factor B is added"),
    (matrix((A, B), (B, A)), matrix((A, B), (B, B)), "A instead of B"),
    (matrix((sin(x) ** 2, 0), (0, 1)), matrix((sin(x), 0), (0, 1)), "the factor sin(x) is added"),
    (matrix((cos(x) * cos(y) - sin(x) * sin(y), 1)), matrix((cos(x) * cos(y), 1)), "the term -sin(x) sin(y) is added"),
    (
        matrix((sin(x) * (1 - cos(y)), 1)),
        matrix((sin(x) - cos(y), 1)),
        "the factor sin(x) is added",
    ),
    (tr(A), A[1, 1] + A[2, 2] + A[3, 2], "A_33 instead of A_32"),
    (cross(a, b)[1], a[2] * b[3] - a[3] * b[1], "b_2 instead of b_1"),
    (matrix((sin(x) / 2, 1)), matrix((sin(x) / 3, 1)), "(1/2) sin(x) instead of sin(x) / 3"),
]


@pytest.mark.parametrize(("left", "wrong", "words"), PRINTED, ids=range(len(PRINTED)))
def test_what_a_slip_is_said_to_be(left: Node, wrong: Node, words: str) -> None:
    meant = array("M", "M", "what is meant", left)
    found = repair(Claim("2", meant, wrong, given=(Definition("1", meant, left),)))
    assert any(each.changes[0].startswith(words) for each in found), [each.changes for each in found]
    assert all(each.edits == 1 for each in found)


@pytest.mark.parametrize("wrong", [printed for _, printed, _ in PRINTED[:3]], ids=range(3))
def test_a_slip_on_the_left_is_undone_there(wrong: Node) -> None:
    found = repair(Claim("1", wrong, turn.T))
    assert any(each.right == turn.T and plain(each.left) == "[cos(x), sin(x); -sin(x), cos(x)]" for each in found), (
        found
    )


def test_a_slip_on_the_left_of_what_says_another_claim_again() -> None:
    said = Claim("1", cross(a, b), A @ b)
    found = repair(Claim("2", cross(b, a) - A @ b, Zero(3, 1), restates=said))
    assert any(plain(each.left) == "-b x a - A b" for each in found), found


def meant_by(name: str, right: Node, wrong: Node, *assuming: Hypothesis) -> list[str]:
    """The right sides that are found for a wrong one of what is defined by the right one."""
    meant = array(name, name, "what is meant", right)
    found = repair(Claim("2", meant, wrong, given=(Definition("1", meant, right),), assuming=assuming))
    return [plain(each.right) for each in found]


@pytest.mark.parametrize("wrong", [b / g, b / g**3], ids=["too low", "too high"])
def test_a_power_in_a_divisor(wrong: Node) -> None:
    assert meant_by("v", cross(a, b / g**2), cross(a, wrong), nonzero(g))[0] == "a x (b / g^2)"


def test_a_letter_left_out_inside_a_word_and_a_transpose_of_one() -> None:
    one, other = column(a, g), column(b, g)
    product, lost = quaternion_product(one, other), quaternion_product(column(Zero(3, 1), g), other)
    assert plain(product) in meant_by("q", product, lost)
    turned = rotation_of_quaternion(one)
    assert plain(turned.T) in meant_by("Q", turned.T, turned)


def test_no_rate_is_taken_of_a_constant() -> None:
    printed = column(-g * rate(x) * cos(x), g * rate(x) * cos(x))
    for each in repair(Claim("1", rate(column(g * cos(x), g * sin(x))), printed)):
        assert "g_dot" not in plain(each.left) + plain(each.right)


INSIDE: list[tuple[Node, Node, tuple[Hypothesis, ...], str]] = [
    (partial(column(a.x, a.x * a.y), a), matrix((2 * a.x, 0, 0), (a.y, a.x, 0)), (), "d[a_x^2; a_x a_y] / da"),
    (partial(a.x, column(a.x, a.y)), matrix((a.y, a.x)), (), "d(a_y a_x) / d[a_x; a_y]"),
    (partial(g * (a.x**2 + a.y**2), a.x), 4 * g * a.x * (a.x**2 + a.y**2), (), "d[g (a_x^2 + a_y^2)^2] / da_x"),
    (
        norm(cos(x) * a + cos(x) * b),
        number(1),
        (unit(a), unit(b), perpendicular(a, b)),
        "|cos(x) a + sin(x) b|",
    ),
    (b - sin(x) * a, sin(x) * b - sin(x) * a, (), "sin(x) (b - a)"),
    (norm(a + sin(x) * b), number(1), (unit(a), unit(b), perpendicular(a, b)), "|cos(x) a + sin(x) b|"),
]


@pytest.mark.sampled(2)
@pytest.mark.parametrize(("wrong", "right", "assuming", "meant"), INSIDE, ids=[meant for *_, meant in INSIDE])
def test_slips_inside_derivatives_and_lengths(wrong: Node, right: Node, assuming: Any, meant: str) -> None:
    assert meant in [plain(each.left) for each in repair(Claim("1", wrong, right, assuming=assuming))]


def test_nothing_is_divided_by_a_zero_that_is_printed() -> None:
    wrong = Claim(
        "1",
        partial(column(sqrt(a.x), a.y), a.x),
        column(1 / (3 * sqrt(a.x)), Zero(1, 1)),
        assuming=(inequality(a.x > 0),),
    )
    assert plain(repair(wrong)[0].right) == "[1 / [2 sqrt(a_x)]; 0]"


def test_a_rate_of_a_product_is_worked_out_by_its_parts() -> None:
    """The entries of all of it would have thousands of terms, at every point of the search."""
    T, S = (homogeneous(square(f"R_{k}", "R", ""), vector(f"p_{k}", "p", "")) for k in "ts")
    wrong = Claim("1", T @ rate(S) + T @ rate(S), rate(T @ S))
    with at_most(1_500_000):
        assert plain(T @ rate(S) + rate(T) @ S) in [plain(each.left) for each in repair(wrong)]
