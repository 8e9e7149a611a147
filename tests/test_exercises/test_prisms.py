"""Exercises 3.11 and 3.12: prisms and their parts, against the formulas of the textbooks and against each other."""

from __future__ import annotations

import math
from itertools import pairwise
from random import Random

import numpy as np
import pytest
import sympy as sp

from chasles.exact.numbers import decimals, is_zero
from chasles.exercises.data import DataError
from chasles.exercises.solving import solve

from .known import number, same

ROOT_3 = sp.sqrt(3)


@pytest.mark.sampled(2)
@pytest.mark.parametrize(
    ("side", "height"),
    [(25, 150), (1, 2), ("2/3", "sqrt(2)"), ("sqrt(3)", 1), ("sqrt(2+sqrt(2))", "0.25"), (2, "sqrt(10)")],
)
def test_a_hexagonal_prism(side: object, height: object) -> None:
    solution = solve("3.11", side=side, height=height)
    a, h = sp.sympify(str(side), rational=True), sp.sympify(str(height), rational=True)
    volume = 3 * ROOT_3 / 2 * a**2 * h
    along, across = 5 * a**2 / 12, 5 * a**2 / 24 + h**2 / 12
    assert solution.status == "ok"
    assert same(solution.answers["V"], volume)
    assert same(solution.answers["centroid"], sp.Matrix([0, 0, h / 2]))
    assert same(solution.answers["k2"], sp.Matrix(sorted((along, across, across), key=float)))
    assert same(solution.answers["I_C_over_rho"], volume * sp.diag(across, across, along))


def test_the_prism_whose_moments_are_all_equal() -> None:
    solution = solve("3.11", side=2, height="sqrt(10)")
    assert len(set(solution.answers["k2"])) == 1
    assert any("All are equal" in step.says for step in solution.steps)
    assert any("Two are equal" in step.says for step in solve("3.11").steps)


@pytest.mark.parametrize(
    "data", [{"side": 0}, {"side": -1}, {"height": "0"}, {"side": [1]}, {"height": "pi*"}, {"edge": 1}]
)
def test_a_malformed_prism(data: dict) -> None:
    with pytest.raises(DataError):
        solve("3.11", **data)


@pytest.mark.sampled(3)
@pytest.mark.parametrize("side", ["pi", "cot(pi/9)", "cos(1)", "tan(1)", "sqrt(pi)"])
def test_a_prism_of_any_size(side: str) -> None:
    answers, a = solve("3.11", side=side, height=1).answers, number(side)
    assert same(answers["V"], 3 * ROOT_3 / 2 * a**2)
    along, across = 5 * a**2 / 12, 5 * a**2 / 24 + sp.Rational(1, 12)
    assert same(answers["k2"], sp.Matrix(sorted((along, across, across), key=float)))


def slope(degrees: object) -> sp.Expr:
    return sp.cot(sp.sympify(str(degrees)) * sp.pi / 180)


@pytest.mark.sampled(3)
@pytest.mark.parametrize(("side", "height", "degrees"), [(25, 150, 45), (1, 3, 60), ("1/2", 2, 30), (4, 10, 45)])
def test_a_wedge_below_the_top(side: object, height: object, degrees: int) -> None:
    a, c = sp.sympify(str(side)), slope(degrees)
    answers = solve("3.12", side=side, height=height, angle_deg=degrees).answers
    assert same(answers["wedge.V"], sp.Rational(9, 4) * a**3 * c)
    assert same(answers["wedge.centroid"], sp.Matrix([0, 5 * ROOT_3 * a / 36, 23 * ROOT_3 * c * a / 72]))
    scale = a**5 * c
    rows = [
        [scale * (263 * c**2 + 260) / 768, 0, 0],
        [0, scale * (263 * c**2 + 360) / 768, -65 * scale * c / 384],
        [0, -65 * scale * c / 384, 155 * scale / 192],
    ]
    # Worked out by integrating 1, x, x x^T over 0 < z < c (y + sqrt(3)/2 a).
    assert same(answers["wedge.I_C_over_rho"], sp.Matrix(rows))


