"""No more is believed of the sign of a function's value than follows from the sign of its argument."""

from __future__ import annotations

import dataclasses
from typing import Any

import pytest
import sympy as sp
from sympy import Abs, Eq, Mod, Ne, Rational, cosh, exp, floor, sinh, tanh

from chasles.prove import Rejected, prove, recheck
from chasles.verdict import Holds, HoldsUnder

x = sp.Symbol("x", real=True)
n, m = sp.symbols("n m", integer=True)
g = sp.Symbol("g", integer=True, nonnegative=True)
q = sp.Symbol("q", rational=True)
ANGLE, OTHER, ARCSINE = (f(arg, evaluate=False) for f, arg in ((sp.atan, g), (sp.atan, q**2), (sp.asin, g)))


def one_where(condition: Any) -> Any:
    """One where a condition holds, else zero."""
    return sp.Piecewise((1, condition), (0, True), evaluate=False)


def positive(e: Any) -> Any:
    """The condition that something is positive, of which SymPy is not asked."""
    return sp.Gt(e, 0, evaluate=False)


MAY_VANISH = [
    one_where(positive(n**2 + ANGLE)),
    one_where(positive(exp(x) * ANGLE)),
    one_where(positive(x**2 * ANGLE + n**2)),
    one_where(positive(g + ANGLE + x**2)),
    one_where(positive(OTHER + n**2)),
    one_where(positive(ARCSINE + n**2)),
    one_where(Ne(ANGLE * (n**2 + 1), 0, evaluate=False)),
    1 - one_where(Eq(ANGLE * (x**2 + 1), 0, evaluate=False)),
    sp.Heaviside(ANGLE + n**2, 0, evaluate=False),
    sp.sign(ANGLE + n**2, evaluate=False),
    1 - sp.KroneckerDelta(ANGLE + n**2, 0, evaluate=False),
    sp.Sum(one_where(positive(ANGLE + n**2 + m)), (m, 0, 1)) - 1,
    sp.Product(one_where(positive(sp.atan(g + m, evaluate=False) + x**2)), (m, 0, 1)),
    sp.Heaviside(sp.atan(n**2, evaluate=False) + x**2, 0, evaluate=False) + sp.cos(sp.pi * n) ** 2 - 1,
]


@pytest.mark.parametrize("e", MAY_VANISH, ids=str)
@pytest.mark.parametrize("more", [0, x])
def test_what_vanishes_at_zero_alone_is_not_taken_for_positive(e: Any, more: Any) -> None:
    assert not isinstance(prove(e + more, 1 + more), Holds | HoldsUnder)


def test_what_may_be_divided_by_zero_is_said() -> None:
    verdict = prove(Mod(x, ANGLE), x - ANGLE * floor(x / ANGLE))
    assert isinstance(verdict, HoldsUnder)
    assert verdict.needs == ("atan(g) != 0",)


@pytest.mark.parametrize("e", [
    one_where(sp.Ge(ANGLE, 0, evaluate=False)), one_where(positive(exp(x) + ANGLE)),
    one_where(positive(cosh(x) + floor(g / 2))), one_where(positive(Abs(x) + exp(n))),
    one_where(positive(tanh(sinh(g + 1)))), one_where(positive(sp.log(x**2 + 2))),
    one_where(positive(sp.atan(g + Rational(1, 2)) + n**2)), 1 + Mod(x, exp(x)) - x + exp(x) * floor(x / exp(x)),
], ids=str)  # fmt: skip
def test_what_follows_from_the_argument_is_seen(e: Any) -> None:
    assert isinstance(prove(e + x, 1 + x), Holds)


even, least = sp.Symbol("e", even=True), sp.Symbol("e", even=True, nonnegative=True)
odd_root, k = sp.Symbol("i", irrational=True), sp.Symbol("k", integer=True)


@pytest.mark.parametrize(
    "value", [least / 3, least / 3 + least**2, (odd_root**2 - 2) ** 2, (even / 3 - k) ** 2], ids=str
)
@pytest.mark.parametrize(
    "e", [one_where(positive(x)), one_where(Ne(x, 0)), sp.Heaviside(x, 0), 1 - sp.KroneckerDelta(x, 0)]
)
def test_what_sympy_takes_for_positive_though_it_may_be_zero_is_not(e: Any, value: Any) -> None:
    """For SymPy a third of an even number is no integer, and the square of an irrational number irrational."""
    assert not isinstance(prove(e, 1, given=[Eq(x, value, evaluate=False)]), Holds | HoldsUnder)


@pytest.mark.parametrize("text", ["9**9**9", "(9**9999)**9999", "("])
def test_a_witness_that_takes_forever_to_write_out_is_rejected(text: str) -> None:
    verdict = prove(x + 1, 1 + x)
    forged = dataclasses.replace(verdict, certificate={**verdict.certificate, "witness": {"x": text}})
    with pytest.raises(Rejected):
        recheck(forged, x + 1, 1 + x)


def test_a_multiple_of_a_logarithm_s_argument_is_taken_apart() -> None:
    assert prove(sp.log(Abs(n / 3 + 1)), sp.log(Abs(n + 3)) - sp.log(3)).true
