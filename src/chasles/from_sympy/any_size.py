"""Questions on matrices whose sizes have letters: what SymPy has no entries of is decided in the declared language."""

from __future__ import annotations

from typing import Any

from chasles.checker.any_size.of_sympy import problem_in_words
from chasles.checker.sparse import Rejected
from chasles.from_sympy.opening import excerpt
from chasles.from_sympy.side_conditions import listed
from chasles.problems.variables import Untreatable
from chasles.prover.symbolic import decide_words
from chasles.verdict import Holds, HoldsUnder, IllFormed, Verdict


def verdict_at_any_size(lhs: Any, rhs: Any, given: Any, nonzero: Any) -> Verdict:
    """The verdict on a question on matrices of any size, with all that a proof may use among its needs.

    Raises `Untreatable` for what is no word of the declared language.
    """
    if getattr(lhs, "shape", (1, 1)) != getattr(rhs, "shape", (1, 1)):
        return IllFormed(f"cannot equate {excerpt(lhs)} and {excerpt(rhs)}: their sizes differ")
    for conditions, name in ((given, "given"), (nonzero, "nonzero")):
        listed(conditions, name)
    try:
        problem, needs = problem_in_words(lhs, rhs, given, nonzero)
    except Rejected as reason:
        raise Untreatable(str(reason)) from None
    verdict = decide_words(problem)
    if isinstance(verdict, Holds | HoldsUnder) and needs:
        return HoldsUnder(needs, verdict.certificate, verdict.witness)
    return verdict
