"""What is wrong in a claim on matrices of any size is repaired, the original first or among the first."""

from __future__ import annotations

from typing import Any

import pytest

from chasles.checker.certificate import check
from chasles.decisions.session import Session
from chasles.repairs.repair import repair
from chasles.statements import Claim, Definition, nonzero, symmetric
from chasles.statements.matrices import invertible
from chasles.vocabulary import (
    CPM,
    Identity,
    Node,
    Zero,
    cross,
    det,
    inverse,
    matrix,
    plain,
    rate,
    square,
    tr,
    vector,
)
from chasles.vocabulary.partial import gradient, partial
from chasles.vocabulary.sizes import Size, rectangular

UNITS = False
n, m = Size("n"), Size("m")
A, B, P, X = (square(name, name, "", size=n) for name in "ABPX")
D, R = square("D", "D", "", size=m), square("R", "R", "", size=m)
H, U, V = rectangular("H", "H", "", m, n), rectangular("U", "U", "", n, m), rectangular("V", "V", "", m, n)
a, b, x, u, v = (vector(name, name, "", size=n) for name in "abxuv")
S = H @ P @ H.T + R
c, e = vector("c", "c", ""), vector("e", "e", "")

SLIPPED: list[tuple[Node, Node, str, tuple[Any, ...]]] = [
    (inverse(A @ B), inverse(A) @ inverse(B), "B^-1 A^-1", (invertible(A), invertible(B))),
    (det(Identity(n) + u @ v.T), 1 - v.T @ u, "1 + v^T u", ()),
    ((x - a).T @ A @ (x - a), x.T @ A @ x + 2 * a.T @ A @ x + a.T @ A @ a, "x^T A x - 2 a^T A x + a^T A a",
     (symmetric(A),)),
    (H @ P @ H.T @ inverse(S), Identity(m) + R @ inverse(S), "1 - R (H P H^T + R)^-1", (invertible(S),)),
    (rate(inverse(X)), -(inverse(X) @ rate(X) @ X), "-X^-1 X_dot X^-1", (invertible(X),)),
    (gradient(x.T @ A @ x, x), (A - A.T) @ x, "(A + A^T) x", ()),
    (gradient(x.T @ A @ x, x), A @ x, "2 A x", (symmetric(A),)),
    (partial(tr(A @ X @ B), X), A.T @ B, "A^T B^T", ()),
    (partial(a.T @ X @ b, X), b @ a.T, "a b^T", ()),
    (inverse(A + u @ v.T), inverse(A) + inverse(A) @ u @ v.T @ inverse(A) / (1 + v.T @ inverse(A) @ u),
     "A^-1 - A^-1 u v^T A^-1 / (1 + v^T A^-1 u)", (invertible(A), nonzero(1 + v.T @ inverse(A) @ u))),
    (det(matrix([A, U], [V, D])), det(A) * det(D + V @ inverse(A) @ U), "det(A) det(D - V A^-1 U)", (invertible(A),)),
    (inverse(matrix([A, U], [0, D])), matrix([inverse(A), inverse(A) @ U @ inverse(D)], [0, inverse(D)]),
     "[A^-1, -A^-1 U D^-1; 0, D^-1]", (invertible(A), invertible(D))),
    (x.T @ (A + A.T) @ x, 2 * x.T @ x, "2 x^T A x", ()),
    (partial(cross(c, e), c), CPM(e), "-CPM(e)", ()),
    (inverse(matrix([A, U], [0, D])), matrix([inverse(A), 0], [0, inverse(D)]), "[A^-1, -A^-1 U D^-1; 0, D^-1]",
     (invertible(A), invertible(D))),
    (inverse(matrix([0, A], [B, 0])), matrix([0, inverse(B)], [Zero(n, n), 0]), "[0, B^-1; A^-1, 0]",
     (invertible(A), invertible(B))),
    (matrix([A, U], [V, D]), matrix([Identity(n), 0], [V @ inverse(A), Identity(m)]) @ matrix([A, 0], [0, D])
     @ matrix([Identity(n), inverse(A) @ U], [0, Identity(m)]),
     "[1, 0; V A^-1, 1] [A, 0; 0, D - V A^-1 U] [1, A^-1 U; 0, 1]", (invertible(A),)),
    (H @ P @ H.T @ inverse(S), Identity(m) - R, "1 - R (H P H^T + R)^-1", (invertible(S),)),
    (rate(inverse(X)), -(inverse(X) @ rate(X)), "-X^-1 X_dot X^-1", (invertible(X),)),
    (gradient(x.T @ A @ x, x), A @ x, "A x + A^T x", ()),
    (inverse(A @ B), inverse(B) @ A, "B^-1 A^-1", (invertible(A), invertible(B))),
    (P @ H.T @ inverse(S), inverse(inverse(P) + H.T @ inverse(R) @ H) @ H.T @ R, "(P^-1 + H^T R^-1 H)^-1 H^T R^-1",
     (invertible(P), invertible(R), invertible(S))),
]  # fmt: skip


