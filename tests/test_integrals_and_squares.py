"""Integrals over a body, components in a frame, sums of squares: what they mean and what they are refused."""

from __future__ import annotations

import pytest

from chasles.checker.certificate import Rejected, check
from chasles.decisions.session import Session
from chasles.statements import (
    Claim,
    Definite,
    Definition,
    OnlyWhere,
    Statement,
    Theorem,
    definite,
    nonzero,
    positive,
)
from chasles.verdict import Fails, Holds, HoldsUnder, IllFormed, Undecided, Verdict
from chasles.vocabulary import (
    CPM,
    LENGTH,
    MASS,
    Identity,
    Integral,
    Misfit,
    Negative,
    Node,
    Zero,
    column,
    cross,
    dot,
    in_frame,
    integral,
    latex,
    norm,
    number,
    plain,
    rate,
    replace,
    scalar,
    square,
    vector,
)

rho = scalar("rho", r"\rho", "density", MASS / LENGTH**3, constant=True)
p, r, c, a, x = (vector(name, name, name, LENGTH) for name in "prcax")
m = scalar("m", "m", "mass", MASS)
area = scalar("A", "A", "an area", LENGTH**2)
M = square("M", "M", "a matrix")
one = Identity(3)
radius = Definition("r", r, p - c)
mass = Definition("m", m, integral(rho, rho, p, r), assuming=(positive(rho),))
center = Definition("c", c, integral(rho * p, rho, p, r) / m, assuming=(positive(m),))


def _verdict(statement: Statement | Theorem) -> Verdict:
    return Session().decide(statement).verdict


def over(of: Node) -> Integral:
    return integral(of, rho, p, r)


def decided(left: Node, right: Node, *given: Statement, assuming=()) -> Verdict:
    return _verdict(Claim("0", left, right, given=given, assuming=assuming))


def test_an_integral_is_spelled_and_measured() -> None:
    assert latex(over(rho * p)) == r"\int_{\mathcal{B}} \rho \mathbf{p} \, d\mathcal{B}"
    assert plain(over(rho * p)) == "int_B(rho p)"
    assert plain(over(p + r)) == "int_B((p + r))"
    assert over(rho * p).measure == (m * p).measure
    with pytest.raises(Misfit, match="cannot add"):
        over(rho * p) + p


def test_components_in_a_frame() -> None:
    assert latex(in_frame(rate(p), "F")) == r"\left[ \dot{\mathbf{p}} \right]_{\mathcal{F}}"
    assert plain(in_frame(rate(p), "F")) == "[p_dot]_F"
    assert isinstance(decided(in_frame(p, "F") - in_frame(r, "F"), p - r), Holds)


def test_what_is_integrated_over_is_not_replaced() -> None:
    free = over(rho * cross(p, x))
    assert replace(free, {p: c, x: a}) == over(rho * cross(p, a))


@pytest.mark.parametrize(
    ("left", "right", "given"),
    [
        (over(rho * (p + r)), over(rho * p) + over(rho * r), ()),
        (over(rho * CPM(r)), CPM(over(rho * r)), ()),
        (over(rho * x), over(rho) * x, ()),
        (over(rho * r), over(rho * p) - over(rho) * c, (radius,)),
        (over(rho * r), Zero(3, 1), (radius, center, mass)),
        (rate(over(rho * p @ p.T)), over(rho * rate(p) @ p.T) + over(rho * p @ rate(p).T), ()),
        (rate(over(rho)), number(0), ()),
    ],
)
def test_an_integral_is_linear(left: Node, right: Node, given: tuple[Statement, ...]) -> None:
    assert decided(left, right, *given).true


@pytest.mark.parametrize(
    ("left", "right"),
    [
        (over(rho * p @ p.T), over(rho * p) @ over(rho * p).T / over(rho)),
        (over(rho * norm(p) ** 2), norm(over(rho * p)) ** 2 / over(rho)),
        (over(rho * r), over(rho * p)),
        (over(rho * p), over(rho) * p),
    ],
)
def test_an_integral_of_a_product_is_no_product_of_integrals(left: Node, right: Node) -> None:
    verdict = decided(left, right, assuming=(nonzero(over(rho)),))
    assert isinstance(verdict, Fails)
    assert any(name.startswith("int(") for name in verdict.counterexample.at)


def test_the_moments_of_a_witness_are_those_of_a_body() -> None:
    shifted = over(rho * (p + x) @ (p + x).T)
    verdict = decided(shifted, shifted.T)
    assert isinstance(verdict, Holds)
    moment = verdict.witness
    assert moment["int(rho)"] > 0
    for k in (1, 2, 3):
        assert moment["int(rho)"] * moment[f"int(rho p_{k} p_{k})"] >= moment[f"int(rho p_{k})"] ** 2


