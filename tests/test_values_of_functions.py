"""Functions that are not known, at expressions: what holds for every one of them, and what fails for some."""

from __future__ import annotations

from typing import Any

import pytest
import sympy as sp
from sympy import Derivative, Eq, Rational, cos, sin, sqrt

from chasles.prove import Rejected, Untreatable, prove, recheck
from chasles.verdict import Fails, Holds, HoldsUnder, Undecided

x, y, t, a, c, z = sp.symbols("x y t a c z", real=True)
r, s = sp.symbols("r s", positive=True)
f, g = sp.Function("f"), sp.Function("g")
X, Y = sp.Function("X")(t), sp.Function("Y")(t)
WAVE = f(x - c * t) + g(x + c * t)
POLAR = f(r * cos(a), r * sin(a))
FORCE = f(sqrt(X**2 + Y**2))


def _laplacian() -> Any:
    second = (f(x, y).diff(one, 2).subs({x: r * cos(a), y: r * sin(a)}) for one in (x, y))
    return sum(second)


@pytest.mark.parametrize(
    ("lhs", "rhs", "given"),
    [
        (WAVE.diff(t, 2), c**2 * WAVE.diff(x, 2), []),
        (Derivative(WAVE, t, 2), c**2 * Derivative(WAVE, x, 2), []),
        (Derivative(sin(x**2), x), 2 * x * cos(x**2), []),
        (Derivative(sin(x**2) * cos(a * x), x, x).doit(), Derivative(sin(x**2) * cos(a * x), x, 2), []),
        (Derivative(sin(sp.pi * x), x), sp.pi * cos(sp.pi * x), []),
        (POLAR.diff(r, 2) + POLAR.diff(r) / r + POLAR.diff(a, 2) / r**2, _laplacian(), []),
        (2 * s * f(x / sqrt(s)).diff(s), -x * f(x / sqrt(s)).diff(x), []),
        (f((x - 1) * (x + 1)), f(x**2 - 1), []),
        (f(g(2 * x)).diff(x), 2 * Derivative(f(g(2 * x)), g(2 * x)) * sp.Subs(Derivative(g(x), x), x, 2 * x), []),
        (
            (X * Y.diff(t) - Y * X.diff(t)).diff(t), 0,
            [Eq(X.diff(t, 2), FORCE * X), Eq(Y.diff(t, 2), FORCE * Y)],
        ),
        (f(0) * f(x), 1, [Eq(f(x), 2), Eq(f(0), Rational(1, 2))]),
    ],
)  # fmt: skip
def test_what_holds_for_all_values_holds_for_every_function(lhs: Any, rhs: Any, given: Any) -> None:
    verdict = prove(lhs, rhs, given)
    assert isinstance(verdict, Holds | HoldsUnder), verdict
    recheck(verdict, lhs, rhs, given)


@pytest.mark.parametrize(
    ("lhs", "rhs"),
    [
        (f(2 * x), 2 * f(x)),
        (f(x + y), f(x) + f(y)),
        (f(x), f(-x)),
        (f(0), f(1)),
        (f(x).diff(x), sp.Subs(Derivative(f(x), x), x, 0)),
    ],
)
def test_a_function_may_have_any_values_at_different_places(lhs: Any, rhs: Any) -> None:
    verdict = prove(lhs, rhs)
    assert isinstance(verdict, Fails), verdict
    recheck(verdict, lhs, rhs)


@pytest.mark.parametrize(
    ("lhs", "rhs", "given"),
    [
        (f(x), 1, [Eq(f(x).diff(x), 0), Eq(f(0), 1)]),  # true: it is constant
        (f(2 * x), 2 * f(x), [Eq(f(x + y), f(x) + f(y))]),  # true if it is given for all x and y
        (z, 2 * z, [Eq(f(x), 1), Eq(f(y), 2), Eq(x, y)]),  # nothing satisfies what is given
        (f(sp.Abs(x)), f(x), []),
    ],
)
def test_what_ties_values_to_each_other_refutes_nothing(lhs: Any, rhs: Any, given: Any) -> None:
    assert isinstance(prove(lhs, rhs, given), Undecided)


@pytest.mark.parametrize(
    ("lhs", "rhs"),
    [
        (sp.Subs(Derivative(f(x) * sp.Max(x, 0), x), x, 0), f(0) / 2),
        (sp.Subs(Derivative(f(x) * sp.Abs(x), x), x, 0), 0),
    ],
)
def test_what_has_a_kink_has_no_rate_there_beside_a_function_either(lhs: Any, rhs: Any) -> None:
    with pytest.raises(Untreatable, match="no derivative there"):
        prove(lhs, rhs)
    smooth = sp.Subs(Derivative(y * f(y), y), y, 2)
    assert isinstance(prove(smooth, f(2) + 2 * sp.Subs(Derivative(f(x), x), x, 2)), Holds)


def test_values_at_the_same_place_are_no_counterexample() -> None:
    verdict = prove(x * f(x), x * f(2 * x))
    assert isinstance(verdict, Fails)
    at = {**verdict.counterexample.at, "x": sp.Integer(0)}
    with pytest.raises(Rejected):
        recheck(Fails(type(verdict.counterexample)(at, (1, 1), "0", "0", "")), x * f(x), x * f(2 * x))


@pytest.mark.parametrize(
    ("left", "right", "given", "needs"),
    [
        (f(x), f(y), [Eq(x, y)], ("x = y",)),
        (x * f(x), y * f(y), [Eq(x, y)], ("x = y",)),
        (f(x + z), f(3 * y), [Eq(x, 2 * y), Eq(z, y)], ("x = 2*y", "z = y")),
        (f(x).diff(x), sp.Subs(f(y).diff(y), y, 2), [Eq(x, 2)], ("x = 2",)),
        (f(x, y), f(y, x), [Eq(x, y)], ("x = y",)),
        (f(x) + x, x + f(x), [Eq(x, y)], ()),
    ],
    ids=str,
)
def test_values_at_what_is_given_to_be_equal_are_the_same(left: Any, right: Any, given: Any, needs: Any) -> None:
    verdict = prove(left, right, given)
    assert isinstance(verdict, Holds | HoldsUnder)
    assert verdict.needs == needs
    recheck(verdict, left, right, given)
    if needs:
        assert not isinstance(prove(left, right), Holds | HoldsUnder)
        with pytest.raises(Rejected):
            recheck(Holds(verdict.certificate, verdict.witness), left, right, given)


@pytest.mark.parametrize("given", [Eq(x**2, y**2), Eq(x, 2 * y), Eq(y, x + 1)], ids=str)
def test_and_others_are_not(given: Any) -> None:
    assert not isinstance(prove(f(x), f(y), given), Holds | HoldsUnder)


@pytest.mark.parametrize(
    ("lhs", "rhs", "given"),
    [
        (f(x), f(y), [Eq(x, 2 * y)]),
        (f(x), f(y), [Eq(x**2, y**2)]),
        (f(x) * f(y), f(x * y), [Eq(x, 3 * y)]),
        (f(x), f(-x), [Eq(x, z)]),
        (f(x, y), f(y, x), [Eq(x, 2 * y)]),
    ],
)
def test_a_counterexample_is_looked_for_where_arguments_differ(lhs: Any, rhs: Any, given: list[Any]) -> None:
    verdict = prove(lhs, rhs, given=given)
    assert isinstance(verdict, Fails)
    recheck(verdict, lhs, rhs, given=given)
