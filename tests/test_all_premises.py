"""A claim that is given brings what it is given itself: nothing fails at a point that this excludes."""

from __future__ import annotations

import json
from random import Random
from typing import Any

import pytest

from chasles.checker.certificate import check
from chasles.checker.refutation import check_counterexample
from chasles.checker.sparse import Rejected
from chasles.decisions.session import Session
from chasles.statements import Claim, Condition, Definition, Postulate, Statement, problem_of, symmetric
from chasles.statements.matrices import idempotent
from chasles.statements.posing import default_sides
from chasles.statements.premises import IN_FULL, with_all_premises
from chasles.verdict import Contradictory, Fails, Holds
from chasles.vocabulary import CPM, Node, cross, dot, inverse, rate, scalar, square, vector
from chasles.vocabulary.nodes import lifted
from chasles.vocabulary.sizes import Size

from .decided import proved, refuted

UNITS = False
a, b, c, f, g, h, k, m = (scalar(letter, letter, "") for letter in "abcfghkm")
p, r, v, w = (vector(letter, letter, "") for letter in "prvw")


def claim(left: Any, right: Any, *given: Statement, number: str = "9", assuming: tuple[Any, ...] = ()) -> Claim:
    return Claim(number, lifted(left), lifted(right), given=given, assuming=assuming)


Q, R = square("Q", "Q", ""), square("R", "R", "")

twice = Definition("1", a, 2 * b)
of_a = claim(f, a + b, Definition("2", f, a + b), twice, number="3")
circle = Condition("4", m**2 + k**2, lifted(1), on=())
law = Postulate("5", rate(v), 2 * w, given=())
on_circle = claim(g, (m + k) ** 2, Definition("6", g, m**2 + k**2 + 2 * m * k), circle, number="7")
free = claim(p, cross(w, r), Definition("8", p, CPM(w) @ r), law, number="10")
determined = claim(h, c + 1, Definition("11", h, c + 1), Condition("12", 3 * c, a, on=(c,)), twice, number="13")
commuting = claim(Q @ R, R @ Q, Definition("19", Q, 2 * R), number="20")
upright = claim(dot(p, w), 0, Definition("21", p, cross(w, r)), number="22")
moving = claim(rate(m), b + a - 2 * b, Definition("16", rate(m), b), Definition("17", rate(Q), R), twice, number="18")
TRUE = [
    claim(Q @ Q @ R, R @ Q @ Q, commuting),
    claim(dot(rate(p), w), -dot(p, rate(w)), upright),
    claim(a * b * b, c * b, Postulate("23", a * b, c)),
    claim(R, R.T, moving, assuming=(symmetric(Q),)),
    claim(f, 3 * b, of_a),
    claim(g, 1 + 2 * m * k, on_circle),
    claim(rate(p), cross(w, rate(r)) + cross(rate(w), r), free),
    claim(dot(rate(v), p), 0, free),
    claim(3 * h, 2 * b + 3, determined),
    claim(f + h, 3 * b + c + 1, of_a, determined),
]
FALSE = [
    claim(dot(rate(p), w), dot(p, rate(w)), upright),
    claim(a * b * b, c * c, Postulate("23", a * b, c)),
    claim(R, -R.T, moving, assuming=(symmetric(Q),)),
    claim(f, 4 * b, of_a),
    claim(g, 1 - 2 * m * k, on_circle),
    claim(dot(v, p), 0, free),
    claim(3 * h, 2 * b - 3, determined),
    claim(f + h, 3 * b + c - 1, of_a, determined),
]


@pytest.mark.parametrize("said", TRUE, ids=str)
def test_what_follows_from_all_that_it_rests_on_is_proved_and_checked(said: Claim) -> None:
    verdict = proved(said)
    if IN_FULL in verdict.certificate:
        with pytest.raises(Rejected):
            check(said, "printed", {key: held for key, held in verdict.certificate.items() if key != IN_FULL})


@pytest.mark.parametrize("said", FALSE, ids=str)
def test_what_is_false_is_refuted_where_all_of_it_holds(said: Claim) -> None:
    refuted(said)


def test_a_point_that_what_it_rests_on_excludes_refutes_nothing() -> None:
    (said, *_) = TRUE
    narrow = Session().decide(claim(f, 3 * b, Definition("3", f, a + b))).verdict
    assert isinstance(narrow, Fails)
    with pytest.raises(Rejected):
        check_counterexample(problem_of(with_all_premises(said, default_sides)), narrow.counterexample)


def test_what_is_given_itself_comes_first() -> None:
    """The claim says of what is defined otherwise what it is here: then the definition behind it is left out."""
    here = claim(f, 3 * c, of_a, Definition("18", a, 3 * c - b))
    assert isinstance(Session().decide(here).verdict, Holds)


def test_premises_behind_a_claim_may_contradict_each_other() -> None:
    one = claim(f, b, Definition("19", f, b), Condition("20", b, lifted(1)), number="21")
    other = claim(g, b, Definition("22", g, b), Condition("23", b, lifted(2)), number="24")
    said = claim(f, 3, one, other)
    verdict = Session().decide(said).verdict
    assert isinstance(verdict, Contradictory), verdict


def _chain(random: Random, length: int) -> tuple[list[Statement], dict[Node, Any]]:
    """Claims that rest on each other, each restating a definition by other letters; and what each letter is by b."""
    letters, worth = [vector(f"u_{k}", f"u_{k}", "") for k in range(length)], {}
    said: list[Statement] = []
    for k, letter in enumerate(letters):
        factors = [random.choice((1, 2, 3, -1)) for _ in range(2)]
        before = letters[k - 1] if k else v
        right = factors[0] * before + factors[1] * v
        definition = Definition(f"{k}.1", letter, right, given=tuple(said[-1:]))
        worth[letter] = factors[0] * worth.get(before, 1) + factors[1]
        swapped = factors[1] * v + factors[0] * before
        said.append(Claim(f"{k}.2", letter, swapped, given=(definition,)))
    return said, worth


@pytest.mark.parametrize("seed", range(12))
def test_chains_of_claims_of_any_length(seed: int) -> None:
    random = Random(seed)
    said, worth = _chain(random, random.randint(2, 5))
    last = said[-1].left
    session = Session()
    true = session.decide(claim(last, worth[last] * v, said[-1])).verdict
    assert isinstance(true, Holds)
    check(claim(last, worth[last] * v, said[-1]), "printed", json.loads(json.dumps(true.certificate)))
    refuted(claim(last, (worth[last] + random.choice((1, -1, 2))) * v, said[-1]))


J = square("J", "J", "", size=Size("n"))


@pytest.mark.parametrize("said", [J, J @ J, J.T, J**2, J @ J.T.T], ids=str)
def test_where_a_matrix_has_no_inverse_nothing_is_refuted_of_one(said: Node) -> None:
    """An idempotent matrix with an inverse is the identity: zero, which has none, refutes nothing."""
    assert not isinstance(Session().decide(claim(inverse(said), J, assuming=(idempotent(J),))).verdict, Fails)
