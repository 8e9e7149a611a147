"""Mass moments of prisms and their parts: exact, against formulas worked out otherwise, integrals, and trimesh."""

from __future__ import annotations

from collections.abc import Mapping
from fractions import Fraction
from random import Random
from typing import Any

import numpy as np
import pytest
import sympy as sp
import trimesh
from chasles.derivations.exercises.calculations.bodies import (
    cut_prism,
    joined,
    point_masses,
    regular_hexagon,
    whole_prism,
)
from chasles.derivations.exercises.calculations.moments import Moments
from chasles.derivations.exercises.calculations.outlines import prism_edges, section_of
from chasles.derivations.exercises.calculations.polygons import twice_the_area
from chasles.derivations.exercises.calculations.solids import Plane, Solid, prism

from chasles.exact.fields import NumberField
from chasles.exact.grammar import read_number
from chasles.exact.numbers import NotDecided, compare, is_zero

s, h, k = sp.symbols("s h k", positive=True)


def sign(x: Fraction) -> int:
    return (x > 0) - (x < 0)


def star(draw: Random, corners: int) -> list[tuple[Fraction, Fraction]]:
    """A polygon that is star-shaped about the origin, in general not convex, counter-clockwise."""
    found = []
    for place in range(corners):
        t = Fraction(2 * place + 1, corners) - 1  # tan of a quarter of the turn, so that the corners go round once
        r = Fraction(draw.randint(2, 9), draw.randint(1, 3))
        x, y = (1 - t * t) / (1 + t * t), 2 * t / (1 + t * t)
        found.append((r * (x * x - y * y), r * 2 * x * y))
    return found


def plane(draw: Random) -> Plane:
    while True:
        entries = tuple(Fraction(draw.randint(-3, 3), draw.randint(1, 2)) for _ in range(3))
        if any(entries):
            return Plane(entries, Fraction(draw.randint(-8, 12), 2))


@pytest.mark.sampled(3)
@pytest.mark.parametrize("seed", range(30))
def test_the_parts_add_up_to_the_whole(seed: int) -> None:
    draw = Random(seed)
    solid = prism(star(draw, draw.randint(3, 9)), Fraction(draw.randint(1, 9), 2), sign)
    below, above = solid.cut(plane(draw), sign)
    assert below + above == solid.moments()
    assert below.volume >= 0
    assert above.volume >= 0


@pytest.mark.sampled(3)
@pytest.mark.parametrize("seed", range(12))
def test_trimesh_finds_the_same(seed: int) -> None:
    draw = Random(100 + seed)
    corners, height = star(draw, draw.randint(4, 8)), Fraction(draw.randint(1, 9), 2)
    cutting = plane(draw)
    below, above = prism(corners, height, sign).cut(cutting, sign)
    turned = Plane(tuple(-x for x in cutting.normal), -cutting.offset)
    compare_with_trimesh(below, corners, height, cutting)
    compare_with_trimesh(above, corners, height, turned)


def compare_with_trimesh(part: Moments, corners: list, height: Fraction, cutting: Plane) -> None:
    """The part below the plane as convex hulls: one for each triangle with a corner at the origin."""
    total = np.zeros((4, 4))
    origin = (Fraction(0), Fraction(0))
    for i in range(len(corners)):
        triangle = [sp.Matrix(list(corner)) for corner in (origin, corners[i - 1], corners[i])]
        edges = prism_edges(triangle, sp.Rational(height))
        at = [p for edge in edges for p in edge if cutting.height(tuple(p)) <= 0]
        at += section_of(edges, sp.Matrix(cutting.normal), sp.Rational(cutting.offset))
        points = np.array([[float(x) for x in p] for p in at])
        if len(points) and np.linalg.matrix_rank(points - points[0], tol=1e-9) == 3:
            total += with_trimesh(points)
    found = np.array([[float(x) for x in row] for row in as_4x4(part)])
    assert np.allclose(found, total, rtol=1e-9, atol=1e-9 * max(1, np.abs(found).max()))


def with_trimesh(points: np.ndarray) -> np.ndarray:
    """Integrals of (1, x) (1, x)^T over the hull, from trimesh's volume, center of mass, and moment of inertia."""
    mesh = trimesh.convex.convex_hull(points)
    centroidal = np.trace(mesh.moment_inertia) / 2 * np.eye(3) - mesh.moment_inertia
    one_and_c = np.array([1, *mesh.center_mass])
    total = mesh.volume * np.outer(one_and_c, one_and_c)
    total[1:, 1:] += centroidal
    return total


def as_4x4(part: Moments) -> list[list]:
    rows = [[x, *row] for x, row in zip(part.first, part.second, strict=True)]
    return [[part.volume, *part.first], *rows]


def test_a_plane_beside_the_prism_leaves_one_part_empty() -> None:
    solid = prism(
        [(Fraction(0), Fraction(0)), (Fraction(1), Fraction(0)), (Fraction(0), Fraction(1))], Fraction(2), sign
    )
    for offset in (2, 5):
        below, above = solid.cut(Plane((Fraction(0), Fraction(0), Fraction(1)), Fraction(offset)), sign)
        assert below == solid.moments()
        assert above.volume == 0
        assert not any(above.first)
        assert not any(x for row in above.second for x in row)


