"""Exact eigenvalues, axes, signatures: of matrices made from known ones, by rotations and congruences."""

from __future__ import annotations

from random import Random

import numpy as np
import pytest
import sympy as sp

from chasles.exact.numbers import NotDecided, is_zero
from chasles.exact.polynomial_roots import Root, real_roots, same_number
from chasles.exact.principal_axes import columns_of, principal_axes
from chasles.exact.spectra import (
    diagonal,
    each_eigenvalue,
    eigenvalues,
    is_positive_definite,
    leading_minors,
    residues_of,
    signature,
    smallest_belongs_to,
)

ROOT_2, ROOT_3 = sp.sqrt(2), sp.sqrt(3)
x = sp.Symbol("x")


def rotation(draw: Random) -> sp.Matrix:
    """A rational rotation, by the Cayley transform."""
    a, b, c = (sp.Rational(draw.randint(-3, 3), draw.randint(1, 3)) for _ in range(3))
    skew = sp.Matrix([[0, -c, b], [c, 0, -a], [-b, a, 0]])
    return (sp.eye(3) - skew).inv() * (sp.eye(3) + skew)


def signs_of(values: list) -> tuple[int, int, int]:
    decimals = [float(value) for value in values]
    return sum(x > 0 for x in decimals), sum(x < 0 for x in decimals), decimals.count(0)


def congruence(draw: Random, size: int) -> sp.Matrix:
    """A matrix of determinant one."""
    lower = sp.Matrix(size, size, lambda i, j: 1 if i == j else draw.randint(-2, 2) if j < i else 0)
    upper = sp.Matrix(size, size, lambda i, j: 1 if i == j else draw.randint(-2, 2) if j > i else 0)
    return lower * upper


SPECTRA = (
    (1, 2, 3),
    (2, 2, 5),
    (2, 5, 5),
    (4, 4, 4),
    (0, 3, 3),
    (-1, 0, 2),
    (3 - ROOT_2, 3, 3 + ROOT_2),
    (1, 2 - ROOT_3, 2 + ROOT_3),
    (ROOT_2, ROOT_2, ROOT_3),
    ((5 - sp.sqrt(5)) / 2, (5 + sp.sqrt(5)) / 2, 7),
)


@pytest.mark.sampled(4)
@pytest.mark.parametrize("values", SPECTRA)
@pytest.mark.parametrize("seed", [1, 2])
def test_known_eigenvalues_and_axes(values: tuple, seed: int) -> None:
    turn = rotation(Random(seed))
    expected = sorted(map(sp.sympify, values), key=float)
    matrix = sp.ImmutableMatrix((turn * sp.diag(*expected) * turn.T).applyfunc(sp.expand))
    found = each_eigenvalue(matrix)
    assert all(is_zero(one - other) for one, other in zip(found, expected, strict=True))
    axes = principal_axes(matrix)
    assert all(map(is_zero, axes * matrix * axes.T - diagonal(found)))
    assert all(map(is_zero, axes * axes.T - sp.eye(3)))
    assert is_zero(axes.det() - 1)
    for i in range(2):
        first = next(entry for entry in axes.row(i) if not is_zero(entry))
        assert float(first) > 0
    assert residues_of(matrix, found).is_zero_matrix
    assert signature(matrix) == signs_of(expected)
    assert is_positive_definite(matrix) == (expected[0] > 0)


def test_equal_eigenvalues_in_different_blocks_are_one() -> None:
    matrix = sp.ImmutableMatrix([[2, 0, 1], [0, 3, 0], [1, 0, 2]])
    assert eigenvalues(matrix) == [(1, 1), (3, 2)]
    near = sp.Rational(3) + sp.Rational(1, 10**40)
    assert len(eigenvalues(sp.ImmutableMatrix([[2, 0, 1], [0, near, 0], [1, 0, 2]]))) == 3


@pytest.mark.sampled(3)
@pytest.mark.parametrize(
    "rows",
    [
        [[5, 1, 2], [1, 6, 0], [2, 0, 9]],
        [[5, -1, -1], [-1, 6, -1], [-1, -1, 7]],
        [[2, ROOT_2, 0], [ROOT_2, 3, 1], [0, 1, 4]],
        [["1/3", 1, 0], [1, "2/7", 2], [0, 2, -1]],
        [[ROOT_2, 1, 0], [1, 3, 1], [0, 1, 4]],
        [[2, 0, 1], [0, 3, 1], [1, 1, 7]],
    ],
)
def test_a_cubic_that_square_roots_do_not_solve(rows: list) -> None:
    matrix = sp.ImmutableMatrix([[sp.sympify(entry) for entry in row] for row in rows])
    found = each_eigenvalue(matrix)
    assert all(isinstance(value, Root) for value in found)
    numeric = np.linalg.eigh(np.array(matrix.tolist(), dtype=float))
    assert np.allclose([float(value.as_data()["decimal"]) for value in found], numeric.eigenvalues, rtol=1e-12)
    for value in found:
        polynomial = sp.Poly(value.coefficients, x)
        assert polynomial.is_irreducible
        assert value.coefficients[0] > 0
        assert sp.real_roots(polynomial)[value.index] == value.value
        assert len(value.as_data()["decimal"].replace("-", "").replace(".", "").lstrip("0")) == 30
    assert residues_of(matrix, found).is_zero_matrix
    *before, last = found[2].coefficients
    assert not residues_of(matrix, [*found[:2], Root((*before, last + 2), 2)]).is_zero_matrix
    assert not residues_of(matrix, found[:2]).is_zero_matrix
    axes = sp.Matrix.hstack(*columns_of(principal_axes(matrix))).T
    assert (axes * axes.T - sp.eye(3)).norm() < sp.Rational(10) ** -40
    assert (axes * matrix.evalf(60) * axes.T - sp.diag(*(v.value.evalf(50) for v in found))).norm() < sp.Rational(
        10
    ) ** -40
    assert axes.det() > 0


