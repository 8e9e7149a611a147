"""Questions that are widened before they are proved: numbers as symbols, quantities that are defined, squares."""

from __future__ import annotations

from dataclasses import replace
from typing import Any

import pytest
import sympy as sp
from sympy import Abs, Eq, Max, Min, Rational, cbrt, cos, root, sin, sqrt

from chasles.algebra.work_limit import STEP, OutOfTime, within
from chasles.checker.expressions.cases import CheckedCase
from chasles.from_sympy.proof_by_cases import ProofByCases
from chasles.prove import Rejected, prove, recheck
from chasles.verdict import Counterexample, Fails, Holds, HoldsUnder, Undecided

x, y, z, a = sp.symbols("x y z a", real=True)
p, r = sp.symbols("p r", positive=True)
t = sp.Symbol("t")
f, g, h = (sp.Function(name)(t) for name in "fgh")

NUMBERS = [
    (cbrt(26 + 15 * sqrt(3)), 2 + sqrt(3)),
    (cbrt(7 + 5 * sqrt(2)) + cbrt(5 * sqrt(2) - 7), 2 * sqrt(2)),
    (cbrt(2 + sqrt(5)) - cbrt(sqrt(5) - 2), 1),
    (x * cbrt(7 + 5 * sqrt(2)), x * (1 + sqrt(2))),
    (sqrt(cbrt(5) - cbrt(4)), (cbrt(2) + cbrt(20) - cbrt(25)) / 3),
    (cbrt(cbrt(2) - 1), cbrt(Rational(1, 9)) - cbrt(Rational(2, 9)) + cbrt(Rational(4, 9))),
    (root((3 + 2 * root(5, 4)) / (3 - 2 * root(5, 4)), 4), (root(5, 4) + 1) / (root(5, 4) - 1)),
]
DEFINED = [
    (x / sqrt(x**2 + y**2), cos(a), [Eq(x, r * cos(a)), Eq(y, r * sin(a))]),
    (sqrt(x), y**2, [Eq(x, y**4)]),
    (sqrt(x), Abs(y), [Eq(y**2, x)]),
    (sqrt(z**2 - y**2), Abs(x), [Eq(z**2, y**2 + x**2)]),
    (sqrt(x**2 + y**2 + z**2), r, [Eq(x, r * sin(a) * cos(p)), Eq(y, r * sin(a) * sin(p)), Eq(z, r * cos(a))]),
    (sqrt(f.diff(t) ** 2 + g.diff(t) ** 2), r * Abs(h.diff(t)), [Eq(f, r * cos(h)), Eq(g, r * sin(h))]),
]
BY_SQUARES = [
    (sqrt(x + 2 * sqrt(x - 1)), 1 + sqrt(x - 1)),
    (sqrt((p + 1) ** 2 - 1), sqrt(p) * sqrt(p + 2)),
    (sqrt(2 * x + 2 * sqrt(x**2 - 1)), sqrt(x + 1) + sqrt(x - 1)),
]
BY_CASES = [
    (Min(Abs(x - y), Abs(x + y)), Abs(Abs(x) - Abs(y))),
    (Abs(x) + Abs(y) + Abs(Abs(x) - Abs(y)), Abs(x - y) + Abs(x + y)),
    (Max(Abs(x), Abs(y)), (Abs(x + y) + Abs(x - y)) / 2),
    (Max(1 / p, 1 / r), 1 / Min(p, r)),
    (Max(r, sp.exp(-sqrt(3)) * cos(1)) + Min(r, sp.exp(-sqrt(3)) * cos(1)), r + sp.exp(-sqrt(3)) * cos(1)),
]
TRUE = [(*sides, []) for sides in (*NUMBERS, *BY_SQUARES, *BY_CASES)] + DEFINED


def name(case: Any) -> str:
    return str(case)[:40]


@pytest.mark.sampled(4)
@pytest.mark.parametrize(("lhs", "rhs", "given"), TRUE, ids=name)
def test_it_holds_and_no_more_than_it(lhs: Any, rhs: Any, given: list[Any]) -> None:
    verdict = prove(lhs, rhs, given)
    assert isinstance(verdict, Holds | HoldsUnder), verdict
    recheck(verdict, lhs, rhs, given)
    for other in (rhs + 1, 2 * rhs, -rhs):
        with pytest.raises(Rejected):
            recheck(verdict, lhs, other, given)
    assert not isinstance(prove(lhs, rhs + Rational(1, 10**6), given), Holds | HoldsUnder)


