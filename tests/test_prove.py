"""The prover for SymPy users: known answers, second opinions of SymPy's own arithmetic, clear refusals, no hanging."""

from __future__ import annotations

import os
import subprocess
import sys
from collections.abc import Iterable, Iterator
from dataclasses import replace
from fractions import Fraction
from pathlib import Path
from time import perf_counter, process_time
from typing import Any

import pytest
import sympy as sp
from hypothesis import HealthCheck, assume, settings
from hypothesis import given as drawn
from hypothesis import strategies as st
from sympy import Abs, Eq, Matrix, Rational, cos, cot, csc, eye, pi, sec, sin, sqrt, tan, zeros
from sympy.core.function import AppliedUndef

from chasles.algebra.normal_form import reduce_by
from chasles.algebra.rings import make_ring
from chasles.algebra.surds import SurdSum, root_of
from chasles.algebra.work_limit import OutOfTime, remaining, within
from chasles.prove import Rejected, Untreatable, prove, recheck
from chasles.verdict import Counterexample, Fails, Holds, HoldsUnder, IllFormed, Undecided

from .sampling import WHOLE, sample

a, b, c, x, y, z, t, phi = sp.symbols("a b c x y z t phi")
m, N = sp.Symbol("m", positive=True), sp.Symbol("N", integer=True)
odd, nonzero = sp.Symbol("odd", odd=True), sp.Symbol("nonzero", nonzero=True)
f, g, theta = (sp.Function(name)(t) for name in ("f", "g", "theta"))
e = Matrix(sp.symbols("e1:4"))
e_t = Matrix([sp.Function(name)(t) for name in ("e1", "e2", "e3")])
u, v, w = (Matrix(sp.symbols(f"{name}1:4")) for name in "uvw")
R = Matrix(3, 3, sp.symbols("r1:4(1:4)"))
R_t = Matrix(3, 3, [sp.Function(f"r{i}{j}")(t) for i in (1, 2, 3) for j in (1, 2, 3)])
unit, unit_t = Eq(e.dot(e), 1), Eq(e_t.dot(e_t), 1)
rotation = [R.T * R - eye(3), Eq(R.det(), 1)]
rotation_t = [R_t.T * R_t - eye(3), Eq(R_t.det(), 1)]


def skew(vector: Any) -> Any:
    return Matrix([[0, -vector[2], vector[1]], [vector[2], 0, -vector[0]], [-vector[1], vector[0], 0]])


ONE, E = eye(3), skew(e)
Q = e * e.T + cos(phi) * (ONE - e * e.T) + sin(phi) * E
tilt = (sqrt(b**2 - 4 * a * c) - b) / (2 * a)


def entries(side: Any) -> list[Any]:
    return list(side) if isinstance(side, sp.MatrixBase) else [sp.sympify(side)]


def number(value: Any) -> Any:
    return Rational(value.numerator, value.denominator) if isinstance(value, Fraction) else sp.sympify(value)


CIRCULAR = (sin, cos, tan, cot, sec, csc)


def at_point(expression: Any, at: dict[str, Any]) -> Any:
    """The expression at a point of a counterexample, by SymPy's substitutions and addition formulas alone."""
    rates = {rate: number(at[str(rate)]) for rate in expression.atoms(sp.Derivative)}
    expression = expression.xreplace(rates)
    for key in [key for key in at if key.startswith("cos(")]:
        (inside,) = sp.sympify(key, locals={"theta": sp.Function("theta")}).args
        multiple, angle = inside.as_coeff_Mul()
        turned = sp.Dummy()
        calls = {call: call.func(call.args[0].subs(angle, turned / multiple)) for call in expression.atoms(*CIRCULAR)}
        values = {cos(turned): number(at[key]), sin(turned): number(at[f"sin({inside})"])}
        expression = sp.expand_trig(expression.xreplace(calls)).rewrite([tan, cot, sec, csc], sin)
        expression = sp.expand_trig(expression.rewrite(sec, cos)).xreplace(values)
    atoms = expression.atoms(sp.Symbol, AppliedUndef)
    return sp.expand(expression.xreplace({atom: number(at[str(atom)]) for atom in atoms if str(atom) in at}))


