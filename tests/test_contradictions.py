"""Hypotheses that nothing satisfies: nothing is decided under them, and a least set of them is named, with a proof."""

from __future__ import annotations

from copy import deepcopy
from typing import Any

import pytest

from chasles.checker.certificate import Rejected
from chasles.checker.contradiction import check_contradiction
from chasles.decisions.plain_data import from_data, to_data
from chasles.decisions.session import Session
from chasles.prover.decide import decide_problem
from chasles.statements import (
    Always,
    Claim,
    Condition,
    Definition,
    Hypothesis,
    Iff,
    Statement,
    Theorem,
    definite,
    half_turn,
    nonzero,
    orthonormal,
    perpendicular,
    positive,
    problem_of,
    rotation,
    symmetric,
    unit,
    unit_column,
)
from chasles.verdict import Contradictory, Fails, Holds, HoldsUnder, Undecided
from chasles.vocabulary import (
    CPM,
    FREQUENCY,
    Identity,
    Node,
    Zero,
    cos,
    det,
    dot,
    norm,
    number,
    rate,
    scalar,
    sin,
    square,
    tr,
    vector,
)

a, b, e, f, g, p, q = (vector(name, name, "") for name in "abefgpq")
m, k, phi = (scalar(name, name, "") for name in ("m", "k", "phi"))
often = scalar("n", "n", "", FREQUENCY, constant=True)
w = vector("w", "w", "", FREQUENCY)
M, N, Q = (square(name, name, "") for name in "MNQ")
Assumed = tuple[Hypothesis, ...]


def let(left: Node, right: Node) -> Definition:
    return Definition(f"d {left}", left, right)


CONTRADICTORY: dict[str, tuple[tuple[Statement, ...], Assumed, Assumed]] = {
    "twice a unit vector": ((let(f, 2 * e),), (unit(e), unit(f)), ()),
    "twice a unit vector, among others": ((let(f, 2 * e),), (unit(e), unit(f)), (positive(m), unit(a), rotation(Q))),
    "no vector of length one": ((let(e, Zero(3, 1)),), (unit(e),), (positive(m),)),
    "a vector of no length": ((let(e, Zero(3, 1)),), (nonzero(norm(e)),), (unit(f),)),
    "a unit vector at right angles to itself": ((let(f, e),), (unit(e), perpendicular(e, f)), (nonzero(k),)),
    "a positive number that is -1": ((let(m, number(-1)),), (positive(m),), (unit(e),)),
    "a positive number that is zero": ((let(m, number(0)),), (positive(m),), (unit(e),)),
    "zero that is none": ((let(m, number(0)),), (nonzero(m),), (unit(e),)),
    "a positive number minus a square": ((let(m, -(k**2)),), (positive(m),), (unit(e),)),
    "a positive number minus squares": ((let(m, -dot(a, a) - 1),), (positive(m),), ()),
    "a positive number minus a length": ((let(m, -norm(a)),), (positive(m),), ()),
    "a positive number minus another": ((let(m, -k),), (positive(m), positive(k)), (unit(e),)),
    "a positive number minus a product": ((let(m, -k * norm(a)),), (positive(m), positive(k)), ()),
    "right angles that are none": ((), (nonzero(dot(e, f)), perpendicular(e, f)), (unit(e),)),
    "a determinant of no rotation": ((), (rotation(Q), nonzero(det(Q) - 1)), (unit(e),)),
    "twice a rotation": ((let(M, 2 * Q),), (rotation(Q), rotation(M)), ()),
    "a triad not at right angles": ((), (orthonormal(e, f, g), nonzero(dot(e, f))), (positive(m),)),
    "a triad of no length one": ((), (orthonormal(e, f, g), nonzero(dot(g, g) - 1)), ()),
    "an entry of no unit column": ((let(m, number(2)),), (unit_column(m, k),), ()),
    "a trace of no half-turn": ((), (half_turn(Q), nonzero(tr(Q) + 1)), ()),
    "minus one, and definite": ((let(M, -Identity(3)),), (definite(M),), (unit(e),)),
    "a definite matrix minus a square": ((let(M, -(k**2) * Identity(3)),), (definite(M),), (unit(e),)),
    "a definite matrix of determinant zero": ((let(M, Zero(3, 3)),), (definite(M),), (unit(e),)),
    "a skew-symmetric matrix that is symmetric": ((let(M, CPM(a)),), (symmetric(M), nonzero(norm(a))), (unit(e),)),
    "a circle without points": ((), (nonzero(sin(phi) ** 2 + cos(phi) ** 2 - 1),), (unit(e),)),
    "a rate of no unit vector": ((let(rate(e), w),), (unit(e), nonzero(dot(e, w))), (positive(m),)),
    "a unit vector that grows": ((let(rate(e), often * e),), (unit(e), nonzero(often)), ()),
    "rates that lead back": ((let(rate(a), often * b), let(rate(b), often * a)), (unit(a), nonzero(often)), ()),
}
CLAIMS = {"true": (p, p), "false": (p, q)}


@pytest.mark.sampled(13)
@pytest.mark.parametrize("says", CLAIMS)
@pytest.mark.parametrize("name", CONTRADICTORY)
def test_what_contradicts_itself_is_named_and_nothing_is_decided_under_it(name: str, says: str) -> None:
    given, needed, others = CONTRADICTORY[name]
    asked = problem_of(Claim("1", *CLAIMS[says], given=given, assuming=(*others, *needed)))
    verdict = decide_problem(asked)
    assert isinstance(verdict, Contradictory), verdict
    assert {*verdict.hypotheses} == {hypothesis.text for hypothesis in needed}
    assert verdict.certificate is not None
    check_contradiction(asked, verdict.hypotheses, verdict.certificate)
    assert from_data(to_data(verdict)) == verdict


