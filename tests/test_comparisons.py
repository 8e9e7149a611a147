"""Inequalities by signs of polynomials in one variable, by bounds of functions and by their slopes; traps for each."""

from __future__ import annotations

from dataclasses import replace
from fractions import Fraction
from random import Random
from typing import Any

import pytest
import sympy as sp
from sympy import Rational, acos, asin, atan, atanh, cos, cosh, erf, exp, floor, log, pi, sin, sinh, sqrt, tanh

from chasles.checker.expressions.cases import CheckedCase
from chasles.checker.expressions.visible import signs_of
from chasles.from_sympy.sufficient import of_values
from chasles.points.search.drawing import Drawing
from chasles.prove import Rejected, Untreatable, prove, recheck
from chasles.verdict import Counterexample, Fails, Holds, HoldsUnder, Undecided

x, y = sp.symbols("x y")
p, q, r = sp.symbols("p q r", positive=True)
d = sp.Symbol("d", positive=True)
n = sp.Symbol("n", integer=True)

TRUE = [
    x**4 - x + 1 > 0, x**6 - x**3 + 1 > 0, n**2 >= n, 3 * p**2 + 1 > 3 * p, cos(x) ** 4 + 1 > cos(x),
    x - 1 < floor(x), floor(x) + floor(-x) <= 0, sp.Mod(x, 3) < 3, atan(x) < pi / 2, acos(x) <= pi,
    asin(x * y) <= pi / 2,
    sp.Abs(sp.atan2(y, x)) <= pi, tanh(x) ** 2 < 1, erf(x) <= 1, sin(x) + cos(x) <= sqrt(2),
    sp.Abs(sinh(x)) < cosh(x), sp.Abs(sinh(x)) <= cosh(x), sp.Max(-sinh(x), sinh(x)) < cosh(x),
    sp.Abs(x - sinh(x)) <= cosh(x) + 1,
    exp(x) >= 1 + x, log(p) <= p - 1, sin(p) < p, exp(-p) < 1, tanh(p) < p, cos(x) >= 1 - x**2 / 2,
    x * exp(-x) <= 1 / sp.E,
    log(1 + p) > p / (1 + p), cosh(x) >= 1 + x**2 / 2, log(p / q) <= p / q - 1,
    erf(x) > -1, exp(p) > p**2, x**4 + exp(x) > Rational(1, 2), p * log(p) >= -1 / sp.E,
    exp(x + y) >= 1 + x + y, (p + q) * (q + r) * (r + p) >= 8 * p * q * r, p**3 + q**3 + r**3 >= 3 * p * q * r,
]  # fmt: skip
NOT_TRUE = [
    x**4 - 2 * x + 1 > 0, x**3 > x, n**2 >= 2 * n, cos(x) ** 2 > 0, x < floor(x), sp.Mod(x, 3) < 2,
    atan(x) < pi / 2 - Rational(1, 9),
    erf(x) > -Rational(9, 10), erf(x) < Rational(9, 10), exp(p) > p**3, p * log(p) > -1 / sp.E,
    exp(x) > 1 + x, exp(x) >= 1 + 2 * x, exp(x) >= 1 + x + x**2 / 2, log(p) < p - 1, sin(x) < x, tanh(p) < p / 2,
    cos(x) > 1 - x**2 / 2, 1 - cos(p) > 0, sin(p) > 0, log(p) > 0, 1 / (1 - p) > 0, sqrt(p) > p,
    x**2 + y**2 > 2 * x * y, (x**2 - 2) ** 2 > 0, sin(x) < 1, sp.Ne(cos(x), 1), (sqrt(p) - 3) ** 2 > 0,
]  # fmt: skip


@pytest.mark.sampled(6)
@pytest.mark.parametrize("claim", TRUE, ids=str)
def test_what_is_true_is_proved_and_the_checker_follows(claim: sp.Rel) -> None:
    verdict = prove(claim)
    assert isinstance(verdict, Holds | HoldsUnder)
    needs = {f"{text} >= 0" for text in ("1 - x**2", "-x**2*y**2 + 1")} | {"x**2 + y**2 != 0"}
    assert needs.issuperset(verdict.needs if isinstance(verdict, HoldsUnder) else ())  # where both sides are defined
    recheck(verdict, claim)


