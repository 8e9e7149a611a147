"""Exponentials, logarithms, powers, hyperbolic and inverse functions: what is true is proved where it is meant."""

from __future__ import annotations

from dataclasses import replace
from typing import Any

import pytest
import sympy as sp
from sympy import (
    Abs,
    E,
    Eq,
    I,
    Rational,
    acos,
    acosh,
    acot,
    arg,
    asin,
    asinh,
    atan,
    atan2,
    atanh,
    cbrt,
    cos,
    cosh,
    coth,
    csch,
    exp,
    log,
    pi,
    sec,
    sech,
    sin,
    sinh,
    sqrt,
    tan,
    tanh,
)  # fmt: skip

from chasles.prove import Rejected, Untreatable, prove, recheck
from chasles.verdict import Contradictory, Fails, Holds, HoldsUnder, Undecided

x, y, z, t, a, b = sp.symbols("x y z t a b")
p, q = sp.symbols("p q", positive=True)
n = sp.Symbol("n", integer=True)
f = sp.Function("f")(t)
third = Rational(1, 3)

TRUE: list[tuple[Any, Any]] = [
    (exp(x + y), exp(x) * exp(y)),
    (exp(x / 2) ** 2 * exp(-x), 1),
    (sqrt(exp(x)), exp(x / 2)),
    (exp(x + exp(x)), exp(x) * exp(exp(x))),
    (exp(x) ** y, exp(x * y)),
    (E**x * E, exp(x + 1)),
    (cosh(x) ** 2 - sinh(x) ** 2, 1),
    (cosh(x + y), cosh(x) * cosh(y) + sinh(x) * sinh(y)),
    (tanh(2 * x), 2 * tanh(x) / (1 + tanh(x) ** 2)),
    (1 - tanh(x) ** 2, sech(x) ** 2),
    (cosh(3 * x), 4 * cosh(x) ** 3 - 3 * cosh(x)),
    (sinh(x / 2) ** 2, (cosh(x) - 1) / 2),
    (log(exp(x)), x),
    (log(cosh(x)), log(exp(2 * x) + 1) - x - log(2)),
    (log(6), log(2) + log(3)),
    (log(Rational(8, 27)), 3 * log(2) - 3 * log(3)),
    (log(p * q), log(p) + log(q)),
    (log(x**2 + 1) * 2, log((x**2 + 1) ** 2)),
    (p ** (a + b), p**a * p**b),
    ((p**a) ** b, p ** (a * b)),
    (p**a * q**a, (p * q) ** a),
    (sqrt(p**a), p ** (a / 2)),
    (2 ** (x + 1), 2 * 2**x),
    (4**x, 2 ** (2 * x)),
    (6**x, 2**x * 3**x),
    (sqrt(2) ** x, 2 ** (x / 2)),
    (cbrt(p * q), cbrt(p) * cbrt(q)),
    (cbrt(p) * p ** Rational(1, 6), sqrt(p)),
    (cbrt(2) * cbrt(4), 2),
    (asinh(sinh(x)), x),
    (asinh(x), log(x + sqrt(x**2 + 1))),
    (sinh(2 * asinh(x)), 2 * x * sqrt(1 + x**2)),
    (sp.Derivative(exp(f), t), f.diff(t) * exp(f)),
    (sp.diff(exp(-a * t) * cos(b * t), t, 2) + 2 * a * sp.diff(exp(-a * t) * cos(b * t), t),
     -(a**2 + b**2) * exp(-a * t) * cos(b * t)),
    (sp.diff(cosh(f), t, 2), cosh(f) * f.diff(t) ** 2 + sinh(f) * f.diff(t, 2)),
    (exp(x + I * y), exp(x) * (cos(y) + I * sin(y))),
    (cosh(x + I * y), cosh(x) * cos(y) + I * sinh(x) * sin(y)),
    (sin(exp(x)) ** 2 + cos(exp(x)) ** 2, 1),
    (sin(x + I * y), sin(x) * cosh(y) + I * cos(x) * sinh(y)),
    (2 * atan(third) + atan(Rational(1, 7)), pi / 4),
    (4 * atan(Rational(1, 5)) - atan(Rational(1, 239)), pi / 4),
    (atan(2) + atan(3), 3 * pi / 4),
    (acos(Rational(3, 5)) + acos(Rational(4, 5)), pi / 2),
    (atan2(-3, -4) + pi, atan2(3, 4)),
    (atan(exp(x)) + atan(exp(-x)), pi / 2),
    (2 * atan(tanh(x / 2)), atan(sinh(x))),
    (asin(tanh(x)), atan(sinh(x))),
    (x * (acos(third) + asin(third)), x * pi / 2),
]  # fmt: skip
CONDITIONAL: list[tuple[Any, Any, set[str]]] = [
    (log(p**2 / q), 2 * log(p) - log(q), set()),
    (log(x * y), log(x) + log(y), {"x*y > 0", "x > 0", "y > 0"}),
    (log(x * y), log(-x) + log(-y), {"x*y > 0", "-x > 0", "-y > 0"}),
    (log(x**2), 2 * log(Abs(x)), {"x != 0"}),
    (log(x**2), 2 * log(x), {"x > 0"}),
    (log(1 / x), -log(x), {"1/x > 0", "x > 0"}),
    (log(tan(x)), log(sin(x)) - log(cos(x)), {"tan(x) > 0", "sin(x) > 0", "cos(x) > 0", "cos(x) != 0"}),
    (log(x**2 - 1), log(x - 1) + log(x + 1), {"x**2 - 1 > 0", "x - 1 > 0", "x + 1 > 0"}),
    (sqrt(x**2) + log(x), x + log(x), {"x > 0"}),
    (x ** (a + b), x**a * x**b, {"x > 0"}),
    (x**x, exp(x * log(x)), {"x > 0"}),
    (x**n * x, x ** (n + 1), {"x > 0"}),
    (cbrt(x * y), cbrt(x) * cbrt(y), {"x*y > 0", "x > 0", "y > 0"}),
    (exp(1 / x) ** 2, exp(2 / x), {"x != 0"}),
    (coth(x) ** 2 - 1, csch(x) ** 2, {"exp(2*x) - 1 != 0"}),
    ((exp(x + y) - 1) / (exp(x) * exp(y) - 1), 1, {"exp(x)*exp(y) - 1 != 0"}),
    (sinh(acosh(x)), sqrt(x**2 - 1), {"x + 1 >= 0", "x - 1 >= 0"}),
    (2 * atanh(x), log(1 + x) - log(1 - x), {"x + 1 > 0", "1 - x > 0"}),
    (2 * acosh(x), acosh(2 * x**2 - 1), {"x - 1 >= 0", "2*x**2 - 2 >= 0"}),
    (sp.asech(p), acosh(1 / p), {"-1 + 1/p >= 0", "1 - p >= 0"}),
    (cos(log(x) + y), cos(log(x)) * cos(y) - sin(log(x)) * sin(y), {"x > 0"}),
    (sp.diff(f**2 * log(f), t), 2 * f * f.diff(t) * log(f) + f * f.diff(t), {"f(t) > 0"}),
    (asin(x) + acos(x), pi / 2, {"1 - x**2 >= 0"}),
    (acos(-x), pi - acos(x), {"1 - x**2 >= 0"}),
    (atan(p) + atan(1 / p), pi / 2, set()),
    (acot(x), atan(1 / x), {"x != 0"}),
    (atan(x), acot(1 / x), {"x != 0"}),
    (atan(x), asin(x / sqrt(1 + x**2)), set()),
    (asin(x), atan(x / sqrt(1 - x**2)), {"1 - x**2 != 0", "1 - x**2 >= 0"}),
    (sin(2 * atan(x)), 2 * x / (1 + x**2), set()),
    (sin(3 * asin(x)), 3 * x - 4 * x**3, {"1 - x**2 >= 0"}),
    (cos(3 * acos(x)), 4 * x**3 - 3 * x, {"1 - x**2 >= 0"}),
    (tan(2 * atan(x)), 2 * x / (1 - x**2), {"1 - x**2 != 0"}),
    (tan(atan(x) + y), (x * cos(y) + sin(y)) / (cos(y) - x * sin(y)), {"-x*sin(y) + cos(y) != 0"}),
    (sin(2 * atan2(y, x)), 2 * x * y / (x**2 + y**2), {"x**2 + y**2 != 0"}),
    (atan2(p, q) + atan2(q, p), pi / 2, set()),
    (atan(p) - atan(q), atan((p - q) / (1 + p * q)), set()),
    (arg(p + I * q), atan(q / p), set()),
    (sp.diff(asin(f), t), f.diff(t) / sqrt(1 - f**2), {"1 - f(t)**2 != 0", "1 - f(t)**2 >= 0"}),
]  # fmt: skip
GIVEN: list[tuple[Any, Any, list[Any]]] = [
    (f.diff(t, 2), exp(f) * f.diff(t), [Eq(f.diff(t), exp(f))]),
    (y, exp(2 * x), [Eq(y, exp(x) ** 2)]),
    (exp(x) * y, exp(x), [Eq(y, 1)]),
]
FALSE: list[tuple[Any, Any]] = [
    (exp(x), 1 + x),
    (exp(x + y), exp(x) + exp(y)),
    (exp(x * y), exp(x) * exp(y)),
    (log(x + y), log(x) + log(y)),
    (log(x) ** 2, 2 * log(x)),
    (cosh(x), sinh(x)),
    (cosh(x) ** 2 + sinh(x) ** 2, 1),
    (tanh(x), sinh(x)),
    (log(2) * 3, log(9)),
    (log(2) / log(3), Rational(12, 19)),
    (exp(pi), 23),
    (exp(pi) - pi, 20),
    (exp(pi * sqrt(163)), 262537412640768744),
    (p**a, a**2 + p),
    ((p**a) ** b, p ** (a**2)),
    (2**x, x**2 + 1),
    (cbrt(p + q), cbrt(p) + cbrt(q)),
    (asinh(x), x),
    (acosh(cosh(x)), x),
    (log(x**2), log(x)),
    (atan(x) + atan(1 / x), pi / 2),
    (atan(x) + atan(y), atan((x + y) / (1 - x * y))),
    (atan(p) + atan(q), atan((p + q) / (1 - p * q))),
    (asin(sin(x)), x),
    (acos(cos(x)), x),
    (atan(tan(x)), x),
    (atan2(y, x), atan(y / x)),
    (2 * asin(x), asin(2 * x * sqrt(1 - x**2))),
    (arg((x + I * y) ** 2), 2 * arg(x + I * y)),
    (sec(atan(x)), 1 + x**2),
    (acos(x), asin(x)),
    (sp.diff(exp(f), t), exp(f)),
    (exp(I * x), exp(-I * x)),
    (log(Abs(x)), Abs(log(Abs(x)))),
]
REFUSED: list[Any] = [
    log(-1 - x**2), log(x) + log(-x), (-2) ** x, log(x + I), x ** (y + I), asin(x + I * y), exp(x) ** 2000,
    exp(x / 997), sp.LambertW(x), exp(sp.sqrt(sp.Symbol("k", complex=True))),
]  # fmt: skip


