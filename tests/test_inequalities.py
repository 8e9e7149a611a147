"""Inequalities assumed and claimed, angles between bounds, arguments said by what is assumed of unit vectors."""

from __future__ import annotations

from fractions import Fraction

import pytest

from chasles.checker.certificate import Rejected, check
from chasles.decisions.session import Session
from chasles.report import details
from chasles.report.equations import in_both, in_latex, in_words
from chasles.statements import Claim, Definition, nonzero, positive, unit
from chasles.statements.inequalities import inequality, says_that
from chasles.verdict import Contradictory, Fails, HoldsUnder, Undecided
from chasles.vocabulary import (
    CPM,
    LENGTH,
    PI,
    Identity,
    Misfit,
    array,
    column,
    cos,
    dot,
    matrix,
    norm,
    rate,
    scalar,
    sin,
    square,
    tan,
    tr,
    vector,
)
from chasles.vocabulary.functions import arccos, arcsin, atan2, sqrt

from .decided import claim, proved, refuted

t, x, y = (scalar(name, name, "a number") for name in "txy")
v, w, e = (vector(name, name, "a vector") for name in "vwe")
R = square("R", "R", "a rotation")
turn = Definition("0", R, e @ e.T + cos(t) * (Identity(3) - e @ e.T) + sin(t) * CPM(e), assuming=(unit(e),))
I = inequality

p = array("p", "p", "Euler-Rodrigues parameters", column(x, x, x, x))
vec = p[2:4]
of_p = Definition("0", R, Identity(3) + 2 * p[1] * CPM(vec) + 2 * CPM(vec) @ CPM(vec), assuming=(unit(p),))
half = Definition("0", p, column(cos(t / 2), e * sin(t / 2)), assuming=(unit(e),))
about_x = matrix((1, 0, 0), (0, cos(y), -sin(y)), (0, sin(y), cos(y)))
about_y = matrix((cos(x), 0, sin(x)), (0, 1, 0), (-sin(x), 0, cos(x)))
about_z = matrix((cos(t), -sin(t), 0), (sin(t), cos(t), 0), (0, 0, 1))
euler = Definition("0", R, about_z @ about_y @ about_x)

BETWEEN = I(x > -1), I(x < Fraction(1, 2))

