"""Fields: what vector calculus says of any, chain rules, and what is given of them, decided and checked."""

from __future__ import annotations

from typing import Any

import pytest

from chasles.checker.certificate import check
from chasles.checker.refutation import check_counterexample
from chasles.decisions.session import Session
from chasles.repairs.repair import repair
from chasles.statements import (
    Claim,
    Condition,
    Definition,
    Statement,
    nonzero,
    orthonormal,
    perpendicular,
    rotation,
    unit,
)
from chasles.statements.posing import problem_of
from chasles.verdict import Fails, Holds, HoldsUnder, Undecided
from chasles.vocabulary import (
    Misfit,
    Node,
    Zero,
    column,
    cross,
    dot,
    latex,
    norm,
    number,
    plain,
    rate,
    scalar,
    square,
    tr,
    vector,
)
from chasles.vocabulary.arguments import WrongArgument
from chasles.vocabulary.fields import field
from chasles.vocabulary.functions import exp
from chasles.vocabulary.nabla import convection, curl, div, grad, laplacian
from chasles.vocabulary.partial import partial
from chasles.vocabulary.sizes import Size

UNITS = False
x, t, q, m = vector("x", "x", ""), scalar("t", "t", ""), scalar("q", "q", ""), scalar("m", "m", "", constant=True)
f, g = (field(scalar(name, name, ""), x) for name in "fg")
u, v, n = (field(vector(name, name, ""), x, t) for name in "uvn")
T = field(square("T", "T", ""), x)
rho = field(scalar("rho", r"\rho", ""), x, t)
NOTHING = column(0, 0, 0)
motion = Definition("0", rate(x), v)
solenoidal = Condition("0", div(v), number(0), on=(v,))
potential = Condition("0", v, grad(f), on=(v,))
mass = Condition("0", rate(rho) + rho * div(v), number(0), on=(rho,))
S = field(square("S", "S", ""), x, t)
L = field(scalar("L", "L", ""), q, rate(q), t)
V = field(scalar("V", "V", ""), q)
h, E = scalar("h", "h", ""), scalar("E", "E", "")
jacobi = Definition("0", h, rate(q) * partial(L, rate(q)) - L)
lagrange = Condition("0", rate(partial(L, rate(q))) - partial(L, q), number(0), on=(q,))
energy = Definition("0", E, m * rate(q) ** 2 / 2 + V)
newton = Condition("0", m * rate(rate(q)), -partial(V, q), on=(q,))
momentum = Condition("0.1", rho * rate(v), div(S) + rho * u, on=(v,))
p, om = field(scalar("p", "p", ""), x, t), field(vector("om", r"\omega", ""), x, t)
spin, flow = Definition("0.1", om, curl(v)), Condition("0.2", rate(v), -grad(p) + m * laplacian(v), on=(v,))
curled = Condition("0.1", v, curl(u), on=(u,))
w, F, C = vector("w", "w", ""), square("F", "F", ""), square("C", "C", "")
stretch = Definition("0", C, F.T @ F)
W = field(scalar("W", "W", ""), C)

s = scalar("s", "s", "")
r, tangent, normal, binormal = (field(vector(name, name, ""), s) for name in ("r", "t", "n", "b"))
bend, twist = (field(scalar(name, name, ""), s) for name in ("kappa", "tau"))
along = Condition("0.1", partial(r, s), tangent, on=(r,))
frenet = (
    along,
    Condition("0.2", partial(tangent, s), bend * normal, on=(tangent,)),
    Condition("0.3", partial(normal, s), twist * binormal - bend * tangent, on=(normal,)),
    Condition("0.4", partial(binormal, s), -twist * normal, on=(binormal,)),
)
slope = Condition("0.1", partial(bend, s), bend**2, on=(bend,))


def _slope(of: Node, order: int) -> Node:
    return partial(_slope(of, order - 1), s) if order else of


