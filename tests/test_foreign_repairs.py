"""Repairs inside what a letter stands for, and of what a claim leaves free, on equations that are not the chapter's."""

from __future__ import annotations

import pytest

from chasles.repairs.ranking import idle_parts
from chasles.repairs.repair import repair
from chasles.statements import Claim, Definition, nonzero, rotation, unit_column
from chasles.vocabulary import (
    CPM,
    Identity,
    Node,
    Zero,
    array,
    column,
    cross,
    inverse,
    matrix,
    plain,
    rate,
    scalar,
    square,
    vector,
)

one, O = Identity(3), Zero(3, 3)
a, b = (vector(name, name, "a vector") for name in "ab")
x, y = (scalar(name, name, "a number") for name in "xy")
A, B = (square(name, name, "a matrix") for name in "AB")
FACTOR = matrix((A, O), (B, O))

INSIDE: list[tuple[Node, Node, bool, str]] = [
    (matrix((-(CPM(a) @ CPM(a)), CPM(a)), (-CPM(a), one)), matrix((O, O), (one, O)), True, "[CPM(a), 0; 1, 0]"),
    (matrix((A @ A.T, A), (A.T, one)), matrix((O, O), (one, O)), True, "[A, 0; 1, 0]"),
    (matrix((A @ A.T, A), (A.T, one)), matrix((A, O), (O, O)), True, "[A, 0; 1, 0]"),
    (matrix((A @ A.T, A @ B.T), (B @ A.T, 2 * B @ B.T)), matrix((A, O), (B, O)), True, "[A, 0; B, B]"),
    (matrix((A @ A, O), (B @ A + A @ B, A @ A)), matrix((A, O), (B, O)), False, "[A, 0; B, A]"),
    (matrix((one, O), (2 * A, one)), matrix((one, O), (O, one)), False, "[1, 0; A, 1]"),
    (matrix((one, A.T), (A, one + A @ A.T)), matrix((one, O), (O, one)), True, "[1, 0; A, 1]"),
]


@pytest.mark.sampled(3)
@pytest.mark.parametrize(("left", "wrong", "transposed", "right"), INSIDE, ids=range(len(INSIDE)))
def test_a_block_that_is_missing_in_a_factor_is_found(left: Node, wrong: Node, transposed: bool, right: str) -> None:
    factor = array("P", "P", "a factor", wrong)
    product = factor @ factor.T if transposed else factor @ factor
    named = array("M", "M", "a product", left)
    found = repair(Claim("3", named, product, given=(Definition("1", factor, wrong), Definition("2", named, left))))[0]
    assert plain(found.right) == f"{right} {right}" + ("^T" if transposed else "")
    assert found.changes == (f"P = {right} instead of {plain(wrong)}",)


def test_a_slip_on_the_left_side_is_nearer_than_one_in_a_definition() -> None:
    factor = array("P", "P", "a factor", FACTOR)
    left = matrix((A @ A.T, A @ B.T), (B @ A.T, 2 * B @ B.T))
    found = repair(Claim("2", left, factor @ factor.T, given=(Definition("1", factor, FACTOR),)))[0]
    assert (plain(found.left), plain(found.right)) == ("[A A^T, A B^T; B A^T, B B^T]", "P P^T")


pair, X = array("p", "p", "a pair", column(a, b)), array("X", "X", "a matrix", matrix((CPM(a), CPM(b))))
given = (Definition("1", pair, column(a, b)), Definition("2", X, matrix((CPM(a), CPM(b)))))
is_unit = (unit_column(a, b),)
claim = Claim("3", CPM(a) @ rate(a) + CPM(b) @ rate(b), X @ rate(pair), given=given, assuming=is_unit)


@pytest.mark.parametrize(("vector", "sign", "words"), [(a, 1, "X + a [a; b]^T"), (b, -1, "X - b [a; b]^T")])
def test_what_is_right_for_another_object_that_a_claim_allows_is_told(vector: Node, sign: int, words: str) -> None:
    """X rate(p) does not change with X + c p^T, for p has length one."""

    def dyad_rate(block: Node) -> Node:
        return sign * (rate(vector) @ block.T + vector @ rate(block).T)

    printed = matrix((CPM(rate(a)) + dyad_rate(a), CPM(rate(b)) + dyad_rate(b)))
    (found,) = repair(Claim("4", rate(X), printed, given=given, assuming=is_unit), context=(claim,))
    assert found.changes == (f"d/dt ({words}) instead of X_dot",)
    assert found.modulo == "(3) says the same of X + c [a; b]^T for every vector c"
    assert found.right == printed


def test_what_leaves_nothing_of_a_factor_or_a_term_ranks_behind() -> None:
    """The slip a x a -> a x b is undone in one way that says nothing; R R^T is one that nobody prints."""
    slip = Claim("5", CPM(a) @ b + A @ a, cross(b, a) + A @ a)
    assert repair(slip)[0].changes == ("the sign of b x a is turned",)
    assert [idle_parts(node, {A}) for node in (a - a, cross(b, b), A @ A.T, B @ B.T, x * (a / x))] == [1, 1, 1, 0, 1]


def test_a_block_that_is_missing_is_a_product_with_a_transpose_or_a_quotient() -> None:
    inverted = matrix((A.T, Zero(3, 1)), (0, 1))
    assert repair(Claim("6", inverse(matrix((A, a), (0, 1))), inverted, assuming=(rotation(A),)))[0].changes == (
        "the term -A^T a is added",
    )
    wrong = Claim("7", inverse(matrix((x, y), (0, 1))), matrix((1 / x, 0), (0, 1)), assuming=(nonzero(x),))
    assert "[1 / x, -y / x; 0, 1]" in [plain(found.right) for found in repair(wrong)]


def test_a_lost_term_with_factors_of_its_own_is_found_where_the_others_stand() -> None:
    u, v, p, q = (vector(name, name, "a vector") for name in "uvpq")
    k, m, n, h = (scalar(name, name, "a number") for name in "kmnh")
    u_of, v_of = Definition("1", u, k * p + m * q), Definition("2", v, n * p + x * q)
    h_of = Definition("3", h, k * x - m * n, assuming=(nonzero(h),))
    found = repair(Claim("4", p, -(m / h * v), given=(u_of, v_of, h_of)))[0]
    assert (plain(found.left), plain(found.right)) == ("p", "-(m / h) v + (x / h) u")
