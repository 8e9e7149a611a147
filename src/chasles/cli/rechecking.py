"""Certificates and counterexamples checked again, by the checker, which imports nothing of the prover."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass
from time import perf_counter

from chasles.checker.certificate import check
from chasles.checker.contradiction import check_contradiction
from chasles.checker.refutation import check_counterexample
from chasles.checker.sparse import Rejected
from chasles.decisions.memory import Memory
from chasles.decisions.processes import spread
from chasles.decisions.session import Decision
from chasles.report.findings import Pairs
from chasles.statements import Entry, Inverse
from chasles.statements.premises import IN_FULL
from chasles.verdict import Contradictory, Fails

A_CHECK = 0.004
"""About how many seconds one takes."""


@dataclass(frozen=True, slots=True)
class Rechecked:
    """How many certificates and counterexamples were checked, in how many seconds, and why some were rejected."""

    certificates: int
    counterexamples: int
    seconds: float
    rejected: tuple[tuple[Entry, str], ...]


def recheck(decided: Pairs, memory: Memory) -> Rechecked:
    """Check every certificate and every counterexample that the memory has not checked when it recalled it."""
    started = perf_counter()
    certified = [(entry, decision, _prove) for entry, decision in decided if decision.certificate is not None]
    equations = [(entry, decision) for entry, decision in decided if not isinstance(decision.statement, Inverse)]
    refuted = [(entry, decision, _refute) for entry, decision in equations if isinstance(decision.verdict, Fails)]
    empty = [
        (entry, decision, _contradict)
        for entry, decision in equations
        if isinstance(decision.verdict, Contradictory) and decision.verdict.certificate is not None
    ]
    asked = [
        (entry, decision, check_again)
        for entry, decision, check_again in (*certified, *refuted, *empty)
        if not memory.has_checked(decision.standing if check_again is _prove else decision.verdict)
    ]
    reasons = spread(_rejection, [(check_again, decision) for _, decision, check_again in asked], A_CHECK)
    rejected = tuple((entry, why) for (entry, _, _), why in zip(asked, reasons, strict=True) if why is not None)
    return Rechecked(len(certified), len(refuted), memory.seconds + perf_counter() - started, rejected)


def _rejection(asked: tuple[Callable[[Decision], None], Decision]) -> str | None:
    """Why a decision is rejected; None if it is not."""
    check_again, decision = asked
    try:
        check_again(decision)
    except Rejected as reason:
        return str(reason)
    return None


def _prove(decision: Decision) -> None:
    """Raises `Rejected` unless the certificate proves what stands."""
    certificate = decision.certificate
    assert certificate is not None
    check(decision.repaired, "printed", certificate, decision.accepted)


def _refute(decision: Decision) -> None:
    """Raises `Rejected` unless the counterexample refutes the printed equation."""
    assert isinstance(decision.verdict, Fails)
    assert not isinstance(decision.statement, Inverse)
    check_counterexample(decision.problem(decision.statement, True), decision.verdict.counterexample)


def _contradict(decision: Decision) -> None:
    """Raises `Rejected` unless the certificate proves that nothing satisfies what the verdict names."""
    verdict = decision.verdict
    assert isinstance(verdict, Contradictory)
    assert verdict.certificate is not None
    assert not isinstance(decision.statement, Inverse)
    problem = decision.problem(decision.statement, IN_FULL in verdict.certificate)
    check_contradiction(problem, verdict.hypotheses, verdict.certificate)
