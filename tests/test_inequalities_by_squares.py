"""Inequalities under equations and inequalities: squares with weights that add up to what cannot be."""

from __future__ import annotations

from copy import deepcopy
from dataclasses import replace
from fractions import Fraction
from typing import Any

import pytest
from sympy import Abs, Eq, Function, Le, Lt, Ne, Rational, Symbol, exp, log, sin, sinh, sqrt, symbols

from chasles.algebra.cones import vanishing
from chasles.prove import Rejected, prove, recheck
from chasles.verdict import Fails, Holds, HoldsUnder

x, y, z, a, b, c, w = symbols("x y z a b c w", real=True)
p, q, r = symbols("p q r", positive=True)

TRUE: list[tuple[Any, list[Any]]] = [
    (x * y <= Rational(1, 4), [Eq(x + y, 1)]),
    (x * y < Rational(1, 3), [Eq(x + y, 1)]),
    ((x + y + z) ** 2 <= 3, [Eq(x**2 + y**2 + z**2, 1)]),
    (p + q >= 2, [Eq(p * q, 1)]),
    (p * q * r <= Rational(1, 27), [Eq(p + q + r, 1)]),
    (b**2 >= 4 * a * c, [Eq(a * x**2 + b * x + c, 0)]),
    (a**4 + b**4 + c**4 >= a * b * c * (a + b + c), []),
    (a * b + Abs(a - b) <= 1, [Eq(a**2 + b**2, 1)]),
    (x * y + x * z + y * z >= 3 * x * y * z, [x >= 0, y >= 0, z >= 0, x + y + z <= 3]),
    (a * c <= x * y, [c >= 0, b >= 0, x >= 0, y >= 0, Eq(x**2, c), Eq(y**2, a**2 * c + b)]),
]


@pytest.mark.sampled(4)
@pytest.mark.parametrize(("claim", "given"), TRUE, ids=str)
def test_what_follows_is_proved_and_no_more(claim: Any, given: list[Any]) -> None:
    verdict = prove(claim, given=given)
    assert isinstance(verdict, Holds | HoldsUnder)
    recheck(verdict, claim, given=given)
    tighter = (Lt if isinstance(claim, Lt) else Le)(claim.lts + 1, claim.gts, evaluate=False)
    assert isinstance(prove(tighter, given=given), Fails)
    with pytest.raises(Rejected):
        recheck(verdict, tighter, given=given)


def test_no_other_squares_are_accepted() -> None:
    claim, given = TRUE[2]
    verdict = prove(claim, given=given)
    assert isinstance(verdict, HoldsUnder)
    leaf = next(case for case in verdict.certificate["cases"].values() if "squares" in case["proof"])
    for changed in (("squares", 0, 0, "-1"), ("squares", 0, 1, "2"), ("of", 0, 1, "7"), ("of", 0, 0, "square 0 1,1")):
        certificate = deepcopy(dict(verdict.certificate))
        said = next(c for c in certificate["cases"].values() if "squares" in c["proof"])["proof"]["squares"][0]
        part, place, inner, text = changed
        said[part][place][inner] = text
        with pytest.raises(Rejected):
            recheck(replace(verdict, certificate=certificate), claim, given=given)
    assert leaf["proof"]["squares"][0]["of"]


def test_what_does_not_follow_is_not_proved() -> None:
    for claim, given in ((x * y <= Rational(1, 5), [Eq(x + y, 1)]), (sqrt(p * q) <= 1, [Eq(p + q, 3)])):
        assert isinstance(prove(claim, given=given), Fails)


def test_what_is_negative_at_an_instant_may_have_any_rate() -> None:
    t = Symbol("t", real=True)
    f, g = Function("f")(t), Function("g")(t)
    assert isinstance(prove(f * g <= Rational(1, 4), given=[Eq(f + g, 1)]), HoldsUnder)
    for claim, given in ((f >= 0, Eq(f.diff(t), 1)), (f * g > -1, Eq((f * g).diff(t), 2))):
        assert not prove(claim, given=[given]).true


QUOTIENTS: list[tuple[Any, list[Any]]] = [
    (sinh(p) / p >= 1, []),
    (sin(x) ** 2 < x**2, [Ne(x, 0)]),
    (x + 1 < exp(x), [Ne(x, 0)]),
    (1 / (exp(p) - 1) < 1 / p, []),
    (log(p) / p <= exp(-1), []),
    (exp(-(x**2)) <= 1 / (1 + x**2), []),
    (x < sin(x), [x < 0]),
]


@pytest.mark.sampled(3)
@pytest.mark.parametrize(("claim", "given"), QUOTIENTS, ids=str)
def test_quotients_and_what_is_below_zero_have_signs_by_slopes(claim: Any, given: list[Any]) -> None:
    verdict = prove(claim, given=given)
    assert verdict.true
    recheck(verdict, claim, given=given)
    assert isinstance(prove(claim.reversed.func(claim.lhs, claim.rhs), given=given), Fails)
    for condition in given:
        assert isinstance(prove(claim), Fails), condition


def test_weights_are_found_where_there_are_some() -> None:
    one, two = Fraction(1), Fraction(2)
    found = vanishing([{"x": one, "y": -two}, {"x": -two, "y": one}, {"x": one, "y": one}], {2})
    assert found == {0: one, 1: one, 2: one}
    assert vanishing([{"x": one}, {"x": one, "y": -one}, {"y": one}], {0}) is None
    assert vanishing([{"x": one, "y": one}, {"x": -one, "y": one}, {"y": -one}], {2}) == {
        0: one / 2,
        1: one / 2,
        2: one,
    }
