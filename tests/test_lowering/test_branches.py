"""Inverses with cases: proved on every way through them, right next to a half-turn, with the sign that is promised."""

from __future__ import annotations

import math
from dataclasses import replace

import numpy as np
import pytest
from scipy.spatial.transform import Rotation

from chasles.decisions.session import Decision
from chasles.lowering.cases import choices_of, largest_of, oriented
from chasles.lowering.declaration import requested
from chasles.lowering.equivalence.requests import differences
from chasles.lowering.lower import lower, program_of
from chasles.lowering.program import Op
from chasles.lowering.refusal import LoweringError
from chasles.lowering.request import Output, composed
from chasles.lowering.rewriting import Angle
from chasles.lowering.scales import is_scale
from chasles.statements import Branch, Definition, Inverse, Kernel, half_turn, symmetric, unit
from chasles.verdict import Defined, Undecided
from chasles.vocabulary import Symbol, column, cos, dot, norm, number, scalar, sin, square, tr, uniform, vect, vector

from ..programs import run

e, phi, Q = vector("e", "e", "axis"), scalar("phi", r"\phi", "angle"), square("Q", "Q", "rotation")


def decide(sentence):
    return Decision(sentence, Defined())


@pytest.fixture(scope="module")
def made(book):
    """The natural invariants of a rotation, by the largest branch and with the first entry that counts positive."""
    inverse = book.natural_invariants
    e, phi = inverse.gives
    choices, rules, angles = choices_of(inverse, largest=True, sign=(cos(phi / 2), e))
    request = composed(
        "natural_invariants",
        inverse.kernel.of,
        (Output("e", "axis", e), Output("phi", "angle", phi)),
        rules=rules,
        hypotheses=inverse.assuming,
        choices=choices,
        angles=angles,
    )
    return request, program_of(request)


def invariants(made, matrix):
    (axis, (angle,)) = run(made[1], [matrix])
    return np.array(axis), angle


@pytest.mark.slow
def test_every_way_is_proved(made):
    assert differences(*made) == ()


def below_scales(program):
    """The steps of which scales are made: the result is the same whichever numbers they choose."""
    found, ahead = set(), [k for k in range(len(program.steps)) if is_scale(program.steps, k)]
    while ahead:
        number = ahead.pop()
        if number not in found:
            found.add(number)
            ahead += program.steps[number].operands
    return found


