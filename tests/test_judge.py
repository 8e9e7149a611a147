"""What stands in for a print that does not, and how later statements use it."""

from __future__ import annotations

import pytest

from chasles.checker.certificate import Rejected, check
from chasles.decisions.session import Session
from chasles.statements import Branch, Chapter, Claim, Definition, Entry, Inverse, Section, Statement, nonzero
from chasles.verdict import Fails, Holds, HoldsUnder, IllFormed, Undecided
from chasles.vocabulary import LENGTH, Node, column, cross, dot, number, plain, scalar, vector

x, y, z, w = (vector(name, name, name) for name in "xyzw")
c = scalar("c", "c", "c")
product = Definition("9.1", z, cross(x, y))
wrong = Claim("9.2", w, 2 * cross(x, y), given=(Definition("9.0", w, 3 * cross(x, y)),))
resting = Claim("9.3", w, 3 * z, given=(wrong, product))
hopeless = Claim("9.4", w, column(c, c, c), given=(Definition("9.0", w, x),), sic=True)


def book(*statements: Statement) -> Chapter:
    section = Section("9", "Slips")
    known: dict[int, Statement] = {}
    for statement in statements:
        known |= {id(given): given for given in statement.given}
        known[id(statement)] = statement
    return Chapter("Slips", tuple(Entry(f"s{k}", section, s) for k, s in enumerate(known.values())))


def test_a_repair_stands_in_for_a_claim_that_fails() -> None:
    judge = Session(book=book(wrong, product, resting))
    decision = judge.decide(wrong)
    assert isinstance(decision.verdict, Fails)
    assert decision.correction is not None
    assert decision.correction.form == decision.correction.found == "repair"
    assert decision.sides == judge.accepted(wrong) == (w, decision.correction.repairs[0].right)
    assert plain(decision.sides[1]) == "3 (x x y)"


def test_what_rests_on_it_is_decided_with_the_repair() -> None:
    judge = Session(book=book(wrong, product, resting))
    decision = judge.decide(resting)
    assert isinstance(decision.verdict, Holds)
    assert {key: used.form for key, used in decision.given.items()} == {"9.2/1": "repair", "9.1/1": "printed"}
    check(decision.repaired, "printed", decision.certificate, decision.accepted)
    with pytest.raises(Rejected):
        check(decision.repaired, "printed", decision.certificate)


def test_without_a_book_nothing_is_repaired() -> None:
    judge = Session()
    assert not judge.decide(wrong).stands
    assert isinstance(judge.decide(resting).verdict, Undecided)
    with pytest.raises(TypeError, match="is not proved"):
        judge.accepted(wrong)


def test_a_declared_form_stands_in_where_the_search_finds_nothing() -> None:
    far = Claim("9.5", cross(x, cross(y, w)), dot(x, y) * z, corrected=dot(x, w) * y - dot(x, y) * w)
    decision = Session(book=book(far)).decide(far)
    assert decision.correction is not None
    assert decision.correction.repairs == ()
    assert (decision.correction.form, decision.correction.found) == ("corrected", "declared")
    assert decision.stands


def test_what_restates_or_solves_says_what_it_used() -> None:
    halved = Claim("9.6", w / 3, z, given=(product,), restates=wrong, by=number(1) / 3)
    decision = Session(book=book(wrong, product, halved)).decide(halved)
    assert decision.given["9.2/1"].form == "repair"
    assert decision.verdict.true


def test_what_cannot_be_repaired_does_not_stand() -> None:
    decision = Session(book=book(hopeless)).decide(hopeless)
    assert not decision.stands
    assert decision.sides == hopeless.printed


def halving(of: Statement, value: Node, *satisfying: Statement) -> Inverse:
    """Back from w = 2 x, or from what stands in for it."""
    branch = Branch("always", c, ((x, value),), by=1 / c)
    return Inverse("9.8", of, (branch,), gives=(x,), assuming=(nonzero(c),), satisfying=satisfying)


def test_an_inverse_says_what_it_inverts_and_what_its_values_satisfy() -> None:
    formula = Definition("9.6", w, 2 * x)
    obeyed = Claim("9.7", x + x, w, given=(formula,))
    decision = Session().decide(halving(formula, w / 2, obeyed))
    assert isinstance(decision.verdict, HoldsUnder)
    assert {key: used.form for key, used in decision.given.items()} == {"9.6/1": "printed", "9.7/1": "printed"}
    check(decision.statement, "printed", decision.certificate, decision.accepted)


def test_an_inverse_of_what_is_repaired_inverts_the_repair() -> None:
    slip = Claim("9.6", w, 3 * x, given=(Definition("9.5", w, 2 * x),))
    decision = Session(book=book(slip)).decide(halving(slip, w / 2))
    assert isinstance(decision.verdict, HoldsUnder)
    assert decision.given["9.6/1"].form == "repair"
    check(decision.statement, "printed", decision.certificate, decision.accepted)


@pytest.mark.parametrize("place", ["of", "satisfying"])
def test_an_inverse_that_rests_on_what_does_not_stand_is_undecided(place: str) -> None:
    formula = Definition("9.6", w, 2 * x)
    sentence = halving(hopeless, w / 2) if place == "of" else halving(formula, w / 2, hopeless)
    verdict = Session().decide(sentence).verdict
    assert isinstance(verdict, Undecided)
    assert "rests on (9.4), which is not proved" in verdict.reason


def test_an_inverse_whose_values_do_not_fit_is_ill_formed() -> None:
    longer = vector("longer", "longer", "of another dimension", LENGTH)
    verdict = Session().decide(halving(Definition("9.6", w, x + 1 * y), longer)).verdict
    assert isinstance(verdict, IllFormed)


def test_an_inverse_of_what_nothing_stands_in_for_is_undecided() -> None:
    torn = Definition("9.6", w, column(c, c), sic=True)
    verdict = Session().decide(halving(torn, w / 2)).verdict
    assert isinstance(verdict, Undecided)
