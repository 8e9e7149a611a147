"""The claims and theorems that exercises 3.11 to 3.21 declare: each holds, needs what it assumes, and can be wrong."""

from __future__ import annotations

from dataclasses import replace as with_fields
from importlib import import_module

import pytest

from chasles.decisions.session import Session
from chasles.exercises.solving import solve
from chasles.statements import Claim, Theorem
from chasles.verdict import Fails
from chasles.vocabulary import Negative

MODULES = ("x3_13", "x3_14", "x3_15", "x3_16", "x3_17", "x3_18", "x3_20", "relative_acceleration")
FAILING = ("accelerations_are_orthogonal",)


def declared() -> dict[str, Claim | Theorem]:
    found: dict[str, Claim | Theorem] = {}
    for module in MODULES:
        for name, value in vars(import_module(f"chasles.derivations.exercises.{module}")).items():
            for place, one in enumerate(value if isinstance(value, tuple) else (value,)):
                if isinstance(one, Claim | Theorem) and one.number.startswith("Ex "):
                    found.setdefault(f"{one.number} part {one.part}: {name}{place or ''}", one)
    return found


DECLARED = declared()


@pytest.fixture(scope="module")
def judge() -> Session:
    return Session()


@pytest.mark.parametrize("name", DECLARED)
def test_a_claim_is_decided(name: str, judge: Session) -> None:
    verdict = judge.decide(DECLARED[name]).verdict
    if name.endswith(FAILING):
        assert isinstance(verdict, Fails)
        return
    assert verdict.true, verdict
    assert not getattr(verdict, "unused", ())


@pytest.mark.sampled(4)
@pytest.mark.parametrize("name", [name for name, one in DECLARED.items() if isinstance(one, Claim)])
def test_a_claim_with_the_other_sign_fails(name: str, judge: Session) -> None:
    claim = DECLARED[name]
    if judge.decide(with_fields(claim, right=Negative(claim.right), corrected=None)).verdict.true:
        # Then both sides are zero.
        assert name.endswith(("no_point_adds_nothing", "terms_are_orthogonal", "orthogonal_on_average", "no_power"))


@pytest.mark.parametrize("number", ["3.17", "3.18"])
def test_proofs(number: str) -> None:
    solution = solve(number)
    proofs = solution.answers["proofs"]
    assert len(proofs) == len(solution.steps) > 5
    assert {proof["verdict"] for proof in proofs} <= {"holds", "holds-under"}
    assert all(step.lines and step.cites for step in solution.steps)


def test_what_is_false_in_the_book_comes_with_a_counterexample() -> None:
    for number, what in (("3.20", "(3.148)"), ("3.21", "Ex 3.21 part 7")):
        steps = [step for step in solve(number).steps if any(cite.verdict == "fails" for cite in step.cites)]
        assert len(steps) == 1
        assert steps[0].cites[0].shown + (f" part {steps[0].cites[0].part}" if number == "3.21" else "") == what
        assert "not so at" in steps[0].lines[-1].text
