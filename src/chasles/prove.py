"""The prover for SymPy users: is an equation between SymPy expressions true?"""

from __future__ import annotations

from collections.abc import Iterable
from typing import Any

from chasles.proof.deadline import OutOfTime, remaining, within
from chasles.proof.decide import decide_problem
from chasles.proof.from_sympy import Question, ask
from chasles.proof.verdict import IllFormed, Undecided, Verdict

__all__ = ["prove"]

BUDGET = 10.0
"""Seconds."""


def prove(
    lhs: Any, rhs: Any, given: Iterable[Any] = (), nonzero: Iterable[Any] = (), budget: float = BUDGET
) -> Verdict:
    """The verdict on `lhs == rhs`, for all real values of the symbols that satisfy the side conditions.

    Args:
        lhs: a SymPy scalar or matrix.
        rhs: one of the same shape.
        given: equations that hold, as `Eq(a, b)` or as expressions or matrices that are zero; between functions of
            time they hold at all times.
        nonzero: scalars that do not vanish. Divisors need not be named: the verdict's `needs` lists them.
        budget: seconds after which the verdict is `Undecided`.

    Returns:
        `Holds` or `HoldsUnder`, with a certificate; `Fails`, with an exact counterexample; `IllFormed`, if the shapes
        differ; or `Undecided`.

    Raises:
        ValueError: for what is not treated, naming it.
    """
    try:
        with within(budget):
            question = ask(lhs, rhs, given, nonzero)
            return question if isinstance(question, IllFormed) else _decided(question)
    except OutOfTime:
        return Undecided(f"{budget:g} seconds were not enough")


def _decided(question: Question) -> Verdict:
    """The verdict; where it is open, another try with the sides multiplied by what does not vanish."""
    verdict = decide_problem(question.problem, question.own, remaining(), question.search)
    divisors = [node for h in question.problem.hypotheses for node in h.nonvanishing]
    attempts = [*([node] for node in divisors), divisors][: len(divisors) if len(divisors) < 2 else None]
    for factors in attempts if isinstance(verdict, Undecided) else ():
        multiple = question.multiplied_by(factors)
        again = decide_problem(multiple.problem, question.own, remaining(), multiple.search)
        if again.true:
            verdict = again
            break
    return question.answered(verdict)