TRUE = [
    (dot(_slope(r, 1), _slope(r, 2)), number(0), along, unit(tangent)),
    (
        dot(cross(_slope(r, 1), _slope(r, 2)), _slope(r, 3)),
        bend**2 * twist,
        *frenet,
        orthonormal(tangent, normal, binormal),
    ),
    (dot(_slope(r, 1), _slope(r, 4)), -3 * bend * partial(bend, s), *frenet, orthonormal(tangent, normal, binormal)),
    (_slope(bend, 5), 120 * bend**6, slope),
    (div(curl(v)), number(0)),
    (curl(grad(f)), NOTHING),
    (div(f * v), f * div(v) + dot(grad(f), v)),
    (curl(f * v), f * curl(v) + cross(grad(f), v)),
    (div(cross(u, v)), dot(v, curl(u)) - dot(u, curl(v))),
    (curl(cross(u, v)), u * div(v) - v * div(u) + convection(v, u) - convection(u, v)),
    (curl(curl(v)), grad(div(v)) - laplacian(v)),
    (div(T.T @ v), dot(div(T), v) + tr(T.T @ grad(v))),
    (laplacian(f * g), f * laplacian(g) + g * laplacian(f) + 2 * dot(grad(f), grad(g))),
    (curl(cross(w, x), x), 2 * w),
    (laplacian(1 / norm(x), x), number(0), nonzero(norm(x))),
    (grad(exp(f)), exp(f) * grad(f)),
    (rate(rho), partial(rho, t) + dot(v, grad(rho)), motion),
    (rate(v), partial(v, t) + convection(v, v), motion),
    (rate(rate(f)), dot(grad(f), rate(rate(x))) + rate(x).T @ grad(grad(f)) @ rate(x)),
    (partial(rho, t) + div(rho * v), number(0), motion, mass),
    (partial(rho * v, t) + div(rho * v @ v.T), div(S) + rho * u, motion, mass, momentum),
    (rate(om), convection(om, v) + m * laplacian(om), motion, spin, flow, solenoidal),
    (laplacian(f), number(0), potential, curled),
    (curl(curl(v)), -laplacian(v), solenoidal),
    (curl(v), NOTHING, potential),
    (div(v), laplacian(f), potential),
    (grad(n).T @ n, NOTHING, unit(n)),
    (grad(u).T @ n + grad(n).T @ u, NOTHING, perpendicular(u, n)),
    (T.T @ partial(T, x[1]) + (T.T @ partial(T, x[1])).T, 0 * T, rotation(T)),
    (rate(E), number(0), energy, newton),
    (partial(W, F), F @ (partial(W, C) + partial(W, C).T), stretch),
]
FALSE = [
    (dot(_slope(r, 1), _slope(r, 3)), bend**2, *frenet, orthonormal(tangent, normal, binormal)),
    (_slope(bend, 5), 24 * bend**6, slope),
    (div(f * v), f * div(v) - dot(grad(f), v)),
    (div(T @ v), dot(div(T), v) + tr(T.T @ grad(v))),
    (curl(curl(v)), laplacian(v), solenoidal),
    (grad(n) @ n, NOTHING, unit(n)),
    (rate(v), partial(v, t), motion),
    (partial(rho, t) + rho * div(v), number(0), motion, mass),
    (div(v), number(0), potential),
    (rate(E), m * rate(q) * rate(rate(q)), energy),
    (partial(partial(V, q), q), number(0), newton, nonzero(m)),
]


def _claim(left: Node, right: Node, *grounds: Any) -> Claim:
    given = tuple(each for each in grounds if isinstance(each, Statement))
    return Claim("1", left, right, given=given, assuming=tuple(each for each in grounds if each not in given))


@pytest.mark.parametrize("said", TRUE, ids=lambda said: plain(said[0]))
def test_what_holds_of_all_fields_is_proved(said: Any) -> None:
    claim = _claim(*said)
    verdict = Session().decide(claim).verdict
    assert isinstance(verdict, Holds | HoldsUnder), verdict
    check(claim, "printed", verdict.certificate)


