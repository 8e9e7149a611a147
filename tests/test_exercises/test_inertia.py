"""Exercises 3.13 to 3.16, 3.20 and 3.21: moments of inertia and dyads of bodies made with known answers."""

from __future__ import annotations

from random import Random
from typing import Any

import pytest
import sympy as sp

from chasles.exact.numbers import is_zero
from chasles.exact.polynomial_roots import Root
from chasles.exercises.data import DataError
from chasles.exercises.solving import solve

from .known import plain, quaternion, rational, rotation, same, vector


def steiner(inertia: Any, m: Any, d: Any) -> sp.Matrix:
    return inertia + m * (d.dot(d) * sp.eye(3) - d * d.T)


def body(draw: Random, *moments: int) -> tuple[sp.Matrix, sp.Matrix]:
    """A moment of inertia with known principal moments, and the rotation whose columns are its axes."""
    turn = rotation(*quaternion(draw))
    return turn * sp.diag(*moments) * turn.T, turn


@pytest.mark.parametrize("seed", range(6))
def test_point_masses(seed: int) -> None:
    draw = Random(seed)
    points = [vector(draw) for _ in range(seed + 1)]
    m = abs(rational(draw)) + 1
    answers = solve("3.13", m=str(m), points=[plain(p) for p in points]).answers
    center = sum(points, sp.zeros(3, 1)) / len(points)
    about = lambda o: sum((m * ((p - o).dot(p - o) * sp.eye(3) - (p - o) * (p - o).T) for p in points), sp.zeros(3))  # noqa: E731
    assert same(answers["I_O"], about(sp.zeros(3, 1)))
    assert same(answers["centroid"], center)
    assert same(answers["I_C"], about(center))
    assert same(answers["total_mass"], m * len(points))


@pytest.mark.parametrize("data", [{"m": 0}, {"m": -1}, {"points": []}, {"points": [[1, 2]]}, {"points": 3}])
def test_malformed_point_masses(data: dict) -> None:
    with pytest.raises(DataError):
        solve("3.13", **data)


@pytest.mark.sampled(3)
@pytest.mark.parametrize(
    ("moments", "admissible", "planar"),
    [((1, 2, 3), True, True), ((3, 4, 5), True, False), ((1, 2, 4), False, False), ((2, 2, 2), True, False),
     ((0, 5, 5), True, True), ((-1, 2, 2), False, False), ((2, 2, 4), True, True)],
)  # fmt: skip
@pytest.mark.parametrize("seed", [1, 2])
def test_two_observers_of_one_body(moments: tuple, admissible: bool, planar: bool, seed: int) -> None:
    draw = Random(seed)
    one, other = (body(draw, *moments)[0] for _ in range(2))
    answers = solve("3.14", A=plain(one), B=plain(other)).answers
    assert answers["compatible"] is True
    assert answers["physically_admissible"] is admissible
    assert answers["planar"] is planar
    expected = sp.Matrix(
        [sum(moments), sum(moments[i] * moments[j] for i, j in ((0, 1), (0, 2), (1, 2))), sp.prod(moments)]
    )
    for name in ("A", "B"):
        assert same(answers[f"invariants_{name}"], expected)
        assert same(answers[f"eigenvalues_{name}"], sp.Matrix(sorted(moments)))
    assert same(answers["trace_sq"], [sum(x * x for x in moments)] * 2)


@pytest.mark.parametrize(("one", "other"), [((1, 2, 3), (1, 2, 4)), ((2, 2, 3), (2, 3, 3)), ((1, 4, 4), (2, 2, 5))])
def test_two_observers_of_two_bodies(one: tuple, other: tuple) -> None:
    draw = Random(3)
    answers = solve("3.14", A=plain(body(draw, *one)[0]), B=plain(body(draw, *other)[0])).answers
    assert answers["compatible"] is False


def test_equal_traces_alone_do_not_make_observers_agree() -> None:
    """The first two invariants of (1, 4, 4) and (2, 2, 5) are 9 and 24; the determinants are 16 and 20."""
    answers = solve("3.14", A=plain(sp.diag(1, 4, 4)), B=plain(sp.diag(2, 2, 5))).answers
    assert answers["invariants_A"][:2, 0] == answers["invariants_B"][:2, 0]
    assert answers["trace_sq"][0] == answers["trace_sq"][1]
    assert answers["compatible"] is False