@pytest.mark.sampled(6)
@pytest.mark.parametrize("claim", NOT_TRUE, ids=str)
def test_what_is_not_always_so_fails_also_where_both_sides_are_equal(claim: sp.Rel) -> None:
    verdict = prove(claim)
    assert isinstance(verdict, Fails)
    recheck(verdict, claim)


def test_signs_of_polynomials_are_those_that_their_zeros_leave() -> None:
    random = Random(1)
    for _ in range(15):
        factors = [x - random.randint(-2, 2) for _ in range(random.randint(0, 3))]
        e = sp.expand(
            sp.prod(factors) * (x**2 + random.randint(-1, 3)) ** random.randint(1, 2) + random.choice((0, 0, 1))
        )
        values = {int(sp.sign(e.subs(x, Rational(k, 8)))) for k in range(-24, 25)}
        zeros = sp.Poly(e, x).count_roots() > 0
        assert signs_of(e) >= values | ({0} if zeros else set())
        if not {1, -1} <= values and not e.has(sp.sqrt(2)):
            assert signs_of(e) <= values | {0} or sp.Poly(e, x).count_roots() > 0


@pytest.mark.parametrize(
    ("e", "facts", "signs"),
    [
        (exp(d) - 1 - d, (), {1}),
        (d - sin(d), (), {1}),
        (1 - cos(d), (), {0, 1}),
        (log(1 - d) + d, ((1 - d, 1),), {-1}),
        (log(1 - d) + d, (), {-1, 0, 1}),  # not real for all d
        (log(d) - d, (), {-1, 0, 1}),  # not so from zero on
        (exp(d) / (1 - d) - 1, (), {-1, 0, 1}),  # a pole between
        (exp(d) - 2 * d - 1, ((d - 5, 1),), {-1, 0, 1}),  # the fact does not hold before
        (exp(sp.Abs(d - 1)) - exp(1) + d, (), {-1, 0, 1}),  # not smooth
        (sin(pi * n) + exp(n) - 1, (), {-1, 0, 1}),  # of an integer nothing is differentiated
    ],
    ids=str,
)
def test_slopes_say_signs_where_a_function_is_smooth_and_all_known_holds_before(
    e: sp.Expr, facts: tuple[tuple[sp.Expr, int], ...], signs: set[int]
) -> None:
    case = CheckedCase(((e,), (sp.S.Zero,)), (), (), facts=facts)
    assert case.signs(e) == signs


@pytest.mark.parametrize(
    ("claim", "low", "high", "held"),
    [
        (sin(x) >= 2 * x / pi, 0, pi / 2, True),  # a concave function lies above its chord, as Jordan's inequality says
        (sin(x) >= 21 * x / (10 * pi), 0, pi / 2, False),
        (sin(x) > 2 * x / pi, 0, pi / 2, False),
        (exp(x) <= 1 + (sp.E - 1) * x, 0, 1, True),
        (exp(x) <= 1 + (sp.E - 1) * x, 0, 2, False),
        (exp(x) >= 2 * x + Rational(3, 5), -1, 1, True),
        (exp(x) >= 2 * x + Rational(62, 100), -1, 1, False),
        (log(1 + x) >= x * log(2), 0, 1, True),
        (x * cos(x) <= sin(x), 0, pi, True),
        (x * cos(x) <= sin(x), 0, 5, False),
    ],
    ids=str,
)
def test_between_two_ends_a_sign_is_seen_piece_by_piece(claim: sp.Rel, low: Any, high: Any, held: bool) -> None:
    given = [x >= low, x <= high]
    verdict = prove(claim, given=given)
    assert isinstance(verdict, HoldsUnder if held else Fails)
    recheck(verdict, claim, given=given)


