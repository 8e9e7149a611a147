"""What pages and records say of Coq: only what it has accepted whole, of what has not changed since."""

from __future__ import annotations

import json
from importlib.resources import files
from pathlib import Path
from typing import Any

import pytest

from chasles.coq import recorded
from chasles.coq.checking import CoqVerdict, accepted_before, keep_accepted
from chasles.coq.recorded import RECORD, CoqCheck, checked_by_coq, text_of
from chasles.coq.sentences import Claimed
from chasles.coq.theorems import claims_of
from chasles.decisions.decision import Decision, key_of
from chasles.decisions.session import Session
from chasles.report.details import evidence
from chasles.report.records import record
from chasles.statements import Claim, Definition, load, unit
from chasles.vocabulary import CPM, Dot, Identity, Negative, Node, paren, vector

from .decided import chapter_session

FILES = {"Statements_01.v": "0" * 64}
ENTRY = next(entry for entry in load() if entry.number == "3.13")


NOTHING_CLAIMED = ("definition", "condition", "postulate")
NOT_RECORDED: dict[str, dict[str, str]] = {
    "chasles.derivations": {},
    "chasles.rotations": {"1.41/1": "no proof is written of what is shown by the angle of a point"},
}
"""The statements that claim something, of which no record is kept, and why."""


@pytest.fixture
def kept(monkeypatch: pytest.MonkeyPatch) -> dict[str, Any]:
    """The record of a chapter of which Coq has accepted one sentence."""
    data: dict[str, Any] = json.loads(text_of("8.16.1", {ENTRY.statement: FILES}, {}))
    monkeypatch.setattr(recorded, "_record", lambda package: data)
    return data


def test_what_is_accepted_is_told_with_version_and_hash(kept: dict[str, Any]) -> None:
    assert checked_by_coq(ENTRY.statement) == CoqCheck("8.16.1", FILES)
    decision = chapter_session().decide(ENTRY.statement)
    assert record(ENTRY, decision)["coq"] == {"version": "8.16.1", "files": FILES}
    assert ("Coq", f"Coq 8.16.1 checked: Statements_01.v sha256:{'0' * 64}") in list(evidence(decision))


def test_of_others_and_of_what_has_changed_nothing_is_told(kept: dict[str, Any]) -> None:
    others = [entry.statement for entry in load() if entry.statement != ENTRY.statement]
    assert not any(map(checked_by_coq, others))
    statement = ENTRY.statement
    assert checked_by_coq(statement.saying(Negative(paren(statement.left)), statement.right)) is None
    assert checked_by_coq(statement.saying(statement.left, statement.left)) is None
    kept["words"] = "0" * 64
    assert checked_by_coq(statement) is None


@pytest.mark.parametrize("data", [{}, [], None, {"words": 1}, {"checked": {"3.13/1": 3}}, "text"])
def test_a_record_that_is_none_says_nothing(monkeypatch: pytest.MonkeyPatch, data: Any) -> None:
    monkeypatch.setattr(recorded, "_record", lambda package: data)
    assert checked_by_coq(ENTRY.statement) is None
    assert record(ENTRY, Decision(ENTRY.statement, chapter_session().decide(ENTRY.statement).verdict))["coq"] is None


@pytest.mark.parametrize("chapter", ["chasles.derivations", "chasles.rotations"])
def test_a_chapter_that_comes_along_brings_its_record(chapter: str) -> None:
    """What has changed since is not told of; `make coq` brings a record up to date."""
    claims = [entry.statement for entry in load(chapter) if entry.statement.role == "claim"]
    assert sum(checked_by_coq(statement) is not None for statement in claims) >= len(claims) / 2


@pytest.mark.parametrize("chapter", NOT_RECORDED)
def test_each_statement_is_in_the_record_or_there_is_a_reason(chapter: str) -> None:
    """A record of what has been declared otherwise since is none."""
    declared = {key_of(entry.statement): entry.statement for entry in load(chapter)}
    claimed = {key for key, statement in declared.items() if statement.role not in NOTHING_CLAIMED}
    told = {key for key, statement in declared.items() if checked_by_coq(statement)}
    assert claimed - told == NOT_RECORDED[chapter].keys(), "`make coq` brings the record up to date"
    kept = json.loads(files(chapter).joinpath(RECORD).read_text("utf-8"))["checked"]
    assert kept.keys() <= declared.keys()


def test_only_what_rests_on_a_changed_declaration_is_checked_again(
    monkeypatch: pytest.MonkeyPatch, tmp_path: Path
) -> None:
    monkeypatch.setenv("CHASLES_CACHE", str(tmp_path))
    a, e, u = (vector(name, name, "a vector") for name in "aeu")
    apart = Claim("3", CPM(e) @ CPM(e), e @ e.T - Identity(3), assuming=(unit(e),))

    def claims(right: Node) -> list[Claimed]:
        defined = Definition("1", u, right)
        resting = Claim("2", Dot(u, u), 4 * Dot(a, a), given=(defined,))
        return [*claims_of(map(Session().decide, (resting, apart)))]

    first = claims(2 * a)
    assert len([claim for claim in first if claim.proof]) == len(first) > 2
    keep_accepted(map(CoqVerdict, first), "8.16.1")
    assert accepted_before(claims(2 * a), "8.16.1") == {claim.name for claim in first}
    assert accepted_before(claims(-2 * a), "8.16.1") == {claim.name for claim in first if claim.number == "3/1"}
    assert accepted_before(first, "8.17") == set()