@pytest.mark.sampled(3)
@pytest.mark.parametrize(("lhs", "rhs"), NUMBERS, ids=name)
def test_what_is_near_is_not_equal(lhs: Any, rhs: Any) -> None:
    assert isinstance(prove(lhs, rhs * (1 + Rational(1, 10**15))), Fails)


@pytest.mark.sampled(3)
@pytest.mark.parametrize(("lhs", "rhs", "given"), DEFINED, ids=name)
def test_a_forged_definition_is_rejected(lhs: Any, rhs: Any, given: list[Any]) -> None:
    verdict = prove(lhs, rhs, given)
    places = verdict.certificate.get("defined", [[0, 0]])
    for forged in ([[0, 1]], [*places, places[0]], [[7, 0]], [[0, 0, 0]], "0"):
        with pytest.raises(Rejected):
            recheck(replace(verdict, certificate={**verdict.certificate, "defined": forged}), lhs, rhs, given)


@pytest.mark.sampled(2)
@pytest.mark.parametrize(
    ("lhs", "rhs", "given"),
    [
        (sqrt(x), y, [Eq(x, y**2)]),
        (x / sqrt(x**2 + y**2), cos(a), [Eq(x, z * cos(a)), Eq(y, z * sin(a))]),
        (sqrt(x), x, [Eq(x, y**4)]),
        (sqrt(x + 2 * sqrt(x - 1)), sqrt(x - 1) - 1, []),
        (sqrt(f.diff(t) ** 2), f.diff(t), [Eq(f, sin(h))]),
    ],
    ids=name,
)
def test_what_a_sign_decides_does_not_hold(lhs: Any, rhs: Any, given: list[Any]) -> None:
    assert not isinstance(prove(lhs, rhs, given), Holds | HoldsUnder)


w, m, k, c = sp.symbols("omega m k c", positive=True)
A, B = sp.symbols("A B")
zeta = sp.Symbol("zeta", positive=True)
SOLUTIONS: list[tuple[Any, Any, Any, bool]] = [
    (f.diff(t, 2) + w**2 * f, 0, A * cos(w * t) + B * sin(w * t), True),
    (m * f.diff(t, 2) + k * f, 0, A * cos(sqrt(k / m) * t) + B * sin(sqrt(k / m) * t), True),
    (m * f.diff(t, 2) + k * f, 0, A * cos(sqrt(m / k) * t) + B * sin(sqrt(k / m) * t), False),
    (
        f.diff(t, 2) + 2 * zeta * w * f.diff(t) + w**2 * f,
        0,
        A * sp.exp(-zeta * w * t) * cos(w * sqrt(1 - zeta**2) * t),
        True,
    ),
    (
        f.diff(t, 2) + 2 * zeta * w * f.diff(t) + w**2 * f,
        0,
        A * sp.exp(-zeta * w * t) * cos(w * sqrt(1 + zeta**2) * t),
        False,
    ),
    (f.diff(t, 2) + 2 * w * f.diff(t) + w**2 * f, 0, (A + B * t) * sp.exp(-w * t), True),
    (f.diff(t, 2) + 2 * w * f.diff(t) + w**2 * f, 0, (A + B * t**2) * sp.exp(-w * t), False),
    (f.diff(t, 2), w**2 * f, A * sp.cosh(w * t) + B * sp.sinh(w * t), True),
    (m * f.diff(t, 2) + c * f.diff(t), m * p, m * p / c * (t + m / c * (sp.exp(-c * t / m) - 1)), True),
    (m * f.diff(t, 2) + c * f.diff(t), m * p, m * p / c * (t + m / c * (sp.exp(-2 * c * t / m) - 1)), False),
    (f.diff(t), 1 - f**2, sp.tanh(t), True),
]


@pytest.mark.sampled(3)
@pytest.mark.parametrize(("lhs", "rhs", "value", "true"), SOLUTIONS, ids=name)
def test_solutions_of_differential_equations(lhs: Any, rhs: Any, value: Any, true: bool) -> None:
    verdict = prove(lhs, rhs, Eq(f, value))
    assert isinstance(verdict, (Holds | HoldsUnder) if true else Fails), verdict
    recheck(verdict, lhs, rhs, Eq(f, value))
    if isinstance(verdict, Fails):
        with pytest.raises(Rejected):
            recheck(verdict, value, f, Eq(f, value))
        with pytest.raises(Rejected):
            recheck(verdict, lhs, rhs, [Eq(f, value), Eq(t * A, B)])


