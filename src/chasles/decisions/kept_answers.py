"""Is an answer from another time right? Its certificate or its counterexample is checked again, without the prover."""

from __future__ import annotations

from collections.abc import Callable, Iterable
from typing import Any

from chasles.checker.certificate import check
from chasles.checker.refutation import check_counterexample
from chasles.checker.sparse import Rejected
from chasles.repairs.repair import Repair, claims_of
from chasles.statements import Problem, Statement, problem_of
from chasles.statements.goals import AcceptedSides
from chasles.verdict import Fails, Holds, HoldsUnder, Verdict
from chasles.vocabulary import Misfit, Node

MALFORMED = (Misfit, ArithmeticError, AttributeError, LookupError, RecursionError, TypeError, ValueError)
"""What data that no prover wrote may raise where they are used."""


def verdict_stands(problem: Problem, verdict: Any) -> bool:
    """Whether a verdict on a problem is proved, or refuted, by what comes with it."""
    try:
        match verdict:
            case Holds() | HoldsUnder():
                check(problem, "printed", verdict.certificate)
            case Fails():
                check_counterexample(problem, verdict.counterexample)
            case _:
                return False
    except (Rejected, *MALFORMED):
        return False
    return True


def repairs_stand(
    statement: Statement,
    repairs: Any,
    accepted: AcceptedSides,
    context: Iterable[Statement],
    verdict_on: Callable[[Problem], Verdict],
) -> bool:
    """Whether each repair is proved by its certificate; what else it says of claims is asked of `verdict_on`."""
    known = tuple(context)
    try:
        return isinstance(repairs, tuple) and all(
            isinstance(each, Repair) and _stands(statement, each, accepted, known, verdict_on) for each in repairs
        )
    except MALFORMED:
        return False


def _stands(
    statement: Statement,
    repair: Repair,
    accepted: AcceptedSides,
    context: tuple[Statement, ...],
    verdict_on: Callable[[Problem], Verdict],
) -> bool:
    claims = claims_of(statement, repair, context)
    problems = [[problem_of(claim, "printed", accepted) for claim in group] for group in claims]
    return (
        bool(problems)
        and any(verdict_stands(problem, repair.verdict) for problem in problems[0])
        and all(any(verdict_on(problem).true for problem in group) for group in problems[1:])
    )


def combination_fits(node: Node, found: Any) -> bool:
    """Whether a combination may stand for an expression: it is a conjecture, and is decided where it is used."""
    return isinstance(found, Node) and found.fault is None and found.shape == node.shape