@pytest.mark.sampled(4)
@pytest.mark.parametrize(("left", "right", "meant", "assuming"), SLIPPED, ids=lambda said: str(said)[:60])
def test_slips_are_repaired(left: Node, right: Node, meant: str, assuming: Any) -> None:
    repairs = repair(Claim("1", left, right, assuming=assuming))
    found = [plain(each.right) for each in repairs]
    assert meant in found[:2], found
    first = repairs[found.index(meant)]
    check(Claim("1", first.left, first.right, assuming=assuming), "printed", first.verdict.certificate)


def test_a_claim_that_is_true_of_even_sizes_alone_is_repaired() -> None:
    """The sign of the determinant is that of n^2 exchanges of columns."""
    found = repair(Claim("1", det(matrix([B, A], [X, 0])), det(A) * det(X)))
    assert "[A, B; 0, X] instead of [B, A; X, 0]" in {each.changes[0] for each in found}


def test_points_of_matrices_with_more_rows_than_columns() -> None:
    found = repair(Claim("1", H @ H.T @ H, H, assuming=(invertible(H.T @ H),)))
    assert "H (H^T H)^-1 H^T H" in {plain(each.left) for each in found}


def test_what_says_more_comes_first_of_two_letters_that_may_be_wrong() -> None:
    claim = Claim("1", det(matrix([A, X], [P, X])), det(A) * det(X - P @ inverse(A) @ B), assuming=(invertible(A),))
    assert repair(claim)[0].changes == ("B instead of X",)


def test_a_determinant_inside_what_is_said_to_have_an_inverse() -> None:
    claim = Claim("1", det(X - A / det(B)), det(X), assuming=(invertible(B), invertible(X - A / det(B))))
    assert Session().decide(claim).verdict.name == "fails"


def test_what_is_true_of_one_size_only_is_no_repair() -> None:
    """At n = 2 the adjugate is linear in the matrix; that is proved for no other size."""
    claim = Claim("1", det(A + Identity(n)), det(A) - tr(A) + 1)
    assert all("tr" not in plain(each.right) or each.verdict.true for each in repair(claim))
    assert not [each for each in repair(claim) if plain(each.right) == "det(A) + tr(A) + 1"]


def test_a_size_that_only_what_is_given_has() -> None:
    """The number of rows of H is in none of the sides."""
    gram = Definition("0", A, H.T @ H)
    found = repair(Claim("1", A.T @ A, A @ A @ A, given=(gram,)))
    assert "A A" in [plain(each.right) for each in found]


def test_what_is_undecided_is_left_alone_where_its_sides_agree_at_points() -> None:
    agreeing = Claim("1", x.T @ A @ x, x.T @ A.T @ x)
    assert repair(agreeing, undecided=True) == ()
    assert repair(Claim("1", x.T @ A @ x, 2 * x.T @ A.T @ x), undecided=True)
