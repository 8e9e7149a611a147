"""Kronecker products and vec of any size: what holds is proved and checked, what does not is refuted at numbers."""

from __future__ import annotations

import pytest

from chasles.statements import Claim, symmetric
from chasles.statements.matrices import invertible, orthogonal
from chasles.vocabulary import Identity, inverse, latex, matrix, square, tr, vector
from chasles.vocabulary.products import kronecker_product as kron
from chasles.vocabulary.products import vec
from chasles.vocabulary.sizes import Size, rectangular

from .decided import claim, proved, refuted

n, m, p = Size("n"), Size("m"), Size("p")
A, C, Q = (square(name, name, "", size=n) for name in "ACQ")
B, D = (square(name, name, "", size=m) for name in "BD")
X, Y, R = rectangular("X", "X", "", n, m), rectangular("Y", "Y", "", n, m), rectangular("R", "R", "", p, n)
x, y = vector("x", "x", "", size=n), vector("y", "y", "", size=m)
one, other = Identity(n), Identity(m)

TRUE = [
    claim(kron(A, B) @ kron(C, D), kron(A @ C, B @ D)),
    claim(kron(R, B) @ kron(X, y), kron(R @ X, B @ y)),
    claim(kron(A, B).T, kron(A.T, B.T)),
    claim(kron(A, B + D), kron(A, B) + kron(A, D)),
    claim(kron(A, other) @ kron(one, B), kron(one, B) @ kron(A, other)),
    claim(kron(kron(A, B), C), kron(A, kron(B, C))),
    claim(tr(kron(A, B)), tr(A) * tr(B)),
    claim(inverse(kron(A, B)), kron(inverse(A), inverse(B)), invertible(A), invertible(B)),
    claim(kron(Q, B) @ kron(Q.T, D), kron(one, B @ D), orthogonal(Q)),
    claim(kron(A, B).T, kron(A, B), symmetric(A), symmetric(B)),
    claim(kron(matrix([A, Q], [C, A]), B), matrix([kron(A, B), kron(Q, B)], [kron(C, B), kron(A, B)])),
    claim(vec(R @ X @ B), kron(B.T, R) @ vec(X)),
    claim(vec(A @ X + X @ B), (kron(other, A) + kron(B.T, one)) @ vec(X)),
    claim(vec(x @ y.T), kron(y, x)),
    claim(vec(X).T @ vec(Y), tr(X.T @ Y)),
    claim(vec(X).T @ kron(B, A) @ vec(Y), tr(X.T @ A @ Y @ B.T)),
    claim((kron(B, A) @ vec(X)).T @ kron(B, A) @ vec(X), tr(X.T @ A.T @ A @ X @ B.T @ B)),
]
FALSE = [
    claim(kron(A, B) @ kron(C, D), kron(C @ A, B @ D)),
    claim(kron(A, B), kron(B, A)),
    claim(vec(A @ X @ B), kron(B, A) @ vec(X)),
    claim(vec(X).T @ kron(B, A) @ vec(Y), tr(X.T @ A @ Y @ B)),
    claim(vec(A.T), vec(A)),
    claim(vec(x @ y.T), kron(x, y)),
]


@pytest.mark.parametrize("said", TRUE, ids=str)
def test_what_is_true_is_proved_and_checked(said: Claim) -> None:
    proved(said)


@pytest.mark.parametrize("said", FALSE, ids=str)
def test_what_is_false_is_refuted_and_checked(said: Claim) -> None:
    refuted(said)


def test_sizes_are_multiplied() -> None:
    assert kron(R, B).shape == (m * p, n * m)
    assert str((n + 1) * m) == "m n + m"
    assert kron(A, B).shape == kron(B, A).shape
    assert latex(vec(X)) == r"\text{vec}\left( \mathbf{X} \right)"