def name(case: Any) -> str:
    return (", ".join(sorted(case)) if isinstance(case, set) else str(case))[:50]


@pytest.mark.sampled(4)
@pytest.mark.parametrize(("lhs", "rhs"), TRUE, ids=name)
def test_identities_hold(lhs: Any, rhs: Any) -> None:
    verdict = prove(lhs, rhs)
    assert isinstance(verdict, Holds | HoldsUnder), verdict
    assert all(need.endswith("+ 1 > 0") or "sqrt" in need for need in verdict.needs), verdict.needs
    recheck(verdict, lhs, rhs)


@pytest.mark.sampled(4)
@pytest.mark.parametrize(("lhs", "rhs", "needs"), CONDITIONAL, ids=name)
def test_where_an_identity_is_meant_is_said(lhs: Any, rhs: Any, needs: set[str]) -> None:
    verdict = prove(lhs, rhs)
    assert isinstance(verdict, Holds | HoldsUnder), verdict
    assert set(verdict.needs) == needs
    recheck(verdict, lhs, rhs)
    values = {symbol: sp.sympify(str(verdict.witness[str(symbol)])) for symbol in (x, y, a, b, p, q, n)
              if str(symbol) in verdict.witness}  # fmt: skip
    gap = (sp.sympify(lhs) - rhs).subs(values)
    assert gap.has(t) or abs(sp.N(gap, 30)) < Rational(1, 10**20)


