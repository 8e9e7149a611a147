"""Inequalities with squares, positive-definite matrices: sums of squares prove them, points refute them."""

from __future__ import annotations

from copy import deepcopy
from fractions import Fraction
from random import Random
from typing import Any

import pytest

from chasles.algebra.squares import sum_of_squares
from chasles.checker.certificate import Rejected, check
from chasles.checker.contradiction import check_contradiction
from chasles.decisions.session import Session
from chasles.statements import Claim, Definition, Hypothesis, Problem, Theorem, nonzero, positive, problem_of, unit
from chasles.statements.inequalities import PositiveDefinite, inequality, says_that
from chasles.verdict import Holds, HoldsUnder
from chasles.vocabulary import (
    CPM,
    Identity,
    Node,
    cos,
    cross,
    det,
    dot,
    matrix,
    norm,
    number,
    scalar,
    sin,
    square,
    tr,
    vector,
)
from chasles.vocabulary.functions import Relation

from .decided import proved, refuted

a, b, c, d, m, k, l, x, y, z, t = (scalar(name, name, "a number") for name in "abcdmklxyzt")
u, v, w, e = (vector(name, name, "a vector") for name in "uvwe")
A, S = (square(name, name, "a matrix") for name in "AS")
spring = matrix((k + l, -l), (-l, l))
chain = matrix((number(2), -1, 0), (-1, 2, -1), (0, -1, 2))

TRUE: tuple[tuple[Relation, tuple[Hypothesis, ...]], ...] = (
    (x**2 + y**2 >= x * y, ()),
    (x**2 + y**2 >= -2 * x * y, ()),
    (x**2 + y**2 + z**2 >= x * y + y * z + z * x, ()),
    (3 * (x**2 + y**2 + z**2) >= (x + y + z) ** 2, ()),
    ((x + y) ** 2 <= 2 * (x**2 + y**2), ()),
    ((a * c + b * d) ** 2 <= (a**2 + b**2) * (c**2 + d**2), ()),
    (dot(u, v) ** 2 <= dot(u, u) * dot(v, v), ()),
    (dot(cross(u, v), cross(u, v)) <= dot(u, u) * dot(v, v), ()),
    (dot(u + v, u + v) <= 2 * dot(u, u) + 2 * dot(v, v), ()),
    (u.T @ A.T @ A @ u >= 0, ()),
    (tr(A.T @ A) >= 0, ()),
    (3 * tr(A.T @ A) >= tr(A) ** 2, ()),
    (tr(A @ A) <= tr(A.T @ A), ()),
    (u.T @ (CPM(v).T @ CPM(v)) @ u >= 0, ()),
    (x**4 + y**4 >= 2 * x**2 * y**2, ()),
    (x**4 + y**4 + z**4 >= x**2 * y**2 + y**2 * z**2 + z**2 * x**2, ()),
    (x**4 + x**2 * y**2 + y**4 >= x**3 * y + x * y**3, ()),
    (x**2 + x + 1 > 0, ()),
    (2 * x**2 - 2 * x * y + y**2 + 1 > 0, ()),
    (x**2 - 2 * x + 2 > 0, ()),
    (x**2 - 4 * x + 5 >= 1, ()),
    (m * x**2 + k * y**2 >= 0, (positive(m), positive(k))),
    (k * x**2 + l * (x - y) ** 2 >= 0, (positive(k), positive(l))),
    (m * x**2 + k > 0, (positive(m), positive(k))),
    (a**2 * b + b**2 * a + a * b > 0, (positive(a), positive(b))),
    (a * dot(u, u) + b * dot(v, v) >= 0, (positive(a), positive(b))),
    (norm(u) * x**2 + norm(v) >= 0, ()),
    (norm(u) ** 2 + norm(v) ** 2 >= 2 * dot(u, v), ()),
    (x * y >= 0, (inequality(x >= 0), inequality(y >= 0))),
    (x * y + x + y >= 0, (inequality(x >= 0), inequality(y >= 0))),
    (1 + cos(t) ** 2 > 0, ()),
    ((x * sin(t) - y * cos(t)) ** 2 + cos(t) ** 2 >= 0, ()),
)
FALSE: tuple[tuple[Relation, tuple[Hypothesis, ...]], ...] = (
    (x**2 + y**2 >= 3 * x * y, ()),
    (x**2 + y**2 > x * y, ()),
    (x**2 + y**2 + z**2 >= 2 * (x * y + y * z + z * x), ()),
    (2 * (x**2 + y**2 + z**2) >= (x + y + z) ** 2, ()),
    ((a * c + b * d) ** 2 >= (a**2 + b**2) * (c**2 + d**2), ()),
    (dot(u, v) ** 2 >= dot(u, u) * dot(v, v), ()),
    (u.T @ A @ u >= 0, ()),
    (tr(A @ A) >= 0, ()),
    (x**4 + y**4 >= 3 * x**2 * y**2, ()),
    (x**2 + x >= 0, ()),
    (x**2 - 2 * x + 1 > 0, ()),
    (x**2 - 4 * x + 5 >= 2, ()),
    (m * x**2 + k * y**2 >= 0, (positive(m),)),
    (k * x**2 - l * y**2 >= 0, (positive(k), positive(l))),
    (x * y >= 0, (inequality(x >= 0),)),
    (a * b - a > 0, (positive(a), positive(b))),
)


