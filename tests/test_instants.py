"""What holds at an instant only has no rate; what has a kink has none there; and bounds that meet are an equation."""

from __future__ import annotations

from typing import Any

import pytest
from sympy import (
    Abs,
    Derivative,
    Eq,
    Function,
    Heaviside,
    Implies,
    Max,
    Mul,
    Ne,
    Or,
    Piecewise,
    Subs,
    floor,
    sign,
    symbols,
)  # fmt: skip

from chasles import vocabulary as w
from chasles.decisions.session import Session
from chasles.prove import Untreatable, prove, recheck
from chasles.statements import Claim
from chasles.verdict import Fails, Holds, HoldsUnder, Undecided
from chasles.vocabulary import functions as f
from chasles.vocabulary import rate, scalar

t, u, y = symbols("t u y")
X, Y, F = (Function(name, real=True)(t) for name in "xyf")
D = X.diff(t)


@pytest.mark.parametrize(
    ("left", "right", "given"),
    [
        (D * (1 - sign(X) ** 2), 0, []),
        (Piecewise((D, Eq(X, 1)), (0, True)), 0, [Eq(Y, X)]),
        (D * Heaviside(-Abs(X), 1), 0, []),
        (Implies(Eq(X, 0), Eq(D, 0)), None, []),
        (Or(Ne(X, 0), Eq(D, 0)), None, []),
        (F.diff(t), sign(X) ** 2 * D, [Eq(F, X * sign(X) ** 2)]),
        (F.diff(t), 0, [Eq(F, t * sign(t) ** 2), Eq(t, 0)]),
        (F.diff(t), Piecewise((1, t >= 0), (0, True)), [Eq(F, Piecewise((t, t > 0), (2, True)))]),
        (Subs(Derivative(Piecewise((1, u > 0), (2, True)), u), u, 0), 0, []),
        (Subs(Mul(u, 1 / u, evaluate=False), u, y), 1, []),
    ],
    ids=str,
)
def test_what_holds_but_for_an_instant_is_not_proved(left: Any, right: Any, given: list[Any]) -> None:
    try:
        verdict = prove(left, right, given)
    except Untreatable:
        return
    assert isinstance(verdict, Fails | Undecided)


@pytest.mark.parametrize(
    ("left", "right", "given"),
    [
        (F.diff(t), Piecewise((D, X >= 0), (0, True)), [Eq(F, Max(X, 0))]),
        (F.diff(t), 0, [Eq(F, floor(t))]),
        (D, 0, [X >= 0, X <= 0]),
        (D, Y.diff(t), [X >= Y, Y >= X]),
        (D, 0, [Eq(Abs(X), 0)]),
        (Function("n", integer=True)(t) >= 1, None, [Function("n", integer=True)(t) > 0]),
        (Subs(Derivative(1 / u, u), u, y), -1 / y**2, []),
    ],
    ids=str,
)
def test_nothing_is_refuted_and_nothing_contradicts_itself_where_a_rate_has_no_value(
    left: Any, right: Any, given: list[Any]
) -> None:
    verdict = prove(left, right, given)
    assert isinstance(verdict, Holds | HoldsUnder | Undecided)
    if verdict.true:
        recheck(verdict, left, right, given)


@pytest.mark.parametrize(
    ("word", "value", "needs"),
    [
        (f.sign(scalar("x", "x", "")), w.number(0), ("x(t) != 0",)),
        (abs(scalar("x", "x", "")), f.sign(scalar("x", "x", "")) * rate(scalar("x", "x", "")), ("x(t) != 0",)),
        (f.sign(scalar("x", "x", "") * scalar("y", "y", "")), w.number(0), ("x(t) != 0", "y(t) != 0")),
    ],
    ids=str,
)
def test_a_rate_of_what_has_a_kink_needs_that_it_is_not_there(word: Any, value: Any, needs: tuple[str, ...]) -> None:
    verdict = Session().decide(Claim("1", rate(word), value)).verdict
    assert isinstance(verdict, HoldsUnder)
    assert verdict.needs == needs
    x = scalar("x", "x", "")
    greater = Claim("2", rate(f.maximum(x, w.number(0))), f.cases((rate(x), x >= 0), otherwise=w.number(0)))
    assert not isinstance(Session().decide(greater).verdict, Fails)