def test_integrals_over_a_wedge() -> None:
    x, y, z = sp.symbols("x y z")
    below, _ = prism(
        [tuple(map(Fraction, corner)) for corner in ((0, 0), (2, 0), (2, 1), (0, 1))], Fraction(5), sign
    ).cut(Plane(tuple(map(Fraction, (-1, -3, 1))), Fraction(0)), sign)
    for exponents in [(i, j, l) for i in range(3) for j in range(3) for l in range(3) if i + j + l <= 2]:
        monomial = x ** exponents[0] * y ** exponents[1] * z ** exponents[2]
        over_z = sp.integrate(monomial, (z, 0, x + 3 * y))
        # The plane leaves through the top where x + 3 y = 5: at the corner (2, 1) only.
        exact = sp.integrate(over_z, (x, 0, 2), (y, 0, 1))
        axes = [axis for axis in range(3) for _ in range(exponents[axis])]
        found = {0: below.volume, 1: below.first, 2: below.second}[len(axes)]
        for axis in axes:
            found = found[axis]
        assert found == Fraction(int(exact.p), int(exact.q)), exponents


HALF_HEXAGON = ((1, 0), ("1/2", "1/2"), ("-1/2", "1/2"), (-1, 0), ("-1/2", "-1/2"), ("1/2", "-1/2"))


class SignCase:
    """The signs that numbers with symbols in them take at a rational sample; `conditions` are those asked for."""

    def __init__(self, field: NumberField, sample: Mapping[sp.Symbol, sp.Rational]) -> None:
        if missing := [str(atom) for atom in field.free if atom not in sample]:
            raise ValueError(f"the sample gives no value to {', '.join(missing)}")
        self.field, self.sample = field, sample
        self._ground = NumberField(*field.roots)
        self.conditions: dict[sp.Expr, int] = {}

    def __call__(self, element: Any) -> int:
        """The sign of an element of the field; zero only where it is identically zero.

        ValueError if it vanishes at the sample without being zero: the sample then lies between two cases.
        """
        if not element:
            return 0
        parts = (self._at_sample(part) for part in (element.numer, element.denom))
        above, below = (compare(self._ground.expression(part), 0) for part in parts)
        value = self.field.expression(element)
        if above * below == 0:
            raise ValueError(f"the sample lies on the boundary of the case: {value} vanishes or is infinite there")
        if value.free_symbols:
            self.conditions[value] = above * below
        return above * below

    def _at_sample(self, polynomial: Any) -> Any:
        """A numerator or denominator where the independent elements have the values of the sample."""
        values = [(self.field(atom).numer, sp.QQ(self.sample[atom].p, self.sample[atom].q)) for atom in self.field.free]
        return polynomial.evaluate(values)


def symbolic(height_over_side: sp.Rational) -> tuple[Moments, Moments, Moments, SignCase, NumberField]:
    """The prism of Exercise 3.12 and its parts by symbols, with Y in units of sqrt(3): no root occurs."""
    field = NumberField(s, h, k)
    case = SignCase(field, {s: sp.Rational(1), h: height_over_side, k: sp.Rational(1)})
    corners = [tuple(field(s * sp.Rational(x)) for x in corner) for corner in HALF_HEXAGON]
    solid: Solid = prism(corners, field(h), case)
    # z = k (y + (sqrt(3)/2) s), with y = sqrt(3) Y and k / sqrt(3) for the cotangent.
    below, above = solid.cut(Plane((field(0), field(-k), field(1)), field(k * s / 2)), case)
    return solid.moments(), below, above, case, field


@pytest.mark.sampled(2)
@pytest.mark.parametrize("height", [sp.Integer(6), sp.Rational(3, 4), sp.Rational(1, 4)])
def test_side_height_and_angle_may_stay_symbols(height: sp.Rational) -> None:
    # At 60 degrees the far edge is at the height s, and the corners in the middle are at s/2.
    whole, below, above, case, field = symbolic(height)
    assert below + above == whole
    assert case.conditions[h] == 1
    values = {s: sp.Integer(3), h: 3 * height, k: sp.Integer(1)}
    assert all(sp.sign(value.subs(values)) == is_sign for value, is_sign in case.conditions.items())
    root = sp.sqrt(3)
    wedge, _ = cut_prism(regular_hexagon(values[s]), values[h], sp.Matrix([0, -1 / root, 1]), sp.Rational(3, 2))
    factors = (sp.Integer(1), root, sp.Integer(1))
    at = below_at(field, below, values).stretched(factors)
    assert sp.simplify(at.volume - wedge.mass) == 0
    assert all(sp.simplify(x - y) == 0 for x, y in zip(at.first, wedge.first, strict=True))
    assert sp.simplify(sp.Matrix(at.second) - wedge.second) == sp.zeros(3)


def below_at(field: NumberField, part: Moments, values: dict) -> Moments:
    read = lambda x: field.expression(x).subs(values)  # noqa: E731
    return Moments(read(part.volume), tuple(map(read, part.first)), tuple(tuple(map(read, row)) for row in part.second))


