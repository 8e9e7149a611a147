"""Angles of any kind, numbers with roots in roots, and what changes its form with a sign: proved and checked."""

from __future__ import annotations

from dataclasses import replace
from typing import Any

import pytest
import sympy as sp
from sympy import (
    Abs,
    Eq,
    Heaviside,
    Max,
    Min,
    Piecewise,
    Rational,
    cos,
    cot,
    pi,
    sec,
    sign,
    sin,
    sqrt,
    tan,
)

from chasles.prove import Rejected, Untreatable, prove, recheck
from chasles.verdict import Fails, Holds, HoldsUnder

x, y, z, a, b, t = sp.symbols("x y z a b t", real=True)
p = sp.Symbol("p")
k, m = sp.symbols("k m", positive=True)
f = sp.Function("f")(t)
w = sqrt(k / m)

ANGLES: list[tuple[Any, Any]] = [
    (cos(1) ** 2 + sin(1) ** 2, 1),
    (cos(2), 2 * cos(1) ** 2 - 1),
    (sin(3), 3 * sin(1) - 4 * sin(1) ** 3),
    (cos(Rational(1, 2)) ** 2, (1 + cos(1)) / 2),
    (sin(x + 1), sin(x) * cos(1) + cos(x) * sin(1)),
    (cos(sqrt(2) * x) * 2 * sin(sqrt(2) * x), sin(2 * sqrt(2) * x)),
    (sin(w * t) ** 2 + cos(w * t) ** 2, 1),
    (cos(2 * w * t), 1 - 2 * sin(w * t) ** 2),
    (sin(x**2 + y), sin(x**2) * cos(y) + cos(x**2) * sin(y)),
    (cos(x * (y + 1)), cos(x * y) * cos(x) - sin(x * y) * sin(x)),
    (sin(2 / x), 2 * sin(1 / x) * cos(1 / x)),
    (cos(sqrt(x)) ** 2 + sin(sqrt(x)) ** 2, 1),
    (cos(cos(x)) ** 2 + sin(cos(x)) ** 2, 1),
    (cos(f**2).diff(t), -2 * f * f.diff(t) * sin(f**2)),
    (cos(pi * x) ** 2, 1 - sin(pi * x) ** 2),
    (cos(pi**2) ** 2, 1 - sin(pi**2) ** 2),
    (tan(2 * x**3), 2 * tan(x**3) / (1 - tan(x**3) ** 2)),
    (m * (a * cos(w * t) + b * sin(w * t)).diff(t, 2), -k * (a * cos(w * t) + b * sin(w * t))),
    (cos(x / y + a), cos(x / y) * cos(a) - sin(x / y) * sin(a)),
    (1 + tan(1) ** 2, sec(1) ** 2),
]
NUMBERS: list[tuple[Any, Any]] = [
    (cos(pi / 7) - cos(2 * pi / 7) + cos(3 * pi / 7), Rational(1, 2)),
    (cos(pi / 9) * cos(2 * pi / 9) * cos(4 * pi / 9), Rational(1, 8)),
    (sin(pi / 18) * sin(5 * pi / 18) * sin(7 * pi / 18), Rational(1, 8)),
    (sin(pi / 7) * sin(2 * pi / 7) * sin(3 * pi / 7), sqrt(7) / 8),
    (sin(x + pi / 7), sin(x) * cos(pi / 7) + cos(x) * sin(pi / 7)),
    (cos(pi / 9), 4 * cos(pi / 27) ** 3 - 3 * cos(pi / 27)),
    (cos(2 * pi / 11) + cos(4 * pi / 11) + cos(6 * pi / 11) + cos(8 * pi / 11) + cos(10 * pi / 11), -Rational(1, 2)),
    (tan(pi / 7) ** 2, sec(pi / 7) ** 2 - 1),
    (sin(pi / 14) * sin(3 * pi / 14) * sin(5 * pi / 14), Rational(1, 8)),
    (sqrt(6 + 2 * sqrt(2) + 2 * sqrt(3) + 2 * sqrt(6)), 1 + sqrt(2) + sqrt(3)),
    (x * sqrt(6 + 2 * sqrt(2) + 2 * sqrt(3) + 2 * sqrt(6)), x * (1 + sqrt(2) + sqrt(3))),
    (sqrt(2 + sqrt(2 + sqrt(2))), 2 * cos(pi / 16)),
    (sqrt(5 + 2 * sqrt(6)), sqrt(2) + sqrt(3)),
    (sqrt(10 - 2 * sqrt(5)), 4 * sin(pi / 5)),
    (sqrt(10 + 2 * sqrt(15) + 2 * sqrt(10) + 2 * sqrt(6)), sqrt(2) + sqrt(3) + sqrt(5)),
]
CASES: list[tuple[Any, Any]] = [
    (Max(x, y) + Min(x, y), x + y),
    (Max(x, y) * Min(x, y), x * y),
    (Max(x, y), (x + y + Abs(x - y)) / 2),
    (Max(x, -x), Abs(x)),
    (Max(x, Max(y, z)), Max(Max(x, y), z)),
    (Max(x, y, z), -Min(-x, -y, -z)),
    (Max(m * x, m * y), m * Max(x, y)),
    (Max(0, Min(1, x)), (1 + Abs(x) - Abs(x - 1)) / 2),
    (Max(p, 2, 3), Max(p, 3)),
    (Max(x, 1 / y), Max(1 / y, x)),
    (sign(x) * Abs(x), x),
    (sign(x) ** 3, sign(x)),
    (sign(x * y), sign(x) * sign(y)),
    (x * sign(x), Abs(x)),
    (sign(p) ** 2 * p, p),
    (Heaviside(x), (1 + sign(x)) / 2),
    (Piecewise((x, x >= 0), (-x, True)), Abs(x)),
    (Piecewise((x - a, x > a), (0, True)), Max(x - a, 0)),
    (Piecewise((1, x > 0), (0, Eq(x, 0)), (-1, True)), sign(x)),
    (Piecewise((0, Eq(y, 0)), (y / Abs(y), True)), sign(y)),
    (Piecewise((x**2, (x > 0) & (y > 0)), (0, True)), Piecewise((0, (x <= 0) | (y <= 0)), (x**2, True))),
    (Abs(x - 1) + Abs(x), Max(2 * x - 1, 1 - 2 * x, 1)),
    (Abs(Abs(x) - Abs(y)), Max(Abs(x) - Abs(y), Abs(y) - Abs(x))),
]
FALSE: list[tuple[Any, Any]] = [
    (sign(x) ** 2, 1),
    (cos(2), 2 * cos(1) ** 2),
    (cos(1), Rational(27, 50)),
    (sin(x + 1), sin(x) + sin(1)),
    (cos(2 * w * t), 2 * sin(w * t) ** 2 - 1),
    (sin(1 / x), 1 / sin(x)),
    (sin(x + pi / 7), sin(x) * cos(pi / 7)),
    (cos(pi / 7), Rational(9, 10)),
    (cos(pi / 7) + cos(2 * pi / 7) + cos(3 * pi / 7), Rational(1, 2)),
    (sqrt(6 + 2 * sqrt(2) + 2 * sqrt(3) + 2 * sqrt(6)), 2 + sqrt(2) + sqrt(3)),
    (sqrt(2) + sqrt(3), sqrt(10) - Rational(1, 100)),
    (sqrt(2 + sqrt(2 + sqrt(2))), 2 * sin(pi / 16)),
    (Max(x, y), x),
    (Max(x, y), (x + y - Abs(x - y)) / 2),
    (Max(x, y, z), Max(x, y)),
    (Min(x, 0) * Max(x, 0), x),
    (sign(x) * x, x),
    (sign(x + y), sign(x) + sign(y)),
    (Heaviside(x), sign(x)),
    (Piecewise((x, x > 1), (1, True)), x),
    (Piecewise((1, x > 0), (0, Eq(x, 0)), (-1, True)), -sign(x)),
    (Max(sin(x), cos(x)), sin(x)),
]