def confirm(verdict: Fails, lhs: Any, rhs: Any, given: Iterable[Any] = (), nonzero: Iterable[Any] = ()) -> None:
    """SymPy finds the given equations satisfied, exactly, and the two sides different."""
    found = verdict.counterexample
    row, column = found.entry
    columns = lhs.shape[1] if isinstance(lhs, sp.MatrixBase) else 1
    left, right = (entries(side)[(row - 1) * columns + column - 1] for side in (lhs, rhs))
    values = [at_point(side, dict(found.at)) for side in (left, right)]
    assert not any(value.free_symbols for value in values), (values, found)
    assert sp.expand(values[0] - values[1]) != 0
    assert abs(sp.N(values[0] - values[1], 40)) > Rational(1, 10**20)
    for text, value in zip((found.left, found.right), values, strict=True):
        said = sp.sympify(text, locals={str(atom): atom for atom in left.free_symbols | right.free_symbols})
        assert abs(sp.N(at_point(said, dict(found.at)) - value, 40)) < Rational(1, 10**20)
    for item in given:
        pairs = (
            zip(entries(item.lhs), entries(item.rhs), strict=True) if isinstance(item, Eq) else ((i, 0) for i in item)
        )
        for one, other in pairs:
            assert at_point(sp.sympify(one - other), dict(found.at)) == 0
    assert all(at_point(item, dict(found.at)) != 0 for item in nonzero)


