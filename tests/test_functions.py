"""Functions of scalars: printed, measured, decided, checked, refuted, differentiated and evaluated."""

from __future__ import annotations

import json
import re
from collections.abc import Callable, Mapping
from dataclasses import replace
from fractions import Fraction
from importlib import import_module
from typing import Any

import mpmath
import pytest
import sympy as sp

from chasles.checker.certificate import Rejected, check
from chasles.checker.expressions.scalars import scalar_question
from chasles.checker.refutation import check_counterexample
from chasles.decisions.memory import Memory
from chasles.decisions.session import Session
from chasles.numerics.reference import evaluate
from chasles.statements import Claim, Condition, Definition, definite, half_turn, nonzero, positive, rotation, unit
from chasles.statements.inequalities import inequality
from chasles.statements.posing import problem_of
from chasles.verdict import Contradictory, Fails, Holds, HoldsUnder, Undecided
from chasles.vocabulary import (
    CPM,
    LENGTH,
    PI,
    Identity,
    Misfit,
    Node,
    array,
    column,
    cos,
    det,
    dot,
    latex,
    norm,
    number,
    plain,
    rate,
    scalar,
    sin,
    square,
    tan,
    tr,
    vector,
)
from chasles.vocabulary.differentiation import rate_of
from chasles.vocabulary.functions import (
    FunctionOf,
    arccos,
    arccosh,
    arcsin,
    arcsinh,
    arctan,
    arctanh,
    atan2,
    cases,
    cosh,
    exp,
    log,
    maximum,
    minimum,
    sign,
    sinh,
    sqrt,
    tanh,
)
from chasles.vocabulary.tree import rebuilt

from .decided import claim, proved, refuted

x, y, p, phi = (scalar(name, letter, "a number") for name, letter in zip("xypf", ("x", "y", "p", r"\phi"), strict=True))
r = scalar("r", "r", "a length", LENGTH)
v = vector("v", "v", "a vector", LENGTH)
e = vector("e", "e", "an axis")
Q, M = square("Q", "Q", "a rotation"), square("M", "M", "a matrix")
a = scalar("a", r"\alpha", "an angle")
angle = Definition("0.1", a, arccos((tr(Q) - 1) / 2))
turn = Definition("0.2", Q, e @ e.T + cos(phi) * (Identity(3) - e @ e.T) + sin(phi) * CPM(e), assuming=(unit(e),))


TRUE = [
    claim(sqrt(x**2 + y**2) ** 2, x**2 + y**2),
    claim(sin(arccos(x)), sqrt(1 - x**2)),
    claim(norm(v), sqrt(v.x**2 + v.y**2 + v.z**2)),
    claim(abs(x), x, positive(x)),
    claim(abs(x), cases((x, x > 0), otherwise=-x)),
    claim(cos(atan2(y, x)), x / sqrt(x**2 + y**2)),
    claim(sin(atan2(y, x)) * sqrt(x**2 + y**2), y),
    claim(cos(arccos((tr(Q) - 1) / 2)), (tr(Q) - 1) / 2, rotation(Q)),
    claim(2 * cos(a) + 1, tr(Q), given=(angle,)),
    claim(rate(sqrt(1 + x**2)), x * rate(x) / sqrt(1 + x**2)),
    claim(rate(arctan(x)), rate(x) / (1 + x**2)),
    claim(rate(atan2(y, x)), (x * rate(y) - y * rate(x)) / (x**2 + y**2)),
    claim(exp(x) * exp(-x), 1),
    claim(sqrt((1 + cos(phi)) / 2), abs(cos(phi / 2))),
    claim(abs(x - y), maximum(x, y) - minimum(x, y)),
    claim(cosh(x) ** 2 - sinh(x) ** 2, 1),
    claim(tanh(x), sinh(x) / cosh(x)),
    claim(arcsinh(x), log(x + sqrt(x**2 + 1))),
    claim(arctanh(x), log((1 + x) / (1 - x)) / 2),
    claim(rate((1 + x**2) ** Fraction(3, 2)), 3 * x * rate(x) * sqrt(1 + x**2)),
    claim(log(p**2), 2 * log(p), positive(p)),
    claim(arcsin(x) + arccos(x), arcsin(x) + arccos(x)),
    claim(norm(v) * sign(p), norm(v), positive(p)),
    claim(column(sqrt(x**2), y), column(abs(x), y)),
    claim(sqrt(det(M) ** 2), abs(det(M))),
    claim(exp(-log(det(M)) / 3) * tr(M), tr(exp(-log(det(M)) / 3) * M), definite(M)),
    claim(sqrt(r**2), r, positive(r)),
]
FALSE = [
    claim(norm(v), abs(v.x)),
    claim(abs(x), x),
    claim(2 * cos(a) + 2, tr(Q), given=(angle,)),
    claim(sqrt((1 + cos(phi)) / 2), cos(phi / 2)),
    claim(rate(arctan(x)), rate(x) / (1 - x**2)),
    claim(cosh(x) ** 2 + sinh(x) ** 2, 1),
    claim(exp(x) * exp(x), exp(x)),
    claim(column(x, sqrt(x**2)), column(x, x)),
    claim(cases((x, x >= 1), otherwise=y), x),
    claim(arccos(x), arcsin(x)),
    claim(maximum(x, y), x),
    claim(sqrt(r**2), -r, positive(r)),
]


