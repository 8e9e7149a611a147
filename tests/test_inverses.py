"""An inverse is treated wherever it stands, and that there is one is among what a verdict needs."""

from __future__ import annotations

from typing import Any

import pytest

from chasles.checker.certificate import Rejected, check
from chasles.checker.refutation import check_counterexample
from chasles.decisions.session import Session
from chasles.statements import (
    Always,
    Claim,
    Condition,
    Definition,
    Theorem,
    definite,
    half_turn,
    nonzero,
    orthonormal,
    problem_of,
    rotation,
    symmetric,
)
from chasles.statements.statement import Statement
from chasles.verdict import Contradictory, Fails, Holds, HoldsUnder, IllFormed, Verdict
from chasles.vocabulary import (
    CPM,
    Identity,
    Node,
    Symbol,
    Zero,
    abbreviation,
    column,
    cos,
    cross,
    det,
    dot,
    inverse,
    matrix,
    norm,
    number,
    paren,
    rate,
    row,
    scalar,
    sin,
    square,
    tr,
    uniform,
    vector,
)


def of_size(name: str, size: int) -> Symbol:
    return Symbol(name, name, uniform((size, size)), "")


A, B, R, Q, S, M, X = (square(name, name, "") for name in "ABRQSMX")
A2, A4, A6 = of_size("A2", 2), of_size("A4", 4), of_size("A6", 6)
s, phi = scalar("s", "s", ""), scalar("phi", r"\phi", "")
a, b, c, x = (vector(name, name, "") for name in "abcx")
one, O, nought = Identity(3), Zero(3, 3), Zero(1, 3)
u, v, w = (vector(name, name, "") for name in "uvw")
triad = row(u, v, w)
turned, second = rotation(R), rotation(Q)
right_handed = orthonormal(u, v, w)
motion = matrix((R, O), (CPM(a) @ R, R))
pose = matrix((R, a), (nought, number(1)))
inertia = matrix((S, s * CPM(c)), (s * CPM(c).T, s * one))
plane = matrix((cos(phi), -sin(phi)), (sin(phi), cos(phi)))
invertible = {name: f"det({name}) != 0" for name in ("A", "B", "S", "A2", "A4", "A6")}
IN_A, IN_B, IN_S = invertible["A"], invertible["B"], invertible["S"]
IS_ROTATION = "R is a rotation"
E = abbreviation("E", "E", inverse(A), "the inverse of A")

