"""Complex expressions: nothing imaginary is dropped, and an equation holds if both of its parts do."""

from __future__ import annotations

from dataclasses import replace
from typing import Any

import pytest
import sympy as sp
from sympy import Abs, Eq, I, Matrix, conjugate, cos, exp, im, re, sin, sqrt, tan

from chasles.prove import Rejected, Untreatable, prove, recheck
from chasles.verdict import Fails, Holds, HoldsUnder

from .sampling import WHOLE

x, y, u, v = sp.symbols("x y u v")
p = sp.Symbol("p", positive=True)
z, w = x + I * y, u + I * v
f, g = sp.Function("f")(x), sp.Function("g")(x)

TRUE: list[tuple[Any, Any, set[str]]] = [
    (z * conjugate(z), Abs(z) ** 2, set()),
    (conjugate(z) * conjugate(w), conjugate(z * w), set()),
    (Abs(z * w), Abs(z) * Abs(w), set()),
    (Abs(z) ** 2 + Abs(w) ** 2, (Abs(z + w) ** 2 + Abs(z - w) ** 2) / 2, set()),
    (re(z * conjugate(w)), x * u + y * v, set()),
    (im(x / z), -x * y / (x**2 + y**2), {"x**2 + y**2 != 0"}),
    (re(1 / z), x / Abs(z) ** 2, {"x**2 + y**2 != 0"}),
    (im(x / y), 0, {"y != 0"}),
    (conjugate(tan(x)), tan(x), {"cos(x) != 0"}),
    (1 / z, conjugate(z) / (x**2 + y**2), {"x**2 + y**2 != 0"}),
    (re(sqrt(z)), sqrt((Abs(z) + x) / 2), {"x**2 + y**2 != 0"}),
    (z**3, x**3 - 3 * x * y**2 + I * (3 * x**2 * y - y**3), set()),
    (z**-2 * w, w / z / z, {"x**2 + y**2 != 0"}),
    (im(y * exp(I * x)), y * sin(x), set()),
    (exp(I * (x + y)), exp(I * x) * exp(I * y), set()),
    ((cos(x) + I * sin(x)) ** 4, cos(4 * x) + I * sin(4 * x), set()),
    (cos(x), (exp(I * x) + exp(-I * x)) / 2, set()),
    (sin(x), (exp(I * x) - exp(-I * x)) / (2 * I), set()),
    (conjugate(exp(I * x)), exp(-I * x), set()),
    (Abs(exp(I * x)), 1, set()),
    (1 + exp(2 * I * sp.pi / 3) + exp(4 * I * sp.pi / 3), 0, set()),
    (sqrt(p) * I * sqrt(p), p * I, set()),
    ((f * exp(I * x)).diff(x), (f.diff(x) + I * f) * exp(I * x), set()),
    (Matrix([[x, z], [0, y]]).H, Matrix([[x, 0], [conjugate(z), y]]), set()),
    (sp.cbrt(-1) * x, x / 2 + sqrt(3) * I * x / 2, set()),
    (sqrt(I) * sqrt(2), 1 + I, set()),
    (exp(I * sqrt(2) * x), cos(sqrt(2) * x) + I * sin(sqrt(2) * x), set()),
    (exp(I * sqrt(p) * x) * exp(-I * sqrt(p) * x) + z, 1 + z, set()),
    (exp(3 * I) + x, cos(3) + I * sin(3) + x, set()),
    (1 + sum(exp(2 * k * I * sp.pi / 7) for k in range(1, 7)) + I * x, I * x, set()),
    (sp.Max(re(z * w), 0) * I, I * (x * u - y * v + Abs(x * u - y * v)) / 2, set()),
    (re(z * exp(I * x**2)), x * cos(x**2) - y * sin(x**2), set()),
    (im(x**2 / y * cos(sqrt(3) * x)), 0, {"y != 0"}),
    (I**I + x, exp(-sp.pi / 2) + x, set()),
    (sp.Pow(-1, sp.Add(0, 0, evaluate=False), evaluate=False) * z, z, set()),
    (1 / (1 + sp.cbrt(-1) ** 2 + sp.cbrt(-1)) + 1 / (1 - sp.cbrt(-1) - sp.cbrt(-1) ** 2), sp.Rational(1, 2), set()),
]
FALSE: list[tuple[Any, Any]] = [
    (im(x / z), 0),
    (im(y * exp(I * x)), 0),
    (re(x * exp(I * y)), x),
    (conjugate(z), z),
    (conjugate(I * x), I * x),
    (conjugate(x + 1 / (u + I)), x + 1 / (u + I)),
    (re(I * x), x),
    (re(z**2), x**2),
    (im((x + I) ** 2), 0),
    (im(sqrt(p) * I), 0),
    (Abs(1 + I * x), 1),
    (Abs(z), Abs(x) + Abs(y)),
    (Abs(z + w), Abs(z) + Abs(w)),
    (re(x / z), 1),
    (z, x),
    (I * x, x),
    (z * w, x * u - y * v),
    (z**2, x**2 + y**2),
    (exp(I * x), cos(x)),
    (im(I * cos(x)), 0),
    (im(I * tan(x)), 0),
    (im(I * f.diff(x)), 0),
    (Matrix([x, z]), Matrix([x, x])),
    (Matrix([[x, z]]).H, Matrix([x, z])),
    (sp.cbrt(-8) + x, x - 2),
    (sp.cbrt(2 - sqrt(5)), (1 - sqrt(5)) / 2),
    (sqrt(I), 1 + I),
    (exp(I * sqrt(2) * x), cos(sqrt(2) * x) - I * sin(sqrt(2) * x)),
    (sp.Max(re(z), 0) * I, I * x),
]
Z, W = sp.symbols("Z W", complex=True)
q = sp.Symbol("q")
REFUSED: list[Any] = [
    sqrt(z), conjugate(sqrt(z)), Abs(sqrt(z) + 1),
    sp.log(z), im(sp.asin(z)), re(sp.sign(z)), im(sp.Function("h")(z)), im(sp.besselj(0, z)),
    sqrt(Z), sp.log(Z), Abs(sqrt(Z)), x**Z, im(sp.Symbol("j", imaginary=True)), x**z, z**x, (-1) ** x,
    conjugate(sp.Symbol("n", complex=True, zero=False)),
    im((-1) ** x), z**40,
]  # fmt: skip


