"""Partial derivatives, Jacobians and gradients: decided, checked, printed, evaluated; refused where they are none."""

from __future__ import annotations

from random import Random
from typing import Any

import mpmath
import pytest

from chasles.decisions.session import Session
from chasles.numerics.reference import evaluate
from chasles.statements import Claim, Condition, Definition, nonzero, rotation
from chasles.verdict import Fails, IllFormed, Undecided
from chasles.vocabulary import (
    ACCELERATION,
    CPM,
    LENGTH,
    MASS,
    MOMENT,
    Identity,
    Misfit,
    Node,
    abbreviation,
    column,
    cos,
    cross,
    det,
    dot,
    inverse,
    latex,
    matrix,
    norm,
    plain,
    rate,
    scalar,
    sin,
    square,
    tr,
    vector,
)
from chasles.vocabulary.functions import exp, sqrt
from chasles.vocabulary.nodes import lifted
from chasles.vocabulary.partial import gradient, partial, with_derivatives

from .decided import claim, proved, refuted

x, y, t = scalar("x", "x", "a number"), scalar("y", "y", "a number"), scalar("t", r"\theta", "an angle")
v, w, A, R = vector("v", "v", ""), vector("w", "w", ""), square("A", "A", ""), square("R", "R", "")
m, g = scalar("m", "m", "", MASS, constant=True), scalar("g", "g", "", ACCELERATION, constant=True)
length, L = scalar("l", "l", "", LENGTH, constant=True), scalar("L", "L", "the Lagrangian", MOMENT)
pendulum = Definition("0.1", L, m * length**2 * rate(t) ** 2 / 2 + m * g * length * cos(t))
circle = Definition("0.2", v, column(x * cos(y), x * sin(y), x))
z, u = scalar("z", "z", "a number"), vector("u", "u", "")
spin = abbreviation("S", "S", CPM(v), "a short letter")
entries, moved = Definition("0.3", v, column(x, y, z)), Definition("0.4", u, A @ w)

TRUE = [
    claim(partial(sin(t) * x, t), x * cos(t)),
    claim(partial(cross(v, w), v), -CPM(w)),
    claim(partial(dot(v, v), v), 2 * v.T),
    claim(gradient(dot(v, A @ v), v), (A + A.T) @ v),
    claim(partial(norm(v), v), v.T / norm(v), nonzero(norm(v))),
    claim(partial(v / norm(v), v), (Identity(3) - v @ v.T / norm(v) ** 2) / norm(v), nonzero(norm(v))),
    claim(partial(L, rate(t)), m * length**2 * rate(t), given=(pendulum,)),
    claim(
        rate(partial(L, rate(t))) - partial(L, t),
        m * length**2 * rate(rate(t)) + m * g * length * sin(t),
        given=(pendulum,),
    ),
    claim(partial(v, y), column(-x * sin(y), x * cos(y), 0), given=(circle,)),
    claim(partial(A @ v, v[2]), A[1:3, 2]),
    claim(partial(tr(A @ A), A[1, 2]), 2 * A[2, 1]),
    claim(partial(rate(t) * t, t), rate(t)),
    claim(partial(rate(x * y), rate(x)), y),
    claim(rate(v), partial(v, x) * rate(x) + partial(v, y) * rate(y), given=(circle,)),
    claim(partial(sqrt(x**2 + y**2), x), x / sqrt(x**2 + y**2)),
    claim(partial(exp(x * y), x), y * exp(x * y)),
    claim(partial(x, y), 0),
    claim(partial(x * y, column(x, y)), matrix((y, x))),
    claim(gradient(x * dot(v, w), column(x, v)), column(dot(v, w), x * w)),
    claim(partial(x * y, v), matrix((y, x, 0)), given=(entries,)),
    claim(partial(A @ v * x, v), A * x + A @ v @ matrix((1, 0, 0)), given=(entries,)),
    claim(partial(x * y, v[2]), x, given=(entries,)),
    claim(partial(rate(x) ** 2, rate(v)), matrix((2 * rate(x), 0, 0)), given=(entries,)),
    claim(partial(dot(u, u), u), 2 * u.T, given=(moved,)),
    claim(partial(det(A), A[1, 2]), A[2, 3] * A[3, 1] - A[2, 1] * A[3, 3]),
    claim(partial(partial(x**2 * y**3, x), y), 6 * x * y**2),
    claim(partial(gradient(dot(v, A @ v), v), v), A + A.T),
    claim(partial(R @ v, v), R, rotation(R)),
    claim(partial(spin @ w, w), spin),
    claim(partial(spin @ w, v), -CPM(w)),
    claim(partial(inverse(A) @ w, A[1, 1]), -(inverse(A) @ partial(A, A[1, 1]) @ inverse(A) @ w), nonzero(det(A))),
]
FALSE = [
    claim(partial(cross(v, w), v), CPM(w)),
    claim(partial(dot(v, A @ v), v), 2 * v.T @ A),
    claim(partial(x**2 * y, x), x * y),
    claim(partial(L, t), m * g * length * sin(t), given=(pendulum,)),
    claim(partial(v, x), column(0, 0, 0), given=(circle,)),
    claim(partial(x * y, v), matrix((0, 0, 0)), given=(entries,)),
    claim(partial(A @ v * x, v), A * x, given=(entries,)),
    claim(partial(dot(v, rate(v)), rate(v)), -v.T, given=(entries,)),
    claim(partial(det(A), A[1, 1]), 0),
    claim(partial(rate(t) * t, rate(t)), 2 * t),
]


