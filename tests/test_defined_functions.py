"""Greatest integers, remainders, factorials and gamma functions, by their definitions, recurrences and values."""

from __future__ import annotations

from dataclasses import replace
from fractions import Fraction
from typing import Any

import pytest
import sympy as sp
from sympy import Eq, Max, Mod, Rational, binomial, ceiling, exp, factorial, floor, frac, gamma, log, pi, sqrt

from chasles.checker.expressions.enclosed import EnclosedValues
from chasles.prove import Rejected, prove, recheck
from chasles.verdict import Contradictory, Counterexample, Fails, Holds, HoldsUnder, Undecided

x, y = sp.symbols("x y", real=True)
p = sp.Symbol("p", positive=True)
n, m = sp.symbols("n m", integer=True)
k = sp.Symbol("k", integer=True, positive=True)

TRUE = [
    (ceiling(x), -floor(-x), set()),
    (frac(x), x - floor(x), set()),
    (Mod(x, y) + 2 - Mod(x, y) * sp.cos(x) ** 2, 2 + Mod(x, y) * sp.sin(x) ** 2, {"y != 0"}),
    (Mod(x, y) + y * floor(x / y), x, {"y != 0"}),
    (Mod(x, 2) + 2 * floor(x / 2), x, set()),
    (gamma(x + 1) - x * gamma(x), 0, {"1/gamma(x) != 0"}),
    (floor(1 / x) * y, y * floor(1 / x), {"x != 0"}),
    (sp.sin(floor(x)) ** 2 + sp.cos(floor(x)) ** 2, 1, set()),
    (exp(floor(x) + 1), sp.E * exp(floor(x)), set()),
    (floor(n / 2) + floor((n + 1) / 2), n, set()),
    (floor(n / 3) + floor((n + 1) / 3) + floor((n + 2) / 3), n, set()),
    (Mod(n, 2) ** 2, Mod(n, 2), set()),
    (Mod(n**3 - n, 6), 0, set()),
    (Mod(n**5 - n, 30), 0, set()),
    ((-1) ** Mod(n, 2), (-1) ** n, set()),
    (Max(floor(x), y) + sp.Min(floor(x), y), floor(x) + y, set()),
    (Mod((n - m) * (2 * n + 1) / 2, 1), Mod((n - m) / 2, 1), set()),
    (gamma(x + 1), x * gamma(x), {"1/gamma(x) != 0"}),
    (gamma(p + 3) / gamma(p), p * (p + 1) * (p + 2), set()),
    (log(gamma(p + 1)), log(p) + log(gamma(p)), set()),
    (factorial(n + 1), (n + 1) * factorial(n), {"1/gamma(n + 1) != 0"}),
    (factorial(n) / factorial(n - 2), n * (n - 1), {"1/gamma(n + 1) != 0"}),
    (binomial(n, 2) + binomial(n + 1, 2), n**2, set()),
    (binomial(k, n), binomial(k - 1, n) + binomial(k - 1, n - 1), set()),
    (binomial(n, m), binomial(n, n - m), {"1/gamma(n + 1) != 0"}),
    (binomial(n, n), 1, {"1/gamma(n + 1) != 0"}),
    (binomial(k, k), 1, set()),
    (binomial(x, y) - binomial(x, x - y), 0, {"1/gamma(x + 1) != 0"}),
    (sp.rf(x, y) * sp.rf(x + y, -y), 1, {"1/gamma(x) != 0", "1/gamma(x + y) != 0"}),
    (gamma(x) / gamma(x + 2), 1 / (x * (x + 1)), {"x != 0", "x + 1 != 0", "1/gamma(x + 2) != 0"}),
    (sp.beta(p, y), sp.beta(p + 1, y) + sp.beta(p, y + 1), {"1/gamma(y) != 0"}),
    (sp.rf(p, n + 1), (p + n) * sp.rf(p, n), {"1/gamma(n + p) != 0"}),
    (sp.ff(x, m), sp.rf(x - m + 1, m), {"1/gamma(x + 1) != 0"}),
    (sp.erfc(-x), 2 - sp.erfc(x), set()),
    (sp.fibonacci(n) ** 2 - sp.fibonacci(n - 1) * sp.fibonacci(n + 1), (-1) ** (n - 1), set()),
    (sp.fibonacci(2 * n), sp.fibonacci(n) * sp.lucas(n), set()),
    (sp.Sum(sp.fibonacci(m), (m, 1, k)), sp.fibonacci(k + 2) - 1, set()),
    (x * sp.sinc(x) + y, sp.sin(x) + y, set()),
    (sp.sinc(x) - sp.sinc(-x), 0, set()),
    (n * sp.KroneckerDelta(n, m), m * sp.KroneckerDelta(m, n), set()),
    (sp.GoldenRatio**2, sp.GoldenRatio + 1, set()),
    (sp.TribonacciConstant**3, sp.TribonacciConstant**2 + sp.TribonacciConstant + 1, set()),
    (sp.Subs(x**2 + y, x, sp.cos(y)), sp.cos(y) ** 2 + y, set()),
    (sp.erf(x * (x + 1)) * y + sp.erf(x**2 + x), (y + 1) * sp.erf(x**2 + x), set()),
    (sp.erf(log(x)) / 2, sp.erf(log(x)) - sp.erf(log(x), evaluate=False) / 2, {"x > 0"}),
    (sp.besselj(0, x) ** 2 - sp.Si(x) ** 2, (sp.besselj(0, -x) - sp.Si(x)) * (sp.besselj(0, x) + sp.Si(x)), set()),
]
FALSE = [
    (floor(x + y), floor(x) + floor(y)),
    (floor(2 * x), 2 * floor(x)),
    (floor((n**3 - n) / 6), (n**3 - n) / 6 - sp.Piecewise((Rational(2, 3), Eq(Mod(n, 6), 2)), (0, True))),
    (ceiling(x), floor(x) + 1),
    (Mod(x, 2 * y), Mod(x, y)),
    (Mod(n, 3) ** 2, Mod(n, 3)),
    (frac(x) + frac(-x), 0),
    (gamma(x), gamma(x + 1)),
    (factorial(2 * n), 2 * factorial(n)),
    (binomial(n, 2), n * (n + 1) / 2),
    (binomial(n, m), binomial(m, n)),
    (binomial(k, n), binomial(k, n + 1)),
    (sp.beta(x, y), gamma(x) * gamma(y)),
    (sp.fibonacci(2 * n), 2 * sp.fibonacci(n)),
    (x * sp.sinc(x), x),
    (sp.KroneckerDelta(n, m), 1),
    (sp.GoldenRatio**2, 3),
]