@pytest.mark.parametrize(
    ("lhs", "rhs", "given"),
    [
        (g.diff(t), w * cos(A + sp.atan(w * t)) / (1 + w**2 * t**2), [Eq(f, A + sp.atan(w * t)), Eq(g, sin(f))]),
        (g.diff(t), cos(sp.log(c + t**2)) * 2 * t / (c + t**2), [Eq(g, sin(f)), Eq(sp.log(c + t**2), f)]),
        (f * f.diff(t), (A * sp.tanh(t) + t) * (1 + A * (1 - sp.tanh(t) ** 2)), [Eq(f, A * sp.tanh(t) + t)]),
    ],
    ids=name,
)
def test_functions_of_functions_that_are_given(lhs: Any, rhs: Any, given: list[Any]) -> None:
    verdict = prove(lhs, rhs, given)
    assert isinstance(verdict, HoldsUnder), verdict
    recheck(verdict, lhs, rhs, given)
    assert isinstance(prove(lhs, rhs + c, given), Fails)


@pytest.mark.parametrize(
    ("lhs", "rhs"),
    [
        (sp.exp(-p * x) * cos(sqrt(p) * x) ** 2, sp.exp(-p * x) * (1 - sin(sqrt(p) * x) ** 2)),
        (sp.exp(2) * sin(2) * sp.cot(2), sp.exp(2) * cos(2)),
        (sp.tanh(x) * cos(x**2) ** 2, sp.tanh(x) - sp.tanh(x) * sin(x**2) ** 2),
        (cos(sp.pi / 7) * sp.cosh(x), (sp.exp(x) + sp.exp(-x)) / 2 * cos(sp.pi / 7)),
        (sp.Mul(cos(1), sp.sinh(2), sp.coth(2), evaluate=False), cos(1) * sp.cosh(2)),
        (cos(sin(2 * x) * p), cos(2 * sin(x) * cos(x) * p)),
    ],
    ids=name,
)
def test_exponentials_beside_angles_that_are_no_products(lhs: Any, rhs: Any) -> None:
    verdict = prove(lhs, rhs)
    assert isinstance(verdict, Holds), verdict
    recheck(verdict, lhs, rhs)


def test_a_function_that_is_given_has_its_value_at_other_arguments_too() -> None:
    s, q = sp.symbols("s t")
    point = Counterexample({"f(s)": Rational(5), "s": Rational(1)}, (1, 1), "5", "1")
    with pytest.raises(Rejected):
        recheck(Fails(point), sp.Function("f")(s), s, Eq(sp.Function("f")(q), q))


def test_a_symbol_without_a_name_is_no_crash() -> None:
    nameless = sp.Symbol("", real=True)
    assert isinstance(prove(sp.exp(nameless) * sp.exp(y), sp.exp(nameless + y)), Undecided)


@pytest.mark.parametrize(
    ("lhs", "rhs", "verdict"),
    [
        ((x, x < sin(x) ** 2 + cos(x) ** 2), sp.Piecewise((x, x < 1), (y, True)), Undecided),
        ((x, x < cos(x)), y - sp.Piecewise((y - x, x < cos(x)), (0, True)), Holds),
        ((x, x < y * sin(x)), sp.Piecewise((y, x >= y * sin(x)), (x, True)), Holds),
        ((x, x + sin(x) < y + sin(y)), x, Fails),
    ],
    ids=name,
)
def test_conditions_on_what_is_no_polynomial_come_to_an_end(lhs: Any, rhs: Any, verdict: type) -> None:
    """SymPy simplifies some of these without end once 1 + d is put for x; sin(x)**2 + cos(x)**2 - x is not linear."""
    assert isinstance(prove(sp.Piecewise(lhs, (y, True)), rhs), verdict)


def test_every_case_counts_as_work() -> None:
    u = sp.symbols("u:4", real=True)
    case = CheckedCase(((Max(*u),), (u[0],)), (), ())
    with within(products=3 * STEP), pytest.raises(OutOfTime):
        ProofByCases(lambda _: Undecided(""), set()).of(case)