@pytest.mark.parametrize("said", TRUE, ids=lambda said: f"{said.left} = {said.right}")
def test_what_is_true_is_proved_and_checked(said: Claim) -> None:
    proved(said)


@pytest.mark.parametrize("said", FALSE, ids=lambda said: f"{said.left} = {said.right}")
def test_what_is_false_is_refuted_and_checked(said: Claim) -> None:
    refuted(said)


halved = Condition("0", 2 * y, x, on=(y,))


def test_what_conditions_determine_is_not_differentiated_as_if_it_were_free() -> None:
    assert isinstance(Session().decide(claim(partial(y, x), 0, given=(halved,))).verdict, Fails)
    verdict = Session().decide(claim(partial(y, x), 0, given=(Condition("0", y**2, x, on=(y,)),))).verdict
    assert isinstance(verdict, Undecided | IllFormed)
    assert "definition" in verdict.reason


@pytest.mark.parametrize("write", [lambda: partial(A, v), lambda: partial(x, x + y), lambda: partial(v, A)])
def test_what_is_no_derivative_is_refused(write: Any) -> None:
    with pytest.raises(Misfit, match="a derivative is"):
        write()


@pytest.mark.parametrize("right", [0, 1, 2 * x])
def test_what_depends_only_on_what_a_symbol_is_is_not_differentiated_by_it(right: Any) -> None:
    """Of z = x^2 and a function of x it is not said what a derivative by z keeps: once it was zero."""
    verdict = Session().decide(claim(partial(x**2, z), right, given=(Definition("0", z, x**2),))).verdict
    assert isinstance(verdict, Undecided)
    assert "does not depend on it" in verdict.reason


def test_dimensions_are_those_of_the_quotient() -> None:
    assert partial(L, t).measure == L.measure
    with pytest.raises(Misfit, match="cannot add"):
        partial(L, t) + partial(L, rate(t))


def test_they_are_printed() -> None:
    assert latex(partial(L, rate(t))) == r"\frac{\partial L}{\partial \dot{\theta}}"
    assert latex(partial(x + y, v.x)) == r"\frac{\partial \left( x + y \right)}{\partial v_x}"
    assert plain(partial(dot(v, w), v)) == "d(v . w) / dv"


def expression(random: Random, depth: int) -> Node:
    """A scalar expression in x, y and the vector v."""
    if depth == 0:
        return random.choice((x, y, v.x, dot(v, w), lifted(random.randint(1, 3))))
    one, other = expression(random, depth - 1), expression(random, depth - 1)
    made = (
        lambda: one + other,
        lambda: one * other,
        lambda: one / (other**2 + 1),
        lambda: sin(one) - cos(other),
        lambda: sqrt(one**2 + 2),
        lambda: norm(v * one + w),
        lambda: dot(cross(v, w * one), A @ v),
        lambda: tr(CPM(v) @ A) * other,
    )
    return random.choice(made)()


@pytest.mark.parametrize("seed", range(25))
def test_they_are_the_slopes(seed: int) -> None:
    """Against differences of values of 60 digits, for expressions made at random."""
    random = Random(seed)
    node = expression(random, 3)
    values: dict[Node, Any] = {s: random.random() for s in (x, y)}
    values |= {v: [random.random() for _ in range(3)], w: [random.random() for _ in range(3)]}
    values |= {A: [[random.random() for _ in range(3)] for _ in range(3)]}
    with mpmath.workdps(60):
        step = mpmath.mpf(10) ** -20
        for by in (x, v):
            found = evaluate(with_derivatives(partial(node, by), {}), values, digits=60)[0]
            for place, slope in enumerate(found):
                moved = [mpmath.mpf(number) for number in (values[by] if by is v else [values[by]])]
                ends = []
                for sign in (1, -1):
                    at = [number + sign * step * (k == place) for k, number in enumerate(moved)]
                    ends.append(evaluate(node, {**values, by: at if by is v else at[0]}, digits=60)[0][0])
                true = (ends[0] - ends[1]) / (2 * step)
                assert abs(true - slope) <= mpmath.mpf(10) ** -25 * max(1, abs(slope))


def test_what_a_given_claim_ties_is_not_taken_for_independent() -> None:
    """y = a x^2 / 2 is behind 2 y = a x^2, of which nothing says that y is independent of x."""
    a, z = scalar("a", "a", ""), scalar("z", "z", "")
    twice = Claim("2", 2 * z, a * x**2, given=(Definition("1", z, a * x**2 / 2),))
    alone = Condition("3", 2 * z, a * x**2)
    decide = Session().decide
    assert decide(Claim("4", partial(z, x), 0 * z, given=(twice,))).verdict.name == "fails"
    assert decide(Claim("5", partial(2 * z, x), 2 * a * x, given=(twice,))).verdict.true
    assert decide(Claim("6", partial(2 * z, a), x**2, given=(twice,))).verdict.true
    for right in (0 * z, a * x):
        verdict = decide(Claim("7", partial(z, x), right, given=(alone,))).verdict
        assert isinstance(verdict, Undecided)
        assert verdict.reason == "(3) ties z to x, by which it is differentiated: say what it is"