def test_the_hexagonal_prism_by_symbols() -> None:
    whole, below, _, _, field = symbolic(sp.Integer(6))
    stretched = below_at(field, whole, {}).stretched((1, sp.sqrt(3), 1))
    assert sp.simplify(stretched.volume - 3 * sp.sqrt(3) / 2 * s**2 * h) == 0
    wedge = below_at(field, below, {}).stretched((1, sp.sqrt(3), 1))
    assert sp.simplify(wedge.volume - stretched.volume * k * s / 2 / h) == 0


def test_a_sample_between_two_cases_is_refused() -> None:
    with pytest.raises(ValueError, match=r"boundary of the case: .* vanishes"):
        symbolic(sp.Integer(1))
    field = NumberField(s, h)
    case = SignCase(field, {s: sp.Rational(1), h: sp.Rational(2)})
    assert case(1 / (field(s) - field(h))) == -1
    assert [sp.simplify(value * (s - h)) for value in case.conditions] == [1]
    assert list(case.conditions.values()) == [-1]
    assert SignCase(field, {s: sp.Rational(3), h: sp.Rational(2)})(1 / (field(s) - field(h))) == 1
    field = NumberField(s)
    with pytest.raises(ValueError, match="gives no value to s"):
        SignCase(field, {})


@pytest.mark.parametrize(
    ("corners", "what"),
    [
        ([(0, 0), (1, 0)], "at least three corners"),
        ([(0, 0), (1, 0), (2, 0)], "cross or touch"),
        ([(0, 0), (1, 0), (1, 0), (0, 1)], "corners 2 and 3 .* coincide"),
        ([(0, 0), (2, 0), (2, 2), (0, 2), (0, 0)], "corners 5 and 1 .* coincide"),
        ([(0, 0), (2, 2), (2, 0), (0, 2)], "cross or touch"),
        ([(0, 0), (4, 0), (4, 4), (2, 0), (0, 4)], "cross or touch"),
        ([(0, 0), (4, 0), (2, 0), (2, 3)], "cross or touch"),
        ([(0, 0), (4, 0), (4, 3), (1, 3), (1, 0), (0, 3)], "cross or touch"),
    ],
)
def test_a_polygon_that_is_none_is_refused(corners: list, what: str) -> None:
    with pytest.raises(ValueError, match=what):
        prism([tuple(map(Fraction, corner)) for corner in corners], Fraction(1), sign)


def test_either_way_round_is_the_same_prism() -> None:
    corners = star(Random(5), 7)
    assert twice_the_area(corners) > 0
    there, back = (prism(polygon, Fraction(2), sign).moments() for polygon in (corners, corners[::-1]))
    assert there == back
    assert there.volume == twice_the_area(corners)


def test_a_height_and_a_normal_that_are_none() -> None:
    corners = star(Random(6), 5)
    with pytest.raises(ValueError, match="height of a prism must be positive"):
        prism(corners, Fraction(0), sign)
    with pytest.raises(ValueError, match="normal of the cutting plane must not be zero"):
        prism(corners, Fraction(1), sign).cut(Plane((Fraction(0),) * 3, Fraction(1)), sign)


def test_nested_roots_and_what_is_no_root() -> None:
    side = sp.sqrt(2 + sp.sqrt(2))
    whole = whole_prism(regular_hexagon(side), sp.sqrt(5))
    parts = cut_prism(regular_hexagon(side), sp.sqrt(5), sp.Matrix([1, sp.sqrt(7), 2]), sp.Integer(1))
    assert joined(*parts) == whole
    assert sp.simplify(whole.mass - 3 * sp.sqrt(15) / 2 * side**2) == 0


@pytest.mark.sampled(3)
@pytest.mark.parametrize("height", ["pi", "cot(pi/9)", "sqrt(3)*cot(pi/9)", "pi*cot(1)", "cos(1)", "sqrt(pi)"])
def test_a_height_that_square_roots_do_not_make(height: str) -> None:
    high = read_number(height)
    whole = whole_prism(regular_hexagon(sp.Integer(2)), high)
    below, above = cut_prism(regular_hexagon(sp.Integer(2)), high, sp.Matrix([0, 0, 1]), high / 3)
    assert joined(below, above) == whole
    assert is_zero(whole.mass - 6 * sp.sqrt(3) * high)
    assert is_zero(3 * below.mass - whole.mass)
    assert is_zero(below.first[2] - high * whole.mass / 18)


def test_sines_beside_cosines_are_declined() -> None:
    with pytest.raises(NotDecided, match="sines and cosines that are no square roots"):
        whole_prism(regular_hexagon(sp.sin(1)), sp.cos(1))


def test_points_at_the_corners_of_a_cube() -> None:
    corners = [sp.Matrix([x, y, z]) for x in (-1, 1) for y in (-1, 1) for z in (-1, 1)]
    body = point_masses(sp.Integer(3), corners)
    assert body.mass == 24
    assert body.inertia == body.centroidal_inertia == 48 * sp.eye(3)