TRUE: list[tuple[Any, ...]] = [
    (sin(x) ** 2 + cos(x) ** 2, 1),
    (sin(2 * x), 2 * sin(x) * cos(x)),
    (cos(x), 1 - 2 * sin(x / 2) ** 2),
    (cos(3 * x), 4 * cos(x) ** 3 - 3 * cos(x)),
    (sin(x + y), sin(x) * cos(y) + cos(x) * sin(y)),
    (sin(x + pi / 4), (sin(x) + cos(x)) / sqrt(2)),
    (sin(pi / 8) * cos(pi / 8), sqrt(2) / 4),
    (sin(pi / 5) * sin(2 * pi / 5), sqrt(5) / 4),
    (sqrt(x**2 + y**2) ** 2, x**2 + y**2),
    (sqrt(x**2), Abs(x)),
    (sqrt(x**4), x**2),
    (sqrt(x**6), Abs(x) ** 3),
    (Abs(x * y), Abs(x) * Abs(y)),
    (sqrt(x**2 + 2 * x * y + y**2), Abs(x + y)),
    (sqrt(2 * x**2 + 2 * y**2), sqrt(2) * sqrt(x**2 + y**2)),
    (sqrt((x - 1) ** 2 * (y**2 + 1)), Abs(x - 1) * sqrt(y**2 + 1)),
    (sqrt(1 - cos(x) ** 2), Abs(sin(x))),
    (sqrt((1 - cos(x)) / 2), Abs(sin(x / 2))),
    (sqrt(3 + 2 * sqrt(2)), 1 + sqrt(2)),
    (sqrt(3 - 2 * sqrt(2)), sqrt(2) - 1),
    (Matrix([x, y]).norm() ** 2, x**2 + y**2),
    (cos(theta).diff(t), -sin(theta) * theta.diff(t)),
    (sin(theta / 2).diff(t, 2), cos(theta / 2) * theta.diff(t, 2) / 2 - sin(theta / 2) * theta.diff(t) ** 2 / 4),
    (sin(a * t).diff(t, 2), -(a**2) * sin(a * t)),
    (sp.Derivative(f**2, t), 2 * f * f.diff(t)),
    (u.cross(v).dot(u.cross(v)), u.dot(u) * v.dot(v) - u.dot(v) ** 2),
    (u.cross(v.cross(w)) + v.cross(w.cross(u)) + w.cross(u.cross(v)), zeros(3, 1)),
    (u.cross(v.cross(w)), v * u.dot(w) - w * u.dot(v)),
    (sp.MatrixSymbol("A", 2, 2).T.T, sp.MatrixSymbol("A", 2, 2)),
    (sqrt(m**2) * x, m * x),
]
CONDITIONAL: list[tuple[Any, Any, dict[str, Any], set[str]]] = [
    (tan(x / 2), sin(x) / (1 + cos(x)), {}, {"cos(x/2) != 0", "cos(x) + 1 != 0"}),
    (tan(x / 2), (1 - cos(x)) / sin(x), {}, {"cos(x/2) != 0", "sin(x) != 0"}),
    (1 + tan(x) ** 2, sec(x) ** 2, {}, {"cos(x) != 0"}),
    (1 / tan(x), cot(x), {}, {"cos(x) != 0", "sin(x) != 0"}),
    (csc(2 * x), sec(x) * csc(x) / 2, {}, {"sin(2*x) != 0", "cos(x) != 0", "sin(x) != 0"}),
    (1 / (x - 1) - 1 / (x + 1), 2 / (x**2 - 1), {}, {"x - 1 != 0", "x + 1 != 0", "x**2 - 1 != 0"}),
    (x / (1 + 1 / x), x**2 / (x + 1), {}, {"x != 0", "x + 1 != 0"}),
    (x * y / x, y, {"nonzero": [x]}, set()),
    (x / (2 * m) + x / (2 * m) + 1 / (x**2 + 1), x / m + 1 / (1 + x**2), {}, set()),
    (1 / Abs(x), Abs(x) / x**2, {}, {"x != 0"}),
    (1 / odd, odd / odd**2, {}, {"odd != 0"}),
    (m / (nonzero * m) + 1 / (2 * N + 1), 1 / nonzero + 1 / (2 * N + 1), {}, {"nonzero != 0"}),
    (sp.log(m) / (sp.exp(x) + 1), sp.log(m) / (1 + sp.exp(x)), {}, set()),
    (sqrt(x) * sqrt(y), sqrt(x * y), {}, {"x >= 0", "y >= 0"}),
    (sqrt(x / y), sqrt(x * y) / Abs(y), {}, {"y != 0", "x*y >= 0"}),
    (1 / sqrt(x / y), sqrt(y / x), {}, {"y != 0", "x != 0", "x*y >= 0"}),
    (sqrt(f**2 + 1).diff(t), f * f.diff(t) / sqrt(f**2 + 1), {}, set()),
    (a * x**2 + b * x + c, 0, {"given": [Eq(x, tilt)]}, {f"x = {tilt}", "-4*a*c + b**2 >= 0", "a != 0"}),
    (y, 0, {"given": [Eq(x * y, 0)], "nonzero": [x]}, {"x*y = 0", "x != 0"}),
    (x, y, {"given": [Eq((x - y) ** 2, 0)]}, {"(x - y)**2 = 0"}),
    (x, z, {"given": [Eq(x, y), Eq(y, z)]}, {"x = y", "y = z"}),
    (x**3, x, {"given": [Eq(x**2, 1)]}, {"x**2 = 1"}),
    (cos(x) ** 2, Rational(9, 25), {"given": [Eq(cos(x), Rational(3, 5))]}, {"cos(x) = 3/5"}),
    (sin(a + b), sin(c), {"given": [Eq(a + b + c, pi)]}, {"a + b + c = pi"}),
    (Q * Q.T, ONE, {"given": [unit]}, {"e1**2 + e2**2 + e3**2 = 1"}),
    (Q.det(), 1, {"given": [unit]}, {"e1**2 + e2**2 + e3**2 = 1"}),
    (Q, ONE + sin(phi) * E + (1 - cos(phi)) * E**2, {"given": [unit]}, {"e1**2 + e2**2 + e3**2 = 1"}),
    (Q * e, e, {"given": [unit]}, {"e1**2 + e2**2 + e3**2 = 1"}),
    (R * R.T, ONE, {"given": rotation[:1]}, {"given[0]"}),
    (R * u.cross(v), (R * u).cross(R * v), {"given": rotation}, {"given[0]", f"{R.det()} = 1"}),
    (e_t.dot(e_t.diff(t)), 0, {"given": [unit_t]}, {"e1(t)**2 + e2(t)**2 + e3(t)**2 = 1"}),
    (R_t.diff(t) * R_t.T, -R_t * R_t.diff(t).T, {"given": rotation_t}, {"given[0]", f"{R_t.det()} = 1"}),
    (f.diff(t, 2), -f, {"given": [Eq(f.diff(t), g), Eq(g.diff(t), -f)]},
     {"Derivative(f(t), t) = g(t)", "Derivative(g(t), t) = -f(t)"}),
]  # fmt: skip
FALSE: list[tuple[Any, Any, dict[str, Any]]] = [
    (sin(x) ** 2 - cos(x) ** 2, 1, {}),
    (sin(2 * x), 2 * sin(x), {}),
    (cos(3 * x), 4 * cos(x) ** 3 + 3 * cos(x), {}),
    (sin(x + y), sin(x) + sin(y), {}),
    (sin(x + pi / 8), sin(x), {}),
    (sin(pi / 8), Rational(2, 5), {}),
    (x * cos(x), x * sin(x), {}),
    (x * cos(x), y * cos(y), {}),
    (pi * x, pi * x + cos(x), {}),
    (sin(x**2), 0, {}),
    (tan(x) * cos(y), sin(x), {}),
    (1 / x, x, {}),
    (1 / x, x, {"nonzero": [x - 1]}),
    (sqrt(x**2), x, {}),
    (sqrt(x**2), -x, {}),
    (sqrt(x**6), x**3, {}),
    (sqrt(x) * sqrt(y), sqrt(x + y), {}),
    (sqrt(1 - cos(x) ** 2), sin(x), {}),
    (sqrt(x * y) / x, sqrt(y / x), {}),
    (sqrt(2) * x, x, {}),
    (sqrt(x**2 + y**2), x + y, {}),
    (Abs(x + y), Abs(x) + Abs(y), {}),
    (sqrt(3 - 2 * sqrt(2)), 1 - sqrt(2), {}),
    (Abs(m) + x, x - m, {}),
    (x, 1, {"given": [Eq(x**2, 1)]}),
    (x, sqrt(2), {"given": [Eq(x**2, 2)]}),
    (y, 0, {"given": [Eq(x * y, 0)]}),
    (x + y, 1, {"given": [Eq(x**2 + y**2, 1)]}),
    (x, 0, {"given": [Eq(x**2 + y**2, 2), Eq(x * y, 0)]}),
    (y, 3, {"given": [Eq(sqrt(x**2 + y**2), 5), Eq(x, 4)]}),
    (sin(x), Rational(4, 5), {"given": [Eq(cos(x), Rational(3, 5))]}),
    (Q * Q.T, ONE, {}),
    (Q, ONE + sin(phi) * E + (1 - cos(phi)) * E, {"given": [unit]}),
    (Q.trace(), 1 + 2 * sin(phi), {"given": [unit]}),
    (u.cross(v.cross(w)), v * u.dot(w) + w * u.dot(v), {}),
    (R * u.cross(v), (R * u).cross(R * v), {"given": rotation[:1]}),
    (R * u.cross(v), (R * v).cross(R * u), {"given": rotation}),
    (cos(theta).diff(t), sin(theta) * theta.diff(t), {}),
    (sin(a * t).diff(t, 2), a**2 * sin(a * t), {}),
    (e_t.dot(e_t.diff(t, 2)), e_t.diff(t).dot(e_t.diff(t)), {"given": [unit_t]}),
    (R_t.diff(t) * R_t.T, zeros(3, 3), {"given": rotation_t}),
    (f.diff(t, 2), f, {"given": [Eq(f.diff(t), g), Eq(g.diff(t), -f)]}),
    (sp.Symbol("x*y"), x * y, {}),
]