def test_observers_whose_moments_are_no_square_roots() -> None:
    one = sp.Matrix([[5, -1, -1], [-1, 6, -1], [-1, -1, 7]])
    turn = rotation(1, 2, 0, 1)
    answers = solve("3.14", A=plain(one), B=plain(turn * one * turn.T)).answers
    assert answers["compatible"] is True
    assert answers["eigenvalues_A"] == answers["eigenvalues_B"]
    assert all(isinstance(value, Root) for value in answers["eigenvalues_A"])


@pytest.mark.parametrize("key", ["A", "B"])
def test_an_unsymmetric_matrix_is_no_moment_of_inertia(key: str) -> None:
    with pytest.raises(DataError, match=f"{key}: expected a symmetric matrix, and got 1 in row 2, column 1 and 0"):
        solve("3.14", **{key: [[1, 0, 0], [1, 2, 0], [0, 0, 3]]})


@pytest.mark.sampled(3)
@pytest.mark.parametrize("seed", range(4))
@pytest.mark.parametrize(
    ("along", "every", "some"),
    [((0, 0, 0), True, True), ((0, 3, 0), True, True), ((1, 2, 0), False, True), ((1, 0, -1), False, True),
     ((1, 2, 3), False, False)],
)  # fmt: skip
def test_shared_principal_axes(seed: int, along: tuple, every: bool, some: bool) -> None:
    draw = Random(seed)
    moments = (3, 4, 5)
    inertia, turn = body(draw, *moments)
    d, m = turn * sp.Matrix(along), abs(rational(draw)) + 1
    answers = solve("3.15", I_C=plain(inertia), m=str(m), d=plain(d)).answers
    assert same(answers["I_P"], steiner(inertia, m, d))
    assert answers["share_all_axes"] is every
    assert answers["share_at_least_one"] is some
    assert same(answers["moments_C"], sp.Matrix(moments))
    if every:
        grown = [moment + m * (d.dot(d) if not along[k] else 0) for k, moment in enumerate(moments)]
        assert same(answers["moments_P"], sp.Matrix(sorted(grown)))


@pytest.mark.parametrize(
    ("moments", "along", "every", "some"),
    [((2, 2, 3), (1, 4, 0), True, True), ((2, 2, 3), (1, 4, 1), False, True), ((2, 2, 2), (1, 2, 3), True, True),
     ((0, 2, 2), (5, 0, 0), True, True)],
)  # fmt: skip
def test_shared_axes_where_moments_are_equal(moments: tuple, along: tuple, every: bool, some: bool) -> None:
    inertia, turn = body(Random(9), *moments)
    answers = solve("3.15", I_C=plain(inertia), d=plain(turn * sp.Matrix(along))).answers
    assert (answers["share_all_axes"], answers["share_at_least_one"]) == (every, some)


@pytest.mark.parametrize("exercise", ["3.15", "3.16", "3.20"])
@pytest.mark.parametrize(
    ("data", "what"),
    [
        ({"m": 0}, "m: expected a number greater than zero"),
        ({"I_C": [[1, 2, 0], [0, 1, 0], [0, 0, 1]]}, "I_C: expected a symmetric matrix"),
        ({"I_C": [[1, 0, 0], [0, -1, 0], [0, 0, 1]]}, "I_C: expected a positive-semidefinite matrix"),
        ({"I_C": [[1, 0], [0, 1]]}, "I_C: expected 3 rows of 3 numbers"),
    ],
)
def test_a_malformed_body(exercise: str, data: dict, what: str) -> None:
    with pytest.raises(DataError, match=what):
        solve(exercise, **data)