HOLDS: list[tuple[str, Node, Node, dict[str, Any], set[str]]] = [
    ("on the left", inverse(R), R.T, {"assuming": (turned,)}, {IS_ROTATION}),
    ("on the right", R.T, inverse(R), {"assuming": (turned,)}, {IS_ROTATION}),
    ("of a rotation, inside", inverse(R) @ a + a, R.T @ a + a, {"assuming": (turned,)}, {IS_ROTATION}),
    ("of a half-turn", inverse(Q) @ a, Q @ a, {"assuming": (half_turn(Q),)}, {"Q is a half-turn"}),
    (
        "of a triad",
        inverse(triad) @ a,
        column(dot(u, a), dot(v, a), dot(w, a)),
        {"assuming": (right_handed,)},
        {right_handed.text},
    ),
    ("of two rotations", inverse(R @ Q), Q.T @ R.T, {"assuming": (turned, second)}, {IS_ROTATION, second.text}),
    (
        "of a defined rotation",
        inverse(X) @ a,
        Q.T @ R.T @ a,
        {"assuming": (turned, second), "given": (Definition("0", X, R @ Q),)},
        {IS_ROTATION, second.text},
    ),
    ("rate times inverse", rate(R) @ inverse(R), -(rate(R) @ inverse(R)).T, {"assuming": (turned,)}, {IS_ROTATION}),
    ("times it", A @ inverse(A), one, {}, {IN_A}),
    ("it times", inverse(A) @ A, one, {}, {IN_A}),
    ("nothing is left of it", inverse(A) - inverse(A), O, {}, {IN_A}),
    ("transposed", inverse(A).T, inverse(A.T), {}, {IN_A}),
    ("of a product", inverse(A @ B) + one, inverse(B) @ inverse(A) + one, {}, {IN_A, IN_B}),
    ("of a product alone", inverse(A @ B), inverse(B) @ inverse(A), {}, {IN_A, IN_B}),
    ("of itself", inverse(inverse(A)) @ B, A @ B, {}, {IN_A}),
    ("of a multiple", s * inverse(s * A), inverse(A), {}, {IN_A, "s != 0"}),
    ("of a half", inverse(A / 2) @ a, 2 * inverse(A) @ a, {}, {IN_A}),
    ("of the opposite", inverse(-A) @ a, -inverse(A) @ a, {}, {IN_A}),
    ("of a square", inverse(A**2) @ a, inverse(A) ** 2 @ a, {}, {IN_A}),
    ("its determinant", det(inverse(A)), 1 / det(A), {}, {IN_A}),
    ("in brackets", inverse(paren(A)) @ A, one, {}, {IN_A}),
    (
        "assumed already",
        inverse(A) @ A,
        one,
        {"assuming": (nonzero(det(A), r"A \text{ regular}"),)},
        {"A text{ regular}"},
    ),
    ("of a definite matrix", inverse(S).T, inverse(S), {"assuming": (definite(S),)}, {"S is positive-definite"}),
    (
        "of a symmetric matrix",
        inverse(S).T @ a,
        inverse(S) @ a,
        {"assuming": (symmetric(S),)},
        {IN_S, "S is symmetric"},
    ),
    ("its rate", rate(inverse(A)), -inverse(A) @ rate(A) @ inverse(A), {}, {IN_A}),
    (
        "its second rate",
        rate(rate(inverse(A2))),
        2 * inverse(A2) @ rate(A2) @ inverse(A2) @ rate(A2) @ inverse(A2) - inverse(A2) @ rate(rate(A2)) @ inverse(A2),
        {},
        {invertible["A2"]},
    ),
    ("Jacobi's formula", det(A) * tr(rate(A) @ inverse(A)), rate(det(A)), {}, {IN_A}),
    ("rate of a product", rate(A @ inverse(A)), O, {}, {IN_A}),
    (
        "rate along a rotation",
        rate(inverse(R)),
        -inverse(R) @ rate(R) @ inverse(R),
        {"assuming": (turned,)},
        {IS_ROTATION},
    ),
    ("of two by two", inverse(A2) @ A2, Identity(2), {}, {invertible["A2"]}),
    ("Cayley and Hamilton", det(A2) * inverse(A2), tr(A2) * Identity(2) - A2, {}, {invertible["A2"]}),
    (
        "of a turn in the plane",
        inverse(plane) @ plane,
        Identity(2),
        {},
        {"det([cos(phi), -sin(phi); sin(phi), cos(phi)]) != 0"},
    ),
    ("of four by four", A4 @ inverse(A4), Identity(4), {}, {invertible["A4"]}),
    ("of six by six", A6 @ inverse(A6), Identity(6), {}, {invertible["A6"]}),
    ("of a scalar", s * inverse(s), number(1), {}, {"s != 0"}),
    ("in a block", matrix((inverse(A), O), (O, one)) @ column(A @ a, b), column(a, b), {}, {IN_A}),
    ("of a block without need", inverse(matrix((one, O), (A, one))) @ column(a, b), column(a, b - A @ a), {}, set()),
    (
        "of a triangular block",
        inverse(matrix((A, O), (M, B))) @ column(A @ a, M @ a + B @ b),
        column(a, b),
        {},
        {IN_A, IN_B},
    ),
    (
        "of a screw motion",
        inverse(motion) @ column(b, c),
        column(R.T @ b, R.T @ (c - cross(a, b))),
        {"assuming": (turned,)},
        {IS_ROTATION},
    ),
    (
        "of a pose",
        inverse(pose) @ column(b, number(1)),
        column(R.T @ (b - a), number(1)),
        {"assuming": (turned,)},
        {IS_ROTATION},
    ),
    (
        "of an inertia dyad",
        inertia @ inverse(inertia),
        Identity(6),
        {"assuming": (symmetric(S),)},
        {"det([S, s CPM(c); s CPM(c)^T, s 1]) != 0"},
    ),
    (
        "Cayley's rotation",
        (one - CPM(a)) @ inverse(one + CPM(a)) @ ((one - CPM(a)) @ inverse(one + CPM(a))).T,
        one,
        {},
        {"det(1 + CPM(a)) != 0"},
    ),
    (
        "Sherman and Morrison",
        inverse(one + a @ b.T),
        one - a @ b.T / (1 + dot(a, b)),
        {"assuming": (nonzero(1 + dot(a, b)),)},
        {"1 + a . b != 0"},
    ),
    (
        "Woodbury",
        inverse(A + A @ B @ A) @ a,
        inverse(A) @ a - B @ inverse(one + A @ B) @ a,
        {},
        {"det(A + A B A) != 0", "det(1 + A B) != 0", IN_A},
    ),
    ("in a norm", norm(inverse(R) @ a), norm(a), {"assuming": (turned,)}, {IS_ROTATION}),
    ("in an abbreviation", E @ A, one, {}, {IN_A}),
    ("in a definition", X @ A, one, {"given": (Definition("0", X, inverse(A)),)}, {IN_A}),
    ("rate of a definition", rate(X), -X @ rate(A) @ X, {"given": (Definition("0", X, inverse(A)),)}, {IN_A}),
    ("a rule that is not at work", a + b, b + a, {"given": (Definition("0", X, inverse(A)),)}, set()),
    ("a similar matrix", tr(inverse(A) @ B @ A), tr(B), {}, {IN_A}),
    ("a turned tensor", inverse(R @ S @ R.T) @ R, R @ inverse(S), {"assuming": (turned,)}, {IN_S, IS_ROTATION}),
]

