"""Derivatives by whole columns and matrices, and rates, of any size: decided, checked, and right at numbers."""

from __future__ import annotations

from fractions import Fraction
from random import Random
from typing import Any

import mpmath
import pytest

from chasles.checker.certificate import check
from chasles.checker.refutation import check_counterexample
from chasles.decisions.session import Session
from chasles.numerics.reference import evaluate
from chasles.statements import Claim, Definition, nonzero, symmetric, unit
from chasles.statements.matrices import invertible, orthogonal, skew_symmetric
from chasles.statements.posing import problem_of
from chasles.verdict import Fails, Holds, HoldsUnder
from chasles.vocabulary import (
    CPM,
    Identity,
    Misfit,
    Node,
    column,
    cos,
    cross,
    det,
    dot,
    inverse,
    matrix,
    norm,
    number,
    rate,
    row,
    scalar,
    square,
    tr,
    vect,
    vector,
)
from chasles.vocabulary.functions import exp, log
from chasles.vocabulary.matrix_derivatives import derivative_by_whole
from chasles.vocabulary.partial import gradient, partial
from chasles.vocabulary.sizes import Size, rectangular

UNITS = False
n, m = Size("n"), Size("m")
A, B, X, W = (square(name, name, "", size=n) for name in "ABXW")
H = rectangular("H", "H", "", m, n)
a, b, x = (vector(name, name, "", size=n) for name in "abx")
z = vector("z", "z", "", size=m)
T = scalar("T", "T", "")
energy = Definition("0", T, rate(x).T @ A @ rate(x) / 2)
riccati = Definition("0", rate(X), A @ X + X @ A.T + B)

TRUE = [
    (partial(a.T @ x, x), a.T),
    (gradient(x.T @ A @ x, x), (A + A.T) @ x),
    (gradient(x.T @ A @ x, x), 2 * A @ x, symmetric(A)),
    (gradient((z - H @ x).T @ (z - H @ x), x), -2 * H.T @ (z - H @ x)),
    (gradient(norm(H @ x) ** 2, x), 2 * H.T @ H @ x),
    (gradient(norm(z - H @ x) ** 2 / 2, x), -H.T @ (z - H @ x)),
    (partial(gradient((z - H @ x).T @ (z - H @ x), x), x), 2 * H.T @ H),
    (gradient(norm(x) ** 4, x), 4 * norm(x) ** 2 * x),
    (partial(H @ x, x), H),
    (partial(x * (a.T @ x), x), (a.T @ x) * Identity(n) + x @ a.T),
    (partial(x / norm(x), x), (Identity(n) - x @ x.T / norm(x) ** 2) / norm(x), nonzero(norm(x))),
    (partial((A @ x).T @ (A @ x) * x, x), norm(A @ x) ** 2 * Identity(n) + 2 * x @ (A.T @ A @ x).T),
    (partial(column(A @ x, H @ x), x), column(A, H)),
    (partial(a.T @ X @ b, X), a @ b.T),
    (partial(a.T @ X.T @ X @ b, X), X @ (b @ a.T + a @ b.T)),
    (partial(tr(A @ X @ B), X), A.T @ B.T),
    (partial(tr(X.T @ B @ X), X), (B + B.T) @ X),
    (partial(tr(X**3), X), 3 * (X.T) ** 2),
    (partial(det(X), X), det(X) * inverse(X).T, invertible(X)),
    (partial(log(det(X)), X), inverse(X).T, invertible(X)),
    (partial(a.T @ inverse(X) @ b, X), -inverse(X).T @ a @ b.T @ inverse(X).T, invertible(X)),
    (partial(tr(A @ inverse(X) @ B), X), -((inverse(X) @ B @ A @ inverse(X)).T), invertible(X)),
    (rate(inverse(X)), -inverse(X) @ rate(X) @ inverse(X), invertible(X)),
    (rate(log(det(X))), tr(inverse(X) @ rate(X)), invertible(X)),
    (rate(X).T, rate(X), symmetric(X)),
    (x.T @ rate(X) @ x, number(0), skew_symmetric(X)),
    (rate(X) @ X.T, -X @ rate(X).T, orthogonal(X)),
    (x.T @ rate(rate(x)), -rate(x).T @ rate(x), unit(x)),
    (rate(dot(x, A @ x)), dot(rate(x), A @ x) + dot(x, rate(A) @ x) + dot(x, A @ rate(x))),
]
GIVEN = [
    (rate(T), rate(x).T @ A @ rate(rate(x)) + Fraction(1, 2) * rate(x).T @ rate(A) @ rate(x), energy, symmetric(A)),
    (rate(gradient(T, rate(x))), A @ rate(rate(x)) + rate(A) @ rate(x), energy, symmetric(A)),
    (rate(inverse(X)), -inverse(X) @ A - A.T @ inverse(X) - inverse(X) @ B @ inverse(X), riccati, invertible(X)),
]
FALSE = [
    (partial(a.T @ X @ b, X), b @ a.T),
    (gradient(x.T @ A @ x, x), 2 * A @ x),
    (rate(inverse(X)), -rate(X), invertible(X)),
    (rate(X), X @ X, orthogonal(X)),
    (rate(x.T @ x), x.T @ rate(x)),
    (rate(rate(x)), x, unit(x)),
]


@pytest.mark.parametrize("said", [*TRUE, *GIVEN], ids=lambda said: str(said[0]))
def test_true_ones_are_proved(said: Any) -> None:
    left, right, *others = said
    given = tuple(each for each in others if isinstance(each, Definition))
    claim = Claim("1", left, right, given=given, assuming=tuple(each for each in others if each not in given))
    verdict = Session().decide(claim).verdict
    assert isinstance(verdict, Holds | HoldsUnder), verdict
    check(claim, "printed", verdict.certificate)


