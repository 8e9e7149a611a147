"""Inequalities that are given to `prove`: signs, differences, and angles between multiples of pi."""

from __future__ import annotations

from dataclasses import replace
from fractions import Fraction
from typing import Any

import pytest
import sympy as sp
from sympy import Abs, Eq, Max, Min, Ne, Piecewise, Rational, acos, asin, atan, atan2, cos, log, pi, sin, sqrt, tan

from chasles.checker.expressions.bounded_angles import between
from chasles.prove import Rejected, Untreatable, prove, recheck
from chasles.verdict import Contradictory, Counterexample, Fails, Holds, HoldsUnder

x, y, z = sp.symbols("x y z", real=True)
X = sp.Symbol("X")
p = sp.Symbol("p", positive=True)
n = sp.Symbol("n", integer=True)
Z = sp.Symbol("Z", complex=True)
a, b = sp.symbols("a b", real=True)
u, v = sp.symbols("u v", nonnegative=True)
w, q, m, c, k = sp.symbols("w q m c k", positive=True)
t, s = sp.symbols("t s")
f, g = (sp.Function(name)(t) for name in "fg")
TRUE: list[tuple[Any, Any, list[Any]]] = [
    (sqrt(x**2), x, [x > 0]),
    (sqrt(x**2), -x, [Rational(0) >= x]),
    (sqrt(X**2), X, [X >= 0]),
    (Abs(x - y), x - y, [x > y]),
    (Abs(x * y - z), z - x * y, [z > x * y]),
    (Max(x, y), x, [x >= y]),
    (Min(x, y, z), z, [x >= y, z < y]),
    (Max(x, y, z), x, [x >= y, y >= z]),
    (Piecewise((x, x > y), (y, True)), x, [x >= y]),
    (sqrt((x - 1) ** 2) + sqrt(x**2), 1, [x > 0, x < 1]),
    (sqrt(x * y), sqrt(-x) * sqrt(-y), [x < 0, y < 0]),
    (log(x / y), log(x) - log(y), [x > 1, y > 1]),
    (sqrt(x**2 - 2 * x * y + y**2), x - y, [x > y, y > 0]),
    (sqrt(x + 2 * sqrt(x - 1)), sqrt(x - 1) + 1, [x >= 1]),
    (acos(x), 2 * atan(sqrt((1 - x) / (1 + x))), [Abs(x) < 1]),
    (atan2(y, x), atan(y / x) + pi, [x < 0, y > 0]),
    (x * y / y, x, [Ne(y, 0)]),
    (Abs(n), n, [n > -1]),
    (Abs(n), -n, [n < 1]),
    (Abs(n - 3), n - 3, [n > Rational(5, 2)]),
    (Abs(n - 2), 2 - n, [2 * n <= 5]),
    (n, 1, [n >= 1, n < Rational(3, 2)]),
    (Abs(sp.floor(x) - 1), sp.floor(x) - 1, [3 * sp.floor(x) > 1]),
    (Abs(x), x, [sp.exp(x) > 1]),
    (Abs(x - y), y - x, [sp.exp(x) < sp.exp(y)]),
    (Abs(x - 1), 1 - x, [atan(x) <= pi / 4]),
    (Abs(x * y), x * y, [sp.sinh(x * y) >= 0]),
    (Abs(Z - Z), 0, [Abs(Z) < 1]),
    (Abs(2 + sp.re(Z)), 2 + sp.re(Z), [Abs(Z + sp.conjugate(Z)) < 2]),
    (sqrt(f**2), f, [f > 0]),
    (sqrt((f - g) ** 2).diff(t), f.diff(t) - g.diff(t), [f > g]),
    (acos(cos(x)), x, [x >= 0, x <= pi]),
    (Abs(sin(x / 2)), sin(x / 2), [x >= 0, x <= pi]),
    (acos(cos(x)), 2 * pi - x, [x > pi, x < 2 * pi]),
    (asin(sin(x)), x, [Abs(x) <= pi / 2]),
    (asin(sin(x)), pi - x, [x >= pi / 2, x <= 3 * pi / 2]),
    (atan(tan(x)), x, [Abs(x) < pi / 2]),
    (atan(tan(x)), x, [x > 0, x > -pi / 2, x < 2, x < pi / 2]),
    (Abs(x - 1), x - 1, [x >= 1, x > 0, x > 1]),
    (atan2(sin(x), cos(x)), x, [x > -pi, x <= pi]),
    (atan2(sin(x), cos(x)), x - 2 * pi, [x > pi, x <= 3 * pi]),
    (sqrt((1 - cos(x)) / 2), sin(x / 2), [x >= 0, x <= 2 * pi]),
    (tan(x / 2), sqrt((1 - cos(x)) / (1 + cos(x))), [x >= 0, x < pi]),
    (Abs(sin(x)), -sin(x), [x > pi, x < 2 * pi]),
    (acos(cos(p)), p, [p <= pi]),
    (acos(cos(x)), x, [x > pi / 4, x <= pi / 2]),
    (Max(x, x**2), x, [x >= 0, x <= 1]),
    (Max(x, x**2), x**2, [x >= 1]),
    (Min(x, 1 / x), x, [x > 0, x <= 1]),
    (Piecewise((a, Abs(x) < 1), (b, True)), a, [x > -1, x < 1]),
    (Piecewise((a, x**2 <= 1), (b, True)), a, [x >= -1, x <= 1]),
    (Abs(cos(x)), cos(x), [x >= -pi / 3, x <= pi / 3]),
    (sqrt(1 - sin(2 * x)), cos(x) - sin(x), [x >= 0, x <= pi / 4]),
    (asin(2 * x * sqrt(1 - x**2)), 2 * asin(x), [x >= -1 / sqrt(2), x <= 1 / sqrt(2)]),
    (2 * atan(x), asin(2 * x / (1 + x**2)), [x >= -1, x <= 1]),
]
FAST = (a + b) / (1 + a * b)
DAMPED = sp.exp(-q * w * t) * cos(w * sqrt(1 - q**2) * t)
BETWEEN: list[tuple[Any, Any, list[Any]]] = [
    (1 / sqrt(1 - FAST**2), (1 + a * b) / sqrt(1 - a**2) / sqrt(1 - b**2), [Abs(a) < 1, Abs(b) < 1]),
    (sp.atanh(a) + sp.atanh(b), sp.atanh(FAST), [a > -1, a < 1, b > -1, b < 1]),
    (DAMPED.diff(t, 2) + 2 * q * w * DAMPED.diff(t), -(w**2) * DAMPED, [q < 1]),
    (sqrt(m**2 - 2 * m * k + k**2), m - k, [m > k]),
    (sqrt((x - y) ** 2) + sqrt((z - x) ** 2), z - y, [x >= y, x < z]),
    (sqrt((4 * k * m - c**2) ** 2), 4 * k * m - c**2, [c**2 < 4 * k * m]),
    (Abs(x), x, [x > 1, x <= 3]),
    (sqrt((1 - q * cos(x)) ** 2), 1 - q * cos(x), [q < 1]),
    (sqrt(f.diff(t) ** 2), f.diff(t), [f.diff(t) > 0]),
    (sqrt((f.diff(t) - g.diff(t)) ** 2), f.diff(t) - g.diff(t), [f.diff(t) > g.diff(t)]),
    (sqrt(f.diff(t) ** 2), f, [Eq(f.diff(t), -f), f > y, y > 0]),
    (Abs(x + f), x + f, [x + f > 0]),
]
WITH_ENDS: list[tuple[Any, Any, list[Any]]] = [
    (sp.atan(tan(x)), x, [x >= -pi / 2, x <= pi / 2]),
    (x, pi / 2, [Eq(sin(x), 1), x >= 0, x <= pi]),
    (x, pi / 2, [Eq(sin(x), 1), x > 0, x < pi]),
    (x, 0, [Eq(cos(x), 1), x >= -pi / 2, x <= pi / 2]),
    (x, acos(y), [Eq(cos(x), y), x >= 0, x <= pi]),
    (x, y, [Eq(sin(x), sin(y)), x >= -pi / 2, x <= pi / 2, y >= -pi / 2, y <= pi / 2]),
    (x, 3 * pi / 2, [Eq(sin(x), -1), x >= 0, x < 2 * pi]),
]
NONE_IS_NEGATIVE: list[tuple[Any, Any, list[Any]]] = [
    (u, 0, [Eq(u + v, 0)]),
    (x, 0, [Eq(x**2 + v, 0)]),
    (x * y, 0, [Eq(u * x**2 + p * y**2, 0)]),
    (u * x, 0, [Eq(u * x**2 + v, 0)]),
    (f.diff(t), 0, [Eq(f**2 + u, 0)]),
]
FALSE: list[tuple[Any, Any, list[Any]]] = [
    (asin(sin(x)), x, [x > pi / 4, x <= 2 * pi]),
    (atan(tan(x)), x, [x >= pi / 6, x < 2 * pi]),
    (sqrt(x**2), x, [x < 0]),
    (Abs(x), x, [sp.exp(x) > Rational(1, 2)]),
    (Abs(x - y), y - x, [sp.exp(-x) < sp.exp(-y)]),
    (Abs(n - 3), n - 3, [2 * n >= 3]),
    (Abs(x - 3), x - 3, [x > Rational(5, 2)]),
    (sqrt(x**2), x, [x > -1]),
    (x, y, [x > y]),
    (Max(x, y, z), x, [x >= y, z >= y]),
    (Max(x, y), x, [x > -1]),
    (Piecewise((x, x > y), (y - 1, True)), x, [x >= y]),
    (f.diff(t), 0, [f > 0]),
    (sqrt(f.diff(t) ** 2), f.diff(t), [f > 0]),
    (sqrt((1 - q * cos(x)) ** 2), 1 - q * cos(x), [q < 2]),
    (x, 0, [Eq(u * x**2 + v, 0)]),
    (u, 0, [Eq(u * x**2 + v, 0)]),
    (u, 0, [Eq(u - v, 0)]),
    (asin(sin(x)), x, [Abs(x) <= pi]),
    (acos(cos(x)), x, [x > -pi / 3, x < pi / 2]),
    (sqrt((1 + cos(x)) / 2), cos(x / 2), [x >= 0, x <= 2 * pi]),
    (acos(cos(x)), 2 * pi - x, [x > pi / 2, x < 2 * pi]),
]


