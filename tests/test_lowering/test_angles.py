"""Functions of one angle in lowest terms: equal to what they were, cheaper where that is possible, exact as algebra."""

from __future__ import annotations

from fractions import Fraction

import pytest
from hypothesis import given
from hypothesis import strategies as st

from chasles.lowering.builder import Builder
from chasles.lowering.circular import constant, multiple_of_angle
from chasles.lowering.cost import price
from chasles.lowering.equivalence.requests import differences
from chasles.lowering.lower import expanded, program_of
from chasles.lowering.passes.angles import respelled
from chasles.lowering.passes.prune import pruned
from chasles.lowering.program import Argument, Op, Program, Result
from chasles.lowering.request import Output, composed
from chasles.vocabulary import cos, cot, number, scalar, sin, tan

phi, alpha, x = (scalar(name, name, "a number") for name in ("phi", "alpha", "x"))
one = number(1)

SPELLED = {
    "versine": (1 - cos(phi), {Op.SINE: 1, Op.MULTIPLY: 3}),
    "one plus cosine": (1 + cos(phi), {Op.COSINE: 1, Op.MULTIPLY: 3}),
    "cotangent": (sin(phi) / (1 - cos(phi)), {Op.SINE: 1, Op.COSINE: 1, Op.MULTIPLY: 1, Op.DIVIDE: 1}),
    "tangent": (sin(phi) / (1 + cos(phi)), {Op.SINE: 1, Op.COSINE: 1, Op.MULTIPLY: 1, Op.DIVIDE: 1}),
    "the other cotangent": ((1 + cos(phi)) / sin(phi), {Op.SINE: 1, Op.COSINE: 1, Op.MULTIPLY: 1, Op.DIVIDE: 1}),
    "reciprocal versine": (1 / (2 * (1 - cos(phi))), {Op.SINE: 1, Op.MULTIPLY: 2, Op.DIVIDE: 1}),
    "a number": (cos(phi) ** 2 + sin(phi) ** 2, {}),
    "a half again": (1 - cos(phi / 2), {Op.SINE: 1, Op.MULTIPLY: 3}),
}
EQUAL = {
    "not a monomial below": sin(phi) / (3 - cos(phi)),
    "half and whole": sin(phi / 2) * sin(phi) / (1 - cos(phi)),
    "higher multiples": (cos(3 * phi) - cos(phi)) / sin(2 * phi),
    "a third": cos(phi / 3) - 4 * cos(phi / 3) ** 3 + cos(phi),
    "powers below": x / (1 - cos(phi)) ** 2 + 1 / sin(phi) ** 3,
    "another angle": cos(alpha) * (1 - cos(phi)) / (1 + cos(alpha)),
    "a sum of angles": cos(alpha + phi) * (1 - cos(phi)) + x,
    "opposite angle": (1 - cos(-phi)) * sin(-phi) / x,
    "cot and tan": cot(phi / 2) - tan(phi / 2),
}


def asked(value):
    used = [symbol for symbol in (phi, alpha, x) if symbol.name in str(value)]
    return composed("f", used, (Output("y", "", value),))


def as_written(value):
    """The program before any function of an angle is written anew."""
    return pruned(expanded(asked(value), dense=False))


@pytest.mark.parametrize("case", SPELLED)
def test_half_the_angle_in_lowest_terms(case):
    value, operations = SPELLED[case]
    program = pruned(respelled(as_written(value), halved=True))
    assert differences(asked(value), program) == ()
    assert dict(program.operations) == operations


@pytest.mark.parametrize("halved", [False, True])
@pytest.mark.parametrize("case", EQUAL)
def test_equal_to_what_it_was(case, halved):
    program = pruned(respelled(as_written(EQUAL[case]), halved=halved))
    assert differences(asked(EQUAL[case]), program) == ()


def test_what_is_the_same_for_all_angles_is_a_number():
    build = Builder()
    c, s = build.cosine(build.input(0, 0)), build.sine(build.input(0, 0))
    total = build.add(build.multiply(c, c), build.multiply(s, s))
    program = Program("f", (Argument("phi", (), ""),), build.steps, (Result("y", (), "", (total,)),))
    (step,) = pruned(respelled(program, halved=True)).steps
    assert (step.op, step.value) == (Op.CONSTANT, 1)


def test_an_angle_may_be_a_cosine():
    program = pruned(respelled(as_written(x * (1 - cos(sin(phi)))), halved=True))
    assert dict(program.operations) == {Op.SINE: 2, Op.COSINE: 1, Op.MULTIPLY: 5}


def test_a_harmless_versine_stays_as_it_is():
    value = cos(phi) * x + (1 - cos(phi))
    assert program_of(asked(value)).operations[Op.MULTIPLY] == 1


def test_a_harmful_versine_does_not():
    program = program_of(asked(x * (1 - cos(phi))))
    assert program.operations[Op.COSINE] == 0
    assert program.operations[Op.SINE] == 1


small = st.integers(-3, 3)


@given(st.lists(st.tuples(small, small, small), min_size=1, max_size=3), st.integers(1, 3), st.integers(-4, 4))
def test_the_algebra_is_exact(terms, times, shift):
    """Sums, products and quotients of functions of an angle whose cosine and sine are rational."""
    c, s = Fraction(3, 5), Fraction(4, 5)
    cosine, sine = multiple_of_angle(times)
    d, t = Fraction(1), Fraction(0)
    for _ in range(times):
        d, t = d * c - t * s, t * c + d * s
    total, expected = constant(Fraction(shift)), Fraction(shift)
    for p, q, r in terms:
        total = total * (cosine * constant(Fraction(p)) + sine * constant(Fraction(q))) + constant(Fraction(r))
        expected = expected * (p * d + q * t) + r
    assert value_at(total, s, c) == expected
    if expected:
        assert value_at((cosine + sine) / total, s, c) == (d + t) / expected


def value_at(function, s, c):
    def polynomial(terms):
        return sum((q * s**i * c**j for (i, j), q in terms), Fraction(0))

    i, j = function.powers
    return polynomial(function.above) / polynomial(function.below) * s**i * c**j


def test_what_gains_nothing_by_halves_is_not_halved():
    stated = as_written(sin(phi / 2))
    assert price(stated) < price(pruned(respelled(stated, halved=True)))
