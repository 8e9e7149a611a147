"""Points that satisfy hypotheses which share symbols, with rates: witnesses, and counterexamples that are checked."""

from __future__ import annotations

from typing import Any

import pytest

from chasles.checker.certificate import check
from chasles.checker.refutation import check_counterexample
from chasles.decisions.session import Session
from chasles.statements import (
    Claim,
    Hypothesis,
    definite,
    half_turn,
    nonzero,
    orthonormal,
    perpendicular,
    positive,
    problem_of,
    rotation,
    symmetric,
    unit,
    unit_column,
)
from chasles.verdict import Fails, Holds, HoldsUnder
from chasles.vocabulary import (
    CPM,
    Identity,
    Node,
    column,
    cross,
    det,
    dot,
    norm,
    number,
    rate,
    scalar,
    square,
    tr,
    vector,
)

from .sampling import sample

I = Identity(3)
R, Q, S = (square(name, name, "") for name in "RQS")
s, k, eta = (scalar(name, name, "") for name in ("s", "k", "eta"))
a, b, c, v3, e1, e2 = (vector(name, name, "") for name in ("a", "b", "c", "eps", "e1", "e2"))
q0, q1, q2, q3 = (scalar(f"q{i}", f"q_{i}", "") for i in range(4))
q, q_dot = column(q1, q2, q3), column(rate(q1), rate(q2), rate(q3))
uc, uc2 = (unit_column(q0, q1, q2, q3),), (unit_column(eta, v3),)


def turn(p: Node, v: Node) -> Node:
    """The rotation with Euler and Rodrigues' parameters."""
    return (2 * p**2 - 1) * I + 2 * v @ v.T + 2 * p * CPM(v)


RR, R2 = turn(q0, q), turn(eta, v3)
w = 2 * (q0 * q_dot - rate(q0) * q + cross(q, q_dot))
w2 = 2 * (q0 * q_dot - rate(q0) * q - cross(q, q_dot))

