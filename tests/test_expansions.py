"""Claims up to terms of an order, and limits: what they say of each coefficient is decided."""

from __future__ import annotations

import re
from fractions import Fraction
from random import Random
from typing import Any

import mpmath
import pytest

from chasles.checker.certificate import Rejected, check
from chasles.decisions.session import Session
from chasles.numerics.reference import evaluate
from chasles.statements import Claim, Condition, Definition, nonzero, positive, unit
from chasles.statements.expanding import coefficients_of
from chasles.statements.matrices import invertible
from chasles.verdict import Holds, IllFormed, Undecided
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
    latex,
    matrix,
    norm,
    number,
    plain,
    scalar,
    sin,
    square,
    tan,
    tr,
    vector,
)
from chasles.vocabulary.expansions import limit, up_to
from chasles.vocabulary.functions import arcsin, arcsinh, arctan, arctanh, cosh, exp, log, sinh, sqrt, tanh
from chasles.vocabulary.nodes import lifted
from chasles.vocabulary.rotation_vectors import exp_of_vector
from chasles.vocabulary.sizes import Size

from .decided import claim, proved, refuted

t, y, a = scalar("t", r"\theta", "an angle"), scalar("y", "y", "a number"), scalar("a", "a", "a number")
e, v, w = vector("e", "e", "an axis"), vector("v", r"\phi", "a rotation vector"), vector("w", "w", "a vector")
M, n = square("M", "M", "a matrix"), Size("n")
N, K = square("N", "N", "a matrix", size=n), square("K", "K", "a matrix", size=n)
size = norm(v)
Exp = Identity(3) + sin(size) / size * CPM(v) + (1 - cos(size)) / size**2 * CPM(v) @ CPM(v)
about_e = Identity(3) + sin(t) * CPM(e) + (1 - cos(t)) * CPM(e) @ CPM(e)

about_z = matrix((cos(t), -sin(t), 0), (sin(t), cos(t), 0), (0, 0, 1))
z = column(0, 0, 1)
left_jacobian = Identity(3) + (1 - cos(size)) / size**2 * CPM(v) + (size - sin(size)) / size**3 * CPM(v) @ CPM(v)


