"""Roots of one product spelled in many ways, and angles that are equal though their roots are spelled differently."""

from __future__ import annotations

from dataclasses import replace
from itertools import permutations
from typing import Any

import pytest
import sympy as sp
from sympy import Rational, cos, exp, expand, factor, log, sin, sqrt, together

from chasles.prove import Rejected, prove, recheck
from chasles.verdict import Fails, Holds, HoldsUnder

p, q, m, k, c = sp.symbols("p q m k c", positive=True)
x, y, t = sp.symbols("x y t", real=True)


def spellings(a: Any, outside: Any, inside: Any, number: Any) -> list[Any]:
    """The root of a times outside^2 times inside times a number, in several ways."""
    return [
        sqrt(expand(a * outside**2 * inside * number)),
        outside * sqrt(expand(a * inside)) * sqrt(number),
        outside * sqrt(inside) * sqrt(number) * sqrt(a),
        outside * sqrt(number) * sqrt(expand(a / inside)) * inside,
        number * outside * inside * sqrt(expand(a / (inside * number))),
        sqrt(number) * sqrt(factor(together(a * outside))) * sqrt(outside * inside),
    ]


PRODUCTS = [
    (k * m - c**2 / 4, 1 / m, 1 / m, 4),
    (p - p**3, q, k / p, Rational(1, 4)),
    (1 - p**2, k / q, m * q, 9),
    (x**2 + p, q**2, 1 / (k * m), 2),
    (p - x, m / p, p, 1),
    (2 * p * q - x**2, p / q**2, k, 1),
]


@pytest.mark.sampled(37)
@pytest.mark.parametrize("product", PRODUCTS, ids=str)
@pytest.mark.parametrize("pair", list(permutations(range(6), 2)), ids=str)
def test_the_root_of_a_product_is_the_same_however_it_is_spelled(product: Any, pair: Any) -> None:
    one, other = (spellings(*product)[place] for place in pair)
    for sides in ((one, other), (one - other, sp.S.Zero), (x * one + y, x * other + y), (1 / one, 1 / other)):
        verdict = prove(*sides)
        assert isinstance(verdict, Holds | HoldsUnder)
        recheck(verdict, *sides)


OSCILLATION = exp(-c * t / (2 * m)) * cos(sqrt(k / m - c**2 / (4 * m**2)) * t)
CURRENT = exp(-c * t / (2 * p)) * sin(sqrt(1 / (p * q) - c**2 / (4 * p**2)) * t)
EQUAL_ANGLES = [
    (m * OSCILLATION.diff(t, 2) + c * OSCILLATION.diff(t), -k * OSCILLATION),
    (p * CURRENT.diff(t, 2) + c * CURRENT.diff(t), -CURRENT / q),
    (cos(sqrt(k / m) * t), cos(t * sqrt(expand(k * m * (p + 1))) / (m * sqrt(p + 1)))),
]


@pytest.mark.parametrize(("left", "right"), EQUAL_ANGLES, ids=str)
def test_angles_are_equal_if_what_they_are_is(left: Any, right: Any) -> None:
    verdict = prove(left, right)
    assert isinstance(verdict, Holds | HoldsUnder)
    recheck(verdict, left, right)
    with pytest.raises(Rejected):
        recheck(verdict, left, 2 * right + 1)
    (one, multiple, other, proof), *_ = verdict.certificate["equal"]
    for forged in ([one, "3", other, proof], [one, multiple, one, proof], [one, multiple, other, {}]):
        with pytest.raises(Rejected):
            recheck(replace(verdict, certificate={**verdict.certificate, "equal": [forged]}), left, right)


def test_angles_that_are_not_equal_are_not_taken_to_be() -> None:
    assert not prove(cos(sqrt(x**2) * t), cos(x * t) + sin(sqrt(x**2) * t) - sin(x * t)).true


@pytest.mark.parametrize("inside", [(x + 1) ** 2 - x**2 - 2 * x, 3 + (x + 1) ** 2 - x**2 - 2 * x], ids=str)
def test_the_logarithm_of_a_sum_that_is_a_number_is_known(inside: Any) -> None:
    assert isinstance(prove(log(inside), log(expand(inside))), Holds)


def test_conditions_that_sympy_simplifies_without_end_are_decided() -> None:
    n = sp.Symbol("n", nonnegative=True)
    z = sp.Symbol("z")
    endless = sp.Piecewise((n * x, n * x > z - n), (z - n, True))
    verdict = prove(endless, n * x, [x <= 1])
    assert isinstance(verdict, Fails)
    recheck(verdict, endless, n * x, [x <= 1])
