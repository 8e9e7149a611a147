"""Values are enclosed, points satisfy what is given, and nothing that is true is refuted at one."""

from __future__ import annotations

from fractions import Fraction
from typing import Any

import pytest
import sympy as sp
from sympy import Abs, Eq, Rational, acos, asin, atan, atan2, cos, cosh, exp, log, pi, sin, sinh, sqrt

from chasles.algebra.work_limit import OutOfTime, within
from chasles.checker.expressions.enclosed import BITS
from chasles.checker.sparse import Rejected
from chasles.from_sympy import proof_by_cases
from chasles.from_sympy.enclosures import Enclosures
from chasles.from_sympy.opening import opened
from chasles.from_sympy.sampling import Sampling
from chasles.points.search.values import Values
from chasles.prove import prove

x, y, z = sp.symbols("x y z")
third = Rational(1, 3)
TINY = Fraction(1, 10**15)
FUNCTIONS: list[Any] = [
    sp.exp, sp.log, sp.sin, sp.cos, sp.tan, sp.cot, sp.sec, sp.csc, sp.sinh, sp.cosh, sp.tanh, sp.coth, sp.sech,
    sp.csch, sp.atan, sp.asin, sp.acos, sp.acot, sp.asec, sp.acsc, sp.asinh, sp.acosh, sp.atanh, sp.acoth, sp.asech,
    sp.acsch, sp.Abs, sp.sign, lambda u: atan2(u, third), lambda u: atan2(u, -third),
    lambda u: atan2(-third, u), lambda u: u**third, lambda u: u**pi, lambda u: sp.Max(u, exp(u)),
    lambda u: sp.Min(u, exp(u)), lambda u: sp.Piecewise((u, (u > 1) | (u < -1)), (u**2, True)),
]  # fmt: skip


@pytest.mark.sampled(3)
@pytest.mark.parametrize("function", FUNCTIONS, ids=lambda f: str(f(x)))
def test_values_are_enclosed(function: Any) -> None:
    expression = function(x)
    bounded = 0
    for value in (*(Rational(k, 4) for k in range(-9, 10)), Rational(17, 3), 30):
        try:
            found = Enclosures({x: sp.sympify(value)})(expression)
        except Rejected:
            continue
        bounded += 1
        exact = expression.subs(x, value)
        assert sp.im(sp.N(exact, 30)) == 0
        digits, unit = Fraction(str(sp.N(exact, 80))), 1 << BITS
        assert found.low - 1 <= digits * unit <= found.high + 1
        assert found.high - found.low < unit * TINY
    assert bounded >= 3


EQUAL: list[tuple[Any, Any]] = [
    (exp(x + y), exp(x) * exp(y)),
    (log(x * y), log(x) + log(y)),
    (cosh(x) ** 2, 1 + sinh(x) ** 2),
    (asin(x) + acos(x), pi / 2),
    (sqrt(x) * sqrt(y), sqrt(x * y)),
    (sin(x + y), sin(x) * cos(y) + cos(x) * sin(y)),
    (sin(2 * atan(x)), 2 * x / (1 + x**2)),
    (Abs(x) * Abs(y), Abs(x * y)),
]


@pytest.mark.parametrize(("one", "other"), EQUAL, ids=str)
def test_equal_sides_are_never_apart(one: Any, other: Any) -> None:
    assert Sampling(opened(one, ""), opened(other, ""), 1).counterexample() is None
    found = Sampling(opened(one, ""), opened(other + Rational(1, 10**9), ""), 1).counterexample(few=True)
    assert found is not None
    values = {symbol: sp.sympify(found.at[str(symbol)]) for symbol in one.free_symbols}
    assert sp.N(one.subs(values) - sp.sympify(found.left), 40) == 0


@pytest.mark.parametrize(
    ("one", "given"),
    [
        (x - 1, [Eq(x * sin(y), 3)]),
        (x + y - z, [Eq(x + y, 2), Eq(x - z, exp(y))]),
        (x - 2 * z, [Eq(log(x) + y, 1), Eq(y, z)]),
        (x, [Eq(x**2, y**2), Eq(y, z)]),
        (exp(x), [Eq(x**2 + y**2 + z**2, 7)]),
        (exp(x), [Eq(x * y * z, 5), Eq(x + y + z, 2)]),
    ],
    ids=str,
)
def test_given_equations_hold_at_the_point(one: Any, given: list[Any]) -> None:
    pairs = [(item.lhs, item.rhs) for item in given]
    found = Sampling(opened(one, ""), opened(sp.Integer(0), ""), 1, pairs).counterexample()
    assert found is not None
    values = {symbol: sp.sympify(found.at[str(symbol)]) for symbol in (x, y, z) if str(symbol) in found.at}
    assert all(abs(sp.N((a - b).subs(values), 40)) < Rational(1, 10**30) for a, b in pairs)
    assert abs(sp.N(one.subs(values), 40)) > Rational(1, 10**10)


@pytest.mark.sampled(4)
@pytest.mark.parametrize(
    "sides",
    [
        ((x, 0), [(x**2 + 1, 0)], []),
        ((x, 0), [(x, 1), (x, 2)], []),
        ((sqrt(-1 - x**2), 1), [], []),
        ((1 / (sin(x) ** 2 + cos(x) ** 2 - 1), 1), [], []),
        ((log(-(x**2)), 1), [], []),
        ((asin(2 + x**2), 1), [], []),
        ((x, 1), [], [sin(x) ** 2 + cos(x) ** 2 - 1]),
        ((x, 1), [(exp(x), 0)], []),
        ((x, sp.I), [(y * exp(x), 0)], [y]),
    ],
    ids=str,
)
def test_where_nothing_is_defined_there_is_no_point(sides: Any) -> None:
    (one, other), given, nonzero = sides
    given = [(sp.sympify(a), sp.sympify(b)) for a, b in given]
    sampling = Sampling(opened(one, ""), opened(sp.sympify(other), ""), 1, given, nonzero)
    assert sampling.point() is None
    assert sampling.counterexample() is None


def test_what_is_assumed_of_a_symbol_is_respected() -> None:
    n, k = sp.Symbol("n", integer=True, positive=True), sp.Symbol("k", negative=True)
    found = Sampling(opened(sin(n) * k, ""), opened(k, ""), 1).counterexample()
    assert found is not None
    assert found.at["n"] > 0 > found.at["k"]
    assert found.at["n"].denominator == 1


def test_what_is_looked_at_case_by_case_and_point_by_point_is_counted(monkeypatch: pytest.MonkeyPatch) -> None:
    with within(1_000), pytest.raises(OutOfTime):
        Enclosures({x: third}).exactly(sin(x) + sp.gamma(x))
    with within(5_000), pytest.raises(OutOfTime):
        Values().into([(((0, k),), Fraction(1)) for k in range(1_000)])
    question = sp.Max(x, y) + sp.Min(x, y), x + y
    assert prove(*question).true
    monkeypatch.setattr(proof_by_cases, "MOST_PARTS", 10)
    assert prove(*question).name == "undecided"
