"""Functions of time with given equations: no true consequence fails, no false one holds, points lie on solutions."""

from __future__ import annotations

from fractions import Fraction
from itertools import permutations
from typing import Any

import pytest
import sympy as sp
from sympy import Eq, Matrix, cos, sin, sqrt

from chasles.prove import Rejected, Untreatable, prove, recheck
from chasles.verdict import Contradictory, Counterexample, Fails, Holds, HoldsUnder, Undecided

t, s, x, k, c, omega = sp.symbols("t s x k c omega")
m, length, grav = sp.symbols("m l g", positive=True)
f, g, h, th, ph, r, la = (sp.Function(name)(t) for name in ("f", "g", "h", "th", "ph", "r", "la"))
X, Y, Z = (sp.Function(name)(t) for name in "XYZ")
J = sp.symbols("J1:4")
w = Matrix([sp.Function(f"w{i}")(t) for i in (1, 2, 3)])
e = Matrix([sp.Function(f"e{i}")(t) for i in (1, 2, 3)])
R = Matrix(3, 3, [sp.Function(f"R{i}{j}")(t) for i in (1, 2, 3) for j in (1, 2, 3)])


def d(expression: Any, times: int = 1) -> Any:
    return sp.diff(expression, t, times)


def skew(v: Any) -> Any:
    return Matrix([[0, -v[2], v[1]], [v[2], 0, -v[0]], [-v[1], v[0], 0]])


