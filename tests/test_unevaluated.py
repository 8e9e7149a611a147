"""What SymPy leaves unevaluated is written out: matrix expressions, finite sums, factorials; decimals on request."""

from __future__ import annotations

from typing import Any

import pytest
import sympy as sp
from sympy import (
    Adjoint,
    BlockMatrix,
    Determinant,
    Eq,
    HadamardProduct,
    Identity,
    Inverse,
    KroneckerProduct,
    MatMul,
    MatPow,
    Matrix,
    MatrixSymbol,
    Product,
    Rational,
    Sum,
    Trace,
    Transpose,
    ZeroMatrix,
    binomial,
    eye,
    factorial,
    zeros,
)

from chasles.prove import Untreatable, prove, recheck
from chasles.verdict import Fails, Holds, HoldsUnder

A, B = MatrixSymbol("A", 2, 2), MatrixSymbol("B", 2, 2)
C, D, u = MatrixSymbol("C", 3, 3), MatrixSymbol("D", 3, 3), MatrixSymbol("u", 3, 1)
x, y = sp.symbols("x y", real=True)
z = sp.Symbol("z")
f = sp.Function("f")(z)
i, j = sp.symbols("i j", integer=True)
n = sp.Symbol("n", integer=True, positive=True)
M = Matrix([[x, y], [1, x]])


def same(left: Any, right: Any, **more: Any) -> Any:
    verdict = prove(left, right, **more)
    assert isinstance(verdict, Holds | HoldsUnder), verdict
    recheck(verdict, left, right, **more)
    return verdict


TRUE: list[tuple[Any, Any]] = [
    (Determinant(A * B), Determinant(A) * Determinant(B)),
    (Determinant(C * D), Determinant(D * C)),
    (Determinant(C.T), Determinant(C)),
    (Determinant(2 * C), 8 * Determinant(C)),
    (Determinant(M), x**2 - y),
    (Trace(A * B), Trace(B * A)),
    (Trace(A + B), Trace(A) + Trace(B)),
    (Trace(C.T), Trace(C)),
    (Transpose(A * B), B.T * A.T),
    (Adjoint(A), A.T),
    (A**2 - Trace(A) * A + Determinant(A) * Identity(2), zeros(2, 2)),
    (HadamardProduct(A, B), HadamardProduct(B, A)),
    (BlockMatrix([[A, B], [B, A]]).T, BlockMatrix([[A.T, B.T], [B.T, A.T]])),
    (BlockMatrix([[A, ZeroMatrix(2, 2)], [ZeroMatrix(2, 2), B]]).as_explicit().det(), Determinant(A) * Determinant(B)),
    (KroneckerProduct(A, B).T, KroneckerProduct(A.T, B.T)),
    ((A * B)[0, 1], A[0, 0] * B[0, 1] + A[0, 1] * B[1, 1]),
    (MatPow(A, 3), A * A * A),
    (MatPow(A, 0), eye(2)),
    ((u.T * C * u)[0, 0], (u.T * C.T * u)[0, 0]),
    (u.T * u, Trace(u * u.T) * Identity(1)),
    (Sum(i**2, (i, 1, 5)), 55),
    (Sum(x**i, (i, 0, 3)) * (1 - x), 1 - x**4),
    (Sum(i * j, (i, 1, 2), (j, 1, 3)), 18),
    (Sum(i, (i, 1, 0)), 0),
    (Product(x + i, (i, 0, 2)), x**3 + 3 * x**2 + 2 * x),
    (factorial(5, evaluate=False), 120),
    (binomial(6, 2, evaluate=False), 15),
]
INVERSES: list[tuple[Any, Any, int]] = [
    (Inverse(A * B), Inverse(B) * Inverse(A), 3),
    (Inverse(C).T, Inverse(C.T), 1),
    (Determinant(Inverse(C)), 1 / Determinant(C), 1),
    (MatPow(A, -2), Inverse(A) * Inverse(A), 1),
    (Inverse(M), M.adjugate() / M.det(), 1),
    (Inverse(M) * M, eye(2), 1),
]
FALSE: list[tuple[Any, Any]] = [
    (Determinant(A + B), Determinant(A) + Determinant(B)),
    (Determinant(2 * A), 2 * Determinant(A)),
    (Trace(A * B), Trace(A) * Trace(B)),
    (A * B, B * A),
    (Transpose(A * B), A.T * B.T),
    (Inverse(A * B), Inverse(A) * Inverse(B)),
    (Inverse(M), M),
    (HadamardProduct(A, B), A * B),
    (Sum(i**2, (i, 1, 5)), 54),
    (Product(x + i, (i, 0, 2)), x**3),
    (binomial(6, 2, evaluate=False), 14),
    (sp.Max(1, sp.Min(3, 4, evaluate=False), evaluate=False), 6),
]


