"""What may follow from premises: nothing that is proved differs at a random motion, and what fails there differs."""

from __future__ import annotations

from collections.abc import Callable
from itertools import chain

import mpmath
import numpy as np
import pytest

from chasles.decisions.recalled import session_of
from chasles.evaluation import matrices
from chasles.motions.time_series import FUNCTIONS, TimeSeries, matrix_product
from chasles.pages.consequences import Consequences
from chasles.pages.premises import PosedEquation, Rules
from chasles.statements import Claim, Definition, Hypothesis, Problem, load, problem_of, rotation, unit
from chasles.vocabulary import (
    FREQUENCY,
    Identity,
    Integral,
    Node,
    Symbol,
    cos,
    cross,
    dot,
    norm,
    number,
    rate,
    scalar,
    sin,
    square,
    undotted,
    vector,
)
from chasles.vocabulary.functions import FunctionOf, sqrt

from .sampling import WHOLE, sample

Pair = tuple[Node, Node]
Facts = Callable[[Symbol], tuple[Hypothesis, ...]]
"""What is known of a symbol."""
MPMATH = {"arcsin": "asin", "arccos": "acos", "arctan": "atan", "log": "ln"}


def premises(problem: Problem) -> tuple[Rules, Facts] | None:
    """The rules of a problem, and the facts of its symbols; None where more is assumed than they say."""
    about = [h for h in problem.hypotheses if h.equations or h.kind == "positive"]
    if problem.conditions or any(len(h.subjects) != 1 or not isinstance(h.subjects[0], Symbol) for h in about):
        return None
    rules = {undotted(left): Definition("", left, right) for left, right in problem.rules}
    return rules, lambda symbol: tuple(h for h in about if h.subjects == (symbol,))


@pytest.mark.sampled(2)
@pytest.mark.parametrize("chapter", ["chasles.derivations", "chasles.rotations"])
def test_a_verdict_of_a_chapter_is_foretold(chapter: str) -> None:
    told = {True: 0, False: 0}
    book = load(chapter)
    session = session_of(book)
    for claim in sample((each.statement for each in book), 4):
        if not isinstance(claim, Claim) or claim.fault:
            continue
        verdict = session.decide(claim).verdict
        problem = problem_of(claim, "printed", session.accepted)
        known = premises(problem)
        if known is None or verdict.name not in ("holds", "holds-under", "fails"):
            continue
        asked = Consequences(known[1])
        found = [asked.may_follow(goal.left, goal.right, known[0]) for goal in problem.goals]
        if None not in found:
            told[verdict.true] += 1
            assert all(found) == verdict.true, claim
    of_all = 1 if WHOLE else 5
    assert told[True] * of_all > 60
    assert sum(told.values()) * of_all > 200


a, b, e, p = (vector(name, name, "a vector") for name in "abep")
w = vector("w", "w", "angular velocity", FREQUENCY)
Q = square("Q", r"\mathbf{Q}", "rotation")
k, m = scalar("k", "k", "a number"), scalar("m", "m", "a mass", constant=True)
v = scalar("rho", r"\rho", "density")


def following(
    left: Node, right: Node, *premises: tuple[Node, Node], posed: tuple[tuple[Node, Node], ...] = ()
) -> object:
    """What is told of two sides where symbols are what the premises say, Q is a rotation and e a unit vector."""
    known = {Q: (rotation(Q),), e: (unit(e),)}
    rules = {undotted(left): Definition("", left, right) for left, right in premises}
    nothing = Hypothesis("posed", ())
    said = [PosedEquation(nothing, one, other, False) for one, other in posed]
    return Consequences(lambda symbol: known.get(symbol, ())).may_follow(left, right, rules, said)


def test_a_rule_for_a_rate_says_what_higher_rates_are() -> None:
    assert following(rate(rate(a)), cross(rate(w), a) + cross(w, cross(w, a)), (rate(a), cross(w, a)))
    assert following(rate(rate(a)), cross(w, cross(w, a)), (rate(a), cross(w, a))) is False


def test_rules_for_a_quantity_and_its_rate_both_hold() -> None:
    said = (p, a + Q @ b), (rate(p), rate(a) + rate(Q) @ b)
    assert following(rate(b), 0 * b, *said)
    assert following(rate(a), 0 * a, *said) is False


def test_what_is_posed_holds_with_its_rates() -> None:
    assert following(dot(rate(a), b), -dot(a, rate(b)), posed=((dot(a, b), number(3)),))
    assert following(dot(rate(a), rate(b)), number(0), posed=((dot(a, b), number(3)),)) is False


