"""What a proof on a page looks for: no counterexample that is easy to evaluate, as none is told."""

from __future__ import annotations

from types import SimpleNamespace
from typing import Any

import pytest

from chasles.decisions.session import Session
from chasles.from_sympy import methods
from chasles.pages.bounded_proofs import proof_of, verdict_on
from chasles.points.search import Search, any_counterexample
from chasles.statements import Claim
from chasles.verdict import Fails, Undecided
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


def test_what_no_proof_is_found_of_is_not_refuted_by_its_values(monkeypatch: pytest.MonkeyPatch) -> None:
    left_open = Undecided("a remainder is left")
    monkeypatch.setattr(methods, "_decided", lambda _: left_open)
    sampling = SimpleNamespace(counterexample=lambda: "a point")
    question: Any = SimpleNamespace(sampling=sampling, formal=False, answered=lambda verdict: verdict)
    assert isinstance(methods._answered(question), Fails)
    with any_counterexample():
        assert methods._answered(question) is left_open