def name(case: Any) -> str:
    return (
        " ".join(str(case).split())[:60] if isinstance(case, sp.Basic | sp.MatrixBase | int) else "under" * bool(case)
    )


@pytest.mark.sampled(3)
@pytest.mark.parametrize(("lhs", "rhs"), TRUE, ids=name)
def test_identities_hold(lhs: Any, rhs: Any) -> None:
    verdict = prove(lhs, rhs)
    assert isinstance(verdict, Holds), verdict
    assert verdict.certificate
    recheck(verdict, lhs, rhs)


@pytest.mark.sampled(3)
@pytest.mark.parametrize(("lhs", "rhs", "under", "needs"), CONDITIONAL, ids=name)
def test_what_an_identity_needs_is_said(lhs: Any, rhs: Any, under: dict[str, Any], needs: set[str]) -> None:
    verdict = prove(lhs, rhs, **under)
    assert isinstance(verdict, HoldsUnder if needs else Holds), verdict
    assert not needs or set(verdict.needs) == needs
    recheck(verdict, lhs, rhs, **under)


@pytest.mark.sampled(3)
@pytest.mark.parametrize(("lhs", "rhs", "under"), FALSE, ids=name)
def test_false_equations_fail_and_sympy_agrees(lhs: Any, rhs: Any, under: dict[str, Any]) -> None:
    verdict = prove(lhs, rhs, **under)
    assert isinstance(verdict, Fails), verdict
    confirm(verdict, lhs, rhs, **under)
    recheck(verdict, lhs, rhs, **under)


def test_both_sides_have_one_shape() -> None:
    verdict = prove(Matrix([x, y]), Matrix([[x, y]]))
    assert verdict == IllFormed("cannot equate a 2 x 1 matrix (the left side) and a 1 x 2 matrix (the right side)")
    assert isinstance(prove(eye(3), 0), IllFormed)
    assert isinstance(prove(u.T * v, u.dot(v)), Holds)