def between(e: sp.Expr, rest: sp.Expr, kind: str = "positive") -> frozenset[int]:
    """The signs of an expression of d where d and others add up to a number."""
    put = {d: sp.Symbol("d", **{kind: True})}
    return (
        CheckedCase(((e,), (sp.S.Zero,)), ((d + rest, sp.S.Zero),), ())
        .each(lambda e: e.xreplace(put))
        .signs(e.xreplace(put))
    )


@pytest.mark.parametrize(
    ("e", "rest", "signs"),
    [
        (exp(d) - 1, p - 1, {1}),
        (exp(d) - sp.E, p - 1, {-1}),
        (exp(d) - sp.E, sp.Symbol("s", nonnegative=True) - 1, {-1, 0}),
        (exp(d) - sp.E, -p - 1, {-1, 0, 1}),  # d is not bounded
        (exp(d) - sp.E, y - 1, {-1, 0, 1}),  # nor here, where nothing is known of y
        (exp(d) - 2, p - 1, {-1, 0, 1}),
        (exp(d) - 1 / (2 * d - 1), p - 1, {-1, 0, 1}),  # a pole between
        (sqrt(2 * d - 1) - exp(d), p - 1, {-1, 0, 1}),  # not real everywhere
        (exp(d) - floor(2 * d) - 1, p - 2, {-1, 0, 1}),  # not smooth
        (
            (3 * d - 1) * (exp(3 * d) - sp.E),
            p - 1,
            {-1, 0, 1},
        ),  # what is zero between is not told from what changes its sign
    ],
    ids=str,
)
def test_pieces_are_those_of_a_smooth_function_up_to_an_end(e: sp.Expr, rest: sp.Expr, signs: set[int]) -> None:
    found = between(e, rest)
    assert found >= signs if len(signs) < 3 else found == signs


@pytest.mark.parametrize("on", ["sqrt(-1)*x", "x*w", "exp(x)", "1", "x + oo", "__import__('os')"])
def test_cases_of_what_is_no_polynomial_are_rejected(on: str) -> None:
    claim = exp(x) >= 1 + x
    verdict = prove(claim)
    assert isinstance(verdict, Holds)
    with pytest.raises(Rejected):
        recheck(replace(verdict, certificate={**verdict.certificate, "on": on}), claim)


def test_what_a_case_needs_is_said_of_no_other_quantity_with_the_name_of_one_of_the_question() -> None:
    def leaf(e: sp.Expr) -> dict[str, Any]:
        verdict = prove(sp.sign(e), 1, nonzero=[sp.sqrt(e)] if e.free_symbols else [])
        return {"proof": verdict.certificate, "needs": list(verdict.needs)}

    new, above = sp.Symbol("x", positive=True), sp.Symbol("d_1", positive=True)
    inner = {"+": leaf((new - 2) ** 2), "0": leaf(sp.Integer(4)), "-": leaf((-new - 2) ** 2)}
    second = {"on": "d_1 - 1", "size": "x", "cases": inner}
    outer = {"+": second, "0": leaf(sp.Integer(9)), "-": leaf((-above - 3) ** 2)}
    certificate = {"on": "x", "size": "d_1", "cases": outer, "witness": {"x": "7"}}
    forged = HoldsUnder(("x - 2 != 0",), certificate, {"x": Fraction(7)})
    with pytest.raises(Rejected, match="the symbol x is not new"):
        recheck(forged, (x - 3) ** 2 > 0)  # it is zero at 3, where the new x is 2
    lost = sp.Piecewise((0, y**2 > -1), (y, True), evaluate=False)
    above = sp.Symbol("y", positive=True)
    cases = {"+": leaf((above - 3) ** 2), "0": leaf(sp.Integer(9)), "-": leaf((-above - 3) ** 2)}
    certificate = {"on": "x", "size": "y", "cases": cases, "witness": {"x": "7", "y": "7"}}
    forged = HoldsUnder(("y - 3 != 0",), certificate, {"x": Fraction(7), "y": Fraction(7)})
    with pytest.raises(Rejected, match="the symbol y is not new"):
        recheck(forged, sp.sign((x - 3) ** 2) + lost, 1)