@pytest.mark.slow
def test_a_wrong_selection_is_found(made):
    request, program = made
    idle = below_scales(program)
    selections = [
        k for k, step in enumerate(program.steps) if step.op is Op.SELECT and 0 not in step.operands and k not in idle
    ]
    for place in (selections[0], selections[len(selections) // 2], selections[-1]):
        step = program.steps[place]
        turned = replace(step, operands=(step.operands[0], step.operands[2], step.operands[1]))
        steps = (*program.steps[:place], turned, *program.steps[place + 1 :])
        assert differences(request, replace(program, steps=steps))


def test_one_root_and_one_arctangent_are_made_for_all_branches(made):
    counts = made[1].operations
    assert counts[Op.ARCTANGENT2] == 1
    assert counts[Op.SQUARE_ROOT] == 2
    assert counts[Op.DIVIDE] == 5 + 3  # three by the largest of what is squared


ANGLES = [1e-9, 1e-3, 1.0, 2.0, 3.0, *(math.pi - gap for gap in (1e-3, 1e-6, 1e-9, 1e-12)), math.pi]
AXES = [(0, 0, 1), (1, 0, 0), (0, -1, 0), (1, 2, 2), (1e-9, 1, 1e-5), (-3, 1e-12, 4), (1, -1, 1), (-1e-7, -1, 2)]


@pytest.mark.parametrize("angle", ANGLES)
@pytest.mark.parametrize("axis", AXES)
def test_next_to_a_half_turn_no_digit_is_lost(made, axis, angle):
    axis = np.array(axis) / np.linalg.norm(axis)
    found, size = invariants(made, Rotation.from_rotvec(axis * angle).as_matrix())
    if angle == math.pi and found @ axis < 0:
        # A float matrix lies on either side of the half-turn.
        axis = -axis
    assert abs(found - axis).max() < 1e-15 + 2e-16 / angle
    assert abs(size - angle) < 1e-15


def test_the_identity_has_an_angle_and_no_axis(made):
    axis, angle = invariants(made, np.eye(3))
    assert np.isnan(axis).all()
    assert angle == 0


@pytest.mark.parametrize("axis", [(0, 0, 1), (0, 1, 0), (0, 3, -4), (-3, 0, 4), (-2, 2, 1), (0, -1, 0), (-1, 0, 0)])
def test_at_a_half_turn_the_first_entry_is_positive(made, axis):
    unit_vector = np.array(axis) / np.linalg.norm(axis)
    found, angle = invariants(made, 2 * np.outer(unit_vector, unit_vector) - np.eye(3))
    assert angle == math.pi
    assert found[np.flatnonzero(found)[0]] > 0
    assert abs(abs(found @ unit_vector) - 1) < 1e-15


def declared(*branches, **rest):
    whole = Inverse("9.1", of=Definition("9.0", Q, e @ e.T), branches=branches, gives=(e,), **rest)
    return replace(whole, kernel=Kernel(of=(Q,), name="f"))


LENGTH = norm(vect(Q))
FIRST = Branch("turning", where=LENGTH, values=((e, vect(Q) / LENGTH),))
LAST = Branch("a half-turn", where=tr(Q), values=((e, column(1, 0, 0)),), assuming=(half_turn(Q),))


def test_the_first_branch_that_applies_is_taken_and_none_beyond_the_last():
    request = requested(declared(FIRST, LAST), decide)
    program = program_of(request)
    assert differences(request, program) == ()
    assert run(program, [[0, -2, 0, 2, 0, 0, 0, 0, 0]]) == ((0, 0, 1),)
    assert run(program, [[-1, 0, 0, 0, -1, 0, 0, 0, 1]]) == ((1, 0, 0),)
    for nowhere in (np.eye(3), np.zeros((3, 3))):
        assert np.isnan(run(program, [nowhere])[0]).all()


def test_a_declared_inverse_is_lowered(book):
    program = lower(declared(FIRST, LAST), decide)
    assert [argument.name for argument in program.arguments] == ["Q"]
    with pytest.raises(LoweringError, match=r"f: \(9\.1\) is undecided as printed"):
        lower(declared(FIRST, LAST), lambda sentence: Decision(sentence, Undecided("")))


@pytest.mark.parametrize(
    ("branches", "said"),
    [
        ((FIRST, replace(LAST, values=())), "the branches must give values to the same symbols"),
        ((replace(FIRST, assuming=(symmetric(Q),)),), "assumes that Q is symmetric, which no comparison of numbers"),
        ((replace(FIRST, values=((e + e, vect(Q)),)),), "a branch gives a value to e + e; it must be a symbol"),
    ],
)
def test_branches_that_cannot_be_told_apart_are_refused(branches, said):
    with pytest.raises(LoweringError) as caught:
        choices_of(declared(*branches))
    assert said in str(caught.value)


def test_an_angle_known_by_its_half_has_a_cosine_and_no_third(book):
    half = Branch("", where=number(1), values=((cos(phi / 2), Q_11), (sin(phi / 2), Q_12)))
    choices, rules, angles = choices_of(declared(half))
    known = {"choices": choices, "rules": rules, "angles": angles}
    request = composed("f", (Q,), (Output("y", "", cos(phi) + sin(phi)),), **known)
    program = program_of(request)
    assert program.operations[Op.ARCTANGENT2] == program.operations[Op.COSINE] == 0
    assert differences(request, program) == ()
    ((found,),) = run(program, [[0.6, 0.8, 0, 0, 0, 0, 0, 0, 0]])
    assert abs(found - (math.cos(2 * math.atan2(0.8, 0.6)) + 0.96)) < 1e-15
    with pytest.raises(LoweringError, match="give the cosine and sine of that fraction instead"):
        composed("f", (Q,), (Output("y", "", cos(phi / 3)),), **known)


def test_an_argument_that_is_an_angle_is_not_opened():
    known = {phi: Angle(Q_11, Q_12)}
    request = composed("f", (theta, Q), (Output("y", "", cos(theta) * cos(phi)),), rules={theta: 2 * phi}, angles=known)
    program = program_of(request)
    assert program.operations[Op.COSINE] == 1
    assert differences(request, program) == ()


theta = scalar("theta", r"\theta", "another angle")
Q_11, Q_12 = (dot(column(1, 0, 0), Q @ unit_column) for unit_column in (column(1, 0, 0), column(0, 1, 0)))
sizes = [scalar(f"s_{k}", "s", "") for k in range(3)]
picked = scalar("picked", "p", "")


@pytest.mark.parametrize(
    ("numbers", "place"), [((3, 1, 2), 0), ((1, 3, 2), 1), ((1, 2, 3), 2), ((2, 2, 1), 0), ((0, 5, 5), 1)]
)
def test_the_largest_is_taken_and_of_equal_ones_the_first(numbers, place):
    choice = largest_of((picked,), [(size, (number(k),)) for k, size in enumerate(sizes)])
    request = composed("f", sizes, (Output("y", "", picked + 0),), choices=(choice,))
    program = program_of(request)
    assert differences(request, program) == ()
    assert run(program, numbers) == ((place,),)


@pytest.mark.parametrize(("numbers", "sign"), [((0, 0, 0), 1), ((0, -2, 5), -1), ((3, -1, 0), 1), ((0, 0, -1), -1)])
def test_the_sign_is_that_of_the_first_entry_that_is_not_zero(numbers, sign):
    turn = Symbol("turn", "", uniform((1, 1)))
    request = composed("f", sizes, (Output("y", "", turn + 0),), choices=(oriented(turn, sizes),))
    program = program_of(request)
    assert differences(request, program) == ()
    assert run(program, numbers) == ((sign,),)


def test_a_hypothesis_beside_the_branches_comes_along():
    request = requested(declared(FIRST, LAST, assuming=(unit(e),)), decide)
    assert [h.text for h in request.hypotheses] == ["|e| = 1"]