@pytest.mark.parametrize(
    ("lhs", "under", "message"),
    [
        (sp.LambertW(x) + y, {}, r"^LambertW\(x\) is not treated\. Treated are rational functions"),
        ((-1) ** x * (cos(y) ** 2 + sin(y) ** 2), {"rhs": (-1) ** x}, r"^log\(-1\) is not treated: it is not real"),
        (sp.log(-2 - x**2), {}, r"^log\(-x\*\*2 - 2\) is not treated: it is not real"),
        (sp.bessely(0, x), {}, r"^bessely\(0, x\) is not treated"),
        (sqrt(x + sp.I * y), {}, r"^sqrt\(x [+] I[*]y\) is not treated: of complex numbers only"),
        (0.5 * x, {}, r"^0\.5\d* is a floating-point number, which is not exact: write Rational\('1/2'\)"),
        (sp.Symbol("z", imaginary=True), {}, "^z is not real"),
        (sp.Symbol("A", commutative=False), {}, "^A does not commute"),
        (x + sp.Symbol("x", positive=True), {}, "^two different symbols are both called x"),
        (x**20000, {}, "its exponent is larger than 10000"),
        (Rational(25, 4) ** Rational(33333333333333333, 5 * 10**16), {}, "denominator of its exponent is larger"),
        (sp.Abs(x ** sp.Integer(10**7)), {}, "its exponent is larger than 10000"),
        (sp.log(sp.Symbol("p", positive=True) ** Rational(1, 10**7) + 1), {}, "is larger than 10000"),
        (
            sp.HadamardProduct(*(sp.MatrixSymbol(name, N, N) for name in "AB")),
            {"rhs": sp.Identity(N)},
            "no word for matrices of any size",
        ),
        ("x + 1", {}, r"^the left side is the text 'x \+ 1': hand in a SymPy expression"),
        (None, {}, "^the left side is None"),
        (Eq(x, 1), {}, "of type Equality: a scalar or a matrix is expected"),
        (x, {"given": [sp.Or(x > 0, y)]}, r"^given\[0\] is .*, which is no equation and no inequality"),
        (x, {"given": [False]}, r"^given\[0\] is False: write Eq\(a, b\)"),
        (x, {"given": [Eq(x, y), sp.LambertW(x)]}, r"^LambertW\(x\) is not treated"),
        (x, {"given": None}, r"^given is None: a list is expected"),
        (x, {"nonzero": [u]}, r"^nonzero\[0\] is a 3 x 1 matrix: a scalar is expected"),
    ],
    ids=lambda case: name(case) if not isinstance(case, str) else "",
)
def test_what_is_not_treated_is_named(lhs: Any, under: dict[str, Any], message: str) -> None:
    with pytest.raises(Untreatable, match=message) as caught:
        prove(lhs, **{"rhs": 1, **under})
    assert isinstance(caught.value, ValueError)


def test_a_symbol_that_is_infinite_is_refused_also_where_it_cancels() -> None:
    inf = sp.Symbol("inf", infinite=True)
    for asked in ((inf + 1 > inf,), (x, x, [Eq(y, inf)]), (inf, inf), (sp.Matrix([inf - x]), sp.Matrix([inf - x]))):
        with pytest.raises(Untreatable, match=r"^inf is infinite: the variables are real"):
            prove(*asked)


@pytest.mark.parametrize(
    ("lhs", "rhs", "given"),
    [
        (sqrt(-1 - x**2), 0, []),
        (1 / ((x + 1) ** 2 - x**2 - 2 * x - 1), 0, []),
        (f.diff(t) * (f.diff(t) - 1), 0, [Eq(f * f.diff(t), f)]),
    ],
    ids=name,
)
def test_where_it_is_unclear_whether_anything_satisfies_the_conditions_it_is_undecided(
    lhs: Any, rhs: Any, given: Any
) -> None:
    assert isinstance(prove(lhs, rhs, given=given), Undecided)


def test_what_sympy_assumes_of_a_symbol_is_respected() -> None:
    n = sp.Symbol("n", integer=True)
    k = sp.Symbol("k", negative=True)
    at = prove(m * n + k, x).counterexample.at
    assert at["m"] > 0 > at["k"]
    assert at["n"].denominator == 1
    assert isinstance(prove(Abs(k), -k), Holds)
    assert isinstance(prove(m, -m), Fails)


@pytest.mark.sampled(3)
@pytest.mark.parametrize(
    ("lhs", "rhs", "given"),
    [
        (Abs(x), x, [Eq(m, x)]),
        (Abs(y), y, [Eq(sqrt(x), y)]),
        (x, 2, [Eq(sqrt(x), -1)]),
        (cos(x), cos(y), [Eq((x - y) ** 2, 0)]),
        (cos(x), 1, [Eq(x**2, 0)]),
        (sin(2 * x), 0, [Eq(x**2, pi**2)]),
        (cos(x * y), 1, [Eq(x**2, 0)]),
        (cos(x * y) + x * y * z, 1 + x + y, [Eq(x**2 + y**2, 0)]),
        (sqrt(x) + x, sqrt(2 * x ** Rational(3, 2) + x**2 + x), []),
        (f.diff(t), 0, [Eq(f**2 + f.diff(t) ** 2, 0)]),
    ],
    ids=name,
)
def test_what_is_true_for_reasons_beyond_algebra_is_never_refuted(lhs: Any, rhs: Any, given: Any) -> None:
    assert not isinstance(prove(lhs, rhs, given=given), Fails)


def test_names_may_be_anything() -> None:
    odd = [sp.Symbol(text) for text in ("x*y", "2x", "cos(x)", "pi", "φ", "a b", "a_b", "w_1", "root_1", "")]
    total = sum(odd)
    assert isinstance(prove(total**2 - 1, (total - 1) * (total + 1)), Holds)
    assert not prove(sqrt(odd[0] ** 2) + cos(x), sum(odd[1:])).true
    told = [symbol for symbol in odd if symbol.name != "cos(x)"]
    verdict = prove(sqrt(told[0] ** 2) + cos(x), sum(told[1:]))
    assert isinstance(verdict, Fails)
    assert set(map(str, told)) <= set(verdict.counterexample.at)


