"""What is proved from few rates of what is assumed, or multiplied by what does not vanish, the checker accepts."""

from __future__ import annotations

import pytest

from chasles.checker.certificate import Rejected, check
from chasles.pages.attempts import solving
from chasles.pages.bounded_proofs import LIKELY
from chasles.pages.premises import PosedEquation, Premises
from chasles.problems.context import build
from chasles.prover.decide import decide_problem
from chasles.statements import Claim, Hypothesis, Problem, nonzero, problem_of
from chasles.verdict import Fails
from chasles.vocabulary import (
    CPM,
    FREQUENCY,
    LENGTH,
    TIME,
    Node,
    Sum,
    Zero,
    cross,
    dot,
    norm,
    paren,
    rate,
    scalar,
    vector,
)

a, b, p = (vector(name, name, "") for name in "abp")
w = vector("w", "w", "", FREQUENCY)
c, d = (vector(name, name, "", FREQUENCY) for name in "cd")
v = scalar("v", "v", "")
s = scalar("s", "s", "", FREQUENCY)
OMEGA = CPM(w)


def posed(left: Node, right: Node, said: str = "(1)") -> Hypothesis:
    return Hypothesis("posed", (Sum((left, -right)),), ((left, right),), (), said, said, free=True)


AXIS = posed(OMEGA @ paren(p - a) - 1 / norm(w) ** 2 * OMEGA**2 @ rate(a), Zero(3, 1))


def problem(left: Node, right: Node, *assuming: Hypothesis) -> Problem:
    return problem_of(Claim("2", left, right, assuming=assuming))


def test_few_rates_of_what_is_assumed_are_taken_for_a_proof() -> None:
    asked = problem(OMEGA @ p, OMEGA @ paren(a + 1 / norm(w) ** 2 * OMEGA @ rate(a)), nonzero(norm(w)), AXIS)
    assert max(g.order for g in build(asked).generators) == 0
    for source in (LIKELY, None):
        verdict = decide_problem(asked, (), 1e6, source)
        assert verdict.true
        check(asked, "", verdict.certificate)


def test_rates_that_a_claim_asks_for_are_taken() -> None:
    asked = problem(dot(rate(a), b), -dot(a, rate(b)), posed(dot(a, b), v), posed(rate(v), 0 * v))
    assert {g.order for g in build(asked).generators} == {0, 1}


def test_rates_that_follow_from_each_other_without_end_are_not_taken_without_end() -> None:
    turned = posed(rate(a), s / norm(b) * (CPM(b) @ a))
    changed = posed(rate(b), s / norm(b) * (CPM(a) @ b), "(2)")
    asked = problem(dot(rate(a), b), 0 * s, turned, changed, nonzero(norm(b)))
    assert max(g.order for g in build(asked).generators) == 0
    verdict = decide_problem(asked)
    assert verdict.true
    check(asked, "", verdict.certificate)


def test_an_equation_between_rates_alone_is_one_of_them() -> None:
    asked = problem(dot(a, b), v, posed(rate(a), rate(b)))
    assert {g.order for g in build(asked).generators} == {0}
    assert isinstance(decide_problem(asked), Fails)


def test_what_only_higher_rates_restrict_is_not_refuted() -> None:
    first = posed(rate(a), c)
    assert not isinstance(decide_problem(problem(rate(c), rate(d), first, posed(rate(a), d, "(2)"))), Fails)
    assert decide_problem(problem(rate(c), rate(d), first, posed(rate(rate(a)), rate(d), "(2)"))).true


def test_what_is_proved_may_be_multiplied_by_what_does_not_vanish() -> None:
    asked = problem(v / norm(w), dot(p, w) / norm(w) ** 2, nonzero(norm(w)), posed(dot(v / norm(w) * w, w), dot(p, w)))
    verdict = decide_problem(asked)
    assert verdict.true
    check(asked, "", verdict.certificate)
    (entry,) = verdict.certificate["entries"].values()
    with pytest.raises(Rejected):
        check(asked, "", {**verdict.certificate, "entries": {"0:0,0": {**entry, "denominator": {}}}})


def test_it_is_multiplied_so_often_as_a_law_divides() -> None:
    k = scalar("k", "k", "", LENGTH**3 / TIME**2, constant=True)
    x = vector("x", "x", "", LENGTH)
    law = posed(rate(rate(x)), -(k / norm(x) ** 3 * x))
    asked = problem(rate(cross(x, rate(x))), Zero(3, 1), nonzero(norm(x)), law)
    verdict = decide_problem(asked)
    assert verdict.true
    check(asked, "", verdict.certificate)


def test_posed_equations_on_the_letter_that_a_claim_is_about_determine_it() -> None:
    claim = Claim("2", p, a + b, assuming=(AXIS,), sic=True)
    known = Premises(lambda symbol: ())
    about = PosedEquation(AXIS, *AXIS.equations[0], open=False)
    found = [(solved.given[-1], solved.assuming, names) for solved, names in solving(claim, known, (about,))]
    assert [(condition.on, *rest) for condition, *rest in found] == [((p,), (), ("(1)",)), ((p, w), (), ("(1)",))]
    assert not [*solving(Claim("2", rate(p), rate(a), sic=True), known, (about,))]
    assert not [*solving(Claim("2", dot(p, a), v, sic=True), known, (about,))]