@pytest.mark.sampled(7)
@pytest.mark.parametrize(("left", "right", "given"), [*TRUE, *BETWEEN, *WITH_ENDS, *NONE_IS_NEGATIVE], ids=str)
def test_what_holds_where_they_do_is_proved(left: Any, right: Any, given: list[Any]) -> None:
    verdict = prove(left, right, given)
    assert isinstance(verdict, Holds | HoldsUnder)
    recheck(verdict, left, right, given)


@pytest.mark.sampled(3)
@pytest.mark.parametrize(("left", "right", "given"), [BETWEEN[k] for k in (0, 1, 2, 4, 6, 7, 8, 9, 11)], ids=str)
def test_the_verdict_says_between_what_a_symbol_is(left: Any, right: Any, given: list[Any]) -> None:
    verdict = prove(left, right, given)
    assert isinstance(verdict, HoldsUnder)
    assert any(" = " in need and "d_1" in need for need in verdict.needs)
    assert not verdict.unused


@pytest.mark.sampled(3)
@pytest.mark.parametrize(("left", "right", "given"), FALSE, ids=str)
def test_what_fails_somewhere_where_they_hold_is_refuted_there(left: Any, right: Any, given: list[Any]) -> None:
    verdict = prove(left, right, given)
    assert isinstance(verdict, Fails)
    recheck(verdict, left, right, given)
    at = {symbol: verdict.counterexample.at.get(str(symbol)) for e in given for symbol in e.free_symbols - {t}}
    if at and None not in at.values():
        assert all(e.subs({symbol: sp.sympify(value) for symbol, value in at.items()}) == sp.true for e in given)