@pytest.mark.sampled(3)
@pytest.mark.parametrize("said", TRUE, ids=lambda said: f"{said.left} = {said.right}")
def test_what_is_true_is_proved_and_the_proof_is_checked(said: Claim) -> None:
    verdict = proved(said)
    if said.left != said.right:
        with pytest.raises(Rejected):
            check(replace(said, right=said.right + said.right + said.left), "printed", verdict.certificate)
        if "scalars" in verdict.certificate:
            without = {name: part for name, part in verdict.certificate.items() if name != "point"}
            with pytest.raises(Rejected):
                check(said, "printed", without)


@pytest.mark.parametrize("said", FALSE, ids=lambda said: f"{said.left} = {said.right}")
def test_what_is_false_is_refuted_and_the_point_is_checked(said: Claim) -> None:
    verdict = refuted(said)
    with pytest.raises(Rejected):
        check_counterexample(problem_of(replace(said, right=said.left)), verdict.counterexample)


def test_a_counterexample_names_the_entry_and_needs_name_hypotheses() -> None:
    found = Session().decide(claim(column(x, sqrt(x**2)), column(x, x))).verdict
    assert isinstance(found, Fails)
    assert found.counterexample.entry == (2, 1)
    needs = Session().decide(claim(abs(x), x, positive(x), rotation(Q))).verdict
    assert isinstance(needs, HoldsUnder)
    assert (needs.needs, needs.unused) == (("x > 0",), ("Q is a rotation",))


def leading_minors(point: Mapping[str, Any]) -> list[Any]:
    entries = sp.Matrix(3, 3, lambda i, j: sp.Rational(str(point[f"M_{i + 1}{j + 1}"])))
    return [entries[:k, :k].det() for k in (1, 2, 3)]


def test_at_a_point_shown_a_definite_matrix_is_so() -> None:
    for said in (claim(abs(M[1, 1]), -M[1, 1], definite(M)), claim(sqrt(det(M)), tr(M), definite(M))):
        refuted = Session().decide(said).verdict
        assert isinstance(refuted, Fails)
        check_counterexample(problem_of(said), refuted.counterexample)
        assert min(leading_minors(refuted.counterexample.at)) > 0
        worse = {**refuted.counterexample.at, "M_11": Fraction(-1)}
        with pytest.raises(Rejected):
            check_counterexample(problem_of(said), replace(refuted.counterexample, at=worse))
    said = claim(sqrt(dot(v, M @ v)) ** 2, dot(v, M @ v), definite(M))
    proved = Session().decide(said).verdict
    assert isinstance(proved, Holds | HoldsUnder)
    check(said, "printed", proved.certificate)
    assert min(leading_minors(proved.witness)) > 0
    negative = {name: f"-{value}" if name[0] in "Md" else value for name, value in proved.certificate["point"].items()}
    scalars = {**proved.certificate["scalars"], "witness": negative}
    with pytest.raises(Rejected):
        check(said, "printed", {**proved.certificate, "scalars": scalars, "point": negative})
    verdict = Session().decide(claim(abs(M[1, 1] + 1), M[1, 1] + 1, definite(M))).verdict
    assert verdict.needs == ("M is positive-definite",)
    both = Session().decide(claim(abs(M[1, 1]) ** 2, M[1, 1] ** 2, definite(M), half_turn(M))).verdict
    assert isinstance(both, Contradictory)
    assert {*both.hypotheses} == {"M is positive-definite", "M is a half-turn"}


