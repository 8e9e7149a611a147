"""Questions of `prove` on matrices whose sizes have letters: decided as declared statements are, and checked again."""

from __future__ import annotations

from dataclasses import replace
from typing import Any

import pytest
import sympy as sp
from sympy import Determinant, Eq, Identity, Inverse, MatPow, MatrixSymbol, Trace

from chasles.prove import Rejected, Untreatable, prove, recheck
from chasles.verdict import Fails, Holds, HoldsUnder, IllFormed

n, m, k = sp.symbols("n m k", integer=True, positive=True)
a = sp.Symbol("a", real=True)
A, B, C = MatrixSymbol("A", n, n), MatrixSymbol("B", n, n), MatrixSymbol("C", k, k)
P, Q, X, Y, x = (MatrixSymbol(*said) for said in (("P", n, k), ("Q", k, n), ("X", n, m), ("Y", m, n), ("x", n, 1)))
ONE = Identity(n)

TRUE: list[tuple[Any, Any, list[Any], set[str]]] = [
    ((A * B).T, B.T * A.T, [], set()),
    (Trace(X * Y), Trace(Y * X), [], set()),
    (Inverse(A * B), Inverse(B) * Inverse(A), [], {"det(A) != 0", "det(B) != 0"}),
    (A * Inverse(ONE + B * A), Inverse(ONE + A * B) * A, [], {"det(A B + 1) != 0", "det(B A + 1) != 0"}),
    (
        Inverse(A + P * C * Q),
        Inverse(A) - Inverse(A) * P * Inverse(Inverse(C) + Q * Inverse(A) * P) * Q * Inverse(A),
        [],
        {"det(A) != 0", "det(C) != 0", "det(Q A^-1 P + C^-1) != 0"},
    ),
    (Determinant(A * B), Determinant(A) * Determinant(B), [], set()),
    (Trace(a * A + B), a * Trace(A) + Trace(B), [], set()),
    (MatPow(A, 3).T, MatPow(A.T, 3), [], set()),
    (A * A.T, ONE, [Eq(A.T * A, ONE)], {"A.T*A = I"}),
    (A * B, ONE, [Eq(B * A, ONE)], {"B*A = I", "det(A) != 0"}),
    (x.T * A * x, sp.ZeroMatrix(1, 1), [A.T + A], {"A + A.T = 0"}),
    (
        A**2,
        A,
        [Eq(A, ONE - X * Inverse(X.T * X) * X.T)],
        {"A = I - X*(X.T*X)**(-1)*X.T", "det(X^T X) != 0"},
    ),
]
FALSE: list[tuple[Any, Any, list[Any]]] = [
    (A * B, B * A, []),
    ((A + B) ** 2, A**2 + 2 * A * B + B**2, []),
    (Determinant(A), 1, [Eq(A.T * A, ONE)]),
    (x.T * A * x, x.T * x, []),
    (Trace(A * B), Trace(A) * Trace(B), []),
]


@pytest.mark.parametrize(("left", "right", "given", "needs"), TRUE, ids=[str(case[0]) for case in TRUE])
def test_the_algebra_of_matrices_decides_them(left: Any, right: Any, given: list[Any], needs: set[str]) -> None:
    verdict = prove(left, right, given)
    assert isinstance(verdict, HoldsUnder if needs else Holds), verdict
    assert set(verdict.needs) == needs
    recheck(verdict, left, right, given)
    for said in ((*verdict.needs, "det(B) = 1"), verdict.needs[1:] if needs else ("a != 0",)):
        with pytest.raises(Rejected):
            recheck(HoldsUnder(said, verdict.certificate, verdict.witness), left, right, given)
    with pytest.raises(Rejected):
        recheck(verdict, left, x.T * x if right == sp.ZeroMatrix(1, 1) else right + right, given)


@pytest.mark.parametrize(("left", "right", "given"), FALSE, ids=[str(case[0]) for case in FALSE])
def test_they_fail_at_numbers_for_the_sizes(left: Any, right: Any, given: list[Any]) -> None:
    verdict = prove(left, right, given)
    assert isinstance(verdict, Fails), verdict
    recheck(verdict, left, right, given)
    found = verdict.counterexample
    with pytest.raises(Rejected):
        recheck(Fails(replace(found, left=found.right)), left, right, given)


def test_what_has_no_word_is_named() -> None:
    with pytest.raises(Untreatable, match="HadamardProduct"):
        prove(sp.HadamardProduct(A, B), sp.HadamardProduct(B, A))
    assert isinstance(prove(X, Y), IllFormed)
    with pytest.raises(ValueError, match="no theorem for Coq"):
        prove((A * B).T, B.T * A.T).coq()


def test_nothing_is_said_of_what_has_no_word_for_its_kind() -> None:
    """No power of nothing, no exponent that may be negative, no symbol of which more is assumed than a word says."""
    negative, whole = sp.Symbol("b", negative=True), sp.Symbol("j", integer=True)
    for left, right in ((MatPow(A, 0), Inverse(A)), (MatPow(A, whole), A), (negative * A, A), (whole * A, A)):
        with pytest.raises(Untreatable):
            prove(left, right)
    assert not isinstance(
        prove(sp.Symbol("p", positive=True) * A, A, [Eq(sp.Symbol("p", positive=True) ** 2, 1)]), Fails
    )
    with pytest.raises(Untreatable, match="given is None"):
        prove(A, B, None)