@pytest.mark.sampled(4)
@pytest.mark.parametrize(("left", "right"), TRUE, ids=str)
def test_what_is_written_out_is_proved(left: Any, right: Any) -> None:
    assert isinstance(same(left, right), Holds)


@pytest.mark.sampled(3)
@pytest.mark.parametrize(("left", "right", "needs"), INVERSES, ids=str)
def test_an_inverse_needs_its_determinant(left: Any, right: Any, needs: int) -> None:
    assert len(same(left, right).needs) == needs


@pytest.mark.parametrize(("left", "right"), FALSE, ids=str)
def test_what_is_false_is_refuted(left: Any, right: Any) -> None:
    assert isinstance(prove(left, right), Fails)


@pytest.mark.parametrize(
    ("left", "right", "message"),
    [
        (Sum(1 / (n + i), (i, 1, n)), Sum(1 / i, (i, n + 1, 2 * n)), "is not treated: of so many terms, only sums of"),
        (Sum(i, (i, 1, sp.oo)), 0, "it has an infinite limit"),
        (Sum(2**i, (i, 1, 5000)), 0, "of so many terms, only sums of polynomials in the index"),
        (MatPow(A, n), A, "the exponent n is no small integer"),
    ],
    ids=str,
)
def test_what_cannot_be_written_out_is_refused(left: Any, right: Any, message: str) -> None:
    with pytest.raises(Untreatable, match=message):
        prove(left, right)


def test_decimals_are_read_on_request_only() -> None:
    m = sp.Symbol("m", positive=True)
    assert isinstance(same(0.5 * m * x**2, m * x**2 / 2, exact=True), Holds)
    assert isinstance(same(Matrix([0.1 + x]), Matrix([x + Rational(1, 10)]), exact=True), Holds)
    assert isinstance(same(x, 0.25, given=[Eq(x, 0.25)], exact=True), HoldsUnder)
    assert isinstance(prove(0.3 * x, x / 3, exact=True), Fails)
    with pytest.raises(Untreatable, match="floating-point"):
        prove(0.5 * m * x**2, m * x**2 / 2)


def unevaluated(*terms: Any) -> Any:
    return sp.Add(*terms, evaluate=False)


@pytest.mark.parametrize(
    ("angle", "same"),
    [
        (unevaluated(2 * x + 2 * y, 4 * sp.pi), 2 * x + 2 * y),
        (unevaluated(x, unevaluated(x, y), sp.pi), 2 * x + y + sp.pi),
        (unevaluated(x + y, -(x + y)), sp.S.Zero),
        (unevaluated(unevaluated(x, sp.pi / 3), unevaluated(y, sp.pi / 6)), x + y + sp.pi / 2),
        (sp.Mul(2, unevaluated(x, unevaluated(y, x)), evaluate=False), 4 * x + 2 * y),
    ],
)
@pytest.mark.parametrize("function", [sp.sin, sp.cos, sp.tan])
def test_sums_in_sums_are_angles(function: Any, angle: Any, same: Any) -> None:
    verdict = prove(function(angle, evaluate=False), function(same))
    assert isinstance(verdict, Holds | HoldsUnder)
    assert isinstance(prove(function(angle, evaluate=False), function(same) + 1), Fails)


