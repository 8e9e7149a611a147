"""Integrals and sums of functions that are not known: linearity, substitution, integration by parts, telescoping."""

from __future__ import annotations

from typing import Any

import pytest
import sympy as sp
from sympy import Integral, Product, Subs, Sum, cos, exp, pi, sin

from chasles.prove import Untreatable, prove, recheck
from chasles.verdict import Fails, Holds, HoldsUnder, Undecided

x, y, a, b, c, s = sp.symbols("x y a b c s", real=True)
n, i = sp.Symbol("n", integer=True, positive=True), sp.Symbol("i", integer=True)
f, g = sp.Function("f"), sp.Function("g")
whole = Integral(f(x), (x, a, b))
of_product = Integral(f(x) * g(x).diff(x), (x, a, b))
part = Integral(f(x).diff(x) * g(x), (x, a, b))
ends = f(b) * g(b) - f(a) * g(a)
slope = Subs(f(x).diff(x), x, 1)

TRUE: list[tuple[Any, Any]] = [
    (Integral(f(x).diff(x), (x, a, b)), f(b) - f(a)),
    (Integral(c * f(x) + g(x), (x, a, b)), c * whole + Integral(g(y), (y, a, b))),
    (whole + Integral(f(x), (x, b, c)), Integral(f(x), (x, a, c))),
    (whole, -Integral(f(x), (x, b, a))),
    (of_product, ends - part),
    (Integral(f(x) * f(x).diff(x), (x, a, b)), (f(b) ** 2 - f(a) ** 2) / 2),
    (Integral(x * f(x).diff(x, 2), (x, 0, 1)), slope - f(1) + f(0)),
    (Integral(exp(x) * (f(x) + f(x).diff(x)), (x, 0, 1)), sp.E * f(1) - f(0)),
    (Integral(f(x + c), (x, a, b)), Integral(f(x), (x, a + c, b + c))),
    (Integral(2 * x * f(x**2), (x, 0, 1)), Integral(f(x), (x, 0, 1))),
    (Integral(f(sin(x)) * cos(x), (x, 0, pi / 2)), Integral(f(s), (s, 0, 1))),
    (Integral(f(a - x), (x, 0, a)), Integral(f(x), (x, 0, a))),
    (Integral(f(x) + 2 * x, (x, 0, 1)), Integral(f(x), (x, 0, 1)) + 1),
    (Integral(f(y), (y, x, x**2)).diff(x), 2 * x * f(x**2) - f(x)),
    (Integral(f(x, y), (y, a, x)).diff(x), f(x, x) + Integral(f(x, y).diff(x), (y, a, x))),
    (Sum(f(i), (i, 1, 3)), f(1) + f(2) + f(3)),
    (Product(f(i), (i, 1, 2)), f(1) * f(2)),
    (Sum(f(i + 1) - f(i), (i, 1, n)), f(n + 1) - f(1)),
    (Sum(c * f(i) + i, (i, 1, n)), c * Sum(f(i), (i, 1, n)) + n * (n + 1) / 2),
    (Sum(f(i - 1), (i, 1, n + 1)), f(n) + Sum(f(i), (i, 0, n - 1))),
]
FALSE: list[tuple[Any, Any]] = [
    (Integral(f(x).diff(x), (x, a, b)), f(b) + f(a)),
    (Integral(c * f(x), (x, a, b)), c**2 * whole),
    (whole, Integral(f(x), (x, b, a))),
    (Integral(f(x + c), (x, a, b)), Integral(f(x), (x, a - c, b - c))),
    (Integral(f(x), (x, 0, 1)), f(1) - f(0)),
    (Sum(f(i), (i, 1, 3)), f(1) + f(2)),
]
OPEN: list[tuple[Any, Any, list[Any]]] = [
    (Integral(f(x) ** 2, (x, 0, 1)), -1, []),  # not so, and not because an integral may have any value
    (Integral(f(x), (x, 0, 1)), -1, [sp.Eq(f(x), 1)]),
    (Integral(sp.Function("f", positive=True)(x), (x, 0, 1)), -1, []),
    (of_product, ends + part, []),
    (Sum(f(i), (i, 1, n)), Sum(f(i), (i, 1, n - 1)), []),
    (Integral(s * f(x), (x, 0, 1)), Integral(x * f(x), (x, 0, 1)), []),  # two integrands in which the letter s is
    (Integral(sp.Function("f", positive=True)(x) ** 2, (x, 0, 1)), Integral(f(x) ** 2, (x, 0, 1)), []),
]  # fmt: skip


@pytest.mark.parametrize(("left", "right"), TRUE, ids=str)
def test_what_holds_for_all_functions_is_proved(left: Any, right: Any) -> None:
    verdict = prove(left, right)
    assert isinstance(verdict, Holds | HoldsUnder)
    recheck(verdict, left, right)


@pytest.mark.parametrize(("left", "right"), FALSE, ids=str)
def test_slips_are_refuted_where_an_integral_may_have_any_value(left: Any, right: Any) -> None:
    verdict = prove(left, right)
    assert isinstance(verdict, Fails)
    recheck(verdict, left, right)


@pytest.mark.parametrize(("left", "right", "given"), OPEN, ids=str)
def test_nothing_is_refuted_by_values_that_no_integral_has(left: Any, right: Any, given: list[Any]) -> None:
    assert isinstance(prove(left, right, given), Undecided)


def test_what_a_substitution_divides_by_is_needed() -> None:
    left, right = Integral(f(c * x), (x, 0, 1)) * c, Integral(f(x), (x, 0, c))
    verdict = prove(left, right)
    assert verdict.needs == ("c != 0",)
    recheck(verdict, left, right)


@pytest.mark.parametrize("e", [Integral(f(x).diff(x) / x, (x, -1, 1)), Integral(f(1 / x), (x, -1, 1))], ids=str)
def test_what_is_not_continuous_between_the_limits_is_refused(e: Any) -> None:
    with pytest.raises(Untreatable, match="is not treated"):
        prove(e, f(1))
