"""What is given for a rate is put for it wherever functions are differentiated."""

from __future__ import annotations

from typing import Any

import pytest

from chasles.checker.certificate import check
from chasles.decisions.session import Session
from chasles.statements import Claim, Condition, Definition, nonzero, positive, symmetric
from chasles.verdict import Fails, Holds, HoldsUnder
from chasles.vocabulary import CPM, Identity, column, cos, cross, dot, norm, rate, scalar, sin, square, vector
from chasles.vocabulary.functions import exp, log, sqrt

UNITS = False
x, y, V = scalar("x", "x", ""), scalar("y", "y", ""), scalar("V", "V", "")
s, w = vector("s", "s", ""), vector("w", "w", "")
A = square("A", "A", "", constant=True)
grows = Definition("1", rate(x), y)
swings = Definition("2", rate(rate(x)), -x)
turns = Definition("3", rate(s), ((1 - dot(s, s)) * Identity(3) + 2 * CPM(s) + 2 * s @ s.T) @ w / 4)
spins = Condition("5", rate(s), CPM(w) @ s, on=(s,))
energy = Definition("4", V, 2 * log(1 + dot(s, s)))

TRUE: list[tuple[Any, Any, Any]] = [
    (rate(log(1 + x**2)), 2 * x * y / (1 + x**2), (grows,)),
    (rate(rate(exp(x))), exp(x) * (y**2 + rate(y)), (grows,)),
    (rate(rate(exp(x))), exp(x) * (rate(x) ** 2 - x), (swings,)),
    (rate(rate(rate(exp(x)))), exp(x) * (rate(x) ** 3 - 3 * x * rate(x) - rate(x)), (swings,)),
    (rate(sqrt(1 + sin(x) ** 2)), y * sin(x) * cos(x) / sqrt(1 + sin(x) ** 2), (grows,)),
    (rate(V), dot(s, w), (energy, turns)),
    (rate(rate(s)), CPM(rate(w)) @ s + CPM(w) @ CPM(w) @ s, (spins,)),
]
SYMMETRIC: list[tuple[Any, Any]] = [
    (exp(x) * dot(s, A @ w), exp(x) * dot(w, A @ s)),
    (rate(dot(s, A @ s) / 2 + log(1 + x**2)), dot(s, A @ rate(s)) + 2 * x * rate(x) / (1 + x**2)),
]
FALSE: list[tuple[Any, Any, Any]] = [
    (rate(rate(s)), CPM(w) @ CPM(w) @ s, (spins,)),
    (rate(log(1 + x**2)), x * y / (1 + x**2), (grows,)),
    (rate(rate(exp(x))), exp(x) * y**2, (grows,)),
    (rate(V), dot(s, w) / 2, (energy, turns)),
]


@pytest.mark.sampled(3)
@pytest.mark.parametrize(("left", "right", "given"), TRUE, ids=str)
def test_true_ones_are_proved(left: Any, right: Any, given: Any) -> None:
    """Once these were refuted, by a rate that is not the given one."""
    claim = Claim("5", left, right, given=given)
    verdict = Session().decide(claim).verdict
    assert isinstance(verdict, Holds | HoldsUnder), verdict
    check(claim, "printed", verdict.certificate)


@pytest.mark.parametrize(("left", "right"), SYMMETRIC, ids=str)
def test_symmetric_matrices_beside_functions(left: Any, right: Any) -> None:
    """A symmetric matrix says twice of each pair of entries that they are equal: once is enough."""
    claim = Claim("6", left, right, assuming=(symmetric(A),))
    verdict = Session().decide(claim).verdict
    assert isinstance(verdict, HoldsUnder), verdict
    assert verdict.needs == ("A is symmetric",)
    check(claim, "printed", verdict.certificate)


@pytest.mark.parametrize(("left", "right", "given"), FALSE, ids=str)
def test_false_ones_are_refuted(left: Any, right: Any, given: Any) -> None:
    assert isinstance(Session().decide(Claim("5", left, right, given=given)).verdict, Fails)