@pytest.mark.parametrize(
    ("claim", "name"),
    [
        (sp.Implies(x > 1, x**2 > 1), "holds-under"),
        (sp.Implies(x**2 > 1, x > 1), "fails"),
        (sp.Implies(sp.Eq(x, 1), sp.Eq(x**2, 1)), "holds-under"),
        (sp.Or(sp.Eq(x, 0), x**2 > 0), "holds"),
        (sp.Or(x > 1, x < 0), "fails"),
        (sp.And(x**2 >= 0, x**2 + y**2 >= 2 * x * y), "holds"),
        (sp.Equivalent(x > 1, x**2 > 1), "fails"),
        (sp.Equivalent(p > 1, p**2 > 1), "holds"),
        (sp.Le(floor(x), x, evaluate=False), "holds"),
    ],
    ids=str,
)
def test_claims_are_joined_by_and_or_not_if_and_if_and_only_if(claim: sp.Basic, name: str) -> None:
    verdict = prove(claim)
    assert verdict.name == name
    recheck(verdict, claim)


FALSE_PREMISES = [
    x**2 < 0,
    sp.And(x > 1, x < 0),
    sp.Lt(x, x - 1, evaluate=False),
    sp.And(sp.Eq(x, 1), sp.Eq(x, 2)),
    sp.Eq(sp.sin(x), 2),
    sp.Eq(x, x + 1, evaluate=False),
    sp.Lt(sp.exp(x), 0, evaluate=False),
    sp.And(x > 1, x**2 < 1),
    sp.false,
]


@pytest.mark.sampled(3)
@pytest.mark.parametrize("premise", FALSE_PREMISES, ids=str)
def test_what_cannot_be_implies_everything(premise: sp.Basic) -> None:
    claim = sp.Implies(premise, x > 5 if premise.has(sp.Pow) else sp.Eq(y, 1), evaluate=False)
    verdict = prove(claim)
    assert verdict.true
    recheck(verdict, claim)
    with pytest.raises(Rejected):
        recheck(verdict, sp.Implies(x > 0, sp.Eq(y, 1)))


def test_what_cannot_be_beside_what_is_given_implies_everything() -> None:
    claim = sp.Implies(x < y, sp.Eq(x, 1))
    assert prove(claim, given=[x > y]).true
    assert isinstance(prove(claim), Fails)
    assert prove(claim, given=[sp.Eq(d, 1), sp.Eq(d, 2)]).reason == "nothing satisfies d = 1 and d = 2"


def test_what_is_no_relation_is_no_equation_either() -> None:
    for claim in (sp.Implies(y, x > 1), sp.Or(y, x > 1), sp.Not(y)):
        with pytest.raises(Untreatable, match="no equation and no inequality"):
            prove(claim)
    verdict = prove(x, 1, given=[sp.Or(sp.Eq(1 / x, 1), sp.Eq(x, 0))])
    assert "x != 0" in verdict.needs  # where x is zero, the first says nothing