TRUE = [
    claim(sin(t), up_to(t - t**3 / 6 + t**5 / 120, t, 7)),
    claim(cos(t / 2), up_to(1 - t**2 / 8 + t**4 * Fraction(1, 384), t, 6, "...")),
    claim(sin(t) / t, up_to(1 - t**2 / 6 + t**4 / 120, t, 6)),
    claim(t / sin(t), up_to(1 + t**2 / 6 + t**4 * Fraction(7, 360), t, 6)),
    claim((1 - cos(t)) / t**2, up_to(Fraction(1, 2) - t**2 / 24 + t**4 / 720, t, 6)),
    claim((cos(t) - sin(t) / t) / t**2, up_to(-lifted(Fraction(1, 3)) + t**2 / 30 - t**4 / 840, t, 6)),
    claim(arctan(t / y) / t, up_to(1 / y - t**2 / (3 * y**3) + t**4 / (5 * y**5), t, 6), nonzero(y)),
    claim(Exp, up_to(Identity(3) + CPM(v), v, 2)),
    claim(Exp, up_to(Identity(3) + CPM(v) + CPM(v) @ CPM(v) / 2, v, 3)),
    claim(about_e, up_to(Identity(3) + t * CPM(e), t, 2), unit(e)),
    claim(limit(sin(t) / t, t), 1),
    claim(limit((1 - cos(t)) / t**2, t), Fraction(1, 2)),
    claim(limit((Exp - Identity(3)) @ w, v), column(0, 0, 0)),
    claim(sqrt(1 + t), up_to(1 + t / 2 - t**2 / 8, t, 3)),
    claim(exp(t) * exp(-t), up_to(1, t, 5)),
    claim(log(1 + t), up_to(t - t**2 / 2, t, 3)),
    claim(arcsin(t), up_to(t + t**3 / 6 + t**5 * Fraction(3, 40), t, 7)),
    claim(sin(y + t), up_to(sin(y) + t * cos(y), t, 2)),
    claim(sqrt(y + t), up_to(sqrt(y) + t / (2 * sqrt(y)), t, 2), positive(y)),
    claim(t / tan(t), up_to(1 - t**2 / 3, t, 4)),
    claim(size / sin(size), up_to(1 + dot(v, v) / 6, v, 4)),
    claim(cross(v, e + v), up_to(cross(v, e), v, 5)),
    claim(about_z, up_to(Identity(3) + t * CPM(z), t, 2)),
    claim(about_z, up_to(matrix((1 - t**2 / 2, -t, 0), (t, 1 - t**2 / 2, 0), (0, 0, 1)), t, 3)),
    claim(limit((size - sin(size)) / size**3, v), Fraction(1, 6)),
    claim(limit(left_jacobian, v), Identity(3)),
    claim(a, up_to(t**2, t, 4), given=(Definition("0", a, sin(t) ** 2),)),
    claim(det(Identity(3) + t * M), up_to(1 + t * tr(M) + (tr(M) ** 2 - tr(M @ M)) * t**2 / 2, t, 3)),
    claim(det(Identity(n) + t * N), up_to(1 + t * tr(N) + (tr(N) ** 2 - tr(N @ N)) * t**2 / 2, t, 3)),
    claim(det(M + t * CPM(e)), up_to(det(M) * (1 + t * tr(inverse(M) @ CPM(e))), t, 2), invertible(M)),
    claim(inverse(Identity(3) + t * M), up_to(Identity(3) - t * M + t**2 * M @ M, t, 3)),
    claim(inverse(N + t * K), up_to(inverse(N) - t * inverse(N) @ K @ inverse(N), t, 2), invertible(N)),
    claim(limit((inverse(Identity(3) - t * M) - Identity(3)) / t, t), M),
    claim(norm(e + t * w), up_to(norm(e) + t * dot(e, w) / norm(e), t, 2), nonzero(norm(e))),
    claim((e + v) / norm(e + v), up_to(e + v - dot(e, v) * e, v, 2), unit(e)),
    claim(exp_of_vector(t * w), up_to(Identity(3) + t * CPM(w) + t**2 * CPM(w) @ CPM(w) / 2, t, 3), nonzero(norm(w))),
    claim(limit((exp_of_vector(t * w) - Identity(3)) / t, t), CPM(w), nonzero(norm(w))),
    claim(norm(e + t * e), up_to((1 + t) * norm(e), t, 5), nonzero(norm(e))),
]
FALSE = [
    claim(norm(t * e), up_to(t, t, 2), unit(e)),
    claim(limit(norm(t * w) / t, t), norm(w), nonzero(norm(w))),
    claim(det(Identity(3) + t * M), up_to(1 + t * tr(M) + (tr(M) ** 2 + tr(M @ M)) * t**2 / 2, t, 3)),
    claim(inverse(Identity(n) + t * N), up_to(Identity(n) + t * N, t, 2)),
    claim(norm(e + t * e), up_to(norm(e), t, 2), nonzero(norm(e))),
    claim(limit((exp_of_vector(t * w) - Identity(3)) / t, t), -CPM(w), nonzero(norm(w))),
    claim(cos(t / 2), up_to(1 - t**2 / 8 + t**4 * Fraction(1, 46080), t, 6, "...")),
    claim(sin(t), up_to(t - t**3 / 6, t, 6)),
    claim(Exp, up_to(Identity(3) - CPM(v), v, 2)),
    claim(Exp, up_to(Identity(3) + CPM(v), v, 3)),
    claim(limit((1 - cos(t)) / t**2, t), Fraction(1, 3)),
    claim(limit(1 / t, t), 0),
    claim(about_z, up_to(Identity(3) - t * CPM(z), t, 2)),
    claim(limit((size - sin(size)) / size**3, v), Fraction(1, 3)),
    claim(exp(t), up_to(1 + t, t, 3)),
    claim(about_e, up_to(Identity(3) - t * CPM(e), t, 2), unit(e)),
    claim(a, up_to(t**2, t, 5), given=(Definition("0", a, sin(t) ** 2),)),
]


@pytest.mark.parametrize("said", TRUE, ids=lambda said: f"{said.left} = {said.right}")
def test_what_is_true_is_proved_and_checked(said: Claim) -> None:
    proved(said)


@pytest.mark.parametrize("said", FALSE, ids=lambda said: f"{said.left} = {said.right}")
def test_what_is_false_is_refuted_and_checked(said: Claim) -> None:
    refuted(said)


def test_a_proof_of_fewer_terms_proves_no_more() -> None:
    few, many = claim(sin(t), up_to(t, t, 3)), claim(sin(t), up_to(t, t, 4))
    verdict = Session().decide(few).verdict
    assert isinstance(verdict, Holds)
    with pytest.raises(Rejected):
        check(many, "printed", verdict.certificate)


@pytest.mark.parametrize(
    ("said", "reason"),
    [
        (claim(det(t * M), up_to(t, t, 2)), "has no inverse where t is zero"),
        (claim(sqrt(t), up_to(t, t, 2)), re.escape("sqrt(t) is not expanded")),
        (claim(sin(1 / t), up_to(t, t, 2)), "grows without bound"),
        (claim(up_to(t, t, 2) + 1, t), "cannot stand beside"),
        (claim(sin(v.x), up_to(v.x, v, 2), unit(v)), "goes to zero, and it is assumed"),
        (claim(y, up_to(t, t, 2), given=(Condition("0", y, t, on=(y,)),)), "has to be definitions"),
        (claim(y, up_to(t, t, 2), given=(Definition("0", t, sin(y)),)), "a given statement says what it is"),
    ],
)
def test_what_is_not_expanded_is_told(said: Claim, reason: str) -> None:
    verdict = Session().decide(said).verdict
    assert isinstance(verdict, IllFormed | Undecided), verdict
    assert re.search(reason, verdict.reason), verdict.reason