r, v = vector("r", "r", ""), vector("v", "v", "")
d = scalar("d", "d", "")
mu, e, p, h, m = (scalar(name, name, "", constant=True) for name in ("mu", "e", "p", "h", "m"))
length = Definition("6", d, norm(r), assuming=(positive(d),))
velocity = Definition("7", v, rate(r))
ATTRACTION = [
    Condition("8", rate(v), -mu / d**3 * r, on=(v,), given=(length,)),
    Condition("8", rate(v) + mu / d**3 * r, column(0, 0, 0), on=(v,), given=(length,)),
    Condition("8", m * rate(v), -m * mu / d**3 * r, on=(v,), given=(length,), assuming=(positive(m),)),
]


@pytest.mark.parametrize("law", ATTRACTION, ids=lambda law: str(law.left))
@pytest.mark.parametrize("w", [v, rate(r)], ids=str)
def test_a_law_for_what_is_defined_as_a_rate_is_a_law_for_what_it_is_the_rate_of(law: Condition, w: Any) -> None:
    """Once this was refused: a definition of v, and a condition on it."""
    given = (velocity, law, length)
    for left, right, wrong in (
        (rate(cross(r, w)), column(0, 0, 0), r),
        (rate(dot(w, w) / 2 - mu / d), 0 * mu, mu),
        (rate(rate(r)), -mu / d**3 * r, mu / d**3 * r),
    ):
        claim = Claim("9", left, right, given=given)
        verdict = Session().decide(claim).verdict
        assert verdict.true, verdict
        check(claim, "printed", verdict.certificate)
        assert Session().decide(Claim("9", left, wrong, given=given)).verdict.wrong


def test_that_something_moving_is_positive_is_given() -> None:
    """An absolute value was differentiated, twice where a rate is given."""
    nu = scalar("nu", "nu", "")
    conic = Definition("10", d, p / (1 + e * cos(nu)))
    momentum = Definition("11", h, sqrt(mu * p), assuming=(positive(mu), positive(p)))
    areas = Condition("12", d**2 * rate(nu), h, on=(nu,), assuming=(positive(h), positive(d)))
    given = (conic, areas, momentum)
    claim = Claim("13", rate(d), mu / h * e * sin(nu), given=given)
    verdict = Session().decide(claim).verdict
    assert verdict.true, verdict
    check(claim, "printed", verdict.certificate)
    assert Session().decide(Claim("13", rate(d), 2 * mu / h * e * sin(nu), given=given)).verdict.wrong


def test_a_law_is_divided_by_what_multiplies_a_rate_and_is_known_not_to_vanish() -> None:
    """That of three rates follows then, and the speed on a conic, which took more work than is allowed."""
    far = nonzero(norm(r))
    law = Condition("14", m * rate(rate(r)), -(mu * m / norm(r) ** 3) * r, on=(r,), assuming=(positive(m), far))
    sides = dot(r, rate(rate(rate(r)))), 2 * mu * dot(r, rate(r)) / norm(r) ** 3
    claim = Claim("15", *sides, given=(law,))
    verdict = Session().decide(claim).verdict
    assert {*verdict.needs} == {"m > 0", "|r| != 0"}
    check(claim, "printed", verdict.certificate)
    assert Session().decide(Claim("15", sides[0], 2 * sides[1], given=(law,))).verdict.wrong
    nu, v_squared = scalar("nu", "nu", ""), scalar("v_squared", "v^2", "")
    conic = Definition("16", d, p / (1 + e * cos(nu)), assuming=(positive(d),))
    areas = Condition("17", d**2 * rate(nu), sqrt(mu * p), on=(nu,), assuming=(positive(d), positive(mu), positive(p)))
    speed = Definition("18", v_squared, rate(d) ** 2 + d**2 * rate(nu) ** 2)
    for factor, right in ((2, True), (3, False)):
        vis_viva = Claim("19", v_squared, mu * (factor / d - (1 - e**2) / p), given=(conic, areas, speed))
        found = Session().decide(vis_viva).verdict
        assert found.true is right, found