JOINED: list[tuple[Any, Any, bool]] = [
    (x**2 > 1, sp.Or(x > 1, x < -1), True),
    (x**2 > 1, sp.Not(sp.And(x <= 1, x >= -1)), True),
    (x > 0, [sp.Implies(y > 0, x > 0), y > 0], True),
    (x > 0, sp.And(sp.Implies(y > 0, x > 0), y > 0), True),
    (x * y >= 0, sp.Equivalent(x > 0, y > 0), True),
    (x > 0, sp.ITE(y > 0, x > 1, x > 2), True),
    (x >= 0, sp.Xor(x > 0, sp.Eq(x, y**2)), True),
    (sp.Eq(sp.Abs(x * y), x * y), [sp.Or(x >= 0, y <= 0), sp.Or(x <= 0, y >= 0)], True),
    (sp.ITE(x > 0, sp.Eq(sp.Abs(x), x), sp.Eq(sp.Abs(x), -x)), [], True),
    (sp.Eq(sp.Mod(n, 2), 0), sp.Or(sp.Eq(n, 2), sp.Eq(n, 4)), True),
    (sp.Eq(sp.Max(x, y), y), [x - y], True),
    (sp.Eq(sp.sign(x), 1), [sp.Matrix([x - 2, y - x])], True),
    (sp.ITE(x > 0, 1 / x > 0, x <= 0), [], True),
    (x**2 > 2, sp.Or(x > 1, x < -1), False),
    (x * y > 0, sp.Equivalent(x > 0, y > 0), False),
    (sp.Eq(x, 1), sp.Or(sp.Ne(x, 1), sp.Eq(x, 2)), False),
    (x > 1, sp.Implies(y > 0, x > 1), False),
    (sp.ITE(x > 0, 1 / x > 1, x <= 0), [], False),
]


@pytest.mark.sampled(3)
@pytest.mark.parametrize(("claim", "given", "true"), JOINED, ids=str)
def test_what_joins_relations_may_be_given(claim: Any, given: Any, true: bool) -> None:
    verdict = prove(claim, given=given)
    assert isinstance(verdict, Holds | HoldsUnder if true else Fails)
    recheck(verdict, claim, given=given)
    if true and given:
        with pytest.raises(Rejected):
            recheck(verdict, claim)


def test_what_is_given_of_cases_is_satisfied_by_a_point_or_proves_nothing() -> None:
    assert not prove(x, y, given=sp.Or(x**2 < 0, y**2 < 0)).true
    u = sp.Function("u")(x)  # which of them holds may change in time
    with pytest.raises(Untreatable, match="no equation and no inequality"):
        prove(u**2 >= 1, given=sp.Or(u >= 1, u <= -1))


MONOTONE: list[tuple[Any, list[Any], bool]] = [
    (asin(x) < asin(y), [x < y], True),
    (acos(x) > acos(y), [x < y], True),
    (sp.atanh(x) <= sp.atanh(y), [x <= y], True),
    (x**5 < y**5, [x < y], True),
    (-(x ** Rational(2, 3)) > -(y ** Rational(2, 3)), [x < y], True),
    (2**x < 3**x, [x > 0], True),
    (Rational(1, 2) ** x < Rational(1, 3) ** x, [x < 0], True),
    (log(x) <= x - 1, [], True),
    (log(exp(x) + 1) > x, [], True),
    (sqrt(p) > log(p), [], True),
    (floor(x) <= floor(y), [x <= y], True),
    (floor(x) + floor(y) <= floor(x + y), [], True),
    (floor(x + y) <= floor(x) + floor(y) + 1, [], True),
    (sp.ceiling(x) <= sp.ceiling(y), [x <= y], True),
    (n < floor(x), [x >= n + 1], True),
    (acos(x) < acos(y), [x < y], False),
    (-asin(x) < -asin(y), [x < y], False),
    (x**4 < y**4, [x < y], False),
    (2**x < 3**x, [], False),
    (floor(x) < floor(y), [x < y], False),
    (n < floor(x), [x > n], False),
    (sp.ceiling(x) < n, [x < n], False),
    (floor(x + y) <= floor(x) + floor(y), [], False),
]


@pytest.mark.sampled(4)
@pytest.mark.parametrize(("claim", "given", "true"), MONOTONE, ids=str)
def test_what_rises_is_greater_where_its_argument_is(claim: Any, given: Any, true: bool) -> None:
    verdict = prove(claim, given=given)
    assert isinstance(verdict, Holds | HoldsUnder if true else Fails)
    recheck(verdict, claim, given=given)