TRUE = [
    (claim(abs(x), x, I(x >= 0)), ("x >= 0",)),
    (claim(abs(x), x, I(x >= 1)), ("x >= 1",)),
    (claim(abs(x), x, I(x > 1)), ("x > 1",)),
    (claim(abs(x), -x, I(x < 0)), ("x < 0",)),
    (claim(sqrt(x**2), x, I(x > 0)), ("x > 0",)),
    (claim(x / x, 1, I(x > 0)), ("x > 0",)),
    (claim(x * y, y * x, I(x >= 1)), ()),
    (claim(sqrt((1 - cos(t)) / 2), sin(t / 2), I(sin(t / 2) >= 0)), ("sin(t / 2) >= 0",)),
    (claim(cos(t / 2), sqrt((1 + cos(t)) / 2), I(t >= 0), I(t <= PI)), ("t >= 0", "t <= pi")),
    (
        claim(sin(t / 2), sin(t) / sqrt(2 * (1 + cos(t))), I(t > -PI), I(t < PI)),
        ("t > -pi", "t < pi"),
    ),
    (claim(abs(sin(t)), -sin(t), I(t >= PI), I(t <= 2 * PI)), ("t >= pi", "t <= 2 pi")),
    (claim(sqrt(x**2) * cos(t), abs(x) * cos(t), I(t >= PI / 3), I(t <= PI)), ()),
    (claim(sin(t / 2), sin(t) / sqrt(2 * (1 + cos(t))), I(cos(t / 2) > 0)), ("cos(t / 2) > 0", "2 cos(t) + 2 != 0")),
    (claim(arccos(cos(t)), t, I(t >= 0), I(t <= PI)), ("t >= 0", "t <= pi")),
    (claim(arccos(cos(t)), -t, I(t <= 0), I(t >= -PI)), ("t <= 0", "t >= -pi")),
    (claim(arccos(cos(2 * t)), 2 * t, I(t >= 0), I(2 * t <= PI)), ("t >= 0", "2 t <= pi")),
    (claim(arcsin(sin(t)), t, I(t >= -PI / 2), I(t <= PI / 2)), ("t >= -pi / 2", "t <= pi / 2")),
    (claim(atan2(sin(t), cos(t)), t, I(t > -PI), I(t <= PI)), ("t > -pi", "t <= pi")),
    (claim(atan2(x * sin(t), x * cos(t)), t, positive(x), I(t > -PI), I(t < PI)), ("x > 0", "t > -pi", "t < pi")),
    (claim(arcsin(x / sqrt(x**2 + y**2)), atan2(x, abs(y)), I(x**2 + y**2 > 0)), ("x^2 + y^2 != 0",)),
    (claim(arccos((tr(R) - 1) / 2), t, I(t >= 0), I(t <= PI), given=(turn,)), ("|e| = 1", "t >= 0", "t <= pi")),
    (claim(sqrt(1 + tr(R)) / 2, abs(cos(t / 2)), given=(turn,)), ("|e| = 1",)),
    (claim(p[1], sqrt(1 + tr(R)) / 2, I(p[1] > 0), given=(of_p,)), ("p_1 > 0", "|p| = 1")),
    (claim(x, -arcsin(R[3, 1]), I(x >= -PI / 2), I(x <= PI / 2), given=(euler,)), ("x >= -pi / 2", "x <= pi / 2")),
    (
        claim(y, atan2(R[3, 2], R[3, 3]), I(cos(x) > 0), I(y > -PI), I(y <= PI), given=(euler,)),
        ("cos(x) > 0", "y > -pi", "y <= pi"),
    ),
    (
        claim(x, atan2(-R[3, 1], sqrt(R[1, 1] ** 2 + R[2, 1] ** 2)), I(x > -PI / 2), I(x < PI / 2), given=(euler,)),
        ("x > -pi / 2", "x < pi / 2"),
    ),
    (claim(t, 2 * arccos(p[1]), I(t >= 0), I(t <= 2 * PI), given=(half,)), ("t >= 0", "t <= 2 pi")),
    (claim(t, arccos(2 * p[1] ** 2 - 1), I(t >= 0), I(t <= PI), given=(half,)), ("t >= 0", "t <= pi")),
    (claim(norm(p), 1, given=(half,)), ("|e| = 1",)),
    (claim(*says_that(x**2 + y**2 >= 2 * x * y)), ()),
    (claim(*says_that(x**2 + 1 > 0)), ()),
    (claim(*says_that(norm(v) >= 0)), ()),
    (claim(*says_that(cos(t) <= 1)), ()),
    (claim(*says_that(x >= 0), I(x > 1)), ("x > 1",)),
    # Of no rational number are both 1 + x and 1/2 - x squares of rational numbers.
    (
        claim(y / (1 + x) + y / (1 - 2 * x), y * (2 - x) / ((1 + x) * (1 - 2 * x)), *BETWEEN),
        ("1 + x != 0", "1 - 2 x != 0"),
    ),
    (claim(abs(x) + y, y, I(x >= 0), I(x <= 0)), ("x >= 0", "x <= 0")),
    (claim(abs(x * y) + abs(x - y), x * y + x - y, I(x * y > 0), I(x - y > 0)), ("x y > 0", "x - y > 0")),
    (claim(tan(t), sin(t) / cos(t), I(t > 0), I(t < PI / 2)), ("t > 0", "t < pi / 2")),
    (
        claim(sqrt(1 + tan(t) ** 2), 1 / cos(t), I(t > -PI / 2), I(t < PI / 2)),
        ("t > -pi / 2", "t < pi / 2"),
    ),
]
FALSE = [
    claim(abs(x), x, I(x <= 1)),
    claim(sqrt((1 + cos(t)) / 2), cos(t / 2), I(t >= 0), I(t <= 2 * PI)),
    claim(x * y, y, I(x >= 1)),
    claim(abs(x), x, I(x < 0)),
    claim(*says_that(x**2 >= x)),
    claim(*says_that(x**2 > 0)),
    claim(x**2, x, I(x > 1)),
    claim(y / (1 + x) + y / (1 - 2 * x), y * (2 + x) / ((1 + x) * (1 - 2 * x)), *BETWEEN),
    claim(rate(1 / x), rate(x) / x**2, I(x > 0), I(x < Fraction(3, 7))),
]


