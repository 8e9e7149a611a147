"""Exercise 3.10: W has the axes as columns, each turned by the rotations before it."""

from __future__ import annotations

from random import Random

import pytest
import sympy as sp
from chasles.derivations.exercises.x3_10 import SEQUENCES

from chasles.exercises.data import DataError
from chasles.exercises.solving import solve

from .known import plain, same, vector

AXES = dict(zip("xyz", (sp.eye(3)[:, k] for k in range(3)), strict=True))
ANGLES = [sp.pi / 6, -sp.pi / 4, 2 * sp.pi / 3, sp.pi / 2, sp.acos(sp.Rational(1, 3)), sp.Integer(0), sp.pi]


def about(axis: str, angle: sp.Expr) -> sp.Matrix:
    u, c, s = AXES[axis], sp.cos(angle), sp.sin(angle)
    return u * u.T + c * (sp.eye(3) - u * u.T) + s * u.hat()


def columns(sequence: str, angles: list) -> tuple[sp.Matrix, sp.Matrix]:
    """W in the fixed frame, and the rotation."""
    turned, found = sp.eye(3), []
    for axis, angle in zip(sequence, angles, strict=True):
        found.append(turned * AXES[axis])
        turned = turned * about(axis, angle)
    return sp.Matrix.hstack(*found), turned


@pytest.mark.sampled(4)
@pytest.mark.parametrize("sequence", SEQUENCES)
def test_every_sequence(sequence: str) -> None:
    draw = Random(sequence)
    angles, rates = draw.sample(ANGLES, 3), vector(draw)
    W, Q = columns(sequence, angles)
    solution = solve("3.10", sequence=sequence.upper(), angles=[str(x) for x in angles], rates=plain(rates))
    answers = solution.answers
    assert same(answers["W_fixed"], W)
    assert same(answers["W_body"], Q.T * W)
    assert same(answers["det"], W.det())
    assert same(answers["omega_fixed"], W * rates)
    assert same(answers["omega_body"], Q.T * W * rates)
    assert (solution.status == "singular") == answers["singular"] == (W.rank(simplify=True) == 2)
    assert answers["rank"] == (2 if answers["singular"] else 3)


@pytest.mark.sampled(2)
@pytest.mark.parametrize("sequence", ["zyz", "xyz", "yxz"])
def test_rates_from_the_angular_velocity(sequence: str) -> None:
    angles, omega = ["1/10", "1/5", "3/10"], sp.Matrix([1, -2, 3])
    solution = solve("3.10", sequence=sequence, angles=angles, omega=plain(omega))
    W, _ = columns(sequence, [sp.Rational(x) for x in angles])
    assert same(W * sp.Matrix(solution.answers["rates"]), omega)


def test_where_w_is_singular_rates_do_not_follow() -> None:
    solution = solve("3.10", angles=["pi/3", "pi", "1"], omega=[1, 0, 0])
    assert (solution.status, solution.answers["rates"], solution.answers["rank"]) == ("singular", None, 2)


@pytest.mark.parametrize(("sequence", "function"), [("zyz", "sin"), ("zyx", "cos")])
def test_the_singular_set(sequence: str, function: str) -> None:
    answers = solve("3.10", sequence=sequence).as_data()["answers"]
    assert answers["det"] == f"-{function}(theta_2)"
    assert answers["singular"].startswith(f"{function}(theta_2) = 0")


@pytest.mark.parametrize(
    ("data", "match"),
    [
        ({"sequence": "xxz"}, "sequence: expected one of xyx"),
        ({"sequence": 313}, "sequence: expected one of"),
        ({"rates": [1, 2, 3]}, "angles: expected"),
        ({"angles": [1, 2]}, "angles: expected a list of 3 numbers"),
        ({"angles": [1, 2, 3], "rates": [1, 0, 0], "omega": [1, 0, 0]}, "rates, omega: expected one of them"),
        ({"angles": ["30 deg", 0, 0]}, r"angles\[1\]: .*at character 4"),
    ],
)
def test_malformed_angles(data: dict, match: str) -> None:
    with pytest.raises(DataError, match=match):
        solve("3.10", **data)