@pytest.mark.parametrize(
    ("lhs", "rhs"),
    [
        ((a + b + c + x + y + z) ** 60, 1),
        ((a + b + c + x + y + z) ** 60, (-a - b - c - x - y - z) ** 60),
        (sqrt(a + b + c + x + y + z) ** 81 * (x + y) ** 40, 1),
        (sum(1 / (x + k * y + k**2 * z) for k in range(9)), sum(1 / (x + k * y - k**2 * z) for k in range(9))),
        (sin(999 * x) + cos(1000 * x), 1),
        ((x + 1) ** 9000, (x - 1) ** 9000),
    ],
    ids=name,
)
def test_a_budget_is_kept(lhs: Any, rhs: Any, monkeypatch: pytest.MonkeyPatch) -> None:
    # This process's own time, whatever else the machine does.
    monkeypatch.setattr("chasles.algebra.work_limit.monotonic", process_time)
    start = process_time()
    verdict = prove(lhs, rhs, budget=1)
    assert process_time() - start < 4
    assert isinstance(verdict, Fails | Undecided)


def test_a_hard_system_is_given_up(monkeypatch: pytest.MonkeyPatch) -> None:
    hard = [Eq(x**5 + y**4 + z**3, 1), Eq(x**3 + y**3 + z**2, 1), Eq(x * y * z + x**2, 3)]
    assert prove(x, 1, given=hard) == Undecided("10 million products of terms were not enough")
    monkeypatch.setattr("chasles.algebra.work_limit.monotonic", process_time)
    start = process_time()
    assert prove(x, 1, given=hard, budget=0.1) == Undecided("0.1 seconds were not enough")
    assert process_time() - start < 4


def test_the_clock_decides_nothing_unless_it_is_asked(monkeypatch: pytest.MonkeyPatch) -> None:
    """A clock that runs a million times as fast is a machine that is a million times as busy."""
    questions = [(sin(x) ** 2 + cos(x) ** 2, 1), (sqrt(x**2), x), ((x + y) ** 9, (x - y) ** 9)]
    calm = [prove(*sides) for sides in questions]
    monkeypatch.setattr("chasles.algebra.work_limit.monotonic", lambda: perf_counter() * 1e6)
    assert [prove(*sides) for sides in questions] == calm
    assert isinstance(prove(*questions[-1], budget=1), Undecided)


def test_a_forged_certificate_is_rejected() -> None:
    verdict = prove(Q * e, e, given=[unit])
    assert isinstance(verdict, HoldsUnder)
    recheck(verdict, Q * e, e, given=[unit])
    with pytest.raises(Rejected):
        recheck(verdict, Q * e, 2 * e, given=[unit])
    with pytest.raises(Rejected):
        recheck(verdict, Q * e, e, given=[Eq(e.dot(e), 2)])
    with pytest.raises(TypeError, match="only what holds or fails can be checked"):
        recheck(prove(eye(3), 0), eye(3), 0)


@pytest.mark.parametrize(
    ("left", "right", "given"),
    [
        (sqrt(2) * x, x * sqrt(2), []),
        (x / (sqrt(2) - 1), (sqrt(2) + 1) * x, []),
        (x**2, 3 * x - 1, [x**2 - 3 * x + 1]),
        (x**4 + y, 4 + y, [x**2 - 2]),
        (x**2, 2 * y**2, [Eq(x, sqrt(2) * y)]),
        (cos(phi + sp.pi / 3), cos(phi) / 2 - sqrt(3) * sin(phi) / 2, []),
    ],
    ids=str,
)
def test_a_witness_with_square_roots_is_checked(left: Any, right: Any, given: list[Any]) -> None:
    verdict = prove(left, right, given=given)
    assert isinstance(verdict, Holds | HoldsUnder)
    witness = verdict.certificate["witness"]
    rooted_names = [name for name, value in witness.items() if "sqrt" in value]
    assert rooted_names
    recheck(verdict, left, right, given=given)
    for name in rooted_names:
        for wrong in ("1", "sqrt(7)", f"1 + {witness[name]}", "sqrt(8)"):
            forged = replace(verdict, certificate={**verdict.certificate, "witness": {**witness, name: wrong}})
            with pytest.raises(Rejected):
                recheck(forged, left, right, given=given)


def test_a_root_in_a_witness_is_not_negative() -> None:
    verdict = prove(sqrt(2) * x, x * sqrt(2))
    assert isinstance(verdict, Holds)
    witness = {**verdict.certificate["witness"], "root_of_2": "-sqrt(2)"}
    with pytest.raises(Rejected, match="the witness has two values of root_of_2"):
        recheck(replace(verdict, certificate={**verdict.certificate, "witness": witness}), sqrt(2) * x, x * sqrt(2))


