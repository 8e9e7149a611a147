"""Inverses with cases: what is decided follows from the branches, and a wrong declaration does not come out as true."""

from __future__ import annotations

from dataclasses import replace
from functools import cache
from typing import Any

import pytest

from chasles.checker.certificate import check
from chasles.decisions.session import Session
from chasles.statements import (
    Branch,
    Chapter,
    Claim,
    Definition,
    Inverse,
    Statement,
    half_turn,
    load,
    nonzero,
    positive,
    rotation,
    unit,
)
from chasles.statements.inversion import problems_of_inverse
from chasles.verdict import Fails, HoldsUnder, Verdict
from chasles.vocabulary import (
    CPM,
    Identity,
    Misfit,
    Negative,
    Node,
    column,
    cos,
    norm,
    number,
    scalar,
    sin,
    square,
    tr,
    vect,
    vector,
)

e, u, p = vector("e", "e", ""), vector("u", "u", ""), vector("p", "p", "")
k, phi = scalar("k", "k", ""), scalar("phi", r"\phi", "")
Q, one = square("Q", "Q", ""), Identity(3)
x_axis = column(1, 0, 0)


@cache
def chapter() -> Chapter:
    return load()


def inverse(name: str) -> Inverse:
    (found,) = (entry.statement for entry in chapter().entries if entry.name == name)
    assert isinstance(found, Inverse)
    return found


def verdict_on(sentence: Inverse) -> Verdict:
    return Session().decide(sentence).verdict


def changed(sentence: Inverse, place: int, **change: Any) -> Inverse:
    """The inverse with one branch changed."""
    branches = list(sentence.branches)
    branches[place] = replace(branches[place], **change)
    return replace(sentence, branches=tuple(branches))


def values(branch: Branch, **change: Node) -> tuple[tuple[Node, Node], ...]:
    return tuple((key, change.get(str(key), value)) for key, value in branch.values)


stretched = Definition("1", u, k * e, assuming=(unit(e),))
"""A vector by its direction and its length."""
polar = Inverse(
    "2",
    of=stretched,
    branches=(
        Branch("it has a direction", norm(u), ((e, u / norm(u)), (k, norm(u)))),
        Branch("it has none", number(1), ((e, x_axis), (k, number(0))), by=number(1)),
    ),
    gives=(e, k),
)
turned = Definition("3", Q, e @ e.T + cos(phi) * (one - e @ e.T) + sin(phi) * CPM(e), assuming=(unit(e),))
_sine = norm(vect(Q))
_columns = [(Q + one) @ column(*(int(j == n) for j in range(3))) for n in range(3)]
by_half_turns = Inverse(
    "4",
    of=turned,
    branches=(
        Branch(
            "in general",
            _sine,
            ((e, vect(Q) / _sine), (cos(phi), (tr(Q) - 1) / 2), (sin(phi), _sine)),
            by=-_sine / 3,
        ),
        *(
            Branch(
                f"a half-turn by column {n}",
                norm(v),
                ((e, v / norm(v)), (cos(phi), number(-1)), (sin(phi), number(0))),
                by=norm(v) * (5 - tr(Q)) / 24,
                assuming=(half_turn(Q),),
            )
            for n, v in enumerate(_columns)
        ),
    ),
    gives=(e, phi),
    assuming=(rotation(Q), nonzero(3 - tr(Q), r"\phi \neq 0")),
    sign=(e, sin(phi)),
)


def test_the_inverses_of_the_book_say_what_they_need() -> None:
    needs = {
        "natural_invariants": ("Q is a rotation", "phi != 0"),
        "euler_rodrigues_parameters": ("Q is a rotation",),
        "screw_of_motion": ("Q is a rotation", "phi != 0"),
    }
    for name, needed in needs.items():
        verdict = verdict_on(inverse(name))
        assert isinstance(verdict, HoldsUnder)
        assert verdict.needs == needed


@pytest.mark.sampled(2)
@pytest.mark.parametrize("sentence", [polar, by_half_turns], ids=["polar", "by_half_turns"])
def test_a_later_branch_is_taken_where_the_earlier_ones_are_not(sentence: Inverse) -> None:
    verdict = verdict_on(sentence)
    assert isinstance(verdict, HoldsUnder)
    check(sentence, "printed", verdict.certificate)
    shuffled = replace(sentence, branches=sentence.branches[::-1])
    assert not verdict_on(shuffled).true or sentence is not polar


@pytest.mark.sampled(3)
@pytest.mark.parametrize("name", ["natural_invariants", "euler_rodrigues_parameters"])
@pytest.mark.parametrize("place", range(4))
def test_a_branch_left_out_is_missed(name: str, place: int) -> None:
    whole = inverse(name)
    rest = whole.branches[:place] + whole.branches[place + 1 :]
    verdict = verdict_on(replace(whole, branches=rest))
    assert isinstance(verdict, Fails)
    assert verdict.counterexample.goal == "no case is left out"


@pytest.mark.sampled(4)
@pytest.mark.parametrize("place", range(4))
def test_a_branch_left_out_of_half_turns_is_missed(place: int) -> None:
    rest = by_half_turns.branches[:place] + by_half_turns.branches[place + 1 :]
    assert isinstance(verdict_on(replace(by_half_turns, branches=rest)), Fails)


def test_no_branch_covers_nothing() -> None:
    assert isinstance(verdict_on(replace(polar, branches=())), Fails)