@pytest.mark.parametrize(
    ("side", "given", "pole"),
    [
        (1 / tan(x), [x > 0, x <= 2 * pi], cos(x)),
        (1 / (1 + tan(x)), [x > 0, x <= 2 * pi], cos(x)),
        (tan(x) ** -2, [x > 0, x <= pi], cos(x)),
        (1 / (1 + 1 / x), [x > -1, x < 1], x),
        (1 / (1 + 1 / (x - y)), [x > -1, x < 1, y >= 0], x - y),
    ],
    ids=str,
)
@pytest.mark.parametrize("other", [0, 1, 2])
def test_no_counterexample_is_where_something_inside_of_a_divisor_is_divided_by_zero(
    side: Any, given: list[Any], pole: Any, other: int
) -> None:
    verdict = prove(side, other, given=given)
    assert isinstance(verdict, Fails)
    recheck(verdict, side, other, given=given)
    at = verdict.counterexample.at
    assert pole.xreplace({e: sp.sympify(at.get(e.name, 0)) for e in (x, y)}) != 0


def test_what_is_divided_by_inside_of_a_divisor_is_needed() -> None:
    verdict = prove(1 / (1 + 1 / x), x / (x + 1), given=[x > -1, x < 1])
    assert isinstance(verdict, HoldsUnder)
    assert "d_1 - 1 != 0" in verdict.needs
    assert not verdict.unused