@pytest.mark.sampled(7)
@pytest.mark.parametrize(("left", "right"), [*ANGLES, *NUMBERS, *CASES], ids=str)
def test_what_is_true_is_proved_and_the_proof_is_accepted(left: Any, right: Any) -> None:
    verdict = prove(left, right)
    assert isinstance(verdict, Holds | HoldsUnder), verdict
    recheck(verdict, left, right)


@pytest.mark.sampled(3)
@pytest.mark.parametrize(("left", "right"), FALSE, ids=str)
def test_what_is_false_is_refuted_and_the_point_is_accepted(left: Any, right: Any) -> None:
    verdict = prove(left, right)
    assert isinstance(verdict, Fails), verdict
    recheck(verdict, left, right)


@pytest.mark.sampled(2)
@pytest.mark.parametrize(
    ("left", "right", "needs"),
    [
        (sin(2 / x), 2 * sin(1 / x) * cos(1 / x), {"x != 0"}),
        (cos(sqrt(x)) ** 2 + sin(sqrt(x)) ** 2, 1, {"x >= 0"}),
        (sign(x) / x, 1 / Abs(x), {"Abs(x) != 0", "x != 0"}),
        (sqrt(x) * Max(x, 0), sqrt(x) * x, {"x >= 0"}),
        (Max(x, 1 / y), Max(1 / y, x), {"y != 0"}),
        (Max(x, y) / (x - y), Piecewise((x / (x - y), x > y), (y / (x - y), True)), {"x - y != 0"}),
        (cot(x**2) * tan(x**2), 1, {"sin(x**2) != 0", "cos(x**2) != 0"}),
        (Max(x, y) / (x + y + Abs(x - y)), Rational(1, 2), {"x + y + Abs(x - y) != 0"}),
        (sp.Mul(sin(x**2), sp.Mul(y, 1 / y, evaluate=False), evaluate=False), sin(x**2), {"y != 0"}),
        (
            Piecewise((Max(x, y) / (x + y + Abs(x - y)), z > 0), (1, True)),
            Piecewise((Rational(1, 2), z > 0), (1, True)),
            {"x + y + Abs(x - y) != 0"},
        ),
    ],
    ids=lambda case: "" if isinstance(case, set) else str(case),
)
def test_what_is_needed_is_said(left: Any, right: Any, needs: set[str]) -> None:
    verdict = prove(left, right)
    assert isinstance(verdict, HoldsUnder), verdict
    assert needs <= set(verdict.needs)
    assert len(verdict.needs) <= 3
    recheck(verdict, left, right)