@pytest.mark.parametrize(("lhs", "rhs", "given"), GIVEN, ids=name)
def test_what_is_given_is_used(lhs: Any, rhs: Any, given: list[Any]) -> None:
    verdict = prove(lhs, rhs, given=given)
    assert isinstance(verdict, HoldsUnder), verdict
    assert isinstance(prove(lhs, rhs + 1, given=given), Fails | Undecided)


@pytest.mark.sampled(4)
@pytest.mark.parametrize(("lhs", "rhs"), FALSE, ids=name)
def test_false_equations_fail_at_a_point(lhs: Any, rhs: Any) -> None:
    verdict = prove(lhs, rhs)
    assert isinstance(verdict, Fails), verdict
    at = verdict.counterexample.at
    values = {symbol: sp.sympify(str(at[str(symbol)])) for symbol in (x, y, a, b, p, q) if str(symbol) in at}
    assert all(values[symbol] > 0 for symbol in (p, q) if symbol in values)
    names = {str(symbol): symbol for symbol in (x, y, a, b, p, q)}
    recheck(verdict, lhs, rhs)
    with pytest.raises(Rejected):
        recheck(verdict, lhs, lhs)
    sides = [sp.sympify(text, locals=names) for text in (verdict.counterexample.left, verdict.counterexample.right)]
    assert abs(sp.N(sides[0] - sides[1], 60)) > Rational(1, 10**20)
    if not sp.sympify(lhs - rhs).has(f) and not (sp.sympify(lhs - rhs).free_symbols - values.keys()):
        for side, told in zip((lhs, rhs), sides, strict=True):
            assert abs(sp.N(sp.sympify(side).subs(values) - told, 60)) < Rational(1, 10**30)