@pytest.mark.sampled(3)
@pytest.mark.parametrize(("said", "needs"), TRUE, ids=lambda said: f"{getattr(said, 'left', '')}")
def test_what_is_true_is_proved_and_names_what_it_needs(said: Claim, needs: tuple[str, ...]) -> None:
    assert set(proved(said).needs) == set(needs)


@pytest.mark.parametrize("said", FALSE, ids=lambda said: f"{said.left} = {said.right}")
def test_what_is_false_is_refuted_where_the_inequalities_hold(said: Claim) -> None:
    refuted(said)


@pytest.mark.sampled(4)
@pytest.mark.parametrize(
    "said",
    [
        claim(arccos(cos(t)), t, I(t >= 0), I(t <= 2 * PI)),
        claim(arccos(cos(t)), t, I(t >= -PI), I(t <= PI)),
        claim(arcsin(sin(t)), t, I(t >= 0), I(t <= PI)),
        claim(atan2(sin(t), cos(t)), t, I(t >= -PI), I(t <= PI)),
        claim(atan2(x * sin(t), x * cos(t)), t, nonzero(x), I(t > -PI), I(t < PI)),
        claim(arccos(cos(t)), t, I(t >= 0)),
        claim(y, atan2(R[3, 2], R[3, 3]), I(y > -PI), I(y <= PI), given=(euler,)),
        claim(x, atan2(-R[3, 1], sqrt(R[1, 1] ** 2 + R[2, 1] ** 2)), I(x >= -PI), I(x <= PI), given=(euler,)),
        claim(p[1], sqrt(1 + tr(R)) / 2, given=(of_p,)),
        claim(p[1], sqrt(1 + tr(R)) / 2, I(p[2] > 0), given=(of_p,)),
        claim(arccos(cos(t)), t),
        claim(arccos(cos(t + x)), t + x, I(t >= 0), I(t <= PI)),
    ],
    ids=lambda said: f"{said.left} {[h.text for h in said.assuming]}",
)
def test_an_angle_that_may_be_another_is_not_proved(said: Claim) -> None:
    assert isinstance(Session().decide(said).verdict, Fails | Undecided)


def test_the_checker_reads_the_bounds_itself() -> None:
    narrow = claim(arccos(cos(t)), t, I(t >= 0), I(t <= PI))
    verdict = Session().decide(narrow).verdict
    assert isinstance(verdict, HoldsUnder)
    for wide in (claim(arccos(cos(t)), t, I(t >= 0), I(t <= 2 * PI)), claim(arccos(cos(t)), t)):
        with pytest.raises(Rejected):
            check(wide, "printed", verdict.certificate)


def test_bounds_that_leave_no_room_or_contradict_one_another_prove_nothing() -> None:
    for said in (
        claim(arccos(cos(t)), t, I(t > PI), I(t < 0)),
        claim(x, x + 1, I(x > 1), I(x < 0)),
        claim(abs(x), x, I(x >= 1), I(x <= 0)),
    ):
        assert isinstance(Session().decide(said).verdict, Contradictory | Undecided)


def test_only_scalars_of_one_dimension_are_compared() -> None:
    with pytest.raises(Misfit):
        inequality(v > 0)
    with pytest.raises(Misfit):
        inequality(scalar("l", "l", "a length", LENGTH) > x)
    assert inequality(dot(v, w) >= rate(t) * 0).text == "v . w >= t_dot 0"


def test_a_comparison_is_printed_as_one_and_its_repair_compares() -> None:
    """Once printed as |d| = d, and repaired to a sum that is not negative."""
    a, b = scalar("a", "a", "a length"), scalar("b", "b", "another")
    wrong = Claim("1", *says_that((a + b) ** 2 <= a**2 + b**2), assuming=(positive(a), positive(b)))
    assert in_words(wrong) == ("a^2 + b^2 >= (a + b)^2",)
    assert in_latex(wrong) == (r"a^2 + b^2 \geq \left( a + b \right)^2",)
    assert in_words(Claim("2", *says_that(a**2 + 1 > 0))) == ("a^2 + 1 > 0",)
    assert in_words(Claim("3", *says_that(-(a**2) <= 0))) in {("a^2 >= 0",), ("-(-a^2) >= 0",), ("-a^2 <= 0",)}
    decision = Session().decide(wrong)
    assert " - (a + b)^2 = -" in dict(details.refuted(decision.verdict.counterexample, wrong))["where"]
    assert decision.correction is None or " >= (" in in_both(decision.correction.sides, "=")[0]