m = sp.Symbol("m", integer=True, nonnegative=True)
FOLLOWING: list[tuple[Any, list[Any], bool]] = [
    (exp(x * y) >= 1 + x * y, [], True),
    (log(1 + 1 / p) < 1 / p, [], True),
    (cos(x * y) >= 1 - x**2 * y**2 / 2, [], True),
    (exp(sqrt(p)) >= 1 + sqrt(p), [], True),
    (sin(sqrt(p)) < sqrt(p), [], True),
    (1 + sin(x) <= exp(sin(x)), [], True),
    (cos(y) < cos(x), [x >= 0, x < y, y <= sp.pi], True),
    (sin(x) <= sin(y), [x >= -sp.pi / 2, x <= y, y <= sp.pi / 2], True),
    (sp.tan(x) < sp.tan(y), [x > -sp.pi / 2, x < y, y < sp.pi / 2], True),
    (-2 * cos(x) < -1, [x > -sp.pi / 3, x < sp.pi / 3], True),
    (x**m <= 1, [x >= 0, x <= 1], True),
    (exp(x * y) > 1 + x * y, [], False),
    (log(1 + 1 / p) < 1 / (2 * p), [], False),
    (exp(x * y) >= 1 + x * y + sp.Symbol("u_1", real=True) ** 2, [], False),
    (cos(y) <= cos(x), [x >= 0, x <= y], False),
    (sin(x) <= sin(y), [x >= -sp.pi / 2, x <= y, y <= sp.pi], False),
    (cos(x) > Rational(1, 2), [x >= -sp.pi / 3, x < sp.pi / 3], False),
    (x**m < 1, [x >= 0, x < 1], False),
]


@pytest.mark.sampled(5)
@pytest.mark.parametrize(("claim", "given", "true"), FOLLOWING, ids=str)
def test_what_follows_from_another_claim_is_proved_by_that(claim: Any, given: Any, true: bool) -> None:
    verdict = prove(claim, given=given)
    assert isinstance(verdict, Holds | HoldsUnder if true else Fails)
    recheck(verdict, claim, given=given)


def _within(low: Any, high: Any, *symbols: Any) -> list[Any]:
    return [relation for symbol in symbols for relation in (symbol > low, symbol < high)]


OF_VALUES: list[tuple[Any, Any, list[Any], bool]] = [
    (x, y, [sp.Eq(sin(x), sin(y)), *_within(-pi / 2, pi / 2, x, y)], True),
    (x, y, [sp.Eq(sinh(x), sinh(y))], True),
    (x, y, [sp.Eq(atan(x), atan(y))], True),
    (sp.Implies(sp.Eq(asin(x), asin(y)), sp.Eq(x, y)), None, [], True),
    (x, atan(2), [sp.Eq(sp.tan(x), 2), *_within(-pi / 2, pi / 2, x)], True),
    (sp.Abs(x), sp.Abs(y), [sp.Eq(cosh(x), cosh(y))], True),
    (x < y, None, [sp.tan(x) < sp.tan(y), *_within(-pi / 2, pi / 2, x, y)], True),
    (x, y, [sp.Eq(sp.tan(x), sp.tan(y)), *_within(-pi / 2, pi, x, y)], False),
    (x, y, [sp.Eq(cosh(x), cosh(y))], False),
    (x, y, [sp.Eq(sin(x), sin(y)), *_within(0, pi, x, y)], False),
    (y, x + 1, [sp.Eq(sinh(x), sinh(y))], False),
    (x, y, [sp.Eq(log(x**2), log(y**2))], False),  # under x > 0 and y > 0 it would be true
    (x, y, [sp.Eq(log(x), log(y))], True),
]


@pytest.mark.sampled(4)
@pytest.mark.parametrize(("left", "right", "given", "true"), OF_VALUES, ids=str)
def test_arguments_are_compared_by_values_where_a_function_rises(left: Any, right: Any, given: Any, true: bool) -> None:
    verdict = prove(left, right, given)
    assert isinstance(verdict, Holds | HoldsUnder) == true
    if not true:
        return
    recheck(verdict, left, right, given)
    if isinstance(verdict, HoldsUnder):
        with pytest.raises(Rejected):
            recheck(replace(verdict, needs=()), left, right, given)
    if right is not None:
        with pytest.raises(Rejected):
            recheck(verdict, left, right + 1, given)
        with pytest.raises(ValueError, match="no theorem"):
            verdict.coq("of_values")


