"""Divisors are kept in range by the largest of what they are made of, and nothing else changes."""

from __future__ import annotations

from dataclasses import replace
from fractions import Fraction

import numpy as np
import pytest

from chasles import kernels
from chasles.bounds.proving import bound_of
from chasles.decisions.session import Session
from chasles.lowering.builder import Builder
from chasles.lowering.declaration import requested
from chasles.lowering.equivalence.requests import differences
from chasles.lowering.lower import program_of
from chasles.lowering.passes import scale
from chasles.lowering.passes.scale import scaled
from chasles.lowering.program import Argument, Op, Program, Result
from chasles.lowering.scales import is_scale, scale_of
from chasles.statements import Claim, Kernel, load, nonzero
from chasles.vocabulary import norm, scalar, vector

from ..programs import fractions, run

SCALED = ["plucker_line", "instant_screw_point", "instant_screw", "wrench_axis", "newton_euler_twist_rate"]


@pytest.fixture(scope="module")
def book():
    judge, entries = Session(), {entry.name: entry for entry in load()}
    return lambda name: requested(entries[name], judge.decide)


def scales(program):
    return [k for k in range(len(program.steps)) if is_scale(program.steps, k)]


@pytest.mark.parametrize("kernel", SCALED)
def test_what_can_leave_the_range_is_scaled_once_and_proved(book, kernel):
    request = book(kernel)
    program = program_of(request)
    assert len(scales(program)) == 1
    assert differences(request, program) == ()


@pytest.mark.parametrize("kernel", ["rotation_from_axis_angle", "screw_axis_point", "natural_rate_matrix", "power"])
def test_what_cannot_is_left_alone(book, kernel):
    assert scales(program_of(book(kernel))) == []


@pytest.mark.parametrize("kernel", ["plucker_line", "newton_euler_twist_rate"])
def test_a_wrong_power_of_the_scale_is_found(book, kernel, monkeypatch):
    right = scale._Scaling._product

    def wrong(self, step):
        powers, held = right(self, step)
        return {place: power - (power == 2) for place, power in powers.items()}, held

    monkeypatch.setattr(scale._Scaling, "_product", wrong)
    request = book(kernel)
    assert differences(request, program_of(request))


@pytest.mark.parametrize("kernel", ["plucker_line", "instant_screw"])
def test_no_step_may_use_the_scale_otherwise(book, kernel):
    """Whatever positive number the scale is, the program has to be right: a result that depends on it is refused."""
    request = book(kernel)
    program = program_of(request)
    (number,) = scales(program)
    result = program.results[0]
    spoiled = replace(result, entries=(number, *result.entries[1:]))
    assert differences(request, replace(program, results=(spoiled, *program.results[1:])))


def test_a_scale_is_the_largest_size_or_one():
    build = Builder()
    number = scale_of(build, [build.input(0, k) for k in range(3)])
    program = Program("s", (Argument("x", (3,), ""),), build.steps, (Result("s", (), "", (number,)),))
    assert is_scale(build.steps, number)
    for values, size in (((1, -3, 2), 3), ((0, 0, 0), 1), ((0, -2, 0), 2), ((5, 1, 1), 5)):
        assert run(program, [[Fraction(x) for x in values]], fractions()) == ((size,),)


def test_a_choice_that_is_no_scale_is_not_taken_for_one():
    build = Builder()
    x, y = build.input(0, 0), build.input(0, 1)
    larger = build.select(build.less(x, y), y, x)
    number = build.select(build.equal(larger, build.zero), build.one, larger)
    assert not is_scale(build.steps, number)


def test_a_program_without_such_a_divisor_is_the_same():
    build = Builder()
    x, y = build.input(0, 0), build.input(0, 1)
    quotient = build.divide(x, build.add(build.one, build.multiply(y, y)))
    program = Program("q", (Argument("x", (2,), ""),), build.steps, (Result("q", (), "", (quotient,)),))
    assert scaled(program) is program


