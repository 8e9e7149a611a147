"""Counterexamples are for people: one entry, what it depends on and no more, small numbers, few of them not zero."""

from __future__ import annotations

from itertools import islice

import pytest

from chasles.checker.refutation import check_counterexample
from chasles.decisions.session import Session
from chasles.prover.decide import decide_problem
from chasles.statements import Claim, Theorem, load, nonzero, problem_of, symmetric, unit
from chasles.verdict import Counterexample, Fails
from chasles.vocabulary import (
    CPM,
    Identity,
    column,
    cos,
    cross,
    dot,
    norm,
    number,
    paren,
    rate,
    scalar,
    sin,
    square,
    vector,
)

from .decided import chapter_session
from .explanations import completions

e, a, b = (vector(name, name, "a vector") for name in "eab")
phi, x = (scalar(name, name, "a number") for name in ("phi", "x"))
S = square("S", "S", "a matrix")
one = Identity(3)


def refuted(claim: Claim) -> Counterexample:
    problem = problem_of(claim)
    verdict = decide_problem(problem, claim.assuming)
    assert isinstance(verdict, Fails)
    check_counterexample(problem, verdict.counterexample)
    return verdict.counterexample


def test_only_what_the_entry_depends_on_is_named() -> None:
    shown = refuted(Claim("1", column(S @ a, 2 * b), column(S @ a, b), assuming=(symmetric(S),)))
    assert set(shown.at) == {"b_1", "b_2", "b_3"}
    assert sorted(map(abs, shown.at.values())) == [0, 0, 1]


def test_what_a_hypothesis_ties_to_the_entry_is_named_too() -> None:
    shown = refuted(Claim("1", rate(e), 2 * rate(e), assuming=(unit(e),)))
    assert set(shown.at) == {f"{name}_{k}" for name in ("e", "e_dot") for k in (1, 2, 3)}
    shown = refuted(Claim("1", S @ S, one, assuming=(symmetric(S),)))
    assert {"S_12", "S_21"} <= set(shown.at) or {"S_13", "S_31"} <= set(shown.at) or {"S_23", "S_32"} <= set(shown.at)


def test_of_a_matrix_that_nothing_ties_single_entries_are_named() -> None:
    shown = refuted(Claim("1", S, 2 * S))
    assert len(shown.at) == 1


@pytest.mark.parametrize(
    "claim",
    [
        Claim("1", cross(e, a), a, assuming=(unit(e),)),
        Claim("1", sin(phi) * e, cos(phi) * e, assuming=(unit(e),)),
        Claim("1", paren(one - e @ e.T) @ a, a, assuming=(unit(e),)),
        Claim("1", norm(a) ** 2, dot(a, b), assuming=(nonzero(norm(a)),)),
        Claim("1", CPM(a) @ S, S @ CPM(a)),
        Claim("1", rate(x * a), x * rate(a)),
    ],
)
def test_few_numbers_are_not_zero_and_these_are_small(claim: Claim) -> None:
    values = [value for value in refuted(claim).at.values() if value]
    assert len(values) <= 3
    assert all(abs(value) == 1 for value in values)


def test_the_book_is_refuted_by_numbers_to_calculate_with_by_hand() -> None:
    found = []
    # What does not stand, as it is without a search for what stands in its place.
    plain = Session()
    for entry, known in chapter_session().decide_all(load()):
        if isinstance(entry.statement, Claim | Theorem) and not known.verdict.true:
            decision = plain.decide(entry.statement)
            verdicts = [decision.verdict, *([decision.correction.verdict] if decision.correction else [])]
            found += [verdict.counterexample for verdict in verdicts if isinstance(verdict, Fails)]
    assert len(found) >= 6
    for shown in found:
        assert len(shown.at) <= 10
        values = [value for value in shown.at.values() if value]
        assert len(values) <= 4
        assert all(abs(value) <= 2 and value.denominator == 1 for value in values)


def test_by_which_fraction_an_angle_is_measured_is_said() -> None:
    shown = refuted(Claim("1", column(cos(phi), sin(phi / 2), 2 * x), column(cos(phi), sin(phi / 2), x)))
    assert {"cos(phi/2)", "sin(phi/2)", "x"} == set(shown.at)


def test_what_is_not_named_may_have_any_value_that_is_possible() -> None:
    claim = Claim("1", column(dot(e, b) * e, sin(phi) * a), column(e, sin(phi) * a), assuming=(unit(e),))
    shown = refuted(claim)
    asked, (row, _) = problem_of(claim), shown.entry
    assert not any(name in shown.at for name in ("a_1", "cos(phi)", "sin(phi)"))
    found = list(islice(completions(asked, shown), 5))
    assert len(found) == 5
    assert len({str(words.value(a)) for words in found}) > 1
    for words in found:
        left, right = words.sides(claim.left, claim.right)
        assert (str(left[row - 1][0]), str(right[row - 1][0])) == (shown.left, shown.right)


def test_a_counterexample_is_found_where_no_plain_point_is_one() -> None:
    small = x * paren(x - 1) * paren(x + 1) * paren(x - 2) * paren(x + 2)
    shown = refuted(Claim("1", small, number(0)))
    assert abs(shown.at["x"]) > 2
