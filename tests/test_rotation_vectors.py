"""The norm of a vector as an angle: Rodrigues' formula with the rotation vector, its rates, and what is not so."""

from __future__ import annotations

from typing import Any

import pytest

from chasles.checker.certificate import Rejected, check
from chasles.checker.refutation import check_counterexample
from chasles.decisions.session import Session
from chasles.statements import Claim, Condition, Definition, nonzero, perpendicular, problem_of, unit
from chasles.verdict import Counterexample, Fails, Holds, HoldsUnder, Undecided
from chasles.vocabulary import (
    CPM,
    FREQUENCY,
    PI,
    Identity,
    Node,
    cos,
    cross,
    det,
    dot,
    inverse,
    norm,
    number,
    rate,
    scalar,
    sin,
    square,
    tr,
    vect,
    vector,
)

I = Identity(3)
p, r, a, b = vector("phi", r"\phi", ""), vector("psi", r"\psi", ""), vector("a", "a", ""), vector("b", "b", "")
phi, Q, n = scalar("alpha", r"\alpha", ""), square("Q", "Q", ""), norm(p)
nz = (nonzero(n),)


def rod(of: Node) -> Node:
    """Rodrigues' formula."""
    size = norm(of)
    return I + sin(size) / size * CPM(of) + (1 - cos(size)) / size**2 * CPM(of) @ CPM(of)


RO = rod(p)
w = sin(n) / n * rate(p) + (1 - cos(n)) / n**2 * cross(p, rate(p)) + (n - sin(n)) / n**3 * dot(p, rate(p)) * p
w2 = sin(n) / n * rate(p) - (1 - cos(n)) / n**2 * cross(p, rate(p)) + (n - sin(n)) / n**3 * dot(p, rate(p)) * p
q0_, q_ = cos(n / 2), sin(n / 2) / n * p

TRUE: list[tuple[str, Node, Node, dict[str, Any]]] = [
    ("circle", sin(n) ** 2 + cos(n) ** 2, number(1), {}),
    ("double", sin(n), 2 * sin(n / 2) * cos(n / 2), {}),
    ("RR^T", RO @ RO.T, I, {"assuming": nz}),
    ("det", det(RO), number(1), {"assuming": nz}),
    ("axis", RO @ p, p, {"assuming": nz}),
    ("trace", tr(RO), 1 + 2 * cos(n), {"assuming": nz}),
    ("vect", vect(RO), sin(n) / n * p, {"assuming": nz}),
    ("inverse", inverse(RO), rod(p).T, {"assuming": nz}),
    ("haversine", RO, I + sin(n) / n * CPM(p) + 2 * (sin(n / 2) / n) ** 2 * CPM(p) @ CPM(p), {"assuming": nz}),
    ("rate norm", rate(n), dot(p, rate(p)) / n, {"assuming": nz}),
    ("rate cos", rate(cos(n)), -sin(n) * dot(p, rate(p)) / n, {"assuming": nz}),
    ("spin", rate(RO), CPM(w) @ RO, {"assuming": nz}),
    ("body spin", rate(RO), RO @ CPM(w2), {"assuming": nz}),
    ("perp", RO @ a, cos(n) * a + sin(n) / n * cross(p, a), {"assuming": (*nz, perpendicular(p, a))}),
    ("two rot", det(rod(p) @ rod(r)), number(1), {"assuming": (*nz, nonzero(norm(r)))}),
    ("norm", norm(2 * p) * cos(n), 2 * n * cos(n), {}),
    ("norm sq", n**2 * cos(n), dot(p, p) * cos(n), {}),
    ("sum of angle", cos(n + phi), cos(n) * cos(phi) - sin(n) * sin(phi), {}),
    ("cos rate undeclared", rate(cos(n)), -sin(n) * rate(n), {}),
    ("quarter", sin(n + PI / 2), cos(n), {}),
    ("def", tr(Q), 1 + 2 * cos(n), {"assuming": nz, "given": (Definition("0", Q, RO),)}),
    ("def rate", rate(Q) @ p + Q @ rate(p), rate(p), {"assuming": nz, "given": (Definition("0", Q, RO),)}),
    ("half quaternion", cos(n / 2) ** 2 + dot(sin(n / 2) / n * p, sin(n / 2) / n * p), number(1), {"assuming": nz}),
    ("quaternion rot", RO, (2 * q0_**2 - 1) * I + 2 * q_ @ q_.T + 2 * q0_ * CPM(q_), {"assuming": nz}),
    (
        "second rate",
        rate(rate(n)),
        (dot(rate(p), rate(p)) + dot(p, rate(rate(p)))) / n - dot(p, rate(p)) ** 2 / n**3,
        {"assuming": nz},
    ),
    (
        "Rodrigues in full",
        RO @ a,
        cos(n) * a + sin(n) / n * cross(p, a) + (1 - cos(n)) / n**2 * dot(p, a) * p,
        {"assuming": nz},
    ),
    ("a rotation keeps lengths", norm(RO @ a) ** 2, dot(a, a), {"assuming": nz}),
    ("it is a power series at none", sin(n) * n, n * sin(n), {}),
]
FALSE: list[tuple[str, Node, Node, dict[str, Any]]] = [
    ("double w", sin(n), sin(n / 2) * cos(n / 2), {}),
    ("odd?", cos(n), sin(n), {}),
    ("wrong sign", RO, I - sin(n) / n * CPM(p) + (1 - cos(n)) / n**2 * CPM(p) @ CPM(p), {"assuming": nz}),
    ("wrong half", I + sin(n) / n * CPM(p) + (1 - cos(n)) / n * CPM(p) @ CPM(p), RO, {"assuming": nz}),
    (
        "not rot",
        (I + sin(n) * CPM(p) + (1 - cos(n)) * CPM(p) @ CPM(p))
        @ (I + sin(n) * CPM(p) + (1 - cos(n)) * CPM(p) @ CPM(p)).T,
        I,
        {},
    ),
    ("rate norm w", rate(n), -dot(p, rate(p)) / n, {"assuming": nz}),
    ("rate cos w", rate(cos(n)), sin(n) * dot(p, rate(p)) / n, {"assuming": nz}),
    ("spin w", rate(RO), CPM(w2) @ RO, {"assuming": nz}),
    ("perp w", RO @ a, cos(n) * a - sin(n) / n * cross(p, a), {"assuming": (*nz, perpendicular(p, a))}),
    ("perp w2", RO @ a, cos(n) * a + sin(n) / n * cross(p, a), {"assuming": nz}),
    ("two", rod(p) @ rod(r), rod(r) @ rod(p), {"assuming": (*nz, nonzero(norm(r)))}),
    ("norm is not its opposite", n, -n, {}),
    ("quarter w", sin(n + PI / 2) * n, -cos(n) * n, {}),
    ("sinc", sin(n) * p, n * p, {}),
    ("second rate", rate(rate(n)), dot(p, rate(rate(p))) / n, {"assuming": nz}),
    (
        "Rodrigues with a slip",
        RO @ a,
        cos(n) * a + sin(n) / n * cross(a, p) + (1 - cos(n)) / n**2 * dot(p, a) * p,
        {"assuming": nz},
    ),
    ("half for whole", tr(RO), 1 + 2 * cos(n / 2), {"assuming": nz}),
    ("not a multiple", cos(2 * n), 2 * cos(n), {}),
    ("a product of turns", rod(p) @ rod(r), I, {"assuming": (*nz, nonzero(norm(r)))}),
    ("a rate is a spin", rate(RO), CPM(rate(p)) @ RO, {"assuming": nz}),
    ("the angle of a sum", cos(n + norm(r)), cos(n) * cos(norm(r)), {}),
    ("its transpose", RO, RO.T, {"assuming": nz}),
]


