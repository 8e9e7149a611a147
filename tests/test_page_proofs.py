"""What a proof on a page looks for: no counterexample that is easy to evaluate, as none is told."""

from __future__ import annotations

import pytest

from chasles.decisions.session import Session
from chasles.pages.bounded_proofs import proof_of, verdict_on
from chasles.points.search import Search
from chasles.statements import Claim
from chasles.verdict import Fails
from chasles.vocabulary import cos, number, scalar
from chasles.vocabulary.functions import sqrt

x, y = (scalar(name, name, "a number") for name in "xy")


@pytest.mark.parametrize("likely", [True, False])
def test_a_proof_looks_at_one_counterexample(likely: bool, monkeypatch: pytest.MonkeyPatch) -> None:
    drawn: list[object] = []
    found = Search._candidate
    monkeypatch.setattr(Search, "_candidate", lambda *of: drawn.append(of) or found(*of))
    claim, session = Claim("1", sqrt(number(1) + x * x) * cos(y), x * cos(y)), Session()
    assert proof_of(claim, session, likely) is None
    assert len(drawn) <= 1
    told = verdict_on(claim, session)
    assert isinstance(told, Fails)
    assert told == verdict_on(claim, Session())