@pytest.mark.parametrize("said", FALSE, ids=lambda said: plain(said[0]))
def test_what_fails_of_some_fields_is_refuted(said: Any) -> None:
    claim = _claim(*said)
    verdict = Session().decide(claim).verdict
    assert isinstance(verdict, Fails), verdict
    check_counterexample(problem_of(claim), verdict.counterexample)


REPAIRED = [
    (div(f * v), f * div(v) - dot(grad(f), v), f * div(v) + dot(grad(f), v)),
    (div(cross(u, v)), dot(v, curl(u)) + dot(u, curl(v)), dot(v, curl(u)) - dot(u, curl(v))),
    (curl(cross(w, x), x), w, 2 * w),
    (rate(v), partial(v, t) - convection(v, v), partial(v, t) + convection(v, v), motion),
]


@pytest.mark.parametrize("said", REPAIRED, ids=lambda said: plain(said[0]))
def test_a_slip_beside_an_operator_is_repaired(said: Any) -> None:
    left, right, meant, *grounds = said
    assert plain(repair(_claim(left, right, *grounds))[0].right) == plain(meant)


def test_nothing_is_refuted_where_what_follows_is_not_all_known() -> None:
    """Equations that lead to ever higher derivatives are not differentiated to the end: a point may be none."""
    higher = Condition("0.1", bend, partial(_slope(twist, 1) ** 2, s), on=(bend,))
    back = Condition("0.2", twist, partial(_slope(bend, 1) ** 2, s), on=(twist,))
    verdict = Session().decide(_claim(_slope(bend, 1), number(0), higher, back)).verdict
    assert not isinstance(verdict, Fails)


def test_what_a_condition_ties_is_not_differentiated_as_if_it_were_free() -> None:
    """On the sphere s depends on x: neither by a derivative nor by a gradient is it taken for a constant."""
    s = scalar("s", "s", "")
    sphere = Condition("0", s**2, 1 - dot(x, x), on=(s,))
    for said in (_claim(grad(s, x), NOTHING, sphere), _claim(partial(s, x).T, NOTHING, sphere)):
        assert isinstance(Session().decide(said).verdict, Undecided)


@pytest.mark.parametrize(
    ("word", "in_latex", "in_text"),
    [
        (div(f * v), r"\nabla \cdot \left( f \mathbf{v} \right)", "div (f v)"),
        (curl(v), r"\nabla \times \mathbf{v}", "curl v"),
        (laplacian(f), r"\nabla^2 f", "laplacian f"),
        (convection(u, v), r"\left( \mathbf{u} \cdot \nabla \right) \mathbf{v}", "(u . grad) v"),
        (2 * grad(f), r"2 \left( \nabla f \right)", "2 (grad f)"),
    ],
)
def test_operators_are_printed_with_nabla(word: Node, in_latex: str, in_text: str) -> None:
    assert (latex(word), plain(word)) == (in_latex, in_text)


@pytest.mark.parametrize(
    ("write", "told"),
    [
        (lambda: div(w), "has no field in it: say by what, as in div(w, x)"),
        (lambda: div(column(u, u), x), "the divergence of"),
        (lambda: field(w), "takes a symbol and what it depends on"),
        (lambda: field(w, 2 * x), "a field depends on symbols of known size, or rates of symbols, and 2 x is none"),
        (lambda: grad(f, 2 * x), "by is the expression 2 x"),
    ],
)
def test_mistakes_are_told(write: Any, told: str) -> None:
    with pytest.raises((WrongArgument, Misfit)) as error:
        write()
    assert told in str(error.value).replace("`", "")


def test_what_depends_on_a_letter_of_any_size_is_not_taken_for_constant() -> None:
    y, s = vector("y", "y", "", size=Size("n")), scalar("s", "s", "")
    square_of = Definition("0", s, y.T @ y)
    claim = _claim(partial(field(scalar("k", "k", ""), s), y), Zero(1, Size("n")), square_of)
    assert not isinstance(Session().decide(claim).verdict, Holds | HoldsUnder)