@pytest.mark.parametrize("said", FALSE, ids=lambda said: str(said[0]))
def test_false_ones_are_refuted(said: Any) -> None:
    left, right, *assuming = said
    claim = Claim("1", left, right, assuming=tuple(assuming))
    verdict = Session().decide(claim).verdict
    assert isinstance(verdict, Fails), verdict
    check_counterexample(problem_of(claim), verdict.counterexample)


def test_no_counterexample_breaks_what_follows_of_lower_rates() -> None:
    """Of a unit vector x, x . dx/dt is zero, though only its second rate is spoken of."""
    claim = Claim("1", x.T @ rate(rate(x)), -rate(x).T @ rate(x), assuming=(unit(x),))
    texts = [h.text for h in problem_of(claim).hypotheses if h.kind == "of a rate"]
    assert len(texts) == 2


c, e, C = vector("c", "c", ""), vector("e", "e", ""), square("C", "C", "")
BY_COLUMN: list[Node] = [
    dot(c, C @ c) * c,
    cross(cross(e, c), c),
    CPM(c) @ e + C @ CPM(e) @ c,
    (C.T @ c @ c.T) @ e,
    (c @ c.T @ C).T @ e / (1 + dot(c, c)),
    column(c.T @ C @ e, cos(dot(c, e)) * c),
    matrix([C, c], [c.T, 1]) @ column(e, 2),
    matrix([C, c], [c.T, 1]).T @ column(c, 2),
    (c @ e.T) ** 2 @ c - C @ (-c),
    exp(dot(c, e)) * CPM(CPM(c) @ e) @ c,
    vect(C) * dot(c, vect(c @ e.T)),
    column(norm(C @ c)),
]
BY_MATRIX: list[Node] = [
    tr(C @ C) * dot(c, C @ e),
    det(C) / (1 + tr(C)),
    det(2 * C - C.T),
    dot(vect(C), C @ e),
    tr(CPM(C @ e) @ C.T),
    tr(matrix([C, c], [c.T @ C, 1]) ** 2),
    dot(c, cross(C @ e, C.T @ c)) - norm(C @ e) ** 2,
    cos(tr(C)) * exp(tr(C)),
]


STEP = mpmath.mpf(10) ** -25


def slope(node: Node, by: Node, values: dict[Node, Any], i: int, j: int) -> list[Any]:
    """The entries of a column, differentiated by one entry of a letter with differences of numbers."""
    ends = []
    for sign in (1, -1):
        moved = [[entry + sign * STEP * ((r, k) == (i, j)) for k, entry in enumerate(row)]
                 for r, row in enumerate(values[by])]  # fmt: skip
        ends.append(evaluate(node, {**values, by: moved}, digits=80))
    return [(one[0] - other[0]) / (2 * STEP) for one, other in zip(*ends, strict=True)]


@pytest.mark.parametrize("node", [*BY_COLUMN, *BY_MATRIX], ids=str)
def test_it_is_the_limit_of_differences(node: Node) -> None:
    by = c if node in BY_COLUMN else C
    draw = Random(1)
    values = {each: [[mpmath.mpf(draw.randint(-9, 9)) / 8 for _ in range(each.shape[1])] for _ in range(3)]
              for each in (c, e, C)}  # fmt: skip
    found = evaluate(derivative_by_whole(node, by), values, digits=60)
    for i in range(3):
        for j in range(by.shape[1]):
            with mpmath.workdps(80):
                slopes = slope(node, by, values, i, j)
            said = [row[i] for row in found] if by is c else [found[i][j]]
            assert all(abs(one - other) < mpmath.mpf(10) ** -30 for one, other in zip(said, slopes, strict=True))


def test_known_sizes() -> None:
    claim = Claim("1", partial(det(C), C), det(C) * inverse(C).T, assuming=(invertible(C),))
    assert isinstance(Session().decide(claim).verdict, HoldsUnder)
    assert isinstance(Session().decide(Claim("2", partial(tr(C @ C), C), 2 * C)).verdict, Fails)


def test_what_has_no_derivative_is_refused() -> None:
    with pytest.raises(Misfit, match="a derivative is by a scalar, of a scalar, or of a column by a column"):
        partial(A @ X, X)
    with pytest.raises(Misfit, match="cannot equate"):
        Claim("1", partial(a.T @ x, x), a)


def test_rates_of_numbers_are_zero_in_every_dimension() -> None:
    """In a chapter without units an entry is differentiated: its matrix of zeros and ones has no dimension."""
    assert rate(matrix([1, 0])).measure == rate(3 * matrix([0, 1])).measure
    claim = Claim("1", partial(c[1] ** 2 * c[2], c), row(2 * c[1] * c[2], c[1] ** 2, 0))
    assert isinstance(Session().decide(claim).verdict, Holds)


def test_what_is_claimed_of_a_trace_is_used() -> None:
    trace = Claim("2", tr(B), tr(A.T @ A), given=(Definition("1", B, A @ A.T),))
    said: list[tuple[Node, Node, bool]] = [
        (tr(B) + 1, 1 + tr(A.T @ A), True),
        (tr(rate(B)), 2 * tr(A.T @ rate(A)), True),
        (partial(tr(B), A), 2 * A, True),
        (tr(B) + 1, 2 + tr(A.T @ A), False),
        (tr(rate(B)), 3 * tr(A.T @ rate(A)), False),
        (partial(tr(B), A), 0 * A, False),
        (partial(tr(B), A), 3 * A, False),
    ]
    for left, right, true in said:
        verdict = Session().decide(Claim("3", left, right, given=(trace,))).verdict
        assert verdict.true == true