EULER = [Eq(J[i] * d(w[i]), (J[i - 2] - J[i - 1]) * w[i - 2] * w[i - 1]) for i in range(3)]
POLAR = [Eq(d(r, 2) - r * d(th) ** 2, -k / r**2), Eq(r * d(th, 2) + 2 * d(r) * d(th), 0)]
ON_CIRCLE = [Eq(d(X, 2), -la * X), Eq(d(Y, 2), -la * Y - grav), Eq(X**2 + Y**2, length**2)]
ROTATION = [Eq(d(X), -omega * Y), Eq(d(Y), omega * X)]
TRUE: list[tuple[Any, Any, list[Any]]] = [
    (d(th, 2) + th + sin(th), sin(th), [Eq(d(th, 2), -th)]),
    (sin(th) * d(th), sin(th) * th, [Eq(d(th), th)]),
    (cos(th) * d(th, 2), -cos(th) * (d(th) + th), [Eq(d(th, 2), -d(th) - th)]),
    (d(f, 2) + sin(f), f + sin(f), [Eq(f, d(g)), Eq(g, d(f))]),
    (sin(f) * d(f, 3), sin(f) * d(f), [Eq(f, d(g)), Eq(g, d(f))]),
    (d(th, 3) * cos(th), -d(th) * cos(th), [Eq(d(th, 2), -th)]),
    (sin(th + ph), sin(2 * th), [Eq(ph, th)]),
    (d(sin(ph)), d(th) * cos(th), [Eq(ph + th, sp.pi)]),
    (sin(ph) * d(ph), sin(d(th)) * d(th, 2), [Eq(ph, d(th))]),
    (h, 0, [Eq(f, 0), Eq(g, d(f)), Eq(h, d(g))]),
    (g, d(f, 2), [Eq(d(X), f), Eq(d(Y), g), Eq(Y, d(f))]),
    (d(f, 2), -f, [Eq(d(f), g), Eq(d(g), -f)]),
    (d(f, 4), f, [Eq(d(f), g), Eq(d(g), -f)]),
    (d(f**2 + d(f) ** 2), 0, [Eq(d(f, 2), -f)]),
    (d(f**2 / 2 + d(f) ** 2 / 2), -c * d(f) ** 2, [Eq(d(f, 2), -f - c * d(f))]),
    (d(m * d(X) ** 2 / 2 + k * X**2 / 2), 0, [m * d(X, 2) + k * X]),
    (d(d(th) ** 2 / 2 - omega**2 * cos(th)), 0, [Eq(d(th, 2), -(omega**2) * sin(th))]),
    (d(m * length**2 * d(th) ** 2 / 2 - m * grav * length * cos(th)), 0,
     [m * length**2 * d(th, 2) + m * grav * length * sin(th)]),
    (X * d(X) + Y * d(Y), 0, [Eq(X**2 + Y**2, 1)]),
    (X * d(X, 2) + Y * d(Y, 2), -(d(X) ** 2) - d(Y) ** 2, [Eq(X**2 + Y**2, 1)]),
    (d(X**2 + Y**2), 0, ROTATION),
    (X**2 + Y**2, 1, [*ROTATION, Eq(X**2 + Y**2, 1)]),
    (d(X, 2), -(omega**2) * X, [*ROTATION, Eq(X**2 + Y**2, 1)]),
    (la * length**2, d(X) ** 2 + d(Y) ** 2 - grav * Y, ON_CIRCLE),
    (d((d(X) ** 2 + d(Y) ** 2) / 2 + grav * Y), 0, ON_CIRCLE),
    (d(r**2 * d(th)), 0, POLAR),
    (d(d(r) ** 2 / 2 + r**2 * d(th) ** 2 / 2 - k / r), 0, POLAR),
    (d(sum(J[i] * w[i] ** 2 for i in range(3)) / 2), 0, EULER),
    (d(sum(J[i] ** 2 * w[i] ** 2 for i in range(3))), 0, EULER),
    (e.dot(d(e)), 0, [Eq(e.dot(e), 1)]),
    (d(e.dot(e)), 0, list(d(e) - w.cross(e))),
    (w.dot(d(e)), 0, [d(e) - w.cross(e), Eq(e.dot(e), 1)]),
    (f, 0, [Eq(f * t, 0), Eq(f, 0)]),
    (d(f), 2 * t, [Eq(f, t**2)]),
    (d(f, 2), 2, [Eq(f, t**2)]),
    (d(f) * t + f, 0, [Eq(f * t, c)]),
    (d(f) * f, g * d(g), [Eq(f, sqrt(1 + g**2))]),
]  # fmt: skip
FALSE: list[tuple[Any, Any, list[Any]]] = [
    (d(th, 2) + th + sin(th), cos(th), [Eq(d(th, 2), -th)]),
    (d(th), -th, [Eq(d(th), th)]),
    (sin(th) * d(th), sin(th), [Eq(d(th), th)]),
    (d(th, 2), -th, [Eq(d(th, 2), -d(th) - th)]),
    (d(f, 2), -f, [Eq(f, d(g)), Eq(g, d(f))]),
    (f, g, [Eq(f, d(g)), Eq(g, d(f))]),
    (sin(ph), sin(2 * th), [Eq(ph, th)]),
    (d(sin(ph)), -d(th) * cos(th), [Eq(ph + th, sp.pi)]),
    (d(f, 2), f, [Eq(d(f), g), Eq(d(g), -f)]),
    (f, 1, [Eq(d(f), g), Eq(d(g), -f)]),
    (d(f**2 / 2 + d(f) ** 2 / 2), 0, [Eq(d(f, 2), -f - c * d(f))]),
    (d(m * d(X) ** 2 / 2 - k * X**2 / 2), 0, [m * d(X, 2) + k * X]),
    (d(d(th) ** 2 / 2 + omega**2 * cos(th)), 0, [Eq(d(th, 2), -(omega**2) * sin(th))]),
    (X * d(X) - Y * d(Y), 0, [Eq(X**2 + Y**2, 1)]),
    (X * d(X, 2) + Y * d(Y, 2), 0, [Eq(X**2 + Y**2, 1)]),
    (d(X * Y), 0, ROTATION),
    (X, 1, [*ROTATION, Eq(X**2 + Y**2, 1)]),
    (d(X, 2), omega**2 * X, [*ROTATION, Eq(X**2 + Y**2, 1)]),
    (la * length**2, d(X) ** 2 + d(Y) ** 2 + grav * Y, ON_CIRCLE),
    (d(r * d(th)), 0, POLAR),
    (d(d(r) ** 2 / 2 + r**2 * d(th) ** 2 / 2 + k / r), 0, POLAR),
    (d(sum(J[i] * w[i] for i in range(3))), 0, EULER),
    (d(w[0]), 0, EULER),
    (d(e.dot(d(e))), 1, [Eq(e.dot(e), 1)]),
    (d(e), sp.zeros(3, 1), [d(e) - w.cross(e), Eq(e.dot(e), 1)]),
    (d(f), t, [Eq(f, t**2)]),
    (f, 0, [Eq(f * g, 0)]),
    (d(f) * f, g, [Eq(f, sqrt(1 + g**2))]),
]  # fmt: skip


def name(case: Any) -> str:
    return " ".join(str(case).split())[:50]


@pytest.mark.sampled(5)
@pytest.mark.parametrize(("lhs", "rhs", "given"), TRUE, ids=name)
def test_what_follows_from_equations_of_motion_holds(lhs: Any, rhs: Any, given: list[Any]) -> None:
    verdict = prove(lhs, rhs, given=given)
    assert isinstance(verdict, Holds | HoldsUnder), verdict
    recheck(verdict, lhs, rhs, given=given)


@pytest.mark.sampled(5)
@pytest.mark.parametrize(("lhs", "rhs", "given"), FALSE, ids=name)
def test_what_does_not_follow_from_them_fails(lhs: Any, rhs: Any, given: list[Any]) -> None:
    assert isinstance(prove(lhs, rhs, given=given), Fails)