TRUE: list[tuple[str, Node, Node, tuple[Hypothesis, ...]]] = [
    ("orth", RR @ RR.T, I, uc),
    ("det", det(RR), number(1), uc),
    ("sum", q0**2 + q1**2 + q2**2 + q3**2, number(1), uc),
    ("rate0", q0 * rate(q0) + q1 * rate(q1) + q2 * rate(q2) + q3 * rate(q3), number(0), uc),
    (
        "second rate",
        q0 * rate(rate(q0))
        + q1 * rate(rate(q1))
        + q2 * rate(rate(q2))
        + q3 * rate(rate(q3))
        + rate(q0) ** 2
        + rate(q1) ** 2
        + rate(q2) ** 2
        + rate(q3) ** 2,
        number(0),
        uc,
    ),
    ("spin skew", rate(RR) @ RR.T, -(rate(RR) @ RR.T).T, uc),
    ("spin", rate(RR), CPM(w) @ RR, uc),
    ("mix", R2 @ R2.T, I, uc2),
    ("mix rate", eta * rate(eta) + dot(v3, rate(v3)), number(0), uc2),
    ("two vectors", dot(a, a) + dot(b, b), number(1), (unit_column(a, b),)),
    ("one scalar", s**2, number(1), (unit_column(s),)),
    ("two scalars", s**2, 1 - k**2, (unit_column(s, k),)),
    ("with perp", dot(v3, a), number(0), (unit_column(eta, v3), perpendicular(v3, a))),
    ("nonzero q0", (1 / q0) * q0, number(1), (unit_column(q0, q1, q2, q3), nonzero(q0))),
    ("shared true", q1**2 + q2**2 + q3**2, s**2 + k**2, (unit_column(q0, q1, q2, q3), unit_column(q0, s, k))),
    ("unit+perp", dot(a, b) + dot(a, a), number(1), (unit(a), unit(b), perpendicular(a, b))),
    ("unit+perp rates", dot(rate(a), b) + dot(a, rate(b)), number(0), (unit(a), unit(b), perpendicular(a, b))),
    ("sym rot", R @ R, I, (rotation(R), symmetric(R))),
    ("two triads sharing", dot(a, b), number(0), (orthonormal(a, b, c), orthonormal(a, e1, e2))),
    (
        "perp rates 2",
        dot(rate(rate(a)), b) + 2 * dot(rate(a), rate(b)) + dot(a, rate(rate(b))),
        number(0),
        (perpendicular(a, b),),
    ),
    ("half turn rate", rate(Q), rate(Q).T, (half_turn(Q),)),
    ("sym rate", rate(S), rate(S).T, (symmetric(S),)),
    ("perp in a column", dot(a, a) + dot(b, b), number(1), (perpendicular(a, b), unit_column(a, b))),
    ("perp beside a column", dot(a, a), 1 - dot(b, b), (perpendicular(b, c), unit_column(a, b), nonzero(dot(a, b)))),
    ("column of three", dot(a, a) + s**2 + k**2, number(1), (unit_column(s, a, k),)),
    ("its norm", norm(v3) ** 2, 1 - eta**2, uc2),
    ("a turn that is definite", R @ R.T, I, (rotation(R), definite(R))),
    ("a turn that is symmetric, of no half", R @ R, I, (rotation(R), symmetric(R), nonzero(1 + tr(R)))),
    ("definite first", tr(S), tr(S.T), (definite(S), symmetric(S))),
    ("a half-turn first", Q @ Q, I, (half_turn(Q), rotation(Q))),
    ("a triad and its perpendiculars", dot(a, b), number(0), (perpendicular(a, b), orthonormal(a, b, c))),
    ("a positive part", q0 / q0, number(1), (positive(q0), *uc)),
]
FALSE: list[tuple[str, Node, Node, tuple[Hypothesis, ...]]] = [
    ("rate wrong", q0 * rate(q0) + q1 * rate(q1) + q2 * rate(q2), number(0), uc),
    ("wrong", q0**2 + q1**2 + q2**2, number(1), uc),
    ("wrong2", RR, RR.T, uc),
    (
        "second rate wrong",
        q0 * rate(rate(q0)) + q1 * rate(rate(q1)) + q2 * rate(rate(q2)) + q3 * rate(rate(q3)),
        number(0),
        uc,
    ),
    ("spin wrong", rate(RR), CPM(w2) @ RR, uc),
    ("mix wrong", R2, I, uc2),
    ("mix rate wrong", eta * rate(eta) - dot(v3, rate(v3)), number(0), uc2),
    ("two vectors wrong", dot(a, b), number(0), (unit_column(a, b),)),
    ("one scalar wrong", s, number(1), (unit_column(s),)),
    ("two scalars wrong", s, 1 - k, (unit_column(s, k),)),
    ("with perp w", eta, number(0), (unit_column(eta, v3), perpendicular(v3, a))),
    ("with perp w2", dot(a, a), eta, (unit_column(eta, v3), perpendicular(v3, a))),
    ("nonzero q0 wrong", q1 / q0, q2 / q0, (unit_column(q0, q1, q2, q3), nonzero(q0))),
    ("positive q0", q0, -q0, (unit_column(q0, q1, q2, q3), positive(q0))),
    ("positive + rate", rate(q0), number(0), (unit_column(q0, q1, q2, q3), positive(q0))),
    ("shared", q0**2 + q1**2, s**2 + k**2, (unit_column(q0, q1, q2, q3), unit_column(q0, s, k))),
    ("unit + rot e", R @ a, a, (rotation(R), unit(a))),
    ("unit+perp rates w", dot(rate(a), b) - dot(a, rate(b)), number(0), (unit(a), unit(b), perpendicular(a, b))),
    ("chain perp", dot(a, c), number(0), (perpendicular(a, b), perpendicular(b, c))),
    ("triangle perp", dot(a, a), dot(b, b), (perpendicular(a, b), perpendicular(b, c), perpendicular(a, c))),
    ("sym rot w", R, I, (rotation(R), symmetric(R))),
    ("sym def", tr(S), number(0), (symmetric(S), definite(S))),
    ("two triads sharing w", b, e1, (orthonormal(a, b, c), orthonormal(a, e1, e2))),
    ("triad unit perp", dot(a, e1), number(1), (orthonormal(a, b, c), unit(e1), perpendicular(e1, b))),
    (
        "perp rates 2w",
        dot(rate(rate(a)), b) + dot(rate(a), rate(b)) + dot(a, rate(rate(b))),
        number(0),
        (perpendicular(a, b),),
    ),
    ("def rate", rate(S), rate(S) * 2, (definite(S),)),
    ("perp in a column", dot(a, a), dot(b, b), (perpendicular(a, b), unit_column(a, b))),
    ("perp beside a column", dot(a, b), number(0), (perpendicular(b, c), unit_column(a, b))),
    ("column of three", dot(a, a), s**2 + k**2, (unit_column(s, a, k),)),
    ("its norm", norm(v3), 1 - eta, uc2),
    ("definite first", tr(S), number(3), (definite(S), symmetric(S))),
    ("a half-turn first", Q, I, (half_turn(Q), rotation(Q))),
    ("a positive part", q0 + q1, q0, (positive(q0), *uc)),
    ("second rate of a positive part", q0 * rate(rate(q0)), -(rate(q0) ** 2), (*uc, positive(q0))),
]
CONTRADICTORY = [
    (unit(a), unit_column(eta, a), nonzero(eta)), (half_turn(R), definite(R)),
    (orthonormal(a, b, c), nonzero(dot(a, b))),
    (unit(b), unit_column(a, b), nonzero(dot(a, b))), (orthonormal(a, b, c), unit_column(a, b)),
    (half_turn(Q), nonzero(1 + tr(Q))), (perpendicular(a, b), nonzero(dot(a, b))),
]  # fmt: skip


@pytest.mark.parametrize(("name", "left", "right", "assuming"), TRUE)
def test_what_follows_has_a_witness(name: str, left: Node, right: Node, assuming: tuple[Any, ...]) -> None:
    claim = Claim(name, left, right, assuming=assuming)
    found = Session().decide(claim).verdict
    assert isinstance(found, Holds | HoldsUnder), found
    check(claim, "printed", found.certificate)


@pytest.mark.sampled(3)
@pytest.mark.parametrize(("name", "left", "right", "assuming"), FALSE)
def test_what_does_not_follow_has_a_counterexample(
    name: str, left: Node, right: Node, assuming: tuple[Any, ...]
) -> None:
    claim = Claim(name, left, right, assuming=assuming)
    found = Session().decide(claim).verdict
    assert isinstance(found, Fails), found
    check_counterexample(problem_of(claim), found.counterexample)


@pytest.mark.sampled(3)
@pytest.mark.parametrize(("place", "assuming"), [*enumerate(CONTRADICTORY)])
def test_what_nothing_satisfies_proves_and_refutes_nothing(place: int, assuming: tuple[Any, ...]) -> None:
    equations = (dot(a, a), dot(a, a)), (tr(R) + tr(Q), 2 + tr(R)), (dot(a, b), number(5))
    for left, right in sample(equations, 3, first=place % 3):
        occurring = left + sum((0 * tr(subject @ subject.T) for h in assuming for subject in h.subjects), number(0))
        assert not Session().decide(Claim("1", occurring, right, assuming=assuming)).verdict.true
