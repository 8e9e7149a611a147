"""Divisors that are seen not to be zero are not asked for: one and squares, sums of what is assumed positive."""

from __future__ import annotations

from fractions import Fraction
from math import inf
from random import Random
from typing import Any

import pytest

from chasles.checker.certificate import check
from chasles.decisions.session import Session
from chasles.statements import Claim, Definition, nonzero, perpendicular, positive
from chasles.statements.bounds import RealInterval
from chasles.statements.inequalities import inequality
from chasles.verdict import Contradictory, Fails, Holds, HoldsUnder
from chasles.vocabulary import (
    CPM,
    Identity,
    Node,
    cos,
    dot,
    inverse,
    norm,
    plain,
    rate,
    scalar,
    sin,
    square,
    tan,
    vector,
)
from chasles.vocabulary.functions import arctan
from chasles.vocabulary.nodes import lifted
from chasles.vocabulary.partial import partial
from chasles.vocabulary.sizes import Size

UNITS = False
r, s, h = scalar("r", "r", ""), scalar("s", "s", ""), scalar("h", "h", "")
a, b = vector("a", "a", ""), vector("b", "b", "")
x, C = vector("x", "x", "", size=Size("n")), square("C", "C", "")
halves = Definition("0", h, 1 + r**2 / 2)
rodrigues = Identity(3) + 2 / (1 + dot(a, a)) * (CPM(a) + CPM(a) @ CPM(a))


def verdict_on(left: Node, right: Node, *assuming: Any, given: tuple[Any, ...] = ()) -> Any:
    claim = Claim("1", left, lifted(right), assuming=assuming, given=given)
    verdict = Session().decide(claim).verdict
    if isinstance(verdict, Holds | HoldsUnder):
        check(claim, "printed", verdict.certificate)
    return verdict


@pytest.mark.parametrize(
    ("left", "right"),
    [
        (s / (1 + r**2), s / (r**2 + 1)),
        (partial(arctan(r), r), 1 / (1 + r**2)),
        (a / (1 + norm(a) ** 2), a / (1 + dot(a, a))),
        (rodrigues.T @ rodrigues, Identity(3)),
        (inverse(Identity(3) - CPM(a)), (Identity(3) + CPM(a) + a @ a.T) / (1 + dot(a, a))),
        (rate(1 / (1 + r**2)), -2 * r * rate(r) / (1 + r**2) ** 2),
        (x / (1 + x.T @ x), x / (1 + dot(x, x))),
    ],
)
def test_one_and_squares_are_no_condition(left: Node, right: Node) -> None:
    verdict = verdict_on(left, right)
    assert isinstance(verdict, Holds), verdict


def test_sums_of_what_is_positive() -> None:
    barycentre = (r * a + s * b) / (r + s)
    verdict = verdict_on(barycentre - a, s / (r + s) * (b - a), positive(r), positive(s))
    assert verdict.needs == ("r + s != 0",)
    assert isinstance(verdict_on(barycentre - a, r / (r + s) * (b - a), positive(r), positive(s)), Fails)
    assert verdict_on(barycentre, barycentre, positive(r)).needs == ("r + s != 0",)
    assert isinstance(verdict_on(s / h, 2 * s / (2 + r**2), given=(halves,)), Holds)


@pytest.mark.parametrize("length", [norm(a), dot(a, a), a.T @ a, norm(a) ** 2], ids=str)
def test_where_a_length_is_not_zero_its_square_is_not(length: Node) -> None:
    verdict = verdict_on(a / dot(a, a) + a / norm(a) ** 2, 2 * a / (a.T @ a), nonzero(length))
    assert isinstance(verdict, HoldsUnder), verdict
    assert len(verdict.needs) == 1


def test_products_of_what_does_not_vanish_and_their_factors() -> None:
    for divisor, *declared in (
        (r**2 - s**2, r - s, r + s),
        (r * h - s * h, r - s, h),
        (r**2 + 2 * r * s + s**2, r + s),
        (r**3 - r * s**2, r, r - s, r + s),
        (r, r * s),
        (r * s**2, r * s),
    ):
        verdict = verdict_on(a / divisor - b / divisor, (a - b) / divisor, *map(nonzero, declared))
        assert verdict.needs == tuple(f"{plain(each)} != 0" for each in declared), verdict
        assert isinstance(verdict_on(a / divisor, b / divisor, *map(nonzero, declared)), Fails)
        assert verdict_on(a / (divisor + 1), a / (divisor + 1), *map(nonzero, declared)).needs == (
            f"{plain(divisor + 1)} != 0",
        )