@pytest.mark.parametrize(
    ("side", "given", "need"),
    [
        (Abs(x) / x, [x >= 0], "x != 0"),
        (sqrt(x**2) / x, [x >= 0], "x != 0"),
        (-x / Abs(x), [Rational(0) >= x], "x != 0"),
        (Abs(x) / x, [x >= 0, x < 1], "d_1/(d_1 + 1) != 0"),
        (Abs(x - 1) / (x - 1), [x >= 1], "d_1 != 0"),
        (Abs(f) / f, [f >= 0], "f(t) != 0"),
    ],
    ids=str,
)
def test_what_a_sign_cancels_is_needed(side: Any, given: list[Any], need: str) -> None:
    verdict = prove(side, 1, given)
    recheck(verdict, side, 1, given)
    assert isinstance(verdict, HoldsUnder)
    assert need in verdict.needs
    assert isinstance(prove(Abs(x) / x, 1, [x > 0]), Holds)


PARTIAL = [1 / x, log(x), sqrt(x), tan(x), acos(x), atan2(y, x), x**z]


@pytest.mark.parametrize("part", PARTIAL)
def test_what_two_sides_have_in_common_has_to_be_defined(part: Any) -> None:
    """It cancels where one side is subtracted from the other, in what is claimed and in what is given."""
    (need,) = prove(part, part).needs
    for more, relation in ((1, sp.Gt), (b**2, sp.Ge), (0, sp.Ge)):
        claim = relation(part + more, part, evaluate=False)
        verdict = prove(claim)
        assert verdict.needs == (need,)
        recheck(verdict, claim)
    for condition, sign in ((b + part > part, 1), (sp.Ne(b + part, part), sp.sign(b)), (b * (1 + part) < b * part, -1)):
        verdict = prove(sp.Matrix([0, Abs(b)]), sp.Matrix([0, sign * b]), given=condition)
        assert need in verdict.needs


@pytest.mark.parametrize("part", [tan(p), cos(p), 1 / sin(p)])
def test_an_angle_may_be_compared_beside_functions_of_it(part: Any) -> None:
    for condition in (Eq(p + part, part + 2 * pi), sp.Le(p + part, part + 2 * pi, evaluate=False)):
        assert not prove(p**2 / p, p, given=condition).wrong


@pytest.mark.parametrize(
    "claim", [sp.Ne(sqrt(X) * sqrt(s), -1), sp.Not(Eq(sqrt(X) * sqrt(s) + 3, 2)), Ne(sqrt(X) + s, s - 1)]
)
def test_what_is_compared_in_a_condition_has_to_be_real(claim: Any) -> None:
    """Roots of negative numbers are imaginary, so that a product of two is -1 where what is asked is not meant."""
    verdict = prove(claim)
    assert "X >= 0" in verdict.needs
    recheck(verdict, claim)
    different = Ne(sqrt(log(u)) * sqrt(atan(X)), sqrt(log(u) * atan(X)))
    at = prove(different).counterexample.at
    assert at["X"] >= 0
    assert at["u"] >= 1


@pytest.mark.parametrize("function", [log, sp.acosh, sqrt, sp.asin, sp.atanh, lambda e: 1 / sqrt(e), lambda e: e**pi])
def test_what_cancels_at_a_counterexample_has_to_be_real(function: Any) -> None:
    """SymPy has 0 for log(-2) - log(-2)."""
    claim = function(X) > function(s)
    same = Eq(function(X), function(s))
    forged = Counterexample({"X": Fraction(-2), "s": Fraction(-2)}, (1, 1), "0", "1")
    with pytest.raises(Rejected):
        recheck(Fails(forged), claim)
    with pytest.raises(Rejected):
        recheck(Fails(replace(forged, left="-2", right="4")), X, s**2, given=[same])
    for found in (prove(claim, given=[s <= X]), prove(X, X + 1, given=[same])):
        assert isinstance(found, Fails)
        at = function(sp.sympify(found.counterexample.at["X"]))
        assert at.is_real