def test_arguments_of_values_that_are_not_where_it_rises_prove_nothing() -> None:
    [claim] = of_values(sp.Eq(x, y), [sp.Eq(sin(x), sin(y))])
    assert set(claim.args) > {-pi / 2 <= x, y <= pi / 2}
    assert not [*of_values(sp.Eq(x, 2), [sp.Eq(sin(x), 1)])]  # 2 is more than pi/2
    assert not [*of_values(sp.Eq(x, 2), [sp.Eq(atanh(x), 1)])]  # and has no inverse hyperbolic tangent
    assert not [*of_values(sp.Eq(x, sp.I), [sp.Eq(sinh(x), 1)])]
    stronger = Fails(Counterexample({"x": Fraction(4), "y": Fraction(4)}, (1, 1), "0", "1"))
    with pytest.raises(Rejected):
        recheck(stronger, x, y, [sp.Eq(sin(x), sin(y))])


def test_where_pi_occurs_the_first_point_is_the_witness(monkeypatch: pytest.MonkeyPatch) -> None:
    """A point with pi among its coordinates is never rational: no other one is looked for."""
    drawn = []
    attempt = Drawing.attempt
    monkeypatch.setattr(Drawing, "attempt", lambda self, *args: drawn.append(args) or attempt(self, *args))
    assert prove(y > -pi / 2, given=[x < y, x > -pi / 2, y < pi / 2]).true
    assert 0 < len(drawn) < 10


GIVEN_LOGARITHMS: list[tuple[Any, list[Any], bool]] = [
    (log(p) > 0, [log(p) > 1], True),
    (log(x) > 0, [log(x) > 1], True),
    (x > 2, [log(x) > 1], True),
    (p < 3, [log(p) < 1], True),
    (x > 3, [log(x) > 1], False),
    (x > -1, [log(x) < 1, x > -2], True),
    (p < 2, [log(p) < 1], False),
]


@pytest.mark.parametrize(("claim", "given", "true"), GIVEN_LOGARITHMS, ids=str)
def test_what_is_given_of_a_logarithm_says_where_it_is_real(claim: Any, given: list[Any], true: bool) -> None:
    try:
        verdict = prove(claim, given=given)
    except Untreatable:
        return
    assert isinstance(verdict, Holds | HoldsUnder | Undecided if true else Fails)
    if not isinstance(verdict, Undecided):
        recheck(verdict, claim, given=given)


def test_what_is_said_of_a_symbol_between_bounds_is_needed() -> None:
    """Also where it cancels, or SymPy sees that the claim follows."""
    for claim, given in ((x > 3, [x > 3]), (x >= 3, [x > 3]), (x + y > 2, [x > 3, y > 0]), (y > -1, [x < y, x > 0])):
        verdict = prove(claim, given=given)
        assert isinstance(verdict, HoldsUnder)
        assert any("d_1" in need for need in verdict.needs)
        recheck(verdict, claim, given=given)
        with pytest.raises(Rejected):
            recheck(Holds(verdict.certificate, verdict.witness), claim, given=given)


def test_a_name_has_all_values_of_what_it_names() -> None:
    u = sp.Symbol("u_1", real=True)  # a symbol of the question is no new name
    assert isinstance(prove(exp(x * y) >= 1 + x * y, given=[u > 2]), Undecided)
    z, w = sp.symbols("z w", complex=True)
    assert not prove(exp(z * w) >= 1 + z * w).true
    verdict = prove(exp(x * y) >= 1 + x * y)
    assert verdict.needs == ("u_1 = x*y",)
    for needs in ((), ("u_1 = x",)):
        with pytest.raises(Rejected):
            recheck(replace(verdict, needs=needs), exp(x * y) >= 1 + x * y)
    with pytest.raises(Rejected):
        recheck(verdict, exp(x * y) >= 2 + x * y)