@pytest.mark.parametrize(
    ("left", "right", "given", "reason"),
    [
        (over(rho * norm(p)), norm(p) * over(rho), (), "no polynomial"),
        (over(rho / dot(p, p)), over(rho) / dot(p, p), (), "no polynomial"),
        (over(rho * p), over(rho * p), (Definition("p", p, a),), "differs from element to element"),
        (over(rho * p), integral(rho * p, rho, p), (), "not over the same"),
        (
            rate(c),
            rate(p),
            (Definition("1", rate(p), rate(c) + rate(x)), Definition("2", c, over(rho * p) / m, given=(mass,)), mass),
            "by this rate itself",
        ),
    ],
)
def test_what_is_not_treated_is_said(left: Node, right: Node, given: tuple[Statement, ...], reason: str) -> None:
    verdict = decided(left, right, *given, assuming=(nonzero(dot(p, p)), positive(m)))
    assert isinstance(verdict, Undecided)
    assert reason in verdict.reason


def theorem(*forms, assuming=()) -> Verdict:
    return _verdict(Theorem("0", "", forms, assuming=assuming))


def test_definite_forms() -> None:
    square_ = norm(cross(a, x)) ** 2
    of = dot(a, a) * dot(x, x) - dot(a, x) ** 2
    assert isinstance(theorem(Definite(of, (square_,))), Holds)
    assert isinstance(theorem(Definite(of, (2 * square_,))), Fails)
    weighted = m * dot(x, x)
    assert isinstance(theorem(Definite(weighted, (weighted,), (x,), one), assuming=(positive(m),)), HoldsUnder)
    assert isinstance(theorem(Definite(of, (square_,), (x,), CPM(a))), IllFormed | Fails)


@pytest.mark.parametrize(
    "squares",
    [
        (Negative(norm(x) ** 2),),
        (dot(a, x),),
        (m * norm(x) ** 2,),
        (norm(x) ** 2, number(-1) * norm(a) ** 2),
        (x.T @ M @ x,),
        (over(rho * norm(p) ** 2),),
    ],
)
def test_what_is_not_seen_to_be_a_square_is_refused(squares: tuple[Node, ...]) -> None:
    of = squares[0] if len(squares) == 1 else squares[0] + squares[1]
    assert isinstance(theorem(Definite(of, squares)), IllFormed)


def test_a_positive_definite_matrix_makes_a_square() -> None:
    form = Definite(x.T @ M @ x, (x.T @ M @ x,), (x,), one)
    verdict = theorem(form, assuming=(definite(M),))
    assert isinstance(verdict, HoldsUnder)
    assert verdict.needs == ("M is positive-definite",)
    minor = verdict.witness["M_11"] * verdict.witness["M_22"] - verdict.witness["M_12"] * verdict.witness["M_21"]
    assert verdict.witness["M_11"] > 0 < minor
    assert isinstance(decided(M, M.T, assuming=(definite(M),)), HoldsUnder)
    assert isinstance(decided(M, one, assuming=(definite(M),)), Fails)


def test_sides_that_are_equal_only_where_squares_vanish() -> None:
    gram, other = x @ x.T, x @ x.T + area * one
    form = OnlyWhere(gram, other, one, (3 * area,))
    assert isinstance(theorem(form, assuming=(positive(area),)), HoldsUnder)
    assert isinstance(theorem(OnlyWhere(gram, other, one, (2 * area,)), assuming=(positive(area),)), Fails)
    assert isinstance(theorem(form), IllFormed)


def test_a_certificate_for_another_body_is_refused() -> None:
    claim = Claim("0", over(rho * r), Zero(3, 1), given=(radius, center, mass))
    verdict = _verdict(claim)
    assert isinstance(verdict, HoldsUnder)
    check(claim, "printed", verdict.certificate)
    massless = {**verdict.certificate, "witness": {**verdict.certificate["witness"], "int(rho)": "0"}}
    with pytest.raises(Rejected, match="does not satisfy"):
        check(claim, "printed", massless)


def test_the_sum_of_all_squares_is_needed() -> None:
    of = dot(column(a, x), column(a, x))
    assert isinstance(theorem(Definite(of, (dot(a, a), dot(x, x)), (a, x), Identity(6))), Holds)
    assert isinstance(theorem(Definite(of, (dot(a, a),))), Fails)
