"""Euler angles: the kernels of the twelve sequences beside SciPy, SymPy's mechanics, differentiation and themselves."""

from __future__ import annotations

from itertools import product

import mpmath
import numpy as np
import pytest
import sympy
import sympy.physics.mechanics as mechanics
from chasles.derivations.x3_10_euler_angles import SEQUENCES, angles
from scipy.spatial.transform import Rotation

from chasles import kernels
from chasles.decisions.session import Session
from chasles.lowering.lower import lower
from chasles.lowering.program import Op, Program
from chasles.statements import Kernel, load

PROPER = tuple(s for s in SEQUENCES if s[0] == s[2])
BATCH = np.random.default_rng(3).uniform(-3.1, 3.1, (200, 3))
VELOCITIES = np.random.default_rng(4).standard_normal((200, 3))
DIGITS = 40


def of(name: str, sequence: str):
    return getattr(kernels, f"{name}_{sequence}")


def arithmetic(program: Program) -> int:
    """How many operations there are besides sines and cosines."""
    return sum(count for op, count in program.operations.items() if op not in (Op.SINE, Op.COSINE))


def test_the_sequences_are_the_twelve() -> None:
    letters = {"".join(s) for s in product("xyz", repeat=3) if s[0] != s[1] != s[2]}
    assert {*SEQUENCES} == letters
    assert len(SEQUENCES) == 12
    assert len(PROPER) == 6


@pytest.mark.parametrize("sequence", SEQUENCES)
def test_the_rotation_is_scipys_intrinsic_one(sequence: str) -> None:
    expected = Rotation.from_euler(sequence.upper(), BATCH).as_matrix()
    np.testing.assert_allclose(of("rotation_from_euler", sequence)(BATCH), expected, rtol=0, atol=2e-15)


@pytest.mark.parametrize("sequence", SEQUENCES)
def test_rotation_and_angular_velocity_are_those_of_sympys_mechanics(sequence: str) -> None:
    turns = mechanics.dynamicsymbols("q1:4")
    fixed, body = mechanics.ReferenceFrame("N"), mechanics.ReferenceFrame("B")
    body.orient_body_fixed(fixed, turns, sequence)
    speeds = sympy.symbols("u1:4")
    spoken = {q.diff(mechanics.dynamicsymbols._t): u for q, u in zip(turns, speeds, strict=True)}
    velocity = body.ang_vel_in(fixed)
    at = dict(zip(turns, (0.7, -1.1, 2.3), strict=True))
    for name, frame in (("euler_rate_matrix", fixed), ("euler_rate_matrix_body", body)):
        W = velocity.to_matrix(frame).subs(spoken).jacobian(speeds).subs(at)
        found = of(name, sequence)([0.7, -1.1, 2.3])
        np.testing.assert_allclose(found, np.array(W, dtype=float), rtol=0, atol=1e-14)
    Q = np.array(fixed.dcm(body).subs(at), dtype=float)
    np.testing.assert_allclose(of("rotation_from_euler", sequence)([0.7, -1.1, 2.3]), Q, rtol=0, atol=1e-14)


def turned(context: mpmath.MPContext, axis: str, angle: mpmath.mpf) -> mpmath.matrix:
    i = "xyz".index(axis)
    j, k = (i + 1) % 3, (i + 2) % 3
    matrix = context.eye(3)
    matrix[j, j] = matrix[k, k] = context.cos(angle)
    matrix[k, j], matrix[j, k] = context.sin(angle), -context.sin(angle)
    return matrix


