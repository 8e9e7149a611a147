"""What the search for a repair is made of: terms and their coefficients, linear systems, places in an expression."""

from __future__ import annotations

from fractions import Fraction
from itertools import product

import pytest

from chasles.algebra.modular import MODULUS, Span, combination, multiple, rational
from chasles.problems.context import build
from chasles.repairs.residues import Sampled, generic_points
from chasles.rewriting.coefficients import AngleFunction, scaled, spelled, split
from chasles.rewriting.places import linear_places, put, separate_sums
from chasles.rewriting.term_basis import term_basis
from chasles.statements import Goal, Problem
from chasles.vocabulary import (
    CPM,
    FREQUENCY,
    Dimension,
    Node,
    Number,
    column,
    cos,
    cross,
    dot,
    norm,
    paren,
    plain,
    scalar,
    vector,
)

x, y, z, e = (vector(name, name, "a vector") for name in "xyze")
w = vector("w", "w", "a spin", FREQUENCY)
phi, theta = (scalar(name, name, "an angle") for name in ("phi", "theta"))


def test_terms_have_the_shape_and_dimension_asked_for() -> None:
    basis = term_basis([cross(w, x), e, CPM(e)])
    for shape in ((3, 1), (1, 3), (3, 3), (1, 1)):
        terms = list(basis.of_dimension(shape, FREQUENCY))
        assert terms
        assert all(term.shape == shape for term in terms)
        assert all(term.measure is not None and term.measure.the_dimension(term) == FREQUENCY for term in terms)
    assert not list(basis.of_dimension((3, 1), Dimension(mass=1)))


def test_a_term_is_a_coefficient_times_a_core() -> None:
    term = -(2 * (3 - cos(phi)) * paren(dot(e, w)) * e @ e.T)
    parts = split(term, lambda node: all(symbol not in plain(node) for symbol in ("e", "w")))
    assert plain(parts.coefficient) == "-2 (3 - cos(phi))"
    assert parts.core is not None
    assert plain(parts.core) == "(e . w) e e^T"
    assert str(scaled(term, Fraction(1, 2))) == "-(3 - cos(phi)) (e . w) e e^T"
    assert scaled(term, Fraction(0)) is None
    assert str(spelled([(Fraction(4), AngleFunction()), (Fraction(2), AngleFunction(cos(phi)))])) == "2 (2 + cos(phi))"
    assert str(spelled([(Fraction(-1, 2), AngleFunction(cos(phi), dot(x, y)))])) == "-cos(phi) / [2 (x . y)]"
    assert spelled([(Fraction(0), AngleFunction())]) is None


def test_systems_are_solved_exactly() -> None:
    columns = [[1, 2, 3, 5], [1, 1, 0, 7], [0, 4, 4, 4]]
    values = [Fraction(1, 2), Fraction(-3), Fraction(5, 7)]
    half, seventh = pow(2, -1, MODULUS), pow(7, -1, MODULUS)
    target = [(a * half - 3 * b + c * 5 * seventh) % MODULUS for a, b, c in zip(*columns, strict=True)]
    assert combination(columns, target) == values
    assert combination([*columns, columns[0]], target) is None
    assert combination(columns, [*target[:3], target[3] + 1]) is None
    assert multiple([2, 4], [1, 2]) == 2
    assert multiple([2, 5], [1, 2]) is None
    assert multiple([0, 0], [0, 0]) is None
    assert rational(half) == Fraction(1, 2)
    assert rational(1 << 40) is None
    assert not Span([[1, 2], [2, 4]]).independent


def test_places_are_where_the_whole_is_linear() -> None:
    node = column(2 * (x + y), cross(x, norm(x) * y))
    linear = {plain(place.node) for place in linear_places(node)}
    assert {"x + y", "|x| y", "y", "|x|"} <= linear
    assert {plain(place.node) for place in linear_places(cross(x, 2 * (y + z))) if place.apart} == {"x x 2 (y + z)"}
    assert [plain(place.node) for place, _ in separate_sums(node)] == ["x + y", "x x |x| y"]
    assert plain(put(node, (0, 1, 0), None)) == "[2 y; x x |x| y]"
    assert plain(put(node, (1,), Number(Fraction(0)) * x)) == "[2 (x + y); 0 x]"


def _at_points(functions: list[Node]) -> tuple[Sampled, Sampled]:
    context = build(Problem(tuple(Goal("", node, node) for node in functions)))
    varied, fixed = generic_points(context, (), 2 * len(functions))
    assert len(varied) == len(fixed) == 2 * len(functions)
    return Sampled(context, varied), Sampled(context, fixed)


@pytest.mark.parametrize("other", [cos(theta), theta * cos(theta)])
def test_two_angles_are_independent_at_generic_points(other: Node) -> None:
    powers = range(1, 4)
    functions = [cos(phi) ** i * other**j for i, j in product(powers, powers)]
    varied, fixed = _at_points(functions)
    span = Span()
    assert all(span.add(varied.flat(function)) for function in functions)
    for function in functions:
        values = fixed.flat(function)
        assert set(values) == {values[0]}
    assert fixed.flat(cos(phi)) != fixed.flat(cos(theta))