@pytest.mark.parametrize("lhs", REFUSED, ids=name)
def test_what_is_not_treated_is_refused(lhs: Any) -> None:
    """Of what is equal there is no counterexample either."""
    with pytest.raises(Untreatable):
        prove(lhs, lhs * (sp.cos(x) ** 2 + sp.sin(x) ** 2))


FORGED = [(lhs, rhs) for lhs, rhs, _ in CONDITIONAL]


@pytest.mark.sampled(7)
@pytest.mark.parametrize(("lhs", "rhs"), [*TRUE, *FORGED], ids=name)
def test_what_is_forged_is_rejected(lhs: Any, rhs: Any) -> None:
    verdict = prove(lhs, rhs)
    assert isinstance(verdict, Holds | HoldsUnder)
    recheck(verdict, lhs, rhs)
    for wrong in (rhs + 1, 2 * rhs + third, rhs + x**2):
        with pytest.raises(Rejected):
            recheck(verdict, lhs, wrong)
    wanted = [need for need in verdict.needs if not need.endswith("+ 1 != 0") and "sqrt" not in need]
    for need in wanted:
        fewer = tuple(other for other in verdict.needs if other != need)
        if not (fewer and (need in IMPLIED or {"x > 0", "1/x > 0"} <= {*verdict.needs})):
            with pytest.raises(Rejected):
                recheck(replace(verdict, needs=fewer), lhs, rhs)
    assert isinstance(verdict.certificate, dict)
    if isinstance(verdict, HoldsUnder):
        with pytest.raises(Rejected):
            recheck(replace(verdict, needs=(*verdict.needs, "z - 17 > 0")), lhs, rhs)
    if verdict.certificate.get("turned"):
        with pytest.raises(Rejected):
            recheck(replace(verdict, certificate={**verdict.certificate, "turned": {"1,1": -1}}), lhs, rhs)


IMPLIED = {
    "x*y > 0", "x/y > 0", "1/x > 0", "tan(x) > 0", "x**2 - 1 > 0", "x + 1 > 0", "x != 0", "cos(x) != 0",
    "x**2 + y**2 != 0",
}  # fmt: skip
"""What other needs may say too: x y > 0 is said by x > 0 and y > 0, and x != 0 by x > 0."""


@pytest.mark.parametrize("value", [-2, 0, Rational(-1, 3)])
def test_a_witness_outside_the_domain_is_rejected(value: Any) -> None:
    for lhs, rhs in (
        (log(x) + log(x), 2 * log(x)),
        (x**y * x, x ** (y + 1)),
        (cbrt(x) ** 2 * sqrt(x), x ** Rational(7, 6)),
    ):
        verdict = prove(lhs, rhs)
        assert isinstance(verdict, HoldsUnder)
        recheck(verdict, lhs, rhs)
        with pytest.raises(Rejected):
            recheck(replace(verdict, witness={**verdict.witness, "x": sp.sympify(value)}), lhs, rhs)


