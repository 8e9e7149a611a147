"""Inequalities by sums of squares: what is claimed not to be negative is one, up to what the hypotheses say."""

from __future__ import annotations

from fractions import Fraction

from chasles.algebra.rings import written
from chasles.algebra.squares import Square, sum_of_squares
from chasles.checker.certificate import check
from chasles.checker.sparse import Rejected
from chasles.problems.context import Context, build, difference
from chasles.problems.divisors import UndeclaredDivisor
from chasles.problems.generators import entries
from chasles.problems.variables import Untreatable
from chasles.prover.certifying import ProvedEntry, certified, proved
from chasles.prover.conditions import solve_conditions
from chasles.prover.sources import DeclaredPoints
from chasles.statements import Hypothesis, Problem
from chasles.statements.inequalities import as_differences
from chasles.verdict import Holds, HoldsUnder


def decide_by_squares(problem: Problem, own: tuple[Hypothesis, ...]) -> Holds | HoldsUnder | None:
    """The verdict where all that is claimed is seen not to be negative, or to be positive; None where it is not."""
    found = as_differences(problem)
    if found is None or found[0].has_functions:
        return None
    plain, signs = found
    try:
        context = build(plain)
        conditions, solved = solve_conditions(context)
        parts = [_entries(context, number, sign) for number, sign in enumerate(signs)]
        witness = DeclaredPoints().witness(context, solved)
    except (Untreatable, UndeclaredDivisor):
        return None
    if witness is None or None in parts:
        return None
    done = [part for part in parts if part is not None]
    verdict = certified(context, conditions, solved, [entry for found, _ in done for entry in found], own, witness)
    assert isinstance(verdict, Holds | HoldsUnder)
    certificate = {**verdict.certificate, "squares": [_written(context, squares) for _, squares in done]}
    try:
        check(problem, "printed", certificate)
    except Rejected:
        return None
    used = {name for _, squares in done for name in _signs(context, squares)}
    needs = (*verdict.needs, *(h.text for h in problem.hypotheses if h.text in used and h.text not in verdict.needs))
    unused = tuple(text for text in verdict.unused if text not in used)
    return proved(needs, certificate, verdict.witness, unused)


def _entries(context: Context, number: int, sign: str) -> tuple[list[ProvedEntry], list[Square]] | None:
    """What is left of a claim when its squares are taken away, which the hypotheses say is zero, and the squares."""
    ring, goal = context.field.ring, context.problem.goals[number]
    signs = _nonnegative(context)
    positive = {place for place, text in signs.items() if text}
    squares: list[Square] | None = []
    found: list[ProvedEntry] = []
    for i, j, ratio in entries(difference(context, goal)):
        cofactors, remainder = context.basis.reduce(ratio.numerator)
        if sign:
            squares = None if any(ratio.denominator) else sum_of_squares(dict(ring.terms(remainder)), signs)
        elif remainder != 0:
            return None
        if squares is None or (sign == "positive" and not any(_is_positive(each, positive) for each in squares)):
            return None
        left = ratio - context.field.ratio(remainder)
        found.append(
            ProvedEntry(goal, f"{number}:{i},{j}", (i + 1, j + 1), left, cofactors, not context.basis.explicit)
        )
    return found, squares or []


def _is_positive(square: Square, positive: set[int]) -> bool:
    _, factor, root = square
    return not any(map(any, root)) and all(place in positive for place, e in enumerate(factor) if e)


def _nonnegative(context: Context) -> dict[int, str]:
    """The places of variables that are not negative, with what says that they are positive."""
    said = {h.subjects[0]: h.text for h in context.active if h.kind == "positive"}
    found: dict[int, str] = {}
    for place, variable in enumerate(context.variables):
        text = (
            said.get(variable.symbol)
            if variable.kind == "entry" and variable.symbol is not None and not variable.order
            else None
        )
        if text or variable.kind == "norm":
            found[place] = text or ""
    return found


def _signs(context: Context, squares: list[Square]) -> set[str]:
    """The texts of the hypotheses by which factors are not negative."""
    said = _nonnegative(context)
    return {said[place] for _, factor, _ in squares for place, e in enumerate(factor) if e}


def _written(context: Context, squares: list[Square]) -> list[list[str]]:
    ring = context.field.ring
    roots = ((c, ring.from_terms({factor: Fraction(1)}), ring.from_terms(root)) for c, factor, root in squares)
    return [[str(c), written(ring, factor), written(ring, root)] for c, factor, root in roots]