@pytest.mark.parametrize("seed", range(4))
def test_the_smallest_moment(seed: int) -> None:
    draw = Random(seed)
    moments = [(3, 4, 5), (2, 2, 3), (2, 2, 2), (0, 3, 3)][seed]
    inertia, turn = body(draw, *moments)
    inside = {k for k, moment in enumerate(moments) if moment == moments[0]}
    alongs = [(0, 0, 0), (2, 0, 0), (0, 1, 0), (1, 1, 0), (1, 1, 1)]
    ds = [turn * sp.Matrix(along) for along in alongs]
    answers = solve("3.16", I_C=plain(inertia), m="2/3", d=[plain(d) for d in ds]).answers
    expected = [all(k in inside for k in range(3) if along[k]) for along in alongs]
    assert answers["smallest_equal_to_C"] == expected
    assert same(answers["moments_C"], sp.Matrix(moments))
    for found, d in zip(answers["moments_P"], ds, strict=True):
        decimals = [float(value.value if isinstance(value, Root) else value) for value in found]
        matrix = steiner(inertia, sp.Rational(2, 3), d)
        assert decimals == sorted(decimals)
        assert abs(sum(decimals) - float(matrix.trace())) < 1e-12 * max(decimals)
        assert decimals[0] > moments[0] - 1e-12


@pytest.mark.sampled(2)
@pytest.mark.parametrize("seed", range(6))
def test_the_inertia_dyad(seed: int) -> None:
    draw = Random(seed)
    inertia, _ = body(draw, *[(3, 4, 5), (2, 2, 3), (1, 1, 1), (0, 2, 2), (1, 2, 3), (4, 5, 6)][seed])
    m, c = abs(rational(draw)) + 1, vector(draw)
    a = c if seed == 4 else vector(draw)
    solution = solve("3.20", I_C=plain(inertia), m=str(m), c=plain(c), a=plain(a))
    answers = solution.answers
    cross = (c - a).T
    skew = sp.Matrix([[0, -cross[2], cross[1]], [cross[2], 0, -cross[0]], [-cross[1], cross[0], 0]])
    dyad = sp.BlockMatrix([[steiner(inertia, m, a - c), m * skew], [m * skew.T, m * sp.eye(3)]]).as_explicit()
    assert same(answers["M_A"], dyad)
    assert same(answers["B"] + m * answers["P"] * answers["P"].T, dyad)
    assert answers["positive_definite"] is (seed != 3)
    assert same(answers["det"], m**3 * inertia.det())
    assert answers["signature_MA_minus_MC"] == ([0, 0, 6] if a == c else [2, 2, 2])
    assert answers["hint_decomposition_exists"] is (a == c)
    decimals = [float(value.value if isinstance(value, Root) else value) for value in answers["eig_M_A"]]
    assert len(decimals) == 6
    assert abs(sum(decimals) - float(dyad.trace())) < 1e-9 * max(decimals)
    assert abs(sum(x * x for x in decimals) - float((dyad * dyad).trace())) < 1e-9 * max(decimals) ** 2


@pytest.mark.parametrize("seed", range(6))
def test_angular_acceleration(seed: int) -> None:
    draw = Random(seed)
    omega, alpha, r = (vector(draw) for _ in range(3))
    alpha = omega * 2 if seed == 4 else alpha
    r = omega.cross(r) if seed == 5 else r
    solution = solve("3.21", omega=plain(omega), alpha=plain(alpha), r=plain(r))
    answers = solution.answers
    product = alpha.cross(r).dot(omega.cross(omega.cross(r)))
    assert answers["trace"] == 0
    assert same(answers["dot_tangential_centripetal"], product)
    assert same(answers["norm_A"] ** 2, 2 * alpha.dot(alpha))
    assert same(answers["norm_O2"], sp.sqrt(2) * omega.dot(omega))
    assert answers["orthogonal_for_this_r"] is bool(is_zero(product))
    assert answers["orthogonal_for_all_r"] is (seed == 4)
    assert answers["last_sentence"].startswith("holds" if is_zero(product) else "fails")


@pytest.mark.parametrize("data", [{"omega": [0, 0, 0]}, {"alpha": [0, 0, 0]}, {"r": [0, 0, 0]}])
def test_accelerations_that_vanish(data: dict) -> None:
    solution = solve("3.21", **data)
    assert solution.answers["dot_tangential_centripetal"] == 0
    assert solution.answers["orthogonal_for_all_r"] is ("r" not in data)
    assert any("not defined" in step.says for step in solution.steps) is ("r" not in data)


def test_the_book_s_sentence_fails_for_the_stand_ins() -> None:
    assert solve("3.21").answers["last_sentence"].startswith("fails")
    assert solve("3.20").answers["hint_decomposition_exists"] is False
    assert solve("3.16").answers["smallest_equal_to_C"] == [True, False, False]