def name(case: Any) -> str:
    return (", ".join(sorted(case)) if isinstance(case, set) else str(case))[:50]


@pytest.mark.parametrize(("lhs", "rhs", "needs"), TRUE, ids=name)
def test_both_parts_are_proved(lhs: Any, rhs: Any, needs: set[str]) -> None:
    verdict = prove(lhs, rhs)
    said = set(verdict.needs if isinstance(verdict, HoldsUnder) else ())
    assert isinstance(verdict, HoldsUnder if said else Holds), verdict
    assert {text for text in said if not text.endswith(" is real")} == needs
    recheck(verdict, lhs, rhs)


READ_AS_REAL = [(conjugate(q), q, [q]), (im(q), 0, [q]), (conjugate(q * x), x * q, [q, x]), (re(g), g, [g]),
                (re(q * exp(I * sqrt(2) * x)), q * cos(sqrt(2) * x), [q, x])]  # fmt: skip


@pytest.mark.parametrize(("lhs", "rhs", "atoms"), READ_AS_REAL, ids=name)
def test_what_is_read_as_real_is_said(lhs: Any, rhs: Any, atoms: Any) -> None:
    verdict = prove(lhs, rhs)
    assert isinstance(verdict, HoldsUnder)
    assert set(verdict.needs) == {f"{atom} is real" for atom in atoms}
    recheck(verdict, lhs, rhs)
    for needs in ((), ("q is real", "x is real", "g(x) is real", "y is real")):
        with pytest.raises(Rejected):
            recheck(replace(verdict, needs=needs), lhs, rhs)


@pytest.mark.sampled(3)
@pytest.mark.parametrize(("lhs", "rhs"), FALSE, ids=name)
def test_nothing_imaginary_is_dropped(lhs: Any, rhs: Any) -> None:
    verdict = prove(lhs, rhs)
    assert isinstance(verdict, Fails), verdict
    found = verdict.counterexample
    row, column = found.entry
    names = {str(symbol): symbol for symbol in (x, y, u, v, p, f, f.diff(x))}
    point = {names[key]: sp.sympify(str(value)) for key, value in found.at.items() if key in names}
    values = []
    for side in (lhs, rhs):
        entry = sp.Matrix([[side]])[0, 0] if not hasattr(side, "shape") else side[row - 1, column - 1]
        for key, value in found.at.items():
            for function in (sin, cos):
                entry = entry.rewrite(sp.cos).subs(function(x), value) if key == str(function(x)) else entry
        values.append(sp.expand(entry.xreplace(point).doit()))
    for text, value in zip((found.left, found.right), values, strict=True):
        if not value.free_symbols:
            assert abs(sp.N(sp.sympify(text) - value, 30)) < sp.Rational(1, 10**20), (found, values)
    assert sp.simplify(sp.sympify(found.left) - sp.sympify(found.right)) != 0


@pytest.mark.parametrize("lhs", REFUSED, ids=name)
def test_what_is_not_taken_apart_is_refused(lhs: Any) -> None:
    """Of what is equal there is no counterexample either."""
    with pytest.raises(Untreatable):
        prove(lhs, lhs * (cos(x) ** 2 + sin(x) ** 2))