def test_a_branch_taken_where_its_values_are_not_defined_does_not_hold() -> None:
    whole = inverse("natural_invariants")
    other = whole.branches[1].where
    assert not verdict_on(changed(whole, 0, where=other)).true
    assert not verdict_on(changed(whole, 0, where=number(1), by=number(0))).true
    assert not verdict_on(changed(polar, 0, where=number(1))).true


@pytest.mark.sampled(2)
@pytest.mark.parametrize("name", ["natural_invariants", "euler_rodrigues_parameters"])
def test_a_sign_turned_in_one_value_fails(name: str) -> None:
    whole = inverse(name)
    for key, value in whole.branches[1].values:
        wrong = values(whole.branches[1], **{str(key): Negative(value)})
        assert isinstance(verdict_on(changed(whole, 1, values=wrong)), Fails)


def test_the_sign_turns_all_that_it_must() -> None:
    whole = inverse("natural_invariants")
    for sign in ((e,), (cos(phi / 2),), (e, sin(phi / 2), cos(phi / 2))):
        named = tuple(key for key, _ in whole.branches[0].values if str(key) in map(str, sign))
        assert len(named) == len(sign)
        assert isinstance(verdict_on(replace(whole, sign=named)), Fails)


def test_values_off_the_unit_circle_fail() -> None:
    first = by_half_turns.branches[1]
    off = values(first, **{"sin(phi)": number(1)})
    assert isinstance(verdict_on(changed(by_half_turns, 1, values=off)), Fails)


def test_what_the_formula_assumes_is_asked_of_the_values() -> None:
    doubled = Branch("it has a direction", norm(u), ((e, 2 * u / norm(u)), (k, norm(u) / 2)))
    verdict = verdict_on(replace(polar, branches=(doubled, polar.branches[1])))
    assert isinstance(verdict, Fails)
    assert verdict.counterexample.goal == "the values satisfy |e| = 1"
    strict = replace(polar, of=replace(stretched, assuming=(unit(e), nonzero(k))))
    assert not verdict_on(strict).true
    where_it_is = replace(strict, branches=(replace(polar.branches[0], by=1 / norm(u)),), assuming=(nonzero(norm(u)),))
    assert verdict_on(where_it_is).needs == ("|u| != 0",)  # type: ignore[attr-defined]


def test_what_the_arguments_obey_is_asked_of_the_values() -> None:
    of = Definition("5", u, k * p)
    constraint = Claim("6", norm(p) ** 2, number(1), assuming=(unit(p),))
    branch = Branch("always", number(1), ((p, u), (k, number(1))), by=number(1))
    loose = Inverse("7", of=of, branches=(branch,), gives=(p, k))
    assert verdict_on(loose).true
    verdict = verdict_on(replace(loose, satisfying=(constraint,)))
    assert isinstance(verdict, Fails)
    assert verdict.counterexample.goal == "the values satisfy (6)"


def test_what_a_branch_assumes_is_shown_where_it_is_taken() -> None:
    whole = inverse("natural_invariants")
    everywhere = replace(whole, assuming=(rotation(Q),))
    assert not verdict_on(everywhere).true
    assert not verdict_on(changed(whole, 0, inverses=())).true
    assert not verdict_on(changed(whole, 0, inverses=((whole.branches[0].inverses[0][0], number(1)),))).true
    eager = changed(by_half_turns, 0, assuming=(half_turn(Q),))
    assert not verdict_on(eager).true
    anywhere = replace(by_half_turns, assuming=(rotation(Q),))
    assert not verdict_on(anywhere).true


def test_the_problems_of_an_inverse_have_names_of_their_own() -> None:
    for sentence in (*map(inverse, ("natural_invariants", "euler_rodrigues_parameters")), by_half_turns, polar):
        names = [says for says, _ in problems_of_inverse(sentence)]
        assert len(set(names)) == len(names)
    with pytest.raises(TypeError, match="two cases called 'it has none'"):
        replace(polar, branches=(polar.branches[1], polar.branches[1]))
    with pytest.raises(TypeError, match="two cases called 'no case is left out'"):
        replace(polar, branches=(replace(polar.branches[1], says="no case is left out"),))


def test_branches_that_cannot_be_are_refused() -> None:
    def declared(of: Statement = turned, **change: Any) -> Inverse:
        return Inverse("8", of=of, branches=(replace(by_half_turns.branches[0], **change),), gives=(e,))

    first = by_half_turns.branches[0].values
    with pytest.raises(TypeError, match="by both its cosine and its sine"):
        declared(values=first[:2])
    with pytest.raises(Misfit, match="e cannot have the value"):
        declared(values=((e, Q), *first[1:]))
    with pytest.raises(Misfit, match="scalars"):
        declared(where=vect(Q))
    with pytest.raises(TypeError, match="that k > 0 cannot be shown"):
        declared(assuming=(positive(k),))
    with pytest.raises(TypeError, match="phi > 0 cannot be shown"):
        declared(of=replace(turned, assuming=(unit(e), positive(phi))))
    with pytest.raises(TypeError, match="is asked of an angle"):
        declared(of=replace(turned, assuming=(unit(e), nonzero(phi))))
    with pytest.raises(TypeError, match="gives no value to k, whose sign turns"):
        replace(by_half_turns, sign=(k,))