def test_what_inequalities_keep_from_zero() -> None:
    assert isinstance(verdict_on(s / r, s / r, inequality(r >= 1)), HoldsUnder)
    ellipse = inequality(r >= 0), inequality(r < 1)
    for divisor in (1 - r**2, 1 + r * cos(h), 2 - r * sin(h) - r):
        verdict = verdict_on(s / divisor, s / divisor, *ellipse)
        assert verdict.needs == (f"{plain(divisor)} != 0",)
    for divisor in (r + r**2, 1 - 2 * r, 1 + 2 * r * cos(h), r * s + 1):
        assert verdict_on(s / divisor, s / divisor, *ellipse).needs[-1] == f"{plain(divisor)} != 0"


def test_a_tangent_stands_where_it_is_one() -> None:
    assert verdict_on(tan(h / 2) * cos(h / 2), sin(h / 2)).needs == ("cos(h / 2) != 0",)
    assert verdict_on(tan(h), sin(h) / cos(h), nonzero(cos(h), r"h \neq 1")).needs == ("h != 1",)


def test_intervals_hold_sums_products_and_powers() -> None:
    draw, grid = Random(1), [Fraction(k, 4) for k in range(-20, 21)]

    def some() -> RealInterval:
        low, high = sorted(Fraction(draw.randint(-3, 3)) for _ in range(2))
        ends = [away if draw.random() < 0.2 else end for end, away in ((low, -inf), (high, inf))]
        return RealInterval(*ends, *(inf not in (-end, end) and low != high and draw.random() < 0.5 for end in ends))

    def has(interval: RealInterval, x: Fraction) -> bool:
        low, high = interval.low, interval.high
        above = x > low or (x == low and not interval.low_open)
        return above and (x < high or (x == high and not interval.high_open))

    for one, other in ((some(), some()) for _ in range(400)):
        for x in draw.sample([x for x in grid if has(one, x)], 1):
            assert has(one.within(other), x) == has(other, x)
            assert all(has(one.power(n), x**n) for n in (1, 2, 3, 4))
            assert has(-one, -x)
            assert all(has(one * other, x * y) and has(one + other, x + y) for y in grid if has(other, y))


@pytest.mark.parametrize("divisor", [r + s, 1 - r**2, r**2 + s**2, 1 + r, dot(a, b) + 1, r**2 - 1], ids=str)
def test_what_may_be_zero_is_a_need(divisor: Node) -> None:
    assert verdict_on(s / divisor, s / divisor).needs == (f"{plain(divisor)} != 0",)
    assert isinstance(verdict_on(s / divisor, 2 * s / divisor), Fails)


def test_what_divides_by_what_vanishes_says_nothing() -> None:
    for verdict in (
        verdict_on(s / (r - r), s),
        verdict_on(s / (r - h), s / r, given=(Definition("0", r, h),)),
        verdict_on(s / dot(a, b), s, perpendicular(a, b)),
    ):
        assert isinstance(verdict, Contradictory), verdict


def test_lengths_whose_rates_are_taken_are_not_zero() -> None:
    assert verdict_on(norm(a) * rate(norm(a)), dot(a, rate(a))).needs == ("|a| != 0",)
    assert isinstance(verdict_on(norm(a) * rate(norm(a)), dot(b, rate(a))), Fails)
    assert verdict_on(r * rate(r), dot(a, rate(a)), given=(Definition("0", r, norm(a)),)).needs == ("|a| != 0",)
    assert isinstance(verdict_on(rate(norm(a) ** 2), 2 * dot(a, rate(a))), Holds)


def test_entries_are_named_as_they_are_written() -> None:
    for divisor, name in ((a[2], "a_2"), (C[1, 3], "C_13"), (a.x + 1, "a_1 + 1")):
        assert verdict_on(s / divisor, s / divisor).needs == (f"{name} != 0",)
