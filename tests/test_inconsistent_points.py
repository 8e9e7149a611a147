"""A counterexample satisfies what is assumed and given jointly: what is said of a rate bears on what it is of."""

from __future__ import annotations

from collections.abc import Mapping
from fractions import Fraction

import pytest

from chasles.checker.certificate import Rejected, check
from chasles.checker.refutation import check_counterexample
from chasles.prover.decide import decide_problem
from chasles.statements import Claim, Condition, Definition, Problem, positive, problem_of, symmetric, unit
from chasles.verdict import Counterexample, Fails, Holds, HoldsUnder
from chasles.vocabulary import FREQUENCY, cross, dot, rate, scalar, square, vector

e, u, x = (vector(name, name, "") for name in "eux")
v, omega = (vector(name, name, "", FREQUENCY) for name in ("v", "omega"))
s = vector("s", "s", "", FREQUENCY * FREQUENCY)
k, m = scalar("k", "k", "", FREQUENCY), scalar("m", "m", "")
M, W = square("M", "M", ""), square("W", "W", "", FREQUENCY)


def at(**values: float) -> Mapping[str, Fraction]:
    return {name: Fraction(value) for name, value in values.items()}


def vectors(**values: tuple[float, float, float]) -> Mapping[str, Fraction]:
    return at(**{f"{name}_{i + 1}": value for name, entries in values.items() for i, value in enumerate(entries)})


def test_a_given_rate_of_a_unit_vector_is_perpendicular_to_it() -> None:
    given = Definition("1", rate(e), v)
    problem = problem_of(Claim("2", dot(e, v), 7 * k, given=(given,), assuming=(unit(e),)))
    shown = Counterexample(vectors(e=(1, 0, 0), v=(3, 0, 0)) | at(k=1), (1, 1), "3", "7")
    with pytest.raises(Rejected, match=r"does not satisfy \|e\| = 1 \(dot\)"):
        check_counterexample(problem, shown)
    check_counterexample(problem, Counterexample(vectors(e=(1, 0, 0), v=(0, 3, 0)) | at(k=1), (1, 1), "0", "7"))
    check_counterexample(problem, refuted(problem))
    proved(problem_of(Claim("2", dot(e, v), 0 * k, given=(given,), assuming=(unit(e),))))


def test_a_given_second_rate_is_that_of_a_unit_vector() -> None:
    given = (Definition("1", rate(e), v), Definition("2", rate(rate(e)), s))
    problem = problem_of(Claim("3", dot(e, s), 7 * k**2, given=given, assuming=(unit(e),)))
    shown = Counterexample(vectors(e=(1, 0, 0), v=(0, 1, 0), s=(3, 0, 0)) | at(k=1), (1, 1), "3", "7")
    with pytest.raises(Rejected, match="does not satisfy"):
        check_counterexample(problem, shown)
    check_counterexample(problem, refuted(problem))
    proved(problem_of(Claim("3", dot(e, s), -dot(v, v), given=given, assuming=(unit(e),))))


def test_a_quantity_and_its_rate_both_given_agree() -> None:
    given = (Definition("1", x, 2 * u), Definition("2", rate(x), cross(omega, u)))
    problem = problem_of(Claim("3", rate(u), cross(omega, u), given=given))
    shown = Counterexample(vectors(u=(1, 0, 0), omega=(0, 0, 1), u_dot=(5, 0, 0)), (1, 1), "5", "0")
    with pytest.raises(Rejected, match="is the rate of x"):
        check_counterexample(problem, shown)
    check_counterexample(problem, refuted(problem))
    proved(problem_of(Claim("3", rate(u), cross(omega, u) / 2, given=given)))


def test_what_a_condition_determines_has_the_rate_that_follows() -> None:
    problem = problem_of(Claim("2", rate(x), rate(u), given=(Condition("1", 2 * x, u, on=(x,)),)))
    shown = Counterexample(vectors(u=(2, 0, 0), x=(1, 0, 0), u_dot=(4, 0, 0), x_dot=(3, 0, 0)), (1, 1), "3", "4")
    with pytest.raises(Rejected, match=r"does not satisfy .*\(dot\)"):
        check_counterexample(problem, shown)
    check_counterexample(problem, refuted(problem))


def test_a_given_rate_keeps_a_matrix_symmetric() -> None:
    given = Definition("1", rate(M), W)
    problem = problem_of(Claim("2", W, 2 * W, given=(given,), assuming=(symmetric(M),)))
    check_counterexample(problem, refuted(problem))
    proved(problem_of(Claim("2", W, W.T, given=(given,), assuming=(symmetric(M),))))


def test_rates_that_nothing_ties_stay_free() -> None:
    problem = problem_of(Claim("2", rate(m), k, given=(Definition("1", rate(e), v),), assuming=(unit(e), positive(m))))
    check_counterexample(problem, Counterexample(at(k=2, m=1, m_dot=1), (1, 1), "1", "2"))


def refuted(problem: Problem) -> Counterexample:
    verdict = decide_problem(problem)
    assert isinstance(verdict, Fails)
    return verdict.counterexample


def proved(problem: Problem) -> None:
    verdict = decide_problem(problem)
    assert isinstance(verdict, Holds | HoldsUnder)
    check(problem, "", verdict.certificate)