def test_a_claim_is_not_refuted_by_one_from_which_it_follows() -> None:
    stronger = Fails(
        Counterexample({"x": Fraction(4)}, (1, 1), "0", "1")
    )  # 4 is not between the ends of a quarter turn
    with pytest.raises(Rejected):
        recheck(stronger, sin(x) <= 1)


def test_what_rises_is_to_be_defined() -> None:
    assert prove(log(x) <= x - 1).needs == ("x > 0",)
    verdict = prove(asin(x) < asin(y), given=[x < y])
    assert {"1 - x**2 >= 0", "1 - y**2 >= 0"} <= {*verdict.needs} or "d_1" in str(verdict.needs)
    with pytest.raises(Rejected):
        recheck(replace(verdict, needs=verdict.needs[:1]), asin(x) < asin(y), given=[x < y])
    with pytest.raises(ValueError, match="an increasing function"):
        verdict.coq("rises")


def test_one_of_several_equations_may_be_given() -> None:
    one_of = sp.Or(sp.Eq(x, 1), sp.Eq(x, -1))
    assert prove(x**2, 1, given=[one_of]).needs == ("(x - 1)*(x + 1) = 0",)
    assert prove(x, 1, given=one_of).counterexample.at == {"x": -1}


def test_a_need_on_a_function_of_time_of_which_something_is_assumed_is_checked() -> None:
    moment = sp.Symbol("t")
    turning = sp.Function("u", real=True)(moment)
    rate_ = turning.diff(moment)
    cases = sp.Piecewise((1, turning > 0), (-1, turning < 0), (0, True))
    asked = sp.sign(turning) * rate_, cases * rate_
    verdict = prove(*asked, nonzero=[turning])
    assert verdict.needs == ("u(t) != 0",)
    recheck(verdict, *asked, nonzero=[turning])


@pytest.mark.parametrize(
    ("function", "at", "needs"),
    [
        (sp.acos, x, ("1 - x**2 >= 0",)),
        (sp.asin, 2 * x, ("1 - 4*x**2 >= 0",)),
        (sp.log, x, ("x > 0",)),
        (sp.log, 1 + x**2, ()),
        (sp.acosh, x, ("x - 1 >= 0",)),
        (sp.atanh, x, ("x + 1 > 0", "1 - x > 0")),
        (sp.asec, x, ("x != 0", "x**2 - 1 >= 0")),
        (sp.acos, sp.sin(x), ()),
        (sp.tan, x, ("cos(x) != 0",)),
        (sp.coth, x, ("exp(2*x) - 1 != 0",)),
        (sp.gamma, x, ("1/gamma(x) != 0",)),
        (sp.factorial, n, ("1/gamma(n + 1) != 0",)),
        (lambda u: sp.Mod(u, y), x, ("y != 0",)),
    ],
)
def test_a_function_is_defined_whose_sign_is_not_asked_for(function: Any, at: Any, needs: tuple[str, ...]) -> None:
    """Squares are not negative whatever is squared: where it has no value nothing is said."""
    f = function(at)
    claims = [(sp.Gt(f**2 + 1, 0, evaluate=False),), (sp.sign(f**2 + 1), 1), (sp.Max(f**2, -1), f**2)]
    for claim in claims:
        verdict = prove(*claim)
        assert verdict.true
        assert {*needs} <= {*verdict.needs}
        assert bool(needs) == bool(verdict.needs)
        recheck(verdict, *claim)
        if needs:
            with pytest.raises(Rejected):
                recheck(replace(verdict, needs=()), *claim)


def test_a_bound_holds_where_what_is_bounded_has_a_value() -> None:
    claim = sp.Abs(acos(x)) / (acos(x) ** 2 / 2 + 2) < 1
    verdict = prove(claim)
    assert isinstance(verdict, HoldsUnder)
    assert verdict.needs == ("1 - x**2 >= 0",)
    recheck(verdict, claim)
