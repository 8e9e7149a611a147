"""The book asked by number from Python: decisions, repairs and roads, and what they say of themselves."""

from __future__ import annotations

from pathlib import Path

import pytest

import chasles
from chasles.decisions.decision import Decision, Decisions
from chasles.several import Several
from chasles.verdict import Assumed, Defined, HoldsUnder, IllFormed, Undecided

PLANAR = Path(__file__).resolve().parents[1] / "examples" / "planar"


def test_one_equation() -> None:
    found = chasles.decide("3.18")
    assert found.verdict.name == "holds-under"
    assert found.needs == ("phi != 0", "|e| = 1")
    assert found.stands
    assert repr(found) == "(<decision on 3.18/1: holds-under phi != 0, |e| = 1>,)"
    assert str(found).startswith("(3.18)  \N{CHECK MARK} holds under  phi != 0, |e| = 1\n  printed")
    assert repr(found.verdict) == "HoldsUnder(needs=('phi != 0', '|e| = 1'), unused=())"


@pytest.mark.parametrize("cited", ["3.4", "(3.4)", "displacement_rearranged", "3.4/2"])
def test_a_number_is_found_however_it_is_cited(cited: str) -> None:
    numbers = {(decision.statement.number, decision.statement.part) for decision in chasles.decide(cited)}
    assert numbers == ({("3.4", 2)} if "/" in cited or "_" in cited else {("3.4", 1), ("3.4", 2), ("3.4", 3)})


def test_the_verdict_on_a_number_is_that_on_its_least_certain_part() -> None:
    found = chasles.decide("3.57")
    assert [decision.verdict.name for decision in found] == ["defined", "ill-formed", "defined", "holds-under"]
    assert found.verdict.name == "ill-formed"
    assert found.stands, "what is right stands in for it"
    assert found.needs == ("omega != 0",)
    statement = found[0].statement
    under = HoldsUnder(("x",), {}, {})
    for verdicts in (
        (Undecided("too large"), under, Defined()),
        (under, Assumed()),
        (IllFormed("no"), Undecided("no")),
    ):
        of_parts = Decisions(Decision(statement, verdict) for verdict in reversed(verdicts))
        assert of_parts.verdict is verdicts[0]
        assert not of_parts.stands or verdicts[0] is under


def test_a_print_that_is_wrong_has_repairs_and_others_none() -> None:
    repairs = chasles.repair("3.96e")
    assert repairs
    assert all(repair.verdict.true for repair in repairs)
    assert repr(repairs[0]).startswith("<repair B = ")
    assert len(repairs._repr_html_().split("A repair")) == len(repairs) + 1
    assert chasles.repair("3.18") == Several()


def test_a_road_is_walked() -> None:
    road = chasles.derive("3.96c")
    assert road.arrives
    assert repr(road) == "<derivation of 3.96c: complete after 3>"
    assert "differentiate both sides" in str(road)


@pytest.mark.parametrize(
    ("ask", "number", "error", "says"),
    [
        (chasles.decide, "3.999", LookupError, "the book has no equation '3.999'; near it: 3.99, "),
        (chasles.derive, "3.999", LookupError, "no derivation leads to '3.999'; near it: "),
        (
            chasles.derive,
            "3.76a",
            LookupError,
            "3 derivations lead to 3.76a: name one of rates_of_natural",
        ),
        (chasles.decide, 3.10, TypeError, "a number is given as text, since 3.1 is not 3.10: '3.1', and not 3.1"),
        (chasles.repair, None, TypeError, "a number is given as text"),
        (chasles.decide, "", LookupError, "the book has no equation ''"),
    ],
)
def test_what_is_not_there_is_said_so(ask, number, error, says) -> None:
    with pytest.raises(error) as raised:
        ask(number)
    assert str(raised.value).startswith(says)


@pytest.mark.skipif(not PLANAR.exists(), reason="needs the checkout")
def test_another_chapter_is_asked_likewise() -> None:
    chapter = chasles.load(PLANAR)
    [number, *_] = [entry.number for entry in chapter if entry.statement.role == "claim"]
    assert chasles.decide(number, chapter) == chasles.decide(number, chapter)
    assert chasles.decide(number, chapter)[0].statement in [entry.statement for entry in chapter]


def test_the_chapter_says_what_it_is() -> None:
    assert chasles.chapter is chasles.chapter
    assert (
        repr(chasles.chapter)
        == f"<chapter 'Fundamentals of Rigid-Body Mechanics': {len(list(chasles.chapter))} statements>"
    )
    assert repr(chasles.chapter.select(["3.18"])) == "(<(3.18) screw_axis_point>,)"