@pytest.mark.parametrize("seed", range(12))
def test_signature_is_kept_by_congruence(seed: int) -> None:
    draw = Random(seed)
    size = draw.choice((3, 6))
    entries = [draw.choice((-2, -1, 0, 0, 1, 3, 5)) for _ in range(size)]
    change = congruence(draw, size)
    matrix = sp.ImmutableMatrix(change * sp.diag(*entries) * change.T)
    expected = signs_of(entries)
    assert signature(matrix) == expected
    assert is_positive_definite(matrix) == (expected == (size, 0, 0))
    assert leading_minors(matrix)[-1] == sp.prod(entries)
    counted: dict[int, int] = {}
    for value, multiplicity in eigenvalues(matrix):
        decimal = value.value.evalf(20) if isinstance(value, Root) else sp.N(value, 20)
        counted[int(sp.sign(decimal))] = counted.get(int(sp.sign(decimal)), 0) + multiplicity
    assert tuple(counted.get(one, 0) for one in (1, -1, 0)) == expected


@pytest.mark.parametrize(
    "roots",
    [
        (ROOT_2 + ROOT_3, ROOT_2 - ROOT_3, -ROOT_2 + ROOT_3, -ROOT_2 - ROOT_3),
        tuple(a * sp.sqrt(2 + b * ROOT_2) for a in (1, -1) for b in (1, -1)),
        tuple(1 + a * ROOT_2 / 2 + b * sp.sqrt(3 + a * ROOT_2) for a in (1, -1) for b in (1, -1)),
        tuple(sp.Rational(1, 3) + a * sp.sqrt(5) + b * sp.sqrt(7) for a in (1, -1) for b in (1, -1)),
    ],
)
def test_a_quartic_that_square_roots_solve(roots: tuple) -> None:
    polynomial = sp.Poly(sp.expand(sp.prod([x - root for root in roots])), x)
    assert polynomial.domain.is_QQ or polynomial.domain.is_ZZ
    assert len(polynomial.factor_list()[1]) == 1
    found = real_roots(polynomial.all_coeffs())
    assert [multiplicity for _, multiplicity in found] == [1] * 4
    expected = sorted(roots, key=float)
    assert all(is_zero(one - other) for (one, _), other in zip(found, expected, strict=True))


def test_a_quartic_that_they_do_not_solve() -> None:
    found = real_roots([sp.Integer(c) for c in (1, -1, -14, 13, 9)])
    assert [value.index for value, _ in found] == [0, 1, 2, 3]
    assert {value.coefficients for value, _ in found} == {(1, -1, -14, 13, 9)}


def test_pi_in_a_cubic_is_declined() -> None:
    with pytest.raises(NotDecided, match="no integer coefficients"):
        eigenvalues(sp.ImmutableMatrix([[sp.pi, 1, 0], [1, 2, 1], [0, 1, 3]]))


def test_a_root_is_no_number_that_square_roots_express() -> None:
    root = Root((1, 0, -3, 1), 0)
    assert same_number(root, Root((1, 0, -3, 1), 0))
    assert not same_number(root, Root((1, 0, -3, 1), 1))
    assert not same_number(root, sp.N(root.value, 40))
    assert same_number(sp.sqrt(8), 2 * ROOT_2)
    assert "x^3 - 3*x + 1" in root.as_text()
    assert "x^{3} - 3 x + 1" in root.as_latex()


def test_vectors_of_the_smallest_eigenvalue() -> None:
    turn = rotation(Random(3))
    matrix = sp.ImmutableMatrix(turn * sp.diag(2, 2, 5) * turn.T)
    assert smallest_belongs_to(matrix, sp.ImmutableMatrix([0, 0, 0]))
    assert smallest_belongs_to(matrix, sp.ImmutableMatrix(turn[:, 0] * 3 - turn[:, 1]))
    assert not smallest_belongs_to(matrix, sp.ImmutableMatrix(turn[:, 2]))
    assert not smallest_belongs_to(matrix, sp.ImmutableMatrix(turn[:, 0] + turn[:, 2]))
