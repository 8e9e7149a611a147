"""What SymPy assumes of symbols counts: it excludes values in proofs, and points have only values that may be."""

from __future__ import annotations

from typing import Any

import pytest
import sympy as sp
from sympy import Abs, Eq, Matrix, Rational, sqrt

from chasles.prove import prove
from chasles.verdict import Fails, Holds, HoldsUnder, Undecided

x, y, z = sp.symbols("x y z")
p, q, W = sp.symbols("p q W", positive=True)
m = sp.Symbol("m", negative=True)
N = sp.Symbol("N", nonnegative=True)
zero = sp.Symbol("o", zero=True)
n, even, odd, prime = (sp.Symbol(k, **{k: True}) for k in ("integer", "even", "odd", "prime"))
r = sp.Symbol("r", rational=True)
w = Matrix(sp.symbols("w1:4"))
t = sp.Symbol("t")
f = sp.Function("f", positive=True)(t)
TRUE: list[tuple[Any, Any, list[Any]]] = [
    (p, 1, [Eq(p**2, 1)]),
    (x, 1, [Eq(p**2, 1), Eq(x, p)]),
    (p, 2, [Eq(p**2, 4)]),
    (p, Rational(1, 3), [Eq(9 * p**2, 1)]),
    (p, 3, [Eq(p**4, 81)]),
    (p, q, [Eq(p**2, q**2)]),
    (p, q, [Eq(p**3, q**3)]),
    (m, -1, [Eq(m**2, 1)]),
    (m, -p, [Eq(m**2, p**2)]),
    (x, 0, [Eq(p * x, 0)]),
    (x, 0, [Eq((p + q) * x, 0)]),
    (x, 0, [Eq((y**2 + 1) * x, 0)]),
    (x, y, [Eq(p * x, p * y)]),
    (x, y, [Eq(m * x, m * y)]),
    (W, sqrt(w.dot(w)), [Eq(w.dot(w), W**2)]),
    (sqrt(w.dot(w)), W, [Eq(W**2 - w.dot(w), 0)]),
    (p, sqrt(x**2 + 1), [Eq(p**2, x**2 + 1)]),
    (p * q, sqrt(x**2 + 1), [Eq(p**2 * q**2, x**2 + 1)]),
    (zero, 0, []),
    (zero * x + y, y, []),
    (sp.cos(zero * x), 1, [Eq(zero * x, 0)][:0]),
    (Abs(p), p, []),
    (Abs(m), -m, []),
    (Abs(N), N, []),
    (sqrt(p**2), p, []),
    (sqrt(m**2 * x**2), -m * Abs(x), []),
    (Abs(p * x), p * Abs(x), []),
    (sqrt(p * x) / sqrt(p), sqrt(x), []),
    (sp.sign(p), 1, []),
    (sp.Min(-N - q, sp.sign(n)), -sp.Max(N + q, -sp.sign(n)), []),
    (f.diff(t), 0, [Eq(f**2, 1)]),
]
FALSE: list[tuple[Any, Any, list[Any]]] = [
    (p, 2, [Eq(p**2, 1)]),
    (x, -1, [Eq(p**2, 1), Eq(x, p)]),
    (x, 1, [Eq(x**2, 1)]),
    (p, q, []),
    (p, x, [Eq(p**2, x**2)]),
    (m, 1, [Eq(m**2, 1)]),
    (p, 0, [Eq(p * x, 0)]),
    (x, 1, [Eq((p + q) * x, 0)]),
    (x, 0, [Eq((p - q) * x, 0)]),
    (W, -sqrt(w.dot(w)), [Eq(w.dot(w), W**2)]),
    (x, sqrt(w.dot(w)), [Eq(w.dot(w), x**2)]),
    (zero + 1, 0, []),
    (zero * x + y, x, []),
    (Abs(m), m, []),
    (N, p, []),
    (n, even, []),
    (n**2, n, []),
    (odd, 1, []),
    (prime, 2, []),
    (prime**2, x, []),
    (r, n, []),
    (even, 0, [Eq(x, even)]),
    (n, 0, [Eq(n**2, 4)]),
    (f, 1, [Eq(f.diff(t), f)]),
]


@pytest.mark.sampled(3)
@pytest.mark.parametrize(("lhs", "rhs", "given"), TRUE)
def test_signs_decide_between_values(lhs: Any, rhs: Any, given: list[Any]) -> None:
    assert isinstance(prove(lhs, rhs, given=given), Holds | HoldsUnder)


@pytest.mark.parametrize(("lhs", "rhs", "given"), FALSE)
def test_points_have_values_that_symbols_may_have(lhs: Any, rhs: Any, given: list[Any]) -> None:
    verdict = prove(lhs, rhs, given=given)
    assert isinstance(verdict, Fails), verdict
    symbols = {str(s): s for s in (p, q, W, m, N, zero, n, even, odd, prime, r)}
    for name, value in verdict.counterexample.at.items():
        if name in symbols:
            exact = sp.sympify(str(value))
            for key, known in symbols[name].assumptions0.items():
                assert getattr(exact, f"is_{key}") in (known, None), (name, value, key)


@pytest.mark.sampled(3)
@pytest.mark.parametrize(
    ("lhs", "rhs", "given"),
    [
        (n, 0, [Eq(2 * n**2, n)]),
        (n, 1, [Eq(n**2, n)]),
        (N, sqrt(w.dot(w)), [Eq(w.dot(w), N**2)]),
        (even, 2, [Eq((even - 2) * (even - 3), 0)]),
        (prime, 2, [Eq((prime - 2) * (prime - 4), 0)]),
        (r, 1, [Eq((r - 1) * (r**2 - 2), 0)]),
    ],
)
def test_what_only_some_values_make_true_is_not_told_to_fail_where_they_are_the_only_ones(
    lhs: Any, rhs: Any, given: list[Any]
) -> None:
    verdict = prove(lhs, rhs, given=given)
    if (lhs, rhs) == (n, 1):
        assert isinstance(verdict, Fails)
    else:
        assert isinstance(verdict, Holds | HoldsUnder | Undecided)