def test_a_witness_with_roots_of_roots_is_followed() -> None:
    nested = sqrt(2 + sqrt(2))
    recheck(prove(nested**3, (2 + sqrt(2)) * nested), nested**3, (2 + sqrt(2)) * nested)


def test_exact_numbers_are_those_of_sympy() -> None:
    one = SurdSum.rational(Fraction(1, 2)) + SurdSum.root_of(SurdSum.rational(2) + rooted(2)) * rooted(3) - rooted(6)
    half = sp.sympify(str(one))
    for value, wanted in ((one * one, half**2), (one**3, half**3), (one.inverse(), 1 / half)):
        assert abs(sp.N(sp.sympify(str(value)) - wanted, 40)) < Rational(1, 10**35)
        assert value is not None
        assert value.is_negative == (sp.N(wanted, 40) < 0)


def test_roots_that_depend_on_others_are_not_taken_for_new_ones() -> None:
    one, other = SurdSum.rational(2) + rooted(2), SurdSum.rational(3) + rooted(2)
    assert str(root_of(one)) == "sqrt(2 + sqrt(2))"
    assert str(root_of(SurdSum.rational(3) + rooted(8))) == "1 + sqrt(2)"
    assert root_of(one * other, [one, other]) is None
    assert root_of(rooted(2) - SurdSum.rational(2)) is None
    conjugate = root_of(SurdSum.rational(2) - rooted(2), [one])
    assert conjugate is not None
    assert (conjugate * SurdSum.root_of(one) - rooted(2)).is_zero


def rooted(square: int) -> SurdSum:
    root = root_of(SurdSum.rational(square))
    assert root is not None
    return root


atoms = st.sampled_from([x, y, z, sin(x), cos(x), sin(2 * x), cos(x / 2), sin(x + y), f, f.diff(t), theta, sin(theta)])
numbers = st.builds(Rational, st.integers(-3, 3), st.integers(1, 3))
trees = st.recursive(
    atoms | numbers,
    lambda inner: st.one_of(
        st.builds(sp.Add, inner, inner), st.builds(sp.Mul, inner, inner), st.builds(sp.Pow, inner, st.integers(2, 3))
    ),
    max_leaves=8,
)
roots = st.recursive(
    st.sampled_from([x, y, x + y, x**2 + 1, Rational(2), Rational(-3)]),
    lambda inner: st.one_of(
        st.builds(sp.Add, inner, inner), st.builds(sp.Mul, inner, inner), st.builds(Abs, inner), st.builds(sqrt, inner)
    ),
    max_leaves=4,
)
some = settings(
    max_examples=60 if WHOLE else 20, deadline=None, derandomize=True, suppress_health_check=list(HealthCheck)
)
few = settings(some, max_examples=20 if WHOLE else 6)


@some
@drawn(trees, numbers)
def test_rewritten_expressions_are_equal_and_perturbed_ones_are_not(tree: Any, shift: Any) -> None:
    assume(not tree.has(sp.nan, sp.zoo))
    other = sp.expand(sp.expand_trig(tree))
    verdict = prove(tree, other)
    assert isinstance(verdict, Holds), verdict
    assume(shift != 0)
    verdict = prove(tree, other + shift * (1 + x**2))
    assert isinstance(verdict, Fails), verdict
    if not (tree.has(theta) or f in tree.atoms(AppliedUndef)):
        confirm(verdict, sp.sympify(tree), other + shift * (1 + x**2))


POINTS = [(Rational(7, 3), Rational(5, 4)), (Rational(-9, 4), Rational(8, 3)), (Rational(-3, 7), Rational(-12, 5))]


def values_at(side: Any) -> Iterator[tuple[int, Any]]:
    """The values at points where all roots are real."""
    for place, point in enumerate(POINTS):
        values = dict(zip((x, y), point, strict=True))
        radicands = [p.base.xreplace(values) for p in side.atoms(sp.Pow) if not p.exp.is_Integer]
        if all(radicand.is_real and radicand >= 0 for radicand in radicands):
            yield place, sp.N(side.xreplace(values), 30)


@few
@drawn(roots, roots)
def test_floating_point_numbers_say_the_same_of_roots(one: Any, other: Any) -> None:
    assume(not (one.has(sp.I, sp.zoo, sp.nan) or other.has(sp.I, sp.zoo, sp.nan)))
    for lhs, rhs in ((one, other), (sqrt(sp.expand(one**2)), one), (sqrt(sp.expand(one**2)), Abs(one))):
        verdict = prove(lhs, rhs)
        left, right = dict(values_at(lhs)), dict(values_at(rhs))
        close = [abs(left[k] - right[k]) < Rational(1, 10**15) for k in left.keys() & right.keys()]
        if isinstance(verdict, Holds | HoldsUnder):
            assert all(close)
        elif isinstance(verdict, Fails):
            confirm(verdict, lhs, rhs)
    assert not isinstance(verdict, Fails)


