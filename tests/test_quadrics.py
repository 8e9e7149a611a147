"""Points on what equations between expressions describe: found for any quadric with simple rational points."""

from __future__ import annotations

import pytest

from chasles.decisions.session import Session
from chasles.pages.consequences import Consequences
from chasles.pages.named_hypotheses import as_hypothesis
from chasles.points.sampling import sample, satisfies
from chasles.problems.context import build
from chasles.statements import Claim, problem_of
from chasles.statements.posing import default_sides
from chasles.vocabulary import Node, Transpose, dot, norm, number, scalar, square, vector

x, y, z, w = (scalar(name, name, "a scalar") for name in "xyzw")
a, b = (vector(name, name, "a vector") for name in "ab")
M = square("M", "M", "a matrix")
ONE = number(1)

EQUATIONS: list[list[tuple[Node, Node]]] = [
    [(x**2 + y**2, ONE)],
    [(2 * x**2 + 3 * y**2, number(5))],
    [(x**2 - 3 * y**2, ONE)],
    [(x * y + z * w, ONE)],
    [(x**2 + x * y + y**2, number(3))],
    [(x**2 + dot(a, a), ONE)],
    [(norm(a), number(2))],
    [(dot(a, a), ONE), (dot(a, b), x)],
    [(x**2 + y**2, ONE), (z**2 + w**2, ONE)],
    [(dot(a, M @ b), ONE)],
]


@pytest.mark.sampled(3)
@pytest.mark.parametrize("equations", EQUATIONS, ids=str)
def test_points_satisfy_the_equations(equations: list[tuple[Node, Node]]) -> None:
    said = tuple(
        as_hypothesis(f"({k})", *each, Session(), Consequences(lambda _: ())) for k, each in enumerate(equations)
    )
    claim = Claim("1", *equations[0], assuming=said, sic=True)
    context = build(problem_of(claim, "printed", default_sides))
    found = list(sample(context, {}, simple=False))
    assert len(found) > 100
    assert all(satisfies(context, point) for point in found)
    assert len({tuple(point.items()) for point in found}) > 20


@pytest.mark.parametrize(
    ("left", "right", "kind"),
    [
        (norm(a), ONE, "unit"),
        (dot(a, a), ONE, "unit"),
        (ONE, a.T @ a, "unit"),
        (dot(a, b), number(0), "perpendicular"),
        (a.T @ b, number(0), "perpendicular"),
        (M, Transpose(M), "symmetric"),
        (M + M.T, M - M, "skew-symmetric"),
        (M @ M, M, "idempotent"),
        (dot(a, a) + x**2, ONE, "unit column"),
        (norm(a), number(2), "posed"),
        (dot(a, a), number(2), "posed"),
        (dot(a, b), ONE, "posed"),
    ],
    ids=str,
)
def test_an_equation_is_the_named_hypothesis_that_says_the_same(left: Node, right: Node, kind: str) -> None:
    assert as_hypothesis("(1)", left, right, Session(), Consequences(lambda _: ())).kind == kind