@pytest.mark.parametrize("said", [TRUE[1], TRUE[7], FALSE[0], FALSE[2]], ids=lambda said: f"{said.left} = {said.right}")
def test_answers_are_kept_and_checked_again(said: Claim) -> None:
    memory = Memory()
    first = Session(memory=memory).decide(said)
    again = Memory(json.loads(json.dumps(memory.as_data(1000))))
    assert Session(memory=again).decide(said).verdict == first.verdict
    assert again.has_recalled


@pytest.mark.parametrize(
    ("node", "in_latex", "text"),
    [
        (2 * sqrt(x**2 + y**2), r"2 \sqrt{x^2 + y^2}", "2 sqrt(x^2 + y^2)"),
        (abs(x - y) ** 2, "|x - y|^2", "|x - y|^2"),
        (x * (1 - y) ** Fraction(3, 2), r"x \left( 1 - y \right)^{3/2}", "x (1 - y)^(3/2)"),
        (atan2(v.y, v.x), r"\operatorname{atan2}\left( v_y, v_x \right)", "atan2(v_y, v_x)"),
        (arccos((tr(Q) - 1) / 2), r"\arccos\left[ \frac{\text{tr}\left( \mathbf{Q} \right) - 1}{2} \right]", None),
        (
            cases((x, x > 0), (y, x <= -1), otherwise=0),
            r"\begin{cases} x & x > 0 \\ y & x \leq -1 \\ 0 & \text{otherwise} \end{cases}",
            "(x if x > 0, y if x <= -1, 0 otherwise)",
        ),
    ],
)
def test_they_are_printed(node: Node, in_latex: str, text: str | None) -> None:
    assert latex(node) == in_latex
    assert text is None or plain(node) == text
    assert rebuilt(node, node._parts()) == node


@pytest.mark.parametrize(
    ("write", "reason"),
    [
        (lambda: exp(r), "exp takes a number without dimension"),
        (lambda: atan2(r, x), "cannot take atan2 of r [m] and x"),
        (lambda: sqrt(v), "sqrt takes scalars, and v is none"),
        (lambda: cases((x, r > x), otherwise=x), "cannot compare r [m] and x"),
        (lambda: cases((x, x > 0), otherwise=r), "cannot take by cases x"),
    ],
)
def test_what_does_not_fit_is_told(write: Callable[[], Node], reason: str) -> None:
    with pytest.raises(Misfit, match=re.escape(reason)):
        write()


def test_a_comparison_is_not_true_or_false_by_itself() -> None:
    with pytest.raises(TypeError, match="no truth value"):
        bool(x < y)


FUNCTIONS: list[tuple[Callable[..., FunctionOf], Callable[..., Any], tuple[str, ...]]] = [
    (sqrt, mpmath.sqrt, ("0.7",)),
    (abs, abs, ("-0.7",)),
    (exp, mpmath.exp, ("-1.3",)),
    (log, mpmath.log, ("0.2",)),
    (arcsin, mpmath.asin, ("-0.9",)),
    (arccos, mpmath.acos, ("-0.3",)),
    (arctan, mpmath.atan, ("5",)),
    (atan2, mpmath.atan2, ("-2", "-3")),
    (sinh, mpmath.sinh, ("0.4",)),
    (cosh, mpmath.cosh, ("0.4",)),
    (tanh, mpmath.tanh, ("0.4",)),
    (arcsinh, mpmath.asinh, ("-0.4",)),
    (arccosh, mpmath.acosh, ("1.4",)),
    (arctanh, mpmath.atanh, ("-0.4",)),
]


@pytest.mark.parametrize(("word", "function", "at"), FUNCTIONS, ids=[row[1].__name__ for row in FUNCTIONS])
def test_values_and_rates_have_fifty_digits(
    word: Callable[..., FunctionOf], function: Callable[..., Any], at: tuple[str, ...]
) -> None:
    arguments = (x, y)[: len(at)]
    with mpmath.workdps(70):
        values = dict(zip(arguments, map(mpmath.mpf, at), strict=True))
        rates = {rate(x): mpmath.mpf(3), rate(y): mpmath.mpf(-2)}
        node = word(*arguments)
        ((found,),) = evaluate(node, values)
        ((moved,),) = evaluate(rate_of(node), {**values, **rates})
        true = function(*values.values())
        along = mpmath.diff(lambda t: function(*(values[s] + t * rates[rate(s)] for s in arguments)), 0)
        assert mpmath.almosteq(found, true, rel_eps=mpmath.mpf(10) ** -49)
        assert mpmath.almosteq(moved, along, rel_eps=mpmath.mpf(10) ** -30)