@pytest.mark.sampled(5)
@pytest.mark.parametrize(
    ("side", "height", "degrees", "through"),
    [(25, 150, 45, "far side"), (25, 30, 45, "top"), (25, "25*sqrt(3)", 45, "far side"), (1, "1/4", 30, "top"),
     (3, 5, 15, "top"), (2, 7, "180/pi*atan(1/2)", "far side"), (1, "sqrt(3)/2", 45, "top")],
)  # fmt: skip
def test_the_parts_and_the_whole(side: object, height: object, degrees: object, through: str) -> None:
    solution = solve("3.12", side=side, height=height, angle_deg=degrees)
    whole = solve("3.11", side=side, height=height).answers
    answers = solution.answers
    assert any(
        f"leaves the prism through {'its top' if through == 'top' else 'the far side'}" in s.says
        for s in solution.steps
    )
    parts = [{key: answers[f"{name}.{key}"] for key in ("V", "centroid", "I_C_over_rho")} for name in ("wedge", "rest")]
    assert is_zero(sum(part["V"] for part in parts) - whole["V"])
    total = sp.zeros(3)
    for part in parts:
        d = part["centroid"] - whole["centroid"]
        total += part["I_C_over_rho"] + part["V"] * (d.dot(d) * sp.eye(3) - d * d.T)
    assert all(map(is_zero, total - whole["I_C_over_rho"]))
    for name in ("wedge", "rest"):
        moments, radii = answers[f"{name}.moments_over_rho"], answers[f"{name}.k2"]
        assert all(is_zero(answers[f"{name}.V"] * k2 - moment) for k2, moment in zip(radii, moments, strict=True))
        assert list(map(float, moments)) == sorted(map(float, moments))
        inertia = answers[f"{name}.I_C_over_rho"]
        tangent = answers[f"{name}.tan_2theta"]
        assert is_zero(tangent * (inertia[1, 1] - inertia[2, 2]) - 2 * inertia[1, 2])


def test_a_cut_through_the_top_by_hand() -> None:
    """At 45 degrees and a height of sqrt(3)/2: over the near half up to y + sqrt(3)/2, over the far half to the top."""
    answers = solve("3.12", side=1, height="sqrt(3)/2", angle_deg=45).answers
    x, y = sp.symbols("x y", real=True)
    near = sp.integrate(sp.integrate(y + ROOT_3 / 2, (x, -1 - y / ROOT_3, 1 + y / ROOT_3)), (y, -ROOT_3 / 2, 0))
    far = 3 * ROOT_3 / 4 * ROOT_3 / 2
    assert same(answers["wedge.V"], sp.nsimplify(near + far))


@pytest.mark.parametrize("degrees", [0, 90, -45, 120, "180", "90.0"])
def test_a_plane_that_does_not_cut(degrees: object) -> None:
    with pytest.raises(DataError, match="angle_deg: expected an angle between 0 and 90"):
        solve("3.12", angle_deg=degrees)


ANGLES = ("20", "70", "40", "80", "33.3", "89.999", "0.001", "1", "7", "0.000000001", "89.999999999", "sqrt(2)", "10",
          "180/pi", "60/pi", "60*sqrt(2)", "50", "65", "85/3", "36", "72", "54", "15", "75", "22.5", "3")  # fmt: skip


def by_quadrature(side: float, height: float, rise: float) -> tuple[float, list[float]]:
    """Volume of the wedge, and the squares of its radii of gyration: Gauss's rule over Y, exact between the kinks."""
    half = np.sqrt(3) / 2 * side
    kinks = sorted({-half, 0.0, half, min(half, height / rise - half)})
    nodes, weights = np.polynomial.legendre.leggauss(8)
    total = np.zeros(7)
    for low, high in pairwise(kinks):
        y = (low + high) / 2 + (high - low) / 2 * nodes
        across, up = side - abs(y) / np.sqrt(3), np.minimum(rise * (y + half), height)
        area = 2 * across * up
        terms = (area, area * y, area * up / 2, area * across**2 / 3, area * y**2, area * up**2 / 3, area * y * up / 2)
        sums = [(high - low) / 2 * float(weights @ term) for term in terms]
        total = total + sums
    volume, y, z = total[:3]
    xx, yy, zz, yz = total[3:] / volume - np.array([0, (y / volume) ** 2, (z / volume) ** 2, y * z / volume**2])
    inertia = [[yy + zz, 0, 0], [0, xx + zz, -yz], [0, -yz, xx + yy]]
    return float(volume), list(np.linalg.eigvalsh(inertia))


