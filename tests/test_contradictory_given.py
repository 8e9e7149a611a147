"""Side conditions that nothing satisfies are told as such, by a smallest set of them; others never are."""

from __future__ import annotations

from typing import Any

import pytest
import sympy as sp
from sympy import Eq, Matrix, cos, pi, sin, sqrt

from chasles.prove import prove
from chasles.verdict import Contradictory, Fails, Holds, HoldsUnder

x, y, z, a, t = sp.symbols("x y z a t")
p, q = sp.symbols("p q", positive=True)
m = sp.Symbol("m", negative=True)
n = sp.Symbol("n", integer=True)
even = sp.Symbol("k", even=True)
r = sp.Symbol("r", rational=True)
nonneg = sp.Symbol("N", nonnegative=True)
zero = sp.Symbol("o", zero=True)
u = Matrix(sp.symbols("u1:4"))
f, g = (sp.Function(name)(t) for name in "fg")

IMPOSSIBLE: list[tuple[list[Any], list[Any], set[str]]] = [
    ([Eq(x, 1), Eq(x, 2)], [], {"x = 1", "x = 2"}),
    ([Eq(x, 1), Eq(y, 3), Eq(x, 2)], [], {"x = 1", "x = 2"}),
    ([Eq(x + y, 1), Eq(x - y, 1), Eq(y, 1), Eq(z, 5)], [], {"x + y = 1", "x - y = 1", "y = 1"}),
    ([Eq(x * y, 1), Eq(x, 0)], [], {"x*y = 1", "x = 0"}),
    ([Eq(x, 0)], [x], {"x = 0", "x != 0"}),
    ([Eq(x * y, 0)], [x, y], {"x*y = 0", "x != 0", "y != 0"}),
    ([Eq(x**2, 0), Eq(y, 1)], [x], {"x**2 = 0", "x != 0"}),
    ([Eq(x, y)], [x - y], {"x = y", "x - y != 0"}),
    ([Eq(x**2 + 1, 0)], [], {"x**2 + 1 = 0"}),
    ([Eq(x**2 + y**2, -1)], [], {"x**2 + y**2 = -1"}),
    ([Eq(x**2 - 2 * x * y + 2 * y**2 + 1, 0)], [], {"x**2 - 2*x*y + 2*y**2 + 1 = 0"}),
    ([Eq(x**2 + x + 1, 0)], [], {"x**2 + x + 1 = 0"}),
    ([Eq(x**4 + x + 1, 0)], [], {"x**4 + x + 1 = 0"}),
    ([Eq(x**4 + y**2 + 3, 0)], [], {"x**4 + y**2 + 3 = 0"}),
    ([Eq(u.dot(u), 1), Eq(u.dot(u), 2)], [], {"u1**2 + u2**2 + u3**2 = 1", "u1**2 + u2**2 + u3**2 = 2"}),
    ([p + 1], [], {"p + 1 = 0", "p is positive"}),
    ([Eq(p, x), Eq(x, -1)], [], {"p = x", "x = -1", "p is positive"}),
    ([Eq(p + q, 0)], [], {"given[0] (false to SymPy)"}),
    ([Eq(p * q + x**2, 0)], [], {"p*q + x**2 = 0", "p is positive", "q is positive"}),
    ([Eq(p, m)], [], {"given[0] (false to SymPy)"}),
    ([Eq(m, x**2)], [], {"m = x**2", "m is negative"}),
    ([Eq(nonneg + 1, x), Eq(x, 0)], [], {"N + 1 = x", "x = 0", "N is nonnegative"}),
    ([Eq(2 * n, x), Eq(x, 1)], [], {"2*n = x", "x = 1", "n is integer"}),
    ([Eq(n**2, x), Eq(x, 2)], [], {"n**2 = x", "x = 2", "n is integer"}),
    ([Eq(even, x), Eq(x, 3)], [], {"k = x", "x = 3", "k is even"}),
    ([Eq(r**2, x), Eq(x, 2)], [], {"r**2 = x", "x = 2", "r is rational"}),
    ([], [zero], {"0 != 0"}),
    ([Eq(zero, x), Eq(x, 1)], [], {"o = x", "x = 1"}),
    ([Eq(cos(x), 2)], [], {"cos(x) = 2"}),
    ([Eq(sin(x), 1), Eq(cos(x), 1)], [], {"sin(x) = 1", "cos(x) = 1"}),
    ([Eq(sqrt(x), y), Eq(y, -1)], [], {"sqrt(x) = y", "y = -1"}),
    ([Eq(sqrt(x**2 + 1), 0)], [], {"sqrt(x**2 + 1) = 0"}),
    ([Eq(f, 0), Eq(f.diff(t), 1)], [], {"f(t) = 0", "Derivative(f(t), t) = 1"}),
    ([Eq(f.diff(t), 1), Eq(f.diff(t), 2), Eq(g, f)], [], {"Derivative(f(t), t) = 1", "Derivative(f(t), t) = 2"}),
    ([Eq(f.diff(t), g), Eq(g, 1), Eq(f, 3)], [], {"Derivative(f(t), t) = g(t)", "g(t) = 1", "f(t) = 3"}),
    ([Eq(Matrix([x, y]), Matrix([1, 2])), Eq(x, 3)], [], {"Matrix([[x], [y]]) = Matrix([[1], [2]])", "x = 3"}),
    ([Eq(a + y, pi), Eq(a + y, 2 * pi)], [], {"a + y = pi", "a + y = 2*pi"}),
]  # fmt: skip
POSSIBLE: list[tuple[list[Any], list[Any]]] = [
    ([Eq(x, 1), Eq(y, 2)], []),
    ([Eq(x, 1), Eq(x**2, 1)], []),
    ([Eq(x * y, 0)], [x]),
    ([Eq(x**2, 1)], [x - 1]),
    ([Eq(x**2 + y**2, 0)], []),
    ([Eq(x**2 - 1, 0)], []),
    ([Eq(x**2 - 2 * x + 1, 0)], []),
    ([Eq(u.dot(u), 1)], []),
    ([Eq(p, 1)], []),
    ([Eq(p**2, x), Eq(x, 4)], []),
    ([Eq(p - q, 0)], []),
    ([Eq(p, -m)], []),
    ([Eq(nonneg, 0)], []),
    ([Eq(nonneg + x**2, 0)], []),
    ([Eq(2 * n, x), Eq(x, 4)], []),
    ([Eq(n**2, x), Eq(x, 9)], []),
    ([Eq(even, x), Eq(x, 4)], []),
    ([Eq(r**2, x), Eq(x, sp.Rational(9, 4))], []),
    ([Eq(zero, x)], []),
    ([Eq(cos(x), 1)], []),
    ([Eq(sin(x), sp.Rational(3, 5)), Eq(cos(x), sp.Rational(-4, 5))], []),
    ([Eq(sqrt(x), y), Eq(y, 1)], []),
    ([Eq(f, 0), Eq(f.diff(t), 0)], []),
    ([Eq(f.diff(t), g), Eq(g, 1)], []),
    ([Eq(a + y, pi), Eq(a - y, pi)], []),
]