@pytest.mark.parametrize(("left", "right", "needs"), TRUE, ids=lambda case: "" if isinstance(case, set) else str(case))
def test_definitions_and_recurrences_prove(left: Any, right: Any, needs: set[str]) -> None:
    verdict = prove(left, right)
    assert isinstance(verdict, Holds | HoldsUnder), verdict
    assert set(getattr(verdict, "needs", ())) == needs
    recheck(verdict, left, right)
    with pytest.raises(Rejected):
        recheck(verdict, left, right + 1)
    for need in needs:
        with pytest.raises(Rejected):
            recheck(replace(verdict, needs=tuple(needs - {need})), left, right)


@pytest.mark.parametrize(("left", "right"), FALSE, ids=str)
def test_values_refute(left: Any, right: Any) -> None:
    verdict = prove(left, right)
    assert isinstance(verdict, Fails), verdict
    recheck(verdict, left, right)


def test_of_functions_that_are_only_bounded_nothing_else_is_told() -> None:
    for left, right in ((sp.Si(x), 0), (sp.Si(x), sp.Si(y)), (sp.erf(x), sp.Si(x))):
        assert isinstance(prove(left, right), Undecided)
    order = Rational(1, 3)
    assert isinstance(prove(sp.besselj(order, x) * 2, sp.besselj(order, x) + sp.besselj(order, x) * y / y), Undecided)


def test_a_value_that_is_given_is_one_at_a_point() -> None:
    assert prove(floor(x) ** 2, 4, given=[Eq(floor(x), 2)]).needs == ("floor(x) = 2",)
    assert isinstance(prove(floor(x), 1 + 0 * y, given=[Eq(2 * floor(x), 1)]), Contradictory)


def test_fractions_of_even_numbers_are_no_integers() -> None:
    """SymPy (1.14) takes a sixth of an even number, and of 2 (k + 1), for an integer."""
    even = sp.Symbol("e", even=True)
    for value, multiple in ((even, 1), (2 * k + 2, n), ((2 * k + 2) ** 3, 1)):
        for claim in ((floor(x * multiple / 6), x * multiple / 6), (sp.sin(pi * x * multiple / 6), 0)):
            found = prove(*claim, given=[Eq(x, value)])
            assert isinstance(found, Fails), value
            recheck(found, *claim, given=[Eq(x, value)])
    assert isinstance(prove(sp.cos(x), (-1) ** n * sp.cos(y), given=[Eq(x, y + pi * n)]), HoldsUnder)
    assert isinstance(prove(sp.tan(x), sp.tan(y), given=[Eq(x, y + pi * n / 2)]), Fails)


def test_a_divisor_and_a_remainder_by_zero_are_no_value() -> None:
    size = sp.Symbol("x", nonnegative=True)
    assert isinstance(prove(Mod(floor(-p), size), sp.Heaviside(-size)), Fails)
    assert prove(Max(0, sp.Piecewise((y, sp.Ne(Mod(-y - 1, x), 0)), (-y, True))), 1).name in ("fails", "undecided")


def test_other_values_of_functions_are_rejected() -> None:
    found = prove(floor(2 * x), 2 * floor(x))
    forged = Counterexample({"x": Fraction(1)}, (1, 1), "2", "2")
    assert isinstance(found, Fails)
    with pytest.raises(Rejected):
        recheck(replace(found, counterexample=forged), floor(2 * x), 2 * floor(x))
    with pytest.raises(Rejected):
        recheck(prove(frac(x), x - floor(x)), frac(y), x - floor(x))


@pytest.mark.parametrize(
    ("e", "value"),
    [
        (floor(sqrt(2) + x), 5), (floor(x), 4), (floor(-x), -4), (gamma(x - 2), 1),
        (gamma(x - Rational(7, 2)), sqrt(pi)),
        (gamma(x - 5), None), (gamma(x + Rational(1, 3)), None), (1 / gamma(x - 5), 0),
        (gamma(x - Rational(9, 2)), -2 * sqrt(pi)), (Mod(-x, Rational(3, 2)), Rational(1, 2)), (Mod(x, x - 4), None),
    ],
    ids=str,
)  # fmt: skip
def test_values_are_enclosed(e: Any, value: Any) -> None:
    values = EnclosedValues({x: sp.Integer(4)})
    if value is None:
        with pytest.raises(Rejected):
            values(e)
    else:
        assert values(e).meets(values(sp.sympify(value)))
