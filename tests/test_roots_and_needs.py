"""Roots of any degree of sums, powers of sums, divisors within divisors, and factors without a real zero."""

from __future__ import annotations

from dataclasses import replace
from typing import Any

import pytest
from sympy import (
    Eq,
    Function,
    Rational,
    Symbol,
    acot,
    acoth,
    acsch,
    atan,
    cbrt,
    cos,
    cosh,
    cot,
    csc,
    diff,
    exp,
    log,
    pi,
    sin,
    sinh,
    sqrt,
    symbols,
    tan,
)

from chasles.prove import Rejected, Untreatable, prove, recheck
from chasles.verdict import Contradictory, Fails, Holds, HoldsUnder

x, y, z, a, b, n, r = symbols("x y z a b n r")
t = symbols("t")
f, g = Function("f")(t), Function("g")(t)

ROOTS: list[tuple[Any, Any]] = [
    (cbrt(x + 1), cbrt(x + 1)),
    (cbrt(x + 1) ** 4, (x + 1) * cbrt(x + 1)),
    (cbrt(2 * x**7 - 27) * 2, cbrt(2 * x**7 - 27) + cbrt(2 * x**7 - 27)),
    (cbrt(2 * x + 2), cbrt(2) * cbrt(x + 1)),
    (cbrt(x - 1) * cbrt(x + 1), cbrt(x**2 - 1)),
    ((cbrt(2) + 1) * (cbrt(4) - cbrt(2) + 1), 3),
    (1 / (cbrt(x + 1) + 1), (cbrt(x + 1) ** 2 - cbrt(x + 1) + 1) / (x + 2)),
    (diff(cbrt(x**3 + x), x), (3 * x**2 + 1) / (3 * cbrt(x**3 + x) ** 2)),
    (diff((a + b * x) ** (n + 1), x), b * (n + 1) * (a + b * x) ** n),
    ((a + b * log(x)) ** (1 - n) / (x * (a + b * log(x))), 1 / (x * (a + b * log(x)) ** n)),
    ((2 * x**2 + 1) ** Rational(1, 6) ** 1 * sqrt(2 * x**2 + 1), (2 * x**2 + 1) ** Rational(2, 3)),
    (cbrt(x**3 + 3 * x**2 + 3 * x + 1), x + 1),
    (cbrt(x / (x + 1)), cbrt(x) / cbrt(x + 1)),
    (cbrt(1 - 3 / x) ** 2 * x, cbrt(1 - 3 / x) ** 5 * x / (1 - 3 / x)),
    (cbrt((x - 1) ** 7 * (x + 1) ** 2) ** 3, (x - 1) ** 7 * (x + 1) ** 2),
    (sqrt(x**2 + x + 1) ** 3, (x**2 + x + 1) * sqrt(x**2 + x + 1)),
    (1 / ((1 - 2 * cbrt(x - 1)) ** 2 / 3 + 1), 3 / (4 - 4 * cbrt(x - 1) + 4 * cbrt(x - 1) ** 2)),
]
DIVISORS: list[tuple[Any, Any]] = [
    (1 / (1 - (a**2 + x**2) / a**2), -(a**2) / x**2),
    (1 / (1 - 2 * x**2 / sqrt(4 * x**4 + 3)), sqrt(4 * x**4 + 3) / (sqrt(4 * x**4 + 3) - 2 * x**2)),
    (1 / (1 + 2 * tan(x) ** 2 / (1 - tan(x) ** 2)), cos(2 * x)),
    (1 / (x**2 / (2 * r * x - x**2) + 1), (2 * r - x) / (2 * r)),
    (1 / (1 - sqrt(tan(x))), (1 + sqrt(tan(x))) / (1 - tan(x))),
    (1 / (1 - sqrt(a**2 - csc(x)) / a), a * (a + sqrt(a**2 - csc(x))) * sin(x)),
    (1 / (1 - 2 * cos(x) ** 2 / cos(2 * x)), -cos(2 * x)),
    (1 / (1 - cot(x) / (1 + cot(x))), 1 + cot(x)),
    (sinh(x) / (a * (cosh(x) + 1)), sinh(x) / (a * cosh(x) + a)),
    (acot(a * x**2) + 1, acot(a * x**2) + sin(x) ** 2 + cos(x) ** 2),
    (acoth(a * x) + acsch(x), acsch(x) + acoth(a * x) * (1 + x - x)),
    (log(x) ** (n + 1) / log(x), log(x) ** n),
    (sin(x) ** (n + 1) / sin(x), sin(x) ** n),
    (cosh(x) ** (n + 1) / cosh(x), cosh(x) ** n),
]
DEFINITE: list[tuple[Any, Any, Any]] = [
    (x, 1, Eq(x**3, 1)),
    (x, 2, Eq(x**3, 8)),
    (x, -1, Eq(x**5, -1)),
    (x, a, Eq((x - a) * (x**2 + x * y + y**2 + 1), 0)),
    (x, 3, Eq(x**3 - 3 * x**2 + x, 3)),
]