def test_what_goes_to_zero_is_a_symbol() -> None:
    with pytest.raises(Misfit, match="is a symbol"):
        up_to(t, t / 2, 3)
    with pytest.raises(Misfit, match="at least 1"):
        up_to(t, t, 0)


def test_they_are_printed() -> None:
    assert latex(up_to(1 - t, t, 2)) == r"1 - \theta + O\left( \theta^2 \right)"
    assert latex(up_to(Identity(3), v, 12, "...")) == r"\mathbf{1} + \cdots"
    assert latex(up_to(t, v, 2)) == r"\theta + O\left( \|\boldsymbol{\phi}\|^2 \right)"
    assert latex(up_to(t, t, 2, "")) == r"\theta"
    assert latex(limit(sin(t) / t, t)) == r"\lim_{\theta \to 0} \frac{\sin \theta}{\theta}"
    assert plain(limit(sin(t) + t, t)) == "lim t -> 0 (sin(t) + t)"
    assert plain(up_to(t, v, 2)) == "t + O(|v|^2)"


def expression(random: Random, depth: int) -> Node:
    """A scalar expression that is analytic at t = 0 for y = 2/3."""
    if depth == 0:
        return random.choice((t, t, y, lifted(Fraction(random.randint(-3, 3) or 1, random.randint(1, 3)))))
    one, other = expression(random, depth - 1), expression(random, depth - 1)
    made = (
        lambda: one + other,
        lambda: one - other,
        lambda: one * other,
        lambda: one / (2 + t * other),
        lambda: sin(one),
        lambda: cos(one),
        lambda: exp(one),
        lambda: sqrt(1 + t**2 * other),
        lambda: log(1 + t * one),
        lambda: arctan(t * one) / t,
        lambda: sin(t * one) / t,
        lambda: norm(column(2, 1 + t * one, t * other)),
        lambda: det(matrix((2 + t * one, t), (t * other, 1))),
        lambda: tr(inverse(matrix((1, t * one), (t, 1 + t * t * other)))),
    )
    return random.choice(made)()


@pytest.mark.sampled(4)
@pytest.mark.parametrize("seed", range(40))
def test_coefficients_are_those_of_the_taylor_series(seed: int) -> None:
    """Against differences of values of 60 digits near zero, for expressions made at random."""
    random, order = Random(seed), 4
    node = expression(random, 3)
    with mpmath.workdps(60):
        near, values = mpmath.mpf(10) ** -12, {y: Fraction(2, 3)}
        total = mpmath.mpf(0)
        for label, left, _ in coefficients_of(node, up_to(0, t, order), {}):
            total += evaluate(left, values, digits=60)[0][0] * near ** int(label.split()[-1])
        true = evaluate(node, {**values, t: near}, digits=60)[0][0]
        assert abs(true - total) < near**order * 10**6
        assert abs(true) < 10**6


@pytest.mark.parametrize("function", [sinh, tanh, arcsinh, arctanh, arcsin, arctan], ids=lambda f: f.__name__)
def test_functions_with_a_slope_are_expanded(function: Any) -> None:
    assert Session().decide(claim(function(2 * t), up_to(2 * t, t, 3))).verdict.true
    wrong = Session().decide(claim(function(2 * t) / t, up_to(3, t, 1))).verdict
    assert wrong.name == "fails"


def test_expansions_around_other_points_than_zero() -> None:
    around = claim(log(y + t), up_to(log(y) + t / y - t**2 / (2 * y**2), t, 3), positive(y))
    assert Session().decide(around).verdict.true
    assert Session().decide(claim(tanh(y + t), up_to(tanh(y) + (1 - tanh(y) ** 2) * t, t, 2))).verdict.true


def test_a_leading_term_that_is_zero_unseen_proves_and_refutes_nothing() -> None:
    hidden = claim(limit(t / (sqrt(y**2 + t) - y), t), 2 * y, positive(y))
    assert Session().decide(hidden).verdict.name == "undecided"
    seen = claim(limit((exp(t) - 1 - t) / (cosh(t) - 1), t), number(1))
    assert Session().decide(seen).verdict.true


def test_what_is_beyond_expansion_is_no_misprint() -> None:
    assert Session().decide(claim(limit(log(t), t), number(0))).verdict.name == "undecided"