@few
@drawn(st.lists(st.tuples(st.integers(-2, 2), st.integers(-2, 2), st.integers(-2, 2)), min_size=3, max_size=3))
def test_consequences_of_given_equations_hold(numbers: list[tuple[int, int, int]]) -> None:
    given = [Eq(x**2 + y**2, 1), Eq(z, x * y + 1)]
    terms = [i * x + j * y + k for i, j, k in numbers]
    multiple = sp.expand(terms[0] * (x**2 + y**2 - 1) + terms[1] * (z - x * y - 1))
    verdict = prove(multiple + terms[2], terms[2], given=given)
    assert isinstance(verdict, Holds | HoldsUnder)
    recheck(verdict, multiple + terms[2], terms[2], given=given)
    verdict = prove(multiple + 1, 0, given=given)
    assert isinstance(verdict, Fails)
    confirm(verdict, multiple + 1, sp.S.Zero, given=given)


QUESTIONS = """
from benchmarks.identities.textbook import identities
from chasles.prove import Untreatable, prove
from tests import test_prove as cases
from tests.sampling import WHOLE, sample
from tests.test_prove_motion import FALSE, TRUE

for lhs, rhs in sample(cases.TRUE, 40):
    print(repr(prove(lhs, rhs)))
for lhs, rhs, under, *_ in [*sample(cases.CONDITIONAL, 40), *sample(cases.FALSE, 40)]:
    print(repr(prove(lhs, rhs, **under)))
CASES = {str(case): case for case in sample([*TRUE, *FALSE], 18)}
if WHOLE:
    from tests import mechanics

    names = [*[*mechanics.CASES][::20], "quat speed", "quat speedF"]
    CASES |= {name: mechanics.CASES[name][:3] for name in names}

def said(*asked):
    try:
        return repr(prove(*asked))
    except Untreatable as error:
        return str(error)

for name, (left, right, given) in CASES.items():
    print(name, said(left, right, given))
for item in sample(list(identities())[::20], 6):
    print(item.text, said(item.left, item.right, item.given))
"""


def test_mixed_derivatives_are_equal_in_any_order() -> None:
    field = sp.Function("u")(x, y)
    for one, other in (((x, y), (y, x)), ((x, y, x), (y, (x, 2))), (((x, 2), y), (x, y, x))):
        assert prove(sp.Derivative(field, *one), sp.Derivative(field, *other)).true
    assert isinstance(prove(sp.Derivative(field, x, y), sp.Derivative(field, x, x)), Fails)


def test_real_roots_are_read() -> None:
    assert prove(sp.real_root(x, 3) ** 3, x).true
    assert prove(sp.real_root(-x, 3), -sp.real_root(x, 3)).true


def test_what_never_changes_its_sign_turns_where_it_is_zero() -> None:
    for given in (f**2 + g**2 <= m**2, f >= g, f <= 1):
        verdict = prove(f.diff(t), g.diff(t), given=given)
        at = verdict.counterexample.at
        assert at.get("d_1(t)", 1) or not at.get("Derivative(d_1(t), t)", 0)
    rise, flat = f.diff(t), Eq(f, 1 - sp.Function("d", nonnegative=True)(t))
    found = Fails(Counterexample({"f(t)": 1, str(rise): 1, "d(t)": 0, "Derivative(d(t), t)": -1}, (1, 1), "1", "0", ""))
    with pytest.raises(Rejected):
        recheck(found, rise, 0, given=flat)


def test_work_is_counted_while_a_leading_term_comes_back() -> None:
    ring = make_ring(("x", "y", "z"))
    one, two, three = ring.generators
    whole, divisor = (
        (one + two + three) ** 16,
        one * two + one * three**9 + two * three**7 + one**0 + two * three + three,
    )
    cofactors, rest = reduce_by(ring, whole, [divisor])
    assert (cofactors[0], rest) == ring.divide(whole, divisor)
    with within(2e4):
        with pytest.raises(OutOfTime):
            reduce_by(ring, whole, [divisor])
        assert remaining() > -2e4


@pytest.mark.slow
def test_both_kinds_of_polynomials_and_two_hash_seeds_say_the_same() -> None:
    root = Path(__file__).parent.parent
    texts = []
    for kind, seed in (("", "1"), ("sympy", "5")):
        environment = {**os.environ, "CHASLES_POLYNOMIALS": kind, "PYTHONHASHSEED": seed, "PYTHONPATH": str(root)}
        run = subprocess.run(
            [sys.executable, "-c", QUESTIONS], capture_output=True, text=True, env=environment, check=True
        )
        texts.append(run.stdout.splitlines())
    assert len(texts[0]) > sum(len(sample(cases, 40)) for cases in (TRUE, CONDITIONAL, FALSE)) + (15 if WHOLE else 4)
    assert texts[0] == texts[1]
