"""Entries, components and blocks: what they are, how they are printed, and which places are refused."""

from __future__ import annotations

import re
from itertools import product

import pytest

from chasles.decisions.memory import Memory
from chasles.decisions.session import Session
from chasles.statements import Chapter, Claim, Entry, Section, rotation
from chasles.verdict import Fails, Holds
from chasles.vocabulary import (
    FREQUENCY,
    LENGTH,
    Misfit,
    Node,
    Zero,
    cross,
    dot,
    latex,
    matrix,
    number,
    rate,
    row,
    square,
    tr,
    vector,
)

R = square("R", "R", "a rotation")
R_AB = square("R_AB", "R_{AB}", "the rotation of frame B in frame A")
w = vector("w", r"\omega", "an angular velocity", FREQUENCY)
p = vector("p", "p_0'", "a position", LENGTH)
T = matrix((R, p), (Zero(1, 3), 1))
session = Session()


@pytest.mark.parametrize(
    ("node", "printed"),
    [
        (R_AB[3, 1], "R_{AB,31}"),
        (p.x, "p_{0,x}'"),
        (R.T[1, 2], r"\left[ \mathbf{R}^T \right]_{12}"),
        (rate(rate(w.y)), r"\ddot{\omega}_y"),
        (matrix((1, 2), (3, 4))[1, 2], r"\begin{bmatrix} 1 & 2 \\ 3 & 4 \end{bmatrix}_{12}"),
        (vector("v", r"{}^A\mathbf{v}_{B/C}", "a velocity").z, "{}^Av_{B/C,z}"),
    ],
)
def test_the_mark_of_a_part_joins_what_the_letter_bears(node: Node, printed: str) -> None:
    assert latex(node) == printed


@pytest.mark.parametrize(
    ("left", "right"),
    [
        (tr(R), R[1, 1] + R[2, 2] + R[3, 3]),
        (cross(p, w).z, p.x * w.y - p.y * w.x),
        (rate(w.x), rate(w).x),
        (rate(R[1:2, 3]), rate(R)[1:2, 3]),
        (T[1:3, 4], p),
        (T[1:3, 1:3], R),
        (T[4, 4], number(1)),
        (R[2, 1:3] @ w, (R @ w).y),
        (R[1:3, 2], R @ matrix((0,), (1,), (0,))),
        (R[:, 1].T, row(R[1, 1], R[2, 1], R[3, 1])),
        (dot(w, w), w.x**2 + w.y**2 + w[3] ** 2),
        (R.T[1, 2], R[2, 1]),
    ],
)
def test_a_part_is_what_stands_there(left: Node, right: Node) -> None:
    claim = Claim("1", left, right)
    assert isinstance(session.decide(claim).verdict, Holds)
    assert not session.decide(Claim("1", left, right + right)).verdict.name.startswith("holds")


@pytest.mark.parametrize(("i", "j"), list(product(range(1, 4), repeat=2)))
def test_the_entries_of_a_rotation_are_its_cofactors(i: int, j: int) -> None:
    (a, b), (c, d) = [(k % 3 + 1, (k + 1) % 3 + 1) for k in (i, j)]
    cofactor = R[a, c] * R[b, d] - R[a, d] * R[b, c]
    assert session.decide(Claim("1", R[i, j], cofactor, assuming=(rotation(R),))).verdict.name == "holds-under"
    assert isinstance(session.decide(Claim("1", R[i, j], -cofactor, assuming=(rotation(R),))).verdict, Fails)


@pytest.mark.parametrize(
    ("places", "reason"),
    [
        ((0, 1), "no row 0: they are counted from 1"),
        ((1, 4), "no column 4"),
        (2, "has a row and a column, as in A[1, 2]"),
        ((slice(2, 1), 1), "no row 2 to 1"),
        ((1.5, 1), "write a number, or a range such as 1:3"),
        ((slice(1, 3, 2), 1), "is no row or column"),
        ((1, 2, 3), "a row and a column"),
    ],
)
def test_places_that_a_matrix_has_not_are_refused(places: object, reason: str) -> None:
    with pytest.raises(Misfit, match=re.escape(reason)):
        R[places]  # type: ignore[index]


def test_an_expression_is_not_gone_through() -> None:
    with pytest.raises(TypeError, match="not iterable"):
        list(w)  # type: ignore[call-overload]


def test_a_repair_with_entries_is_found_and_kept() -> None:
    wrong = Claim("1", cross(p, w).z, p.x * w.y + p.y * w.x)
    book = Chapter("Parts", (Entry("wrong", Section("1", "One"), wrong),), "parts")
    memory = Memory()
    session = Session(book=book, memory=memory)
    correction = session.decide(wrong).correction
    assert correction is not None
    assert correction.sides[1] == p.x * w.y - p.y * w.x
    again = Session(book=book, memory=Memory(memory.as_data(1000))).decide(wrong)
    assert again.correction is not None
    assert again.correction.sides == correction.sides


def test_a_zero_among_blocks_is_a_block_of_zeros() -> None:
    assert matrix((R, p), (0, 1)) == matrix((R, p), (Zero(1, 3), 1))
    assert matrix((R, 0), (0, R)).shape == (6, 6)
    assert row(R, 0) == row(R, Zero(3, 1))
    assert matrix((0, 1), (1, 0)) == matrix((number(0), 1), (1, number(0)))
    assert matrix((R, p), (0, 0, 0, 1)).shape == (4, 4)
    with pytest.raises(Misfit):
        matrix((R, 1), (0, 1))