@pytest.mark.parametrize("sequence", SEQUENCES)
def test_the_rate_matrices_are_the_derivatives_of_the_rotation(sequence: str) -> None:
    context = mpmath.MPContext()
    context.dps = DIGITS
    point, step = [0.4, 1.3, -2.1], context.mpf(10) ** (-DIGITS // 3)

    def rotation(moved: int, by: mpmath.mpf) -> mpmath.matrix:
        now = [context.mpf(x) + (by if k == moved else 0) for k, x in enumerate(point)]
        first, second, third = (turned(context, axis, x) for axis, x in zip(sequence, now, strict=True))
        return first * second * third

    for place in range(3):
        slope = (rotation(place, step) - rotation(place, -step)) / (2 * step)
        Q = rotation(place, context.mpf(0))
        for name, velocity in (("euler_rate_matrix", slope * Q.T), ("euler_rate_matrix_body", Q.T * slope)):
            column = [float(velocity[2, 1]), float(velocity[0, 2]), float(velocity[1, 0])]
            np.testing.assert_allclose(of(name, sequence)(point)[:, place], column, rtol=0, atol=4e-16)


@pytest.mark.parametrize("sequence", SEQUENCES)
def test_the_rates_go_back_through_the_matrix(sequence: str) -> None:
    rates = of("euler_rates", sequence)(BATCH, VELOCITIES)
    W = of("euler_rate_matrix", sequence)(BATCH)
    np.testing.assert_allclose((W @ rates[..., None])[..., 0], VELOCITIES, rtol=0, atol=1e-12)


@pytest.mark.sampled(5)
@pytest.mark.parametrize("sequence", SEQUENCES)
@pytest.mark.parametrize("dtype", [np.float64, np.float32])
def test_near_a_singular_configuration_the_rates_are_right(sequence: str, dtype: type) -> None:
    """The finite value for the float that is given, the nearest to pi/2 or to pi among them."""
    middles = np.array([0.0, np.pi], dtype) if sequence in PROPER else np.array([np.pi / 2, -np.pi / 2], dtype)
    offsets = np.array([0.0, 1e-300, 1e-30, 1e-12, 1e-8, 1e-4], dtype)
    for middle, offset in product(middles, offsets):
        theta = middle + offset
        if theta == 0:
            continue
        point = np.array([0.3, theta, 1.1], dtype)
        omega = np.array([0.2, -0.5, 0.7], dtype)
        found = of("euler_rates", sequence)(point, omega)
        expected = solved(sequence, point, omega)
        assert found.dtype == dtype
        np.testing.assert_allclose(found, expected, rtol=16 * np.finfo(dtype).eps)


def solved(sequence: str, point: np.ndarray, omega: np.ndarray) -> list[float]:
    """The rates from the definition: the axes of the turns as columns, in many digits."""
    context = mpmath.MPContext()
    context.dps = 700
    first, second = (
        turned(context, axis, context.mpf(float(x))) for axis, x in zip(sequence[:2], point[:2], strict=True)
    )
    axes = [context.matrix([int(axis == letter) for letter in "xyz"]) for axis in sequence]
    columns = [axes[0], first * axes[1], first * second * axes[2]]
    W = context.matrix(3, 3)
    for j, column in enumerate(columns):
        for i in range(3):
            W[i, j] = column[i]
    solution = context.lu_solve(W, context.matrix([context.mpf(float(x)) for x in omega]))
    return [float(x) if abs(x) < 1e308 else float("inf") * int(context.sign(x)) for x in solution]


@pytest.mark.parametrize("sequence", PROPER)
@pytest.mark.parametrize("zero", [0.0, -0.0])
@pytest.mark.parametrize("omega", [(0.2, -0.5, 0.7), (0.0, 0.0, 0.0)])
def test_where_the_sine_is_zero_two_rates_have_no_value(sequence: str, zero: float, omega: tuple[float, ...]) -> None:
    with pytest.warns(RuntimeWarning, match="invalid"):
        found = of("euler_rates", sequence)([0.3, zero, 1.1], omega)
    assert np.isnan(found).tolist() == [True, False, True]


@pytest.mark.parametrize("sequence", [s for s in SEQUENCES if s not in PROPER])
def test_no_float_is_singular_where_a_cosine_is_divided_by(sequence: str) -> None:
    found = of("euler_rates", sequence)([[0.3, 0.0, 1.1], [0.3, np.pi / 2, 1.1]], [0.2, -0.5, 0.7])
    assert np.isfinite(found).all()


@pytest.mark.parametrize("sequence", SEQUENCES)
def test_without_limits_there_is_no_number(sequence: str) -> None:
    with pytest.warns(RuntimeWarning, match="invalid"):
        assert np.isnan(of("rotation_from_euler", sequence)([np.inf, 0.2, 0.3])).any()
    assert np.isnan(of("rotation_from_euler", sequence)([np.nan, 0.2, 0.3])).any()


def test_few_operations() -> None:
    decide = Session().decide
    entries = {entry.name: entry for entry in load()}
    for sequence in SEQUENCES:
        assert arithmetic(lower(entries[f"rotation_from_euler_{sequence}"], decide)) <= 18
        assert arithmetic(lower(entries[f"euler_rate_matrix_{sequence}"], decide)) == 2
        assert arithmetic(lower(entries[f"euler_rate_matrix_body_{sequence}"], decide)) == 2
        inverted = Kernel(of=(angles,), name="inverse", results=("W_inverse",))
        assert arithmetic(lower(entries[f"inverse_of_euler_rate_matrix_{sequence}"], decide, inverted)) <= 6
        assert arithmetic(lower(entries[f"euler_rates_{sequence}"], decide)) == 9