def test_nothing_follows_where_no_motion_is() -> None:
    assert following(a, a, posed=((dot(a, a), number(-1)),)) is False
    assert following(a, a, posed=((norm(e), number(2)),)) is False


def test_facts_hold_at_every_motion() -> None:
    assert following(Q.T @ Q, Identity(3))
    assert following(dot(e, rate(e)), number(0))
    assert following(Q, Q.T) is False


def test_an_integral_is_a_sum_over_elements_that_keep_their_masses() -> None:
    total, turned = Integral(v * cross(p, rate(p)), v, (p,)), Integral(v * cross(p, rate(rate(p))), v, (p,))
    assert following(rate(total), turned)
    assert following(rate(total), 2 * turned) is False
    assert following(Integral(v * cross(a, p), v, (p,)), cross(a, Integral(v * p, v, (p,))))


@pytest.mark.parametrize("name", sorted(set(FUNCTIONS) - {"atan2", "sign", "max", "min"}))
def test_a_function_has_the_terms_of_its_series(name: str) -> None:
    inner = [0.3, 0.7, -0.2, 0.1, 0.05]
    found = FUNCTIONS[name](TimeSeries(np.array(inner).reshape(-1, 1, 1)))
    function = getattr(mpmath, MPMATH.get(name, name), abs)
    exact = mpmath.taylor(lambda t: function(sum(c * t**k for k, c in enumerate(inner))), 0, len(inner) - 1)
    assert np.allclose(found.terms.ravel(), [float(c) for c in exact], rtol=1e-9)


def test_an_angle_by_its_tangent_moves_as_its_sine_and_cosine() -> None:
    angle = FunctionOf("atan2", (sin(k), cos(k)))
    assert following(rate(rate(angle)), rate(rate(k)))


def test_premises_are_the_least_from_which_it_follows() -> None:
    rules: Rules = {undotted(x): Definition("", x, y) for x, y in ((p, a + b), (rate(a), cross(w, a)), (b, 2 * e))}
    nothing = Hypothesis("posed", ())
    needed, other = (PosedEquation(nothing, x, y, False) for x, y in ((dot(a, b), number(3)), (k, number(2))))
    consequences = Consequences(lambda symbol: ())
    assert consequences.least(rate(p), cross(w, a) + rate(b), rules, ()) == (
        {quantity: rules[quantity] for quantity in rules if quantity[0] in (p, a)},
        (),
    )
    assert consequences.least(dot(a, b), number(3), {}, (other, needed))[1] == (needed,)


def test_what_has_no_value_is_not_known() -> None:
    assert following(FunctionOf("sqrt", (-dot(a, a),)), number(0)) is None


@pytest.mark.parametrize("name", "abdefg")
def test_roots_are_compared_where_they_are_real(name: str) -> None:
    """Three free letters are positive at one motion of eight."""
    x, y, z = (scalar(name + letter, name + letter, "a number") for letter in "xyz")
    consequences = Consequences(lambda _: ())
    assert consequences.may_follow(sqrt(x) * sqrt(y) * sqrt(z), sqrt(z) * sqrt(x) * sqrt(y), {}) is True
    assert consequences.may_follow(sqrt(x) * sqrt(y) * sqrt(z), sqrt(x) * sqrt(y) * z, {}) is False


@pytest.mark.parametrize("terms", [3, 4])
@pytest.mark.parametrize("shape", [(3, 3, 3), (3, 3, 1), (2, 1, 1)])
def test_a_product_of_all_entries_at_once_is_that_of_each(shape: tuple[int, int, int], terms: int) -> None:
    rows, inner, columns = shape
    numbers = np.random.default_rng(1)
    linear = np.array([1.0, 1.0, 0.0]).reshape(-1, 1, 1)
    left = [[TimeSeries(linear * numbers.uniform(size=(3, 4, 1)), 2) for _ in range(inner)] for _ in range(rows)]
    right = [[TimeSeries(numbers.uniform(size=(terms, 1, 2))) for _ in range(columns)] for _ in range(inner)]
    left[0][0] = TimeSeries(np.zeros((terms, 1, 1)), 0)
    found, expected = matrix_product(left, right), matrices.product(left, right)
    for one, other in zip(chain(*found), chain(*expected), strict=True):
        assert len(one) == len(other)
        np.testing.assert_allclose(*np.broadcast_arrays(one.terms, other.terms), rtol=1e-14)
        assert not np.any(one.terms[one.reach :])