def claim(relation: Relation, assuming: tuple[Hypothesis, ...]) -> Claim:
    return Claim("1", *says_that(relation), assuming=assuming)


@pytest.mark.parametrize(("relation", "assuming"), TRUE, ids=str)
def test_sums_of_squares_are_never_negative(relation: Relation, assuming: tuple[Hypothesis, ...]) -> None:
    said = claim(relation, assuming)
    verdict = Session().decide(said).verdict
    assert isinstance(verdict, Holds | HoldsUnder), verdict
    assert set(verdict.needs) <= {h.text for h in assuming}
    check(said, "printed", verdict.certificate)


@pytest.mark.sampled(3)
@pytest.mark.parametrize(("relation", "assuming"), FALSE, ids=str)
def test_what_is_negative_somewhere_is_refuted(relation: Relation, assuming: tuple[Hypothesis, ...]) -> None:
    said = claim(relation, assuming)
    refuted(said)


DEFINITE: tuple[tuple[Node, bool, tuple[Hypothesis, ...], bool | None], ...] = (
    (spring, False, (positive(k), positive(l)), True),
    (spring, False, (positive(k),), False),
    (spring, True, (positive(k), positive(l)), True),
    (chain, False, (), True),
    (matrix((number(1), 2), (2, 1)), True, (), False),
    (matrix((number(1), 1), (1, 1)), True, (), True),
    (matrix((number(1), 1), (1, 1)), False, (), False),
    (matrix((number(1), 2), (0, 5)), False, (), False),
    (A.T @ A, True, (), True),
    (A.T @ A, False, (), False),
    (A @ A, True, (), False),
    (Identity(3) + u @ u.T, False, (), True),
    (dot(u, u) * Identity(3) - u @ u.T, True, (), True),
    (m * (dot(u, u) * Identity(3) - u @ u.T), True, (positive(m),), True),
    (m * (dot(u, u) * Identity(3) - u @ u.T), True, (), False),
    (CPM(u).T @ CPM(u), True, (), True),
    (CPM(u) @ CPM(u), True, (), False),
    (Identity(3) - 2 * u @ u.T, True, (unit(u),), False),
    (S.T @ chain @ S, True, (), True),
)  # fmt: skip


@pytest.mark.sampled(4)
@pytest.mark.parametrize(("of", "semi", "assuming", "holds"), DEFINITE, ids=str)
def test_definite_matrices(of: Node, semi: bool, assuming: tuple[Hypothesis, ...], holds: bool) -> None:
    said = Theorem("1", "it is positive-definite", (PositiveDefinite(of, semi),), assuming=assuming)
    if holds:
        assert set(proved(said).needs) <= {h.text for h in assuming}
    else:
        refuted(said)


def test_given_definitions_are_used() -> None:
    sum_ = Definition("1", a, x + y)
    said = Claim("2", *says_that(a**2 <= 2 * (x**2 + y**2)), given=(sum_,))
    assert Session().decide(said).verdict.true