def test_a_complex_condition_says_both_of_its_parts() -> None:
    verdict = prove(x, y, given=[Eq(x + I * y, u + I * u)])
    assert isinstance(verdict, HoldsUnder)
    assert isinstance(prove(x, y, given=[Eq(re(z), u)]), Fails)
    assert isinstance(prove(x / z, 1 / (1 + I * y / x), nonzero=[x, z]), Holds | HoldsUnder)


OF_COMPLEX_SYMBOLS: list[tuple[Any, Any, dict[str, Any], bool]] = [
    (Abs(Z) ** 2, Z * conjugate(Z), {}, True),
    (Abs(Z) ** 2, Z**2, {}, False),
    (re(Z * conjugate(W)), re(Z) * re(W) + im(Z) * im(W), {}, True),
    (re(Z * W), re(Z) * re(W), {}, False),
    (exp(Z + W), exp(Z) * exp(W), {}, True),
    (1 / Z, conjugate(Z) / Abs(Z) ** 2, {}, True),
    (1 / Z, conjugate(Z), {"given": Eq(Abs(Z), 1)}, True),
    (1 / Z, conjugate(Z), {"given": Eq(re(Z), 1)}, False),
    (Z**2, -1, {"given": {Z: I}}, True),
    (Z**2, 1, {"given": {Z: I}}, False),
    (conjugate(Z), Z, {}, False),
    (im(Z), 0, {}, False),
    (re(Z) ** 2 + im(Z) ** 2, Abs(Z) ** 2, {}, True),
    (re(Z) + I * im(Z), Z, {}, True),
    (re(Z) - I * im(Z), Z, {}, False),
    (tan(x + I * y), (sin(2 * x) + I * sp.sinh(2 * y)) / (cos(2 * x) + sp.cosh(2 * y)), {}, True),
    (sp.coth(x + I * y), (sp.sinh(2 * x) - I * sin(2 * y)) / (sp.cosh(2 * x) - cos(2 * y)), {}, True),
    (tan(x + I * y), tan(x) + I * tan(y), {}, False),
    *[(sp.tanh(Z + W), (sp.tanh(Z) + sp.tanh(W)) / (1 + sp.tanh(Z) * sp.tanh(W)), {}, True)] * WHOLE,
]


@pytest.mark.sampled(3)
@pytest.mark.parametrize(("lhs", "rhs", "under", "true"), OF_COMPLEX_SYMBOLS, ids=name)
def test_complex_symbols_have_all_complex_values(lhs: Any, rhs: Any, under: dict[str, Any], true: bool) -> None:
    verdict = prove(lhs, rhs, **under)
    assert isinstance(verdict, (Holds | HoldsUnder) if true else Fails), verdict
    recheck(verdict, lhs, rhs, **under)


NOT_REAL = (
    {"imaginary": True}, {"infinite": True}, {"antihermitian": True}, {"algebraic": True},
    {"complex": True, "positive": False}, {"complex": True, "hermitian": True},
)  # fmt: skip
"""What may be assumed of a symbol that is no real number, and says more than that it is a complex one."""


@pytest.mark.parametrize("symbol", [sp.Symbol("j", **assumed) for assumed in NOT_REAL], ids=str)
@pytest.mark.parametrize("rule", ["abs", "max", "root", "sign", "switch"])
def test_cases_of_signs_are_of_real_symbols(symbol: Any, rule: str) -> None:
    """|Z|^2 = Z^2 holds where Z is positive, zero or negative: a complex Z is none of these."""
    sides = {
        "abs": (Abs(symbol) ** 2 * x, symbol**2 * x),
        "max": (sp.Max(x, 0) * Abs(symbol), sp.Max(x, 0) * Abs(symbol) * (cos(x) ** 2 + sin(x) ** 2)),
        "root": (sqrt(symbol**2) * x, Abs(symbol) * x * (cos(x) ** 2 + sin(x) ** 2)),
        "sign": (sp.sign(symbol) * Abs(symbol) + x, symbol + x),
        "switch": (sp.Piecewise((Abs(symbol) ** 2, x > 0), (0, True)), sp.Piecewise((symbol**2, x > 0), (0, True))),
    }
    lhs, rhs = sides[rule]
    with pytest.raises(Untreatable):
        prove(lhs, rhs)
    with pytest.raises(Rejected):
        recheck(Holds({"variant": 0, "names": {}, "witness": {}}, {}), lhs, rhs)


def test_symbols_that_are_called_the_same_are_told_apart() -> None:
    one, other = (sp.Dummy("Z", complex=True) for _ in "ab")
    with pytest.raises(Untreatable, match="two different symbols are both called _Z"):
        prove(one * conjugate(one), other * conjugate(other))