@pytest.mark.sampled(3)
@pytest.mark.parametrize("name", CONTRADICTORY)
def test_fewer_hypotheses_do_not_contradict_themselves(name: str) -> None:
    given, needed, others = CONTRADICTORY[name]
    for left_out in needed if len(needed) > 1 else ():
        fewer = tuple(h for h in (*others, *needed) if h != left_out)
        verdict = decide_problem(problem_of(Claim("1", p, p, given=given, assuming=fewer)))
        assert isinstance(verdict, Holds | HoldsUnder | Undecided), verdict


def certified(name: str) -> tuple[Any, Contradictory, dict[str, Any]]:
    given, needed, others = CONTRADICTORY[name]
    asked = problem_of(Claim("1", p, q, given=given, assuming=(*others, *needed)))
    verdict = decide_problem(asked)
    assert isinstance(verdict, Contradictory)
    return asked, verdict, deepcopy(dict(verdict.certificate or {}))


def test_a_forged_contradiction_is_rejected() -> None:
    asked, verdict, certificate = certified("twice a unit vector")
    for label in certificate["contradiction"]:
        forged = deepcopy(certificate)
        forged["contradiction"][label] += " + 1"
        with pytest.raises(Rejected):
            check_contradiction(asked, verdict.hypotheses, forged)
        del forged["contradiction"][label]
        with pytest.raises(Rejected):
            check_contradiction(asked, verdict.hypotheses, forged)
    with pytest.raises(Rejected, match="not assumed"):
        check_contradiction(asked, (*verdict.hypotheses, "m > 0"), certificate)
    with pytest.raises(Rejected):
        check_contradiction(asked, verdict.hypotheses[:1], certificate)


def test_a_power_of_what_does_not_vanish_is_read_as_it_is() -> None:
    asked, verdict, certificate = certified("a positive number minus a square")
    for power in (2, 0, -1, 128, "1"):
        forged = certificate | {"nonvanishing": dict.fromkeys(certificate["nonvanishing"], power)}
        with pytest.raises(Rejected):
            check_contradiction(asked, verdict.hypotheses, forged)
    with pytest.raises(Rejected):
        check_contradiction(asked, verdict.hypotheses, certificate | {"nonvanishing": {}})


def test_what_only_does_not_vanish_is_not_taken_to_be_positive() -> None:
    name = "a positive number minus squares"
    _, _, certificate = certified(name)
    asked = problem_of(Claim("1", p, q, given=CONTRADICTORY[name][0], assuming=(nonzero(m),)))
    with pytest.raises(Rejected, match="shows no contradiction"):
        check_contradiction(asked, (nonzero(m).text,), certificate | {"nonvanishing": {f"1. {nonzero(m).text}": 1}})


def test_a_condition_is_among_what_contradicts_itself() -> None:
    given = Condition("3", e, 2 * f, on=(e,))
    verdict = decide_problem(problem_of(Claim("1", p, q, given=(given,), assuming=(unit(e), unit(f), positive(m)))))
    assert isinstance(verdict, Contradictory)
    assert (verdict.hypotheses, verdict.certificate) == (("|e| = 1", "|f| = 1", "(3)"), None)


EMPTY = {
    "one over the other": Iff(m, k, k / m, m / k),
    "with more factors": Iff(m, 2 * k, 2 * k / m, m / (2 * k)),
    "vectors": Iff(m * a, k * a, k / m, m / k),
}


@pytest.mark.parametrize("name", EMPTY)
def test_if_and_only_if_that_speaks_of_nothing_is_not_proved(name: str) -> None:
    verdict = Session().decide(Theorem("1", "", (EMPTY[name],), assuming=(nonzero(m), nonzero(k), unit(a)))).verdict
    assert isinstance(verdict, Contradictory), verdict


def test_if_and_only_if_that_speaks_of_something_is() -> None:
    turned = Iff(a, Q @ a, Q, Q.T)
    assert isinstance(Session().decide(Theorem("1", "", (turned,), assuming=(rotation(Q),))).verdict, HoldsUnder)
    scaled = Iff(a, m * a, m, 1 / m)
    assert isinstance(Session().decide(Theorem("1", "", (scaled,), assuming=(nonzero(m),))).verdict, HoldsUnder)
    assert isinstance(Session().decide(Theorem("1", "", (Always(a, a),), assuming=(nonzero(m),))).verdict, Holds)


SATISFIABLE: dict[str, Assumed] = {
    "a length": (nonzero(norm(a)),),
    "a number": (nonzero(m),),
    "a sum": (nonzero(m + k),),
    "a product": (nonzero(dot(e, f)), unit(e)),
    "a determinant": (nonzero(det(M)),),
    "two unit vectors at right angles": (perpendicular(e, f), unit(e), unit(f)),
    "a unit column": (unit_column(m, k),),
    "a half-turn": (half_turn(Q),),
    "a sine": (nonzero(sin(phi)),),
    "a triad said twice": (orthonormal(e, f, g), unit(e), perpendicular(e, f)),
    "a definite matrix": (definite(M), positive(m)),
    "a rotation": (rotation(Q), symmetric(M)),
}


@pytest.mark.parametrize("name", SATISFIABLE)
def test_what_is_assumed_of_symbols_that_do_not_occur_keeps_nothing_from_being_refuted(name: str) -> None:
    for left, right in ((p, q), (rate(p), 2 * rate(p))):
        verdict = decide_problem(problem_of(Claim("1", left, right, assuming=SATISFIABLE[name])))
        assert isinstance(verdict, Fails), verdict