def test_no_forged_squares_are_accepted() -> None:
    said = claim(m * x**2 + 2 * m * x * y + m * y**2 + 1 > 0, (positive(m),))
    verdict = Session().decide(said).verdict
    assert isinstance(verdict, HoldsUnder)
    honest: dict[str, Any] = dict(verdict.certificate)
    ((first, second),) = honest["squares"]
    assert first[1] == "1*m"
    for forged in (
        [["-1", *first[1:]], second],
        [first],
        [first, ["1", "1", "0"]],
        [first, ["1", "1*x", "1"]],
        [["2", *first[1:]], second],
        [first, second, second],
        [["1", "1", "1*x"], second],
        [],
    ):
        with pytest.raises(Rejected):
            check(said, "printed", {**deepcopy(honest), "squares": [forged]})
    negative = claim(m * x**2 + 2 * m * x * y + m * y**2 + 1 > 0, ())
    with pytest.raises(Rejected):
        check(negative, "printed", honest)
    equation = Claim("1", m * x**2 + 2 * m * x * y + m * y**2 + 1, number(0), assuming=(positive(m),))
    with pytest.raises(Rejected):
        check(equation, "printed", honest)


def test_each_square_counts_for_its_own_claim() -> None:
    """What is said twice, once as an equation, is not proved by squares."""
    form = x**2 + y**2
    goals = problem_of(claim(form >= 0, ())).goals
    plain = problem_of(Claim("1", form, number(0))).goals
    certificate = {"squares": [[["1", "1", "1*x"], ["1", "1", "1*y"]], []], "witness": {"x": "0", "y": "0"}}
    with pytest.raises(Rejected):
        check(Problem((*goals, *plain)), "printed", certificate)
    with pytest.raises(Rejected):
        check(Problem((*plain, *goals)), "printed", {**certificate, "squares": certificate["squares"][::-1]})
    check(Problem(goals), "printed", {**certificate, "squares": certificate["squares"][:1]})


def test_what_is_not_zero_is_not_therefore_positive() -> None:
    """b = -a^2 contradicts nothing, though a is positive and b is not zero."""
    said = Hypothesis("equation", (b + a**2,), ((b + a**2, number(0)),), (), "", "b = -a^2", free=True)
    problem = Problem((), hypotheses=(positive(a), nonzero(b), said))
    forged = {"variables": ["a", "b"], "nonvanishing": {"2. b != 0": 1}, "contradiction": {"b = -a^2 [0: 1, 1]": "1"}}
    with pytest.raises(Rejected):
        check_contradiction(problem, [h.text for h in problem.hypotheses], forged)


def test_squares_add_up() -> None:
    """Squares of random linear forms are found again, and what is negative somewhere is never a sum of squares."""
    draw = Random(3)
    for _ in range(200):
        size, terms = draw.randint(1, 4), dict[tuple[int, ...], Fraction]()
        for sign in (*[1] * draw.randint(1, 4), draw.choice((1, -1))):
            form = [Fraction(draw.randint(-3, 3)) for _ in range(size)]
            for i in range(size):
                for j in range(size):
                    place = tuple((n == i) + (n == j) for n in range(size))
                    terms[place] = terms.get(place, Fraction(0)) + sign * form[i] * form[j]
        found = sum_of_squares(terms, ())
        points = [[draw.randint(-4, 4) for _ in range(size)] for _ in range(40)]
        values = [sum(q * prod_at(place, at) for place, q in terms.items()) for at in points]
        assert found is not None or sign == -1
        for at, value in zip(points, values, strict=True):
            if found is not None:
                total = sum(q * sum(f * prod_at(p, at) for p, f in root.items()) ** 2 for q, _, root in found)
                assert value == total >= 0


def prod_at(place: tuple[int, ...], at: list[int]) -> Fraction:
    total = Fraction(1)
    for exponent, value in zip(place, at, strict=True):
        total *= value**exponent
    return total


def test_the_print_says_what_is_claimed() -> None:
    assert isinstance(det(spring), Node)
    labels = [label for label, _, _ in PositiveDefinite(spring).equations()]
    assert labels == ["it is symmetric", "its quadratic form is never negative", "its determinant is positive"]
