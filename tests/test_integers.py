"""Integers in powers of negative numbers and in half turns, which are proved by remainders, and as limits of sums."""

from __future__ import annotations

from dataclasses import replace
from fractions import Fraction
from typing import Any

import pytest
import sympy as sp
from sympy import Abs, Product, Rational, Sum, cos, pi, sin, tan

from chasles.prove import Rejected, Untreatable, prove, recheck
from chasles.verdict import Counterexample, Fails, Holds, HoldsUnder

n, m = sp.symbols("n m", integer=True)
k = sp.Symbol("k", integer=True, positive=True)
even, odd = sp.Symbol("e", even=True), sp.Symbol("o", odd=True)
a, x = sp.symbols("a x", real=True)


def whole(function: Any, argument: Any) -> Any:
    """A function that SymPy does not evaluate."""
    return function(argument, evaluate=False)


TRUE = [
    (cos(n * pi), (-1) ** n),
    (whole(cos, n * pi + a), (-1) ** n * cos(a)),
    (whole(cos, (n + Rational(1, 2)) * pi + a), -((-1) ** n) * sin(a)),
    (sin(n * pi / 2) ** 2, (1 - (-1) ** n) / 2),
    (cos(2 * pi * n / 3), cos(4 * pi * n / 3)),
    ((-2) ** n, (-1) ** n * 2**n),
    ((-1) ** (n + m), (-1) ** n * (-1) ** m),
    ((-1) ** (n * m), cos(n * m * pi)),
    ((-1) ** (n**2), (-1) ** n),
    ((-1) ** (n**3 - n), 1),
    ((-1) ** (n * (n + 1)), 1),
    ((1 - (-1) ** n) / n, (1 - cos(n * pi)) / n),
    (cos(pi * even / 2), (-1) ** (even / 2)),
    (sin(pi * odd / 2), (-1) ** ((odd - 1) / 2)),
    (Abs((-1) ** n + x) * Abs((-1) ** n - x), Abs(1 - x**2)),
    (2 / (2 * k + 1), 1 / (k + Rational(1, 2))),
    (tan(a + n * pi / 2, evaluate=False) ** 2 * (1 + (-1) ** n), tan(a) ** 2 * (1 + (-1) ** n)),
]
FALSE = [
    ((-1) ** n, 1),
    (whole(tan, a + n * pi / 2), tan(a)),
    (cos(n * pi / 2), 0),
    ((-1) ** (n * m), (-1) ** n * (-1) ** m),
    ((-1) ** (odd * k), (-1) ** (k + 1)),
    (sin(2 * pi * n / 3), 0),
]


@pytest.mark.sampled(3)
@pytest.mark.parametrize(("left", "right"), TRUE, ids=str)
def test_remainders_prove(left: Any, right: Any) -> None:
    verdict = prove(left, right)
    assert isinstance(verdict, Holds | HoldsUnder)
    recheck(verdict, left, right)


@pytest.mark.parametrize(("left", "right"), FALSE, ids=str)
def test_an_integer_refutes(left: Any, right: Any) -> None:
    verdict = prove(left, right)
    assert isinstance(verdict, Fails)
    recheck(verdict, left, right)


def test_what_vanishes_for_some_integer_is_told_in_the_integers_of_the_question() -> None:
    verdict = prove((1 - (-1) ** n) / (n - 3), (1 - cos(n * pi)) / (n - 3))
    assert isinstance(verdict, HoldsUnder)
    assert verdict.needs == ("n - 3 != 0",)


@pytest.fixture(scope="module")
def proved() -> Any:
    return prove(cos(n * pi / 2) ** 2, (1 + (-1) ** n) / 2)


def forged(verdict: Any, **changed: Any) -> Any:
    return replace(verdict, certificate={**verdict.certificate, **changed})


def test_a_remainder_that_is_left_out_is_rejected(proved: Any) -> None:
    certificate = proved.certificate
    for remainder in certificate["cases"]:
        cases = {key: case for key, case in certificate["cases"].items() if key != remainder}
        with pytest.raises(Rejected):
            recheck(forged(proved, cases=cases), cos(n * pi / 2) ** 2, (1 + (-1) ** n) / 2)


@pytest.mark.parametrize(
    "remainders", [["n", 2, "k_1"], ["n", 0, "k_1"], ["n", 4, "n"], ["n", -4, "k_1"], ["m", 4, "k_1"]]
)
def test_other_remainders_are_rejected(proved: Any, remainders: list[Any]) -> None:
    with pytest.raises(Rejected):
        recheck(forged(proved, remainders=remainders), cos(n * pi / 2) ** 2, (1 + (-1) ** n) / 2)


def test_the_proof_for_an_integer_is_none_for_a_real_number(proved: Any) -> None:
    real = sp.Symbol("n", real=True)
    with pytest.raises(Rejected):
        recheck(proved, cos(real * pi / 2) ** 2, (1 + cos(pi * real)) / 2 + 0 * x)


def test_a_counterexample_at_no_integer_is_rejected() -> None:
    found = Counterexample({"n": Fraction(1, 2)}, (1, 1), "0", "1", "")
    with pytest.raises(Rejected):
        recheck(Fails(found), cos(n * pi), 1)


i, j, N = sp.symbols("i j N")
SUMS = [
    (Sum(i, (i, 1, n)), n * (n + 1) / 2),
    (Sum(i**3, (i, 1, n)), Sum(i, (i, 1, n)) ** 2),
    (Sum(x * i + 1, (i, m, n)), x * Sum(i, (i, m, n)) + n - m + 1),
    (Sum(j, (j, 1, i), (i, 1, n)), n * (n + 1) * (n + 2) / 6),
    (Sum(x * Sum(j, (j, 1, i)), (i, 1, n)), x * n * (n + 1) * (n + 2) / 6),
    (Sum(i, (i, 10, 5)), -30),
    (Sum(i, (i, 1, 10**6)), 500000500000),
    (Sum(i, (i, x, x + 2)), 3 * x + 3),
    (Sum((i - (n + 1) / 2) ** 2, (i, 1, n)) / n, (n**2 - 1) / 12),
    (Sum(i**2, (i, -n, n)), n * (n + 1) * (2 * n + 1) / 3),
    (Sum(j * i, (j, 0, i), (i, 0, 3)), 25),
]


@pytest.mark.sampled(5)
@pytest.mark.parametrize(("left", "right"), SUMS, ids=str)
def test_sums_of_polynomials_to_any_limit(left: Any, right: Any) -> None:
    verdict = prove(left, right)
    assert isinstance(verdict, Holds | HoldsUnder)
    recheck(verdict, left, right)
    wrong = prove(left, right + 1)
    assert isinstance(wrong, Fails)
    recheck(wrong, left, right + 1)


@pytest.mark.parametrize(
    "e", [Sum(i, (i, 1, N)), Sum(j, (j, 0, i), (i, x, x + 2)), Sum(1 / i, (i, 1, x)), Product(i, (i, 1, N))], ids=str
)
def test_other_sums_are_refused(e: Any) -> None:
    with pytest.raises(Untreatable, match="is not treated"):
        prove(e, e + 1)