@pytest.mark.sampled(3)
@pytest.mark.parametrize(("left", "right"), [*ROOTS, *DIVISORS], ids=str)
def test_true_identities_are_proved_and_checked(left: Any, right: Any) -> None:
    verdict = prove(left, right)
    assert isinstance(verdict, Holds | HoldsUnder)
    recheck(verdict, left, right)


@pytest.mark.sampled(5)
@pytest.mark.parametrize(("left", "right"), [*ROOTS, *DIVISORS], ids=str)
def test_what_is_twice_as_large_is_refuted(left: Any, right: Any) -> None:
    verdict = prove(left, 2 * right)
    assert isinstance(verdict, Fails)
    recheck(verdict, left, 2 * right)


@pytest.mark.sampled(5)
@pytest.mark.parametrize(("left", "right"), [*ROOTS, *DIVISORS], ids=str)
def test_no_proof_is_accepted_for_another_equation_or_without_needs(left: Any, right: Any) -> None:
    verdict = prove(left, right)
    assert isinstance(verdict, Holds | HoldsUnder)
    with pytest.raises(Rejected):
        recheck(verdict, left, right * 3 / 2)
    if isinstance(verdict, HoldsUnder):
        with pytest.raises(Rejected):
            recheck(replace(verdict, needs=()), left, right)


@pytest.mark.sampled(2)
@pytest.mark.parametrize(("left", "right", "given"), DEFINITE, ids=str)
def test_a_factor_without_a_real_zero_is_divided_by(left: Any, right: Any, given: Any) -> None:
    verdict = prove(left, right, given=given)
    assert isinstance(verdict, Holds | HoldsUnder)
    recheck(verdict, left, right, given=given)
    assert isinstance(prove(left, right + 1, given=given), Fails)


@pytest.mark.parametrize("given", [x**2 + x + 1, x**4 - x**3 + x**2 - x + 1, x**2 + x * y + y**2 + 1], ids=str)
def test_a_polynomial_without_a_real_zero_contradicts(given: Any) -> None:
    assert isinstance(prove(x, 5, given=given), Contradictory)


def test_a_polynomial_with_a_real_zero_is_not_divided_by() -> None:
    for factor in (x**2 - 4, x**4 - 5 * x**2 + 4, x**2 + 2 * x + 1, x**4 - x**3 - x + 1):
        assert isinstance(prove(x, 7, given=(x - 7) * factor), Fails)


def test_the_root_of_a_multiple_is_no_root() -> None:
    assert isinstance(prove(cbrt(2 * x + 2), cbrt(x + 1)), Fails)
    left = cbrt(x + 1) ** 4
    verdict = prove(left, (x + 1) * cbrt(x + 1))
    assert isinstance(verdict, HoldsUnder)
    names = {**verdict.certificate["names"]}
    (word,) = [name for name, text in names.items() if text.endswith("(1/3)")]
    for text in ("(x + 1)**(2/3)", "(2*x + 2)**(1/3)", "(x + 2)**(1/3)"):
        forged = replace(verdict, certificate={**verdict.certificate, "names": {**names, word: text}})
        with pytest.raises(Rejected):
            recheck(forged, left, (x + 1) * cbrt(x + 1))


VALUES: list[tuple[Any, Any, Any]] = [
    (log(x), 0, Eq(x, 1)),
    (exp(x + y), exp(1) * exp(x), Eq(y, 1)),
    (atan(x), pi / 4, Eq(x, 1)),
    (cbrt(x), 2, Eq(x, 8)),
    (exp(f).diff(t), exp(g + 1) * g.diff(t), Eq(f, g + 1)),
    (2**x + cosh(y), 4 + cosh(y), Eq(x, 2)),
]


@pytest.mark.parametrize(("left", "right", "given"), VALUES, ids=str)
def test_a_value_that_is_given_is_put_into_functions(left: Any, right: Any, given: Any) -> None:
    verdict = prove(left, right, given=given)
    assert isinstance(verdict, HoldsUnder)
    recheck(verdict, left, right, given=given)
    wrong = prove(left, right + 1, given=given)
    assert not isinstance(wrong, Holds | HoldsUnder)
    with pytest.raises(Rejected):
        recheck(verdict, left, right, given=Eq(given.lhs, given.rhs + 1))
    with pytest.raises(Rejected):
        recheck(verdict, left, right)


def test_a_value_at_which_a_function_is_not_real_contradicts_and_one_at_zero_is_refused() -> None:
    assert isinstance(prove(log(x), 0, given=Eq(x, -1)), Contradictory)
    assert not isinstance(prove(1 / log(x), 1, given=Eq(x, 1)), Holds | HoldsUnder | Fails)
    with pytest.raises(Untreatable, match="assumed to be zero"):
        prove(0, 1 / Symbol("o", zero=True))