@pytest.mark.sampled(17)
@pytest.mark.parametrize("degrees", ANGLES)
def test_every_angle(degrees: str) -> None:
    answers = solve("3.12", angle_deg=degrees).answers
    angle = number(degrees)
    # Each near the end where it is exact to the last digit of a double.
    rise = 1 / math.tan(math.radians(angle)) if angle < 45 else math.tan(math.radians(90 - angle))
    volume, radii = by_quadrature(25, 150, rise)
    assert [float(decimals(x)) for x in answers["wedge.k2"]] == pytest.approx(radii, rel=1e-8)
    assert float(decimals(answers["wedge.V"])) == pytest.approx(volume, rel=1e-9)
    whole = sp.Rational(3, 2) * ROOT_3 * 25**2 * 150
    assert is_zero(answers["wedge.V"] + answers["rest.V"] - whole)
    for name in ("wedge", "rest"):
        inertia, tangent = answers[f"{name}.I_C_over_rho"], answers[f"{name}.tan_2theta"]
        assert is_zero(tangent * (inertia[1, 1] - inertia[2, 2]) - 2 * inertia[1, 2])
    # What is printed is read again as the same numbers.
    printed = solve("3.12", angle_deg=degrees).as_data()["answers"]
    assert is_zero(number(printed["rest.V"]) - answers["rest.V"])


@pytest.mark.parametrize(
    "data",
    [{"angle_deg": "33.3", "height": "pi"}, {"angle_deg": 20, "side": "cot(1)"}, {"height": "pi", "side": "cot(1)"},
     {"angle_deg": 20, "height": "cos(1) + sin(1)"}, {"height": "cos(1) + sin(1)"}],
)  # fmt: skip
def test_more_than_one_number_beside_roots_is_declined_at_once(data: dict) -> None:
    with pytest.raises(DataError, match=r"only one number that square roots do not express|are not told apart"):
        solve("3.12", **data)


@pytest.mark.parametrize(
    "data",
    [{"angle_deg": "1.5", "side": "sqrt(7)"}, {"angle_deg": 10, "side": "sqrt(2)", "height": "sqrt(5+sqrt(7))"}],
)
def test_too_many_roots_are_declined_at_once(data: dict) -> None:
    with pytest.raises(DataError, match="too many different square roots"):
        solve("3.12", **data)


def test_a_wedge_in_cotangents() -> None:
    """At 20 degrees: the formulas of a wedge below the top, in the cotangent itself."""
    answers = solve("3.12", side=1, height=10, angle_deg=20).as_data()["answers"]
    assert answers["wedge.V"] == "9*cot(pi/9)/4"
    assert answers["wedge.centroid"] == ["0", "5*sqrt(3)/36", "23*sqrt(3)*cot(pi/9)/72"]


def test_the_plane_through_the_upper_edge() -> None:
    """The height of the far edge, in cotangents: neither below the top nor above it."""
    solution = solve("3.12", side=1, height="sqrt(3)*cot(pi/9)", angle_deg=20)
    assert any("leaves the prism through the far side" in step.says for step in solution.steps)
    assert same(solution.answers["rest.V"], solution.answers["wedge.V"])


def test_a_drawn_section_is_on_the_plane_and_in_order() -> None:
    draw = Random(1)
    for height in (150, 30):
        solution = solve("3.12", height=height, angle_deg=draw.choice((30, 45, 60)))
        curve = next(item for item in solution.picture.items if type(item).__name__ == "Curve")
        assert len(curve.points) == 7
        assert curve.points[0] == curve.points[-1]