FAILS: list[tuple[str, Node, Node, dict[str, Any]]] = [
    ("it is not itself", inverse(R), R, {"assuming": (turned,)}),
    ("nor on the right", R, inverse(R), {"assuming": (turned,)}),
    ("nor its square", R @ R, inverse(R), {"assuming": (turned,)}),
    ("the other order", inverse(A @ B) + one, inverse(A) @ inverse(B) + one, {}),
    ("not its transpose", A.T @ a, inverse(A) @ a, {}),
    ("without a sign", rate(inverse(A)), inverse(A) @ rate(A) @ inverse(A), {}),
    ("with one too few", rate(inverse(A)) @ a, -inverse(A) @ rate(A) @ a, {}),
    ("not symmetric", rate(R) @ inverse(R), (rate(R) @ inverse(R)).T, {"assuming": (turned,)}),
    ("its determinant", det(inverse(A)), det(A), {}),
    ("its trace", tr(inverse(A)) * tr(A), number(9), {}),
    ("a sum", inverse(A + B), inverse(A) + inverse(B), {}),
    ("a multiple", inverse(2 * A) @ a, 2 * inverse(A) @ a, {}),
    ("the opposite", inverse(-A) @ a, inverse(A) @ a, {}),
    ("not symmetric either", inverse(A).T @ a, inverse(A) @ a, {}),
    ("of two by two", inverse(A2) @ A2, 2 * Identity(2), {}),
    ("of a turn", inverse(plane) @ Identity(2), plane, {}),
    ("of four by four", A4 @ inverse(A4.T), Identity(4), {}),
    (
        "of a triangular block",
        inverse(matrix((A, O), (M, B))) @ column(a, b),
        column(inverse(A) @ a, inverse(B) @ b),
        {},
    ),
    (
        "of a screw motion",
        inverse(motion) @ column(b, c),
        column(R.T @ b, R.T @ (c + cross(a, b))),
        {"assuming": (turned,)},
    ),
    ("of a pose", inverse(pose) @ column(b, number(1)), column(R.T @ b - a, number(1)), {"assuming": (turned,)}),
    ("Sherman and Morrison", inverse(one + a @ b.T) @ c, c - a @ b.T @ c, {}),
    ("in an abbreviation", E @ A.T, one, {}),
    ("in a definition", X @ B, one, {"given": (Definition("0", X, inverse(A)),)}),
    ("in a norm", norm(inverse(A) @ a), norm(a), {}),
    ("Jacobi's formula", tr(rate(A) @ inverse(A)), rate(det(A)), {}),
]


def decided(claim: Statement | Theorem) -> Verdict:
    """The verdict, checked by the checker."""
    found = Session().decide(claim).verdict
    match found:
        case Holds(certificate) | HoldsUnder(_, certificate):
            check(claim, "printed", certificate)
        case Fails(counterexample):
            check_counterexample(problem_of(claim), counterexample)
    return found


@pytest.mark.sampled(4)
@pytest.mark.parametrize(("name", "left", "right", "more", "needs"), HOLDS)
def test_it_holds_where_there_is_an_inverse(
    name: str, left: Node, right: Node, more: dict[str, Any], needs: set[str]
) -> None:
    found = decided(Claim(name, left, right, **more))
    assert isinstance(found, Holds | HoldsUnder), found
    said = set(found.needs) if isinstance(found, HoldsUnder) else set()
    assert needs <= said <= needs | {h.text for h in more.get("assuming", ())}


@pytest.mark.sampled(4)
@pytest.mark.parametrize(("name", "left", "right", "more"), FAILS)
def test_it_fails_at_a_point_that_is_checked(name: str, left: Node, right: Node, more: dict[str, Any]) -> None:
    assert isinstance(decided(Claim(name, left, right, **more)), Fails)


@pytest.mark.parametrize("singular", [CPM(a), a @ b.T, matrix((A, O), (B, O)), matrix((s, s), (s, s)), A - A, 0 * A])
def test_what_has_no_inverse_proves_nothing(singular: Node) -> None:
    size = Identity(singular.shape[0])
    for right in (size, 2 * size):
        found = decided(Claim("1", inverse(singular) @ singular, right))
        assert isinstance(found, Contradictory | IllFormed)


def test_in_theorems_and_conditions() -> None:
    always = Theorem("T", "", (Always(inverse(A) @ A, one), Always(inverse(A.T), inverse(A).T)))
    found = decided(always)
    assert isinstance(found, HoldsUnder)
    assert found.needs == (IN_A,)
    posed = Condition("1", inverse(A) @ x, b, on=(x,))
    solved = decided(Claim("2", x, A @ b, given=(posed,)))
    assert isinstance(solved, HoldsUnder)
    assert IN_A in solved.needs
    assert isinstance(decided(Claim("3", x, A.T @ b, given=(posed,))), Fails)


@pytest.mark.parametrize("word", ["det(A) != 0", "s != 0"])
def test_a_certificate_for_another_divisor_is_rejected(word: str) -> None:
    claim = Claim("1", s * inverse(s * A) @ a, inverse(A) @ a)
    found = decided(claim)
    assert isinstance(found, HoldsUnder)
    witness = dict.fromkeys(found.certificate["witness"], "0")
    with pytest.raises(Rejected):
        check(claim, "printed", {**found.certificate, "witness": witness})
    assert word in found.needs