@pytest.mark.parametrize(("name", "left", "right", "more"), TRUE)
def test_it_holds(name: str, left: Node, right: Node, more: dict[str, Any]) -> None:
    claim = Claim(name, left, right, **more)
    found = Session().decide(claim).verdict
    assert isinstance(found, Holds | HoldsUnder), found
    check(claim, "printed", found.certificate)
    needs = found.needs if isinstance(found, HoldsUnder) else ()
    assert set(needs) <= {"|phi| != 0", "|psi| != 0", "phi is perpendicular to a"}
    assert all(h.text in needs for h in more.get("assuming", ()) if h.kind == "nonzero")


@pytest.mark.parametrize(("name", "left", "right", "more"), FALSE)
def test_it_fails_at_a_vector(name: str, left: Node, right: Node, more: dict[str, Any]) -> None:
    claim = Claim(name, left, right, **more)
    found = Session().decide(claim).verdict
    assert isinstance(found, Fails), found
    check_counterexample(problem_of(claim), found.counterexample)


def test_a_length_is_not_negative() -> None:
    claim = Claim("1", norm(p) * cos(norm(p)) * norm(r) * PI, norm(p) * norm(r) * PI)
    found = Session().decide(claim).verdict
    assert isinstance(found, Fails)
    shown = found.counterexample
    assert all(value >= 0 for name, value in shown.at.items() if name.startswith("|"))
    turned = {name: -value if name.startswith(("|", "sin")) else value for name, value in shown.at.items()}
    with pytest.raises(Rejected):
        check_counterexample(
            problem_of(claim), Counterexample(turned, shown.entry, shown.left, shown.right, shown.goal)
        )


UNTREATED = [
    Claim("1", cos(norm(p)), number(1), given=(Definition("0", p, a + b),)),
    Claim("1", cos(norm(a - b)), cos(norm(b - a)) + dot(a, b)),
    Claim("1", cos(norm(p)), number(1), given=(Condition("0", cross(p, a), b, on=(p,)),)),
    Claim("1", cos(norm(p)), number(1), given=(Definition("0", rate(p), vector("v", "v", "", FREQUENCY)),)),
]


def test_the_length_of_a_unit_vector_is_one_beside_its_cosine() -> None:
    claim = Claim("1", cos(norm(a)), cos(norm(a)) + norm(a) - 1, assuming=(unit(a),))
    verdict = Session().decide(claim).verdict
    assert isinstance(verdict, HoldsUnder)
    check(claim, "printed", verdict.certificate)


@pytest.mark.sampled(2)
@pytest.mark.parametrize("claim", UNTREATED)
def test_where_more_is_known_of_a_length_it_is_a_question_of_scalars(claim: Claim) -> None:
    verdict = Session().decide(claim).verdict
    assert isinstance(verdict, Undecided | Fails)
    if isinstance(verdict, Fails):
        check_counterexample(problem_of(claim), verdict.counterexample)