@pytest.mark.sampled(6)
@pytest.mark.parametrize(
    ("lhs", "rhs", "given"),
    [
        (f, 0, [Eq(f * t, 0)]),
        (f, 0, [Eq(f * t**2, 0)]),
        (f, g, [Eq(t * f, t * g)]),
        (X, Y, [Eq(d(X) + d(Y), X), Eq(d(X) + d(Y), Y)]),
        (d(X), d(Y), [Eq(d(X) + d(Y), X), Eq(d(X) + d(Y), Y)]),
        (d(f), 0, [Eq(d(f) ** 2, 0)]),
        (f, 0, [Eq(f**2 + d(f) ** 2, 0)]),
        (d(f, 2), 0, [Eq(d(f) ** 2, 1)]),
        (X, 0, [Eq(d(X), Y), Eq(d(Y), X), Eq(X * Y, 0)]),
        (f, t, [Eq((f - t) ** 2, 0)]),
        (f * d(g), 0, [Eq(f * g, 0)]),
        (d(r), 0, [Eq(r**3, 8)]),
        (la, 0, [Eq(d(X), la), Eq(d(Y), la), Eq(X + Y, 1)]),
        (la, 0, [Eq(d(X), la * Y), Eq(d(Y), la * X), Eq(X**2 + Y**2, 1), Eq(X, Y)]),
        (d(f) - g, 0, [Eq(sin(f), sin(h)), Eq(d(h), g), Eq(cos(f), cos(h))]),
        (f, h, [Eq(d(g), f), Eq(d(g), h)]),
        (c, 0, [Eq(d(f), c), Eq(f, 1)]),
        (c, k, [Eq(d(f), c), Eq(d(f), k)]),
    ],
    ids=name,
)  # fmt: skip
def test_what_holds_at_all_times_does_not_fail_because_of_a_single_instant(lhs: Any, rhs: Any, given: Any) -> None:
    """At an instant alone each of these could be wrong."""
    verdict = prove(lhs, rhs, given=given, budget=4)
    assert isinstance(verdict, Holds | HoldsUnder | Undecided), verdict


def test_a_point_through_which_nothing_moves_refutes_nothing_where_no_rate_occurs() -> None:
    forged = Fails(Counterexample({"f(t)": Fraction(1), "t": Fraction(0)}, (1, 1), "1", "0"))
    with pytest.raises(Rejected):
        recheck(forged, f, 0, given=[Eq(f * t, 0)])


@pytest.mark.sampled(3)
@pytest.mark.parametrize(
    ("lhs", "rhs", "given"),
    [
        (f, 1, [Eq(f, 0), Eq(d(f), 1)]),
        (f, 1, [Eq(d(f), 1), Eq(d(f), 2)]),
        (x, 1, [Eq(d(X), Y), Eq(d(Y), X), Eq(X**2 + Y**2, 1)]),
        (X, 1, [Eq(X**2 + Y**2, 1), Eq(X * d(X) + Y * d(Y), 1)]),
        (e.dot(d(e)), 1, [Eq(e.dot(e), 1), Eq(e.dot(d(e)), 1)]),
        (f, t, [Eq(t * f, 1), Eq(t * d(f) + f, 1)]),
    ],
    ids=name,
)
def test_nothing_holds_or_fails_where_no_function_satisfies_the_equations(lhs: Any, rhs: Any, given: Any) -> None:
    for side in (rhs, lhs):
        assert isinstance(prove(lhs, side, given=given, budget=4), Contradictory | Undecided)


def test_functions_of_several_variables_are_refused_where_they_would_have_to_be_differentiated() -> None:
    u = sp.Function("u")(x, t)
    with pytest.raises(Untreatable, match="of several variables are not differentiated"):
        prove(u.diff(t, x) + d(f), 0, given=[Eq(u, 0)])
    assert isinstance(prove(u.diff(t, x) + d(f), 0, given=[Eq(f, sp.Function("q")(s))]), Fails)


@pytest.mark.sampled(3)
@pytest.mark.parametrize("order", list(permutations(range(3))))
@pytest.mark.parametrize(("left", "right"), [(3 * f * g, 2 * f * g - 2 * d(g) ** 2), (d(f), g), (f, 0)])
def test_what_is_contradictory_later_is_contradictory(left: Any, right: Any, order: tuple[int, ...]) -> None:
    """With f' = g the second rate of f is the first one of g, which is said to be zero, and one."""
    given = [Eq(d(f), g), Eq(d(g), 0), Eq(d(f, 2), 1)]
    assert isinstance(prove(left, right, given=[given[place] for place in order]), Contradictory)
