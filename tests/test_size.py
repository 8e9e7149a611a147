"""Large questions come to an end after an amount of work, on every machine alike, and most of them with a verdict."""

from __future__ import annotations

from dataclasses import replace
from typing import Any

import pytest
from sympy import Abs, Add, I, Max, Rational, Sum, Symbol, arg, ceiling, floor, symbols

from chasles.prove import Rejected, Untreatable, prove, recheck
from chasles.verdict import Fails, Holds

x, y, k = symbols("x y k", real=True)
n = Symbol("n", integer=True, positive=True)


@pytest.mark.parametrize(
    ("left", "right", "name"),
    [
        (Sum(x**k * (k * x + ceiling(x)) ** Rational(1, 3), (k, 0, 500)), 0, None),
        (Sum(x**k / (k * x + 1), (k, 0, 400)), 0, None),
        (x**1000 - 1 > 0, None, Fails),
        (Abs((x + I * y) ** 31), Abs(x + I * y) ** 31, Holds),
        (arg((x + I * y) ** 12), 0, Fails),
        (Add(*(Abs(x - j) for j in range(9))) >= 20, None, Holds),
    ],
    ids=lambda case: str(case)[:30],
)
def test_the_work_is_bounded(left: Any, right: Any, name: type[Holds] | type[Fails] | None) -> None:
    if name is None:
        with pytest.raises(Untreatable, match="of so many terms"):
            prove(left, right)
        return
    verdict = prove(left, right)
    assert isinstance(verdict, name)
    recheck(verdict, left, right)


@pytest.mark.parametrize(("left", "right"), [(floor(x), x), (Max(x, y), x), (Sum(2**k, (k, 1, n)), n)], ids=str)
def test_a_point_is_told_in_numbers_not_in_texts(left: Any, right: Any) -> None:
    verdict = prove(left, right)
    assert isinstance(verdict, Fails)
    found = verdict.counterexample
    forged = replace(found, at=dict.fromkeys(found.at, "factorial(10**9)"))
    with pytest.raises(Rejected):
        recheck(Fails(forged), left, right)