def test_given_equations_are_used_by_cases_and_in_angles() -> None:
    for left, right, given in (
        (Max(x, y), x, [Eq(x, y + m)]),
        (cos(1) * y, 1, [Eq(y, sec(1))]),
        (y, Abs(x), [Eq(y, Max(x, -x))]),
    ):
        verdict = prove(left, right, given=given)
        assert isinstance(verdict, HoldsUnder), verdict
        assert f"{given[0].lhs} = {given[0].rhs}" in verdict.needs
        recheck(verdict, left, right, given=given)


@pytest.mark.parametrize(
    ("left", "right"),
    [
        (sqrt(-1 - x**2), sqrt(-(x**2) - cos(x) ** 2 - sin(x) ** 2)),
        (cos(pi / 181), x),
        (Max(x, y) + sp.I, sp.I + Max(x, y) + x - x + y),
    ],
    ids=str,
)
def test_what_is_nowhere_defined_or_too_large_is_not_decided(left: Any, right: Any) -> None:
    try:
        verdict = prove(left, right)
    except Untreatable:
        return
    assert not verdict.true


FORGED = [
    (Max(x, y) + Min(x, y), x + y, 2 * x),
    (cos(2), 2 * cos(1) ** 2 - 1, 2 * cos(1)),
    *[(NUMBERS[k][0], NUMBERS[k][1], 1) for k in (0, 3, 9)],
]


@pytest.mark.sampled(5)
@pytest.mark.parametrize(("left", "right", "other"), FORGED, ids=str)
def test_a_proof_of_something_else_is_rejected(left: Any, right: Any, other: Any) -> None:
    verdict = prove(left, right)
    assert isinstance(verdict, Holds | HoldsUnder)
    with pytest.raises(Rejected):
        recheck(verdict, left, other)
    with pytest.raises(Rejected):
        recheck(verdict, left + x, right)


def _without(cases: Any) -> list[Any]:
    """Cases of which one is said to be impossible, one is missing, or two are exchanged."""
    named = {"+": cases["+"], "0": cases["0"], "-": cases["-"]}
    return [{**named, "-": {"impossible": True}}, {"+": named["+"]}, {**named, "-": named["+"], "+": named["-"]}]


def test_forged_parts_of_certificates_are_rejected() -> None:
    left, right = Max(x, y) * sqrt(x), sqrt(x) * (x + y + Abs(x - y)) / 2
    verdict = prove(left, right)
    assert isinstance(verdict, HoldsUnder), verdict
    recheck(verdict, left, right)
    tree = verdict.certificate
    forged: list[Any] = [
        Holds(tree, verdict.witness),
        replace(verdict, witness={**verdict.witness, "x": sp.S(-1)}),
        replace(verdict, witness={}),
        replace(verdict, certificate={**tree, "on": "x"}),
        replace(verdict, certificate={**tree, "size": "x"}),
        replace(verdict, certificate={**tree, "cases": {**tree["cases"], "-": {"impossible": True}}}),
        replace(verdict, certificate={**tree, "cases": {"+": tree["cases"]["+"], "0": tree["cases"]["0"]}}),
        replace(
            verdict, certificate={**tree, "cases": {**tree["cases"], "-": tree["cases"]["+"], "+": tree["cases"]["-"]}}
        ),
    ]
    for other in forged:
        with pytest.raises(Rejected):
            recheck(other, left, right)


def test_a_number_that_does_not_vanish_is_no_fact() -> None:
    left, right = NUMBERS[9]
    verdict = prove(left, right)
    assert isinstance(verdict, Holds)
    certificate = {**verdict.certificate, "facts": ["sqrt(2) - 1"]}
    with pytest.raises(Rejected, match="not known to be zero"):
        recheck(replace(verdict, certificate=certificate), left, right)


def test_a_counterexample_that_is_none_is_rejected() -> None:
    verdict = prove(Max(x, y), x)
    assert isinstance(verdict, Fails)
    at = {**verdict.counterexample.at, "y": verdict.counterexample.at["x"]}
    with pytest.raises(Rejected):
        recheck(Fails(replace(verdict.counterexample, at=at)), Max(x, y), x)
    with pytest.raises(Rejected):
        recheck(Fails(replace(verdict.counterexample, left="77")), Max(x, y), x)
