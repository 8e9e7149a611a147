"""The bound that runs with a program: not below the error that is made, and large where digits are lost."""

from __future__ import annotations

import math
from fractions import Fraction

import numpy as np
import pytest

from chasles.lowering.arithmetic import decimals
from chasles.lowering.lower import expanded, program_of, stable
from chasles.lowering.request import Output, composed
from chasles.lowering.rounding import losses
from chasles.vocabulary import cos, dot, norm, scalar, sin, vector

from ..programs import run

phi, x = scalar("phi", r"\phi", "an angle"), scalar("x", "x", "a number")
u, w = vector("u", "u", "a vector"), vector("w", "w", "a vector")
FORMULAS = {
    "versine": ((phi,), 1 - cos(phi)),
    "twice the square of a sine": ((phi,), 2 * sin(phi / 2) ** 2),
    "quotient": ((phi, x), x * sin(phi) / (2 - cos(phi))),
    "length": ((u, w), norm(u) / dot(w, w)),
    "difference": ((u, w), dot(u, w) - norm(u)),
}


def program(name):
    of, value = FORMULAS[name]
    return expanded(composed("f", of, (Output("y", "", value),)), dense=False)


def point(of, scale):
    return [[scale * (k + 1) * (0.3 + 0.17 * i) for i in range(symbol.shape[0])] for k, symbol in enumerate(of)]


def at(inputs):
    return {(k, i): np.array([x]) for k, entries in enumerate(inputs) for i, x in enumerate(entries)}


@pytest.mark.parametrize("scale", [1.0, 1e-3, 1e-6])
@pytest.mark.parametrize("case", FORMULAS)
def test_no_error_is_larger_than_the_bound(case, scale):
    inputs = point(FORMULAS[case][0], scale)
    arithmetic = decimals(80)
    exact = [[arithmetic.constant(Fraction(entry)) for entry in entries] for entries in inputs]
    ((got,),), ((wanted,),) = run(program(case), inputs), run(program(case), exact, arithmetic)
    ((bound,),) = losses(program(case), at(inputs))
    assert abs(got - wanted) <= 1.01 * bound * abs(wanted) * 2.0**-53


def test_lost_digits_are_seen():
    tiny = at([[1e-12]])
    ((lost,),), ((kept,),) = losses(program("versine"), tiny), losses(program("twice the square of a sine"), tiny)
    assert lost > 1e20
    assert kept < 16


def test_no_value_is_an_infinite_loss():
    request = composed("f", (phi,), (Output("y", "", 1 / sin(phi)),))
    assert losses(expanded(request, dense=False), at([[0.0]])).tolist() == [[math.inf]]


def test_programs_that_lose_digits_are_left_out():
    request = composed("f", (phi,), (Output("y", "", 1 - cos(phi)),))
    versine, square = program("versine"), program("twice the square of a sine")
    assert stable(request, [versine, square]) == [square]
    assert stable(request, [versine]) == [versine]
    assert losses(program_of(request), at([[1e-12]])).item() < 16