@pytest.mark.parametrize(
    "given", [[x > 1, x < 0], [x > y, y > x], [x > y, y >= x], [p < 0], [x > 1, Eq(x, 1)]], ids=str
)
def test_what_nothing_satisfies_is_contradictory(given: list[Any]) -> None:
    assert isinstance(prove(x, 2 * y, given), Contradictory)


@pytest.mark.sampled(4)
@pytest.mark.parametrize(("left", "right", "given"), TRUE[:12] + TRUE[20:26], ids=str)
def test_a_proof_does_not_do_without_them(left: Any, right: Any, given: list[Any]) -> None:
    verdict = prove(left, right, given)
    assert isinstance(verdict, Holds | HoldsUnder)
    with pytest.raises(Rejected):
        recheck(verdict, left, right)
    opposite = [type(e)(e.rhs, e.lhs) for e in given if not e.has(Abs)]
    if opposite:
        with pytest.raises(Rejected):
            recheck(verdict, left, right, opposite)


def test_an_exponential_of_a_complex_number_does_not_say_that_it_is_real() -> None:
    assert not prove(sp.im(Z), 0, given=[sp.exp(Z) > 1]).true


def test_one_between_functions_of_different_variables_is_refused() -> None:
    with pytest.raises(Untreatable, match="compares functions of different variables"):
        prove(x, y, [f > sp.Function("h")(s)])


@pytest.mark.parametrize("after", [True, False])
@pytest.mark.parametrize("before", [True, False])
@pytest.mark.parametrize(("low", "high"), [(0, 1), (-1, 1), (0, 2), (-2, 2), (-1, 2), (0, 3), (1, 4), (-4, 4), (0, 8)])
def test_an_angle_between_two_has_all_values_between_them_and_no_other(
    low: int, high: int, after: bool, before: bool
) -> None:
    """In eighths of a turn: the values at small and large numbers come near both ends and stay between them."""
    least, most = low * pi / 4, high * pi / 4
    symbols = dict[str, Any]()

    def fresh(name: str, **assumed: bool) -> Any:
        return symbols.setdefault(name, sp.Symbol(name, real=True, **assumed))

    angle = between(least, most, after, before, fresh)
    if angle is None:
        assert not (after or before) or high - low > 4 or low == 1
        return
    (first, *others) = symbols.values()
    bounded = angle.has(asin)
    numbers = (
        [k * Rational(1, 8) for k in range(-8, 9)]
        if bounded
        else [sign * sp.Integer(10) ** k for k in range(-9, 10, 3) for sign in (1, -1)]
    )
    numbers = [
        v for v in (*numbers, sp.S.Zero) if first.is_nonnegative is None or v > 0 or (v == 0 and not first.is_positive)
    ]
    pairs = [{first: v} | dict.fromkeys(others, w) for v in numbers for w in (numbers if others else (0,))]
    values = [float(angle.xreplace(pair)) for pair in pairs if not others or any(pair.values())]
    assert min(values) == pytest.approx(float(least), abs=1e-6)
    assert max(values) == pytest.approx(float(most), abs=1e-6)
    exact = {angle.xreplace(pair) for pair in pairs if not others or any(pair.values())}
    assert (least in exact, most in exact) == (not after, not before)


def test_a_proof_that_does_not_say_what_its_symbols_are_is_rejected() -> None:
    asked = (sqrt((1 - cos(x)) / 2), sin(x / 2), [x >= 0, x <= 2 * pi])
    verdict = prove(*asked)
    recheck(verdict, *asked)
    for said in verdict.needs:
        with pytest.raises(Rejected):
            recheck(replace(verdict, needs=tuple(text for text in verdict.needs if text != said)), *asked)


@pytest.mark.parametrize(
    ("root", "given"),
    [
        (sp.sqrt(x), x < 0),
        (sp.sqrt(x + y), x + y < 0),
        (x / sp.sqrt(y - 1), y < 1),
        (sp.sqrt(x) * sp.sqrt(y), x < 0),
        (sp.sqrt(-y) / sp.sqrt(sp.Symbol("k", positive=True)), -y <= 0),
        (sp.sqrt(-y), y >= 0),
        (sp.sqrt(x - y), y >= x),
    ],
)
def test_nothing_holds_of_roots_that_are_not_real_where_what_is_given_holds(root: Any, given: Any) -> None:
    assert not prove(root, root, given=[given]).true
    piecewise = Piecewise((root, sp.Not(given)), (0, True))
    assert prove(piecewise, 0, given=[given]).true