def test_cases_take_the_first_that_holds() -> None:
    node = cases((1, x > y), (2, x >= y), otherwise=dot(v, v) / dot(v, v))
    values = {v: [1, 0, 0]}
    assert [int(evaluate(node, {**values, x: k, y: 1})[0][0]) for k in (2, 1, 0)] == [1, 2, 1]
    assert int(evaluate(maximum(x, y, 3) + sign(minimum(x, number(-1))), {x: 1, y: 7})[0][0]) == 6


joints = array("th", r"\theta", "joint angles", column(x, y, p))
BEYOND_SUMS = [
    claim(cos(joints[1] + joints[2]), cos(joints[1]) * cos(joints[2]) - sin(joints[1]) * sin(joints[2])),
    claim(rate(cos(joints[1])), -(sin(joints[1]) * rate(joints)[1])),
    claim(sin(x * y) ** 2, 1 - cos(x * y) ** 2),
    claim(rate(sin(x * y)), cos(x * y) * (rate(x) * y + x * rate(y))),
    claim(sin(norm(e) * x) ** 2 + cos(x * norm(e)) ** 2, 1),
    claim(sin(2 * x * y), 2 * sin(x * y) * cos(x * y)),
    claim(Identity(3) + sin(x * norm(e)) * CPM(e), Identity(3) + sin(x) * CPM(e), unit(e)),
    claim(cos(arccos(x) / 2) ** 2, (1 + x) / 2),
]


@pytest.mark.parametrize("said", BEYOND_SUMS, ids=lambda said: f"{said.left} = {said.right}")
def test_angles_that_are_no_sums_of_symbols_are_decided(said: Claim) -> None:
    proved(said)
    wrong = replace(said, right=said.right + said.right)
    refuted = Session().decide(wrong).verdict
    assert isinstance(refuted, Fails), refuted
    check_counterexample(problem_of(wrong), refuted.counterexample)


y_at_zero = cases((sqrt(p), y > 0), (sqrt(p), y < 0), otherwise=-1)
SIMPLIFIED_AWAY = [
    (claim(sqrt(p) * y / y, sqrt(p)), "holds-under", "y != 0"),
    (claim(sqrt(p) * y / y, sqrt(p), nonzero(y)), "holds-under", "p >= 0"),
    (claim(sqrt(p) * y / y, y_at_zero, positive(p)), None, "y != 0"),
    (claim(sqrt(x) ** 2, abs(x)), "holds-under", "x >= 0"),
    (claim(exp(log(x)), abs(x)), "holds-under", "x >= 0"),
    (claim(sqrt(x) ** 2, -x), "fails", ""),
    (claim(cos(arccos(x)), cases((x, x <= 1), otherwise=0)), "holds-under", "1 - x^2 >= 0"),
]


@pytest.mark.parametrize(("said", "name", "need"), SIMPLIFIED_AWAY, ids=lambda it: str(getattr(it, "left", "")))
def test_what_is_simplified_away_refutes_nothing_where_it_is_not_defined(
    said: Claim, name: str | None, need: str
) -> None:
    verdict = Session().decide(said).verdict
    assert not isinstance(verdict, Fails) or name == "fails"
    if name is not None:
        assert verdict.name == name
    if isinstance(verdict, HoldsUnder):
        assert need in verdict.needs
        check(said, "printed", verdict.certificate)


def test_two_quantities_of_one_name_are_told_apart() -> None:
    v_1, other = scalar("v_1", "v_1", "a length", LENGTH), scalar("x", "x", "another", constant=True)
    for said in (claim(abs(v_1), abs(v.x)), claim(abs(x), abs(other))):
        verdict = Session().decide(said).verdict
        assert isinstance(verdict, Undecided)
        assert "rename one" in verdict.reason