def test_a_bound_is_proved_with_the_scale(book):
    request = book("plucker_line")
    (guarantee,) = bound_of(program_of(request), request).guarantees
    assert (guarantee.against, float(guarantee.units) < 10) == ("terms", True)


@pytest.mark.parametrize("size", [1e-320, 1e-300, 1e-160, 1e-155, 1e154, 1e200, 1e307])
def test_directions_of_every_length(size):
    along = np.array([0.6, 0.0, 0.8])
    with np.errstate(all="raise", under="ignore"):
        e = kernels.plucker_line(np.zeros(3), along * size)[:3]
    assert np.allclose(e, along, rtol=1e-3 if size < 1e-310 else 1e-15)
    axis, pitch = kernels.instant_screw(along * size, 2 * along * size, np.zeros(3))
    assert np.allclose(axis[:3], along, rtol=1e-3 if size < 1e-310 else 1e-15)
    assert np.isclose(pitch, 2, rtol=1e-2)


@pytest.mark.parametrize("angle", [1e-30, 1e-160, 1e-200, 1e-300])
def test_the_axis_of_the_smallest_turn(angle):
    e, phi = kernels.natural_invariants([[1, 0, 0], [0, 1, -angle], [0, angle, 1]])
    assert (e.tolist(), phi) == ([1, 0, 0], angle)


@pytest.mark.parametrize("place", range(9))
@pytest.mark.parametrize("wrong", [np.nan, np.inf, -np.inf])
def test_no_axis_of_what_is_no_number(place, wrong):
    Q = np.array([[1, -1e-3, 0], [1e-3, 1, 0], [0, 0, 1]])
    Q.flat[place] = wrong
    with np.errstate(all="ignore"):
        e, phi = kernels.natural_invariants(Q)
    assert np.isnan(e).all()
    assert np.isnan(phi)


def test_small_inertias_in_single_precision():
    inertia, w = np.diag([1e-13, 2e-13, 3e-13]).astype(np.float32), np.array([1, 1, 1, 0, 0, 0], np.float32) * 1e-13
    found = kernels.newton_euler_twist_rate(inertia.astype(np.float32), np.float32(1), np.zeros(6, np.float32), w)
    assert np.allclose(found[:3], [1, 1 / 2, 1 / 3], rtol=1e-6)


def test_programs_keep_their_comparisons_free_of_charge(book):
    assert program_of(book("instant_screw")).operations[Op.DIVIDE] == 13


@pytest.mark.sampled(2)
@pytest.mark.parametrize("kernel", ["natural_invariants", "screw_of_motion"])
def test_no_case_may_use_the_scale_otherwise(book, kernel):
    request = book(kernel)
    program = program_of(request)
    assert differences(request, program) == ()
    (number,), steps = scales(program), list(program.steps)
    one = next(k for k, step in enumerate(steps) if step.op is Op.CONSTANT and step.value == 1)
    readers = [k for k, step in enumerate(steps) if number in step.operands]
    spoiled = replace(steps[readers[0]], operands=tuple(one if k == number else k for k in steps[readers[0]].operands))
    steps[readers[0]] = spoiled
    assert differences(request, replace(program, steps=tuple(steps)))


@pytest.mark.parametrize("power", [5, 7])
def test_a_high_power_of_a_length_is_no_divisor_that_can_be_zero(power):
    """Once refused: "divides by what can be zero where the formula has a value"."""
    r, mu = vector("r", "r", "a position"), scalar("mu", "mu", "a parameter")
    tide = mu / norm(r) ** power * (3 * r @ r.T)
    said = Claim("1", tide, tide, assuming=(nonzero(norm(r)),), kernel=Kernel(of=(r, mu), name="tide"))
    request = requested(said, Session().decide)
    program = program_of(request)
    assert scales(program)
    assert differences(request, program) == ()