@pytest.mark.sampled(4)
@pytest.mark.parametrize(("given", "nonzero", "said"), IMPOSSIBLE)
def test_conditions_that_nothing_satisfies_are_told_and_none_to_spare(
    given: list[Any], nonzero: list[Any], said: set[str]
) -> None:
    for sides in ((z, 7), (z, z)):
        verdict = prove(*sides, given=given, nonzero=nonzero)
        assert isinstance(verdict, Contradictory), verdict
        assert set(verdict.hypotheses) == said


def test_a_divisor_that_vanishes_everywhere_is_told() -> None:
    divisor = sin(x) ** 2 + cos(x) ** 2 - 1
    assert prove(1 / divisor, 0) == Contradictory((f"{divisor} != 0",), prove(1 / divisor, 0).certificate)


@pytest.mark.sampled(4)
@pytest.mark.parametrize(("given", "nonzero"), POSSIBLE)
def test_conditions_that_something_satisfies_do_not_contradict_each_other(given: list[Any], nonzero: list[Any]) -> None:
    assert isinstance(prove(z, z, given=given, nonzero=nonzero), Holds | HoldsUnder)
    assert isinstance(prove(z, 7, given=given, nonzero=nonzero), Fails)


@pytest.mark.sampled(3)
@pytest.mark.parametrize("claim", [x > 0, x >= 0, Eq(sp.Max(x, y), 1), Eq(sp.Abs(x), y), sp.Or(x > 1, y > 1)], ids=str)
@pytest.mark.parametrize(
    "given", [sp.false, x < x - 1, x**2 < 0, Eq(x**2, -1, evaluate=False), Eq(x, x + 1, evaluate=False)], ids=str
)
def test_contradictory_conditions_are_told_whatever_is_claimed(claim: Any, given: Any) -> None:
    assert isinstance(prove(claim, given=[given]), Contradictory)


def test_a_sign_that_is_given_has_a_value_at_zero() -> None:
    assert not isinstance(prove(sp.Max(x, y) > 0, given=[Eq(sp.sign(x), 0)]), Contradictory)