@pytest.mark.sampled(2)
@pytest.mark.parametrize(
    ("lhs", "rhs"),
    [(log(8, 2, evaluate=False), 3), (cbrt(x + y) ** 4, (x + y) * cbrt(x + y)), (cbrt(2) * cbrt(3), cbrt(6)),
     (cbrt(exp(3 * x)), exp(x)), (log(x, 10), log(x) / log(10))],
    ids=name,
)  # fmt: skip
def test_roots_of_sums_and_other_bases_are_decided_or_left_open(lhs: Any, rhs: Any) -> None:
    verdict = prove(lhs, rhs)
    assert isinstance(verdict, Holds | HoldsUnder | Undecided), verdict
    if not isinstance(verdict, Undecided):
        recheck(verdict, lhs, rhs)


def test_two_symbols_of_one_name_are_not_confused() -> None:
    for one, other in ((exp(x), exp(sp.Symbol("x", positive=True))), (atan(x), atan(sp.Symbol("x", real=True)))):
        with pytest.raises(Untreatable, match="two different symbols"):
            prove(one, other)


def test_where_nothing_is_defined_nothing_is_proved() -> None:
    assert isinstance(prove(1 / (cosh(x) ** 2 - sinh(x) ** 2 - 1), 1), Undecided)
    assert isinstance(prove(asin(2 + x**2) * 0 + asin(x**2 + 2), asin(x**2 + 2)), Undecided)
    assert isinstance(prove(exp(x), 1, given=[Eq(exp(2 * y) + 1, 0)]), Undecided | Contradictory)


GIVEN_LINEAR = [
    (exp(x), exp(y), Eq(x, y)),
    (exp(x) * exp(y), 1, Eq(x + y, 0)),
    (log(p), log(2 * q), Eq(p, 2 * q)),
    (sp.atan(x), -sp.atan(y), Eq(x + y, 0)),
    (sp.cosh(x), sp.cosh(y), Eq(x, -y)),
    (x + exp(2 * x), y + exp(2 * y), Eq(x, y)),
    (2**x, 2**y, Eq(x, y)),
]


@pytest.mark.parametrize(("lhs", "rhs", "given"), GIVEN_LINEAR)
def test_what_is_given_to_be_equal_may_stand_in_a_function(lhs: Any, rhs: Any, given: Any) -> None:
    verdict = prove(lhs, rhs, given=given)
    assert verdict.true, verdict
    recheck(verdict, lhs, rhs, given=given)
    wrong = prove(lhs, 2 * rhs, given=given)
    assert not wrong.true
    if isinstance(wrong, Fails):
        recheck(wrong, lhs, 2 * rhs, given=given)


LOGARITHMS = [
    (acosh(p + 1), log(p + 1 + sqrt((p + 1) ** 2 - 1))),
    (acosh(x), log(x + sqrt(x**2 - 1))),
    (acosh(x), log(x + sqrt(x - 1) * sqrt(x + 1))),
    (asinh(x), sp.sign(x) * acosh(sqrt(x**2 + 1))),
    (2 * atanh(tan(x / 2)), log((1 + sin(x)) / cos(x))),
    (atanh(-p), log((1 - p) / (1 + p)) / 2),
    (log(sqrt(p) - Abs(x)) + log(sqrt(p) + Abs(x)), log(p - x**2)),
]


@pytest.mark.sampled(3)
@pytest.mark.parametrize(("lhs", "rhs"), LOGARITHMS, ids=name)
def test_sums_of_logarithms_are_compared_by_what_they_are_of(lhs: Any, rhs: Any) -> None:
    verdict = prove(lhs, rhs)
    assert isinstance(verdict, Holds | HoldsUnder)
    recheck(verdict, lhs, rhs)
    assert isinstance(prove(lhs, rhs + log(2)), Fails)


@pytest.mark.parametrize("multiple", [0, -1, "0"])
def test_a_zeroth_power_shows_nothing(multiple: Any) -> None:
    verdict = prove(acosh(x), log(x + sqrt(x**2 - 1)))
    assert isinstance(verdict, HoldsUnder)
    forged = replace(verdict, certificate={**verdict.certificate, "raised": {"1,1": multiple}, "entries": {}})
    for wrong in (log(x + sqrt(x**2 - 1)) + log(2), log(2 * x), log(x + sqrt(x**2 - 1))):
        with pytest.raises(Rejected):
            recheck(forged, acosh(x), wrong)