@pytest.mark.parametrize(
    ("left", "right"),
    [
        (Determinant(sp.ImmutableMatrix([[x, 0], [0, 1 / x]])), 1),
        (Trace(MatMul(sp.ImmutableMatrix([[x]]), sp.ImmutableMatrix([[1 / x]]))), 1),
        (Trace(HadamardProduct(sp.ImmutableMatrix([[sp.log(x), 1], [2, 3]]), sp.ImmutableMatrix([[0, 1], [2, 0]]))), 0),
        (x * Sum(i / x, (i, 1, 3)), 6),
        ((x + 1) * Sum(1 / (i + x), (i, 1, 1)), 1),
    ],
)
def test_what_cancels_when_it_is_written_out_has_to_be_defined_all_the_same(left: Any, right: Any) -> None:
    assert not isinstance(prove(left, right), Holds)


@pytest.mark.parametrize(
    ("e", "rate", "needs"),
    [
        (sp.log(z), 1 / z, {"z > 0"}),
        (y + sp.log(z) * y - y * sp.log(z), 0, set()),
        (z + sp.log(y), 1, {"y > 0"}),
        (sp.asin(z), 1 / sp.sqrt(1 - z**2), {"1 - z**2 != 0", "1 - z**2 >= 0"}),
        (abs(f), sp.sign(f) * f.diff(z), {"f(z) != 0"}),
        (sp.sqrt(f**2), f.diff(z) * f / abs(f), {"f(z) != 0"}),
        (sp.Max(f, 0), f.diff(z) * sp.Heaviside(f), {"f(z) != 0"}),
    ],
)
def test_where_a_derivative_is_taken_there_has_to_be_one(e: Any, rate: Any, needs: set[str]) -> None:
    derivative = sp.Derivative(e, z)
    for left, right in ((derivative, rate), (derivative**2, rate**2)):
        assert set(same(left, right).needs) - {"f(z) is real"} == needs


@pytest.mark.parametrize(
    ("e", "rate", "condition"),
    [(sp.Min(z, 1), 1, z < 1), (sp.acos(sp.cos(z)), 1, sp.And(z > 0, z < sp.pi)), (sp.Max(z, y), 1, z > y)],
)
def test_where_an_inequality_is_given_derivatives_are_taken_first(e: Any, rate: Any, condition: Any) -> None:
    assert same(sp.Derivative(e, z), rate, given=condition).true
    assert prove(sp.Derivative(e, z), rate + y**2, given=condition).wrong


def test_a_value_that_sympy_gets_wrong_is_not_taken() -> None:
    """Of -csc(x) SymPy (1.14) takes asec as of csc(x), where it is not evaluated at once."""
    for part, angle in ((3, sp.pi * 5 / 6), (6, sp.pi * 2 / 3), (4, sp.pi * 3 / 4)):
        turn = sp.Mul(Rational(1, part), sp.Mul(1, sp.pi, evaluate=False), evaluate=False)
        secant = sp.asec(sp.Mul(-1, sp.csc(turn, evaluate=False), evaluate=False), evaluate=False)
        assert isinstance(same(secant + x, angle + x), Holds)
        assert isinstance(prove(secant, sp.pi - angle), Fails)


@pytest.mark.parametrize(
    "e", [Adjoint(sp.S(5)), Transpose(sp.S(5)), sp.Integral(sp.cos(x ** Rational(7, 3)), (x, 0, 1))]
)
def test_what_is_no_matrix_and_what_is_no_sum_is_refused(e: Any) -> None:
    with pytest.raises(Untreatable, match=r"not treated|cannot write out"):
        prove(e, e + 1 if isinstance(e, sp.Integral) else sp.S(5))