def test_what_is_real_nowhere_is_not_refuted() -> None:
    """SymPy has a number for the root of -2; the statement stands nowhere."""
    for said in (claim(sqrt(number(-2)), number(0)), claim(sqrt(y) + sqrt(-y), number(0), positive(y))):
        assert Session().decide(said).verdict.name == "contradictory"


@pytest.mark.parametrize("angle", [tr(x * Identity(3)) / 3, x / norm(v) * norm(v)])
def test_a_point_of_scalars_is_accepted_where_polynomials_can_be_read(angle: Node) -> None:
    """The prover takes an angle for one of symbols by words alone, the checker by its entries."""
    said = claim(rate(sin(y)), rate(sin(angle)), nonzero(norm(v)))
    verdict = Session().decide(said).verdict
    assert isinstance(verdict, Fails)
    check_counterexample(problem_of(said), verdict.counterexample)
    with pytest.raises(Rejected):
        check_counterexample(problem_of(said), replace(verdict.counterexample, left="17"))


@pytest.mark.parametrize(
    ("said", "verdict"),
    [
        (claim(abs(x), x, inequality(exp(x) > 1)), "holds-under"),
        (claim(abs(x), x, inequality(abs(x) < 1)), "fails"),
        (claim(x, y, inequality(abs(x) < 0)), "undecided"),
        (claim(x, number(0), inequality(abs(x) <= 0)), "holds-under"),
        (claim(abs(x - 1), 1 - x, inequality(arccos(x) < 1)), "holds-under"),
        (claim(abs(log(x)), -log(x), inequality(log(x) > 0)), "fails"),
    ],
)
def test_an_inequality_with_functions_is_not_read_by_itself(said: Claim, verdict: str) -> None:
    """Read as a word, the absolute value of what is assumed positive is the same, and nothing would be assumed."""
    assert Session().decide(said).verdict.name == verdict


def test_bounds_of_an_angle_are_given_where_something_else_is_assumed_of_it() -> None:
    """An arc is an angle between 0 and pi, and no such angle is four or more: nothing satisfies all three."""
    arc, bounds = claim(arccos(cos(y)), y), (inequality(y >= 0), inequality(y <= PI))
    assert not scalar_question(problem_of(replace(arc, assuming=bounds))).given
    more = replace(arc, assuming=(*bounds, inequality(y >= 4)))
    assert len(scalar_question(problem_of(more)).given) == 1
    assert not Session().decide(more).verdict.true


ACUTE = inequality(phi > -PI / 2), inequality(phi < PI / 2)
height = log(tan(PI / 4 + phi / 2))
cosine = Condition("0", cos(phi), x)
OF_BOUNDED = [
    (claim(height, arcsinh(tan(phi)), *ACUTE), True),
    (claim(phi, PI / 2 - 2 * arctan(exp(-height)), *ACUTE), True),
    (claim(rate(height), rate(phi) / cos(phi), *ACUTE), True),
    (replace(claim(phi, arctan(x), *ACUTE), given=(Condition("0", tan(phi), x),)), True),
    (replace(claim(phi, arccos(x), inequality(phi >= 0), inequality(phi <= PI)), given=(cosine,)), True),
    (replace(claim(phi, arccos(x), inequality(phi >= 0), inequality(phi <= 2 * PI)), given=(cosine,)), False),
    (claim(arctan(tan(phi)), phi, inequality(phi > -PI / 2), inequality(phi < PI)), False),
    (claim(height, arcsinh(sin(phi)), *ACUTE), False),
]


@pytest.mark.sampled(3)
@pytest.mark.parametrize(("said", "true"), OF_BOUNDED, ids=range(len(OF_BOUNDED)))
def test_what_is_said_of_an_angle_between_bounds_is_decided(said: Claim, true: bool) -> None:
    """Inverse functions and roots have other values beyond."""
    verdict = Session().decide(said).verdict
    assert isinstance(verdict, Holds | HoldsUnder if true else Fails)
    assert not true or {*verdict.needs} >= {h.text for h in said.assuming}


def test_a_star_does_not_hide_the_shapes_of_exercises() -> None:
    """Once `from chasles.vocabulary.functions import *` made `Scalar()` an error of types."""
    shapes, words = (
        vars(import_module("chasles.statements.exercise")),
        vars(import_module("chasles.vocabulary.functions")),
    )
    public = {name for name in shapes.keys() & words.keys() if not name.startswith("_")}
    assert {name for name in public if shapes[name] is not words[name]} == set()
