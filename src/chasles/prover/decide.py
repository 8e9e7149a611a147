"""The decision of a problem: goals divided by the hypotheses; for a remainder, the search for a counterexample."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import replace
from itertools import islice
from math import inf
from typing import Any

from chasles.algebra.groebner import Basis, combined, completed
from chasles.algebra.work_limit import OutOfTime, remaining, within
from chasles.checker.any_size.at_sizes import sizes_in
from chasles.points import sampling as points
from chasles.points.evaluation import measured
from chasles.problems.context import Context, build, difference
from chasles.problems.divisors import UndeclaredDivisor
from chasles.problems.generators import entries
from chasles.problems.variables import NoForm, Untreatable
from chasles.prover.certifying import ProvedEntry, certified
from chasles.prover.conditions import Solved, Underdetermined, satisfying_point, solve_conditions
from chasles.prover.consistency import contradiction
from chasles.prover.sources import SAMPLES, DeclaredPoints, PointSource
from chasles.statements import Goal, Hypothesis, Problem
from chasles.statements.conditions import freed
from chasles.statements.spins import with_spins
from chasles.verdict import Counterexample, Fails, Holds, HoldsUnder, IllFormed, Posed, Undecided, Verdict
from chasles.vocabulary import Symbol, symbols_of

BUDGET = 2e7
"""The work that a single decision may take before it gives up as undecided, in products of terms."""
POWERS = 1, 3
"""With these powers of what does not vanish an entry is multiplied: a law may divide by the cube of a distance."""
CASES = 4
"""So many points are drawn to find one at which a case occurs."""
DECLARED = DeclaredPoints()
REMAINDER = "a remainder is left, and no counterexample was found"
NO_POINT = "it follows from its hypotheses, but no point was found that satisfies them all"


def decide_problem(
    problem: Problem, own: tuple[Hypothesis, ...] = (), budget: float = BUDGET, search: PointSource | None = None
) -> Verdict:
    """The verdict on a problem; `own` are the hypotheses whose use is reported, `search` finds points for free ones.

    `Fails` always carries a counterexample and `Holds` a certificate; nothing is concluded from a remainder alone.
    """
    try:
        with within(budget):
            return _decide(problem, own, search or DECLARED)
    except OutOfTime as error:
        if remaining() < inf:
            raise
        return Undecided(str(error))


def _decide(problem: Problem, own: tuple[Hypothesis, ...], source: PointSource) -> Verdict:
    try:
        context = build(problem)
        conditions, solved = solve_conditions(context)
        unproved = open_entries(context)
        turned = _by_spins(context, solved, unproved, own) if source is DECLARED else None
        if turned is not None:
            return turned
        proved = _prove(context, context.basis, unproved)
    except (UndeclaredDivisor, Underdetermined) as error:
        if isinstance(error, UndeclaredDivisor) and not problem.conditions:
            return IllFormed(str(error))
        # What is assumed of a symbol that conditions determine is known of it where these are assumed, too.
        verdict = _decide(freed(problem), own, source)
        if isinstance(verdict, Undecided):
            return Undecided(str(error))
        if isinstance(verdict, Holds | HoldsUnder):
            return replace(verdict, certificate={**verdict.certificate, "freed": True})
        return verdict
    except Untreatable as error:
        return source.contradiction(problem) or Undecided(str(error), without_form=isinstance(error, NoForm))
    found = None if proved else _refuted(context, solved, unproved, source)
    if found is not None:
        return Fails(found)
    if _suspects(unproved):
        lengths = any(variable.kind == "norm" for variable in context.variables)
        return source.contradiction(problem) or Undecided(REMAINDER, without_form=lengths)
    witness = source.witness(context, solved)
    if witness is None:
        return source.contradiction(problem) or Undecided(NO_POINT)
    for case in problem.cases:
        if not _occurs(problem, case) and (empty := contradiction(problem, (case,))):
            return empty
    return certified(context, conditions, solved, unproved, own, witness, source.write)


def _occurs(problem: Problem, case: Goal) -> bool:
    """Whether a case is seen to occur: it is solved for a symbol of which nothing is assumed."""
    bound = {part for h in problem.hypotheses for node in (*h.subjects, *h.nonvanishing) for part in symbols_of(node)}
    bound |= {symbol for left, _ in problem.rules for symbol in symbols_of(left)}
    free = [symbol for symbol in symbols_of(case.left) if symbol not in bound]
    for symbol in free if not problem.conditions else ():
        try:
            context = build(replace(problem, goals=(), conditions=(case,), unknowns=(symbol,)))
            if satisfying_point(context, islice(points.sample(context, {}), CASES)) is not None:
                return True
        except Untreatable:
            continue
    return False


def _refuted(
    context: Context, solved: tuple[Solved, ...], unproved: list[ProvedEntry], source: PointSource
) -> Counterexample | None:
    """A counterexample to one of the entries; None too if the completed hypotheses prove them all."""
    found = source.refute_soon(context, solved, _suspects(unproved))
    if found is not None or _combine(context, unproved):
        return found
    basis = completed(context.basis)
    if _prove(context, basis, unproved) or _prove_multiplied(context, basis, unproved):
        return found
    return source.refute(context, solved, _suspects(unproved))


def _suspects(unproved: list[ProvedEntry]) -> list[ProvedEntry]:
    return [entry for entry in unproved if entry.cofactors is None]


def _by_spins(
    context: Context, solved: tuple[Solved, ...], unproved: list[ProvedEntry], own: tuple[Hypothesis, ...]
) -> Verdict | None:
    """The verdict where rotations move: refuted at a point, or proved for all spins; None where neither is found."""
    spun = with_spins(context.problem)
    if spun is context.problem or all(entry.ratio.is_zero for entry in unproved):
        return None
    if not DECLARED.likely_vanish(context, solved, unproved):
        found = DECLARED.refute(context, solved, unproved)
        return Fails(found) if found else None
    verdict = _decide(spun, own, DECLARED)
    if isinstance(verdict, Holds | HoldsUnder):
        return replace(verdict, certificate={**verdict.certificate, "spins": True})
    return None


def determining(problem: Problem, symbols: tuple[Symbol, ...]) -> Problem:
    """The problem whose conditions are what was to be decided, on the given symbols and those already determined."""
    conditions = (*problem.conditions, *problem.goals)
    return replace(problem, goals=(), conditions=conditions, unknowns=(*problem.unknowns, *symbols))


def pose(problem: Problem, attempts: int = points.ATTEMPTS) -> Verdict:
    """A condition, with a point that satisfies it together with the hypotheses; one is drawn in so many attempts."""
    if sizes_in(problem):
        from chasles.prover.symbolic import pose_at_sizes  # few chapters have letters for sizes

        return pose_at_sizes(problem)
    try:
        witness = _satisfying(problem, attempts)
    except Untreatable:
        try:
            witness = _satisfying(freed(problem), attempts)
        except Untreatable as error:
            return Undecided(str(error))
    if witness is None:
        return contradiction(problem) or Undecided("no point was found that satisfies the condition")
    return Posed(witness)


def _satisfying(problem: Problem, attempts: int) -> Mapping[str, Any] | None:
    """A point that satisfies the conditions and hypotheses, as it is shown, if one is found."""
    context = build(problem)
    witness = satisfying_point(context, islice(points.sample(context, {}, attempts=attempts), SAMPLES))
    return None if witness is None else measured(context, witness)


def open_entries(context: Context) -> list[ProvedEntry]:
    """The entries of all goals, of which nothing is proved yet."""
    found = []
    for number, goal in enumerate(context.problem.goals):
        for i, j, ratio in entries(difference(context, goal)):
            found.append(ProvedEntry(goal, f"{number}:{i},{j}", (i + 1, j + 1), ratio))
    return found


def _combine(context: Context, todo: list[ProvedEntry]) -> bool:
    """Try to add every entry up of what is assumed; each that is such a sum gets its cofactors."""
    generators = [generator.polynomial for generator in context.generators]
    for entry in _suspects(todo):
        entry.cofactors = combined(context.field.ring, entry.ratio.numerator, generators)
        if entry.cofactors is None:
            return False
    return True


def _prove(context: Context, basis: Basis, todo: list[ProvedEntry]) -> bool:
    """Try to reduce every entry to zero; each that does gets its cofactors."""
    for entry in todo:
        if entry.cofactors is None:
            cofactors, remainder = basis.reduce(entry.ratio.numerator)
            if remainder == 0:
                entry.cofactors, entry.by_division = cofactors, basis is context.basis and not basis.explicit
    return all(entry.cofactors is not None for entry in todo)


def _prove_multiplied(context: Context, basis: Basis, todo: list[ProvedEntry]) -> bool:
    """Try to reduce the entries multiplied by what does not vanish: with it, all that vanishes may be a multiple."""
    for entry in _suspects(todo) if context.field.nonzero else ():
        for power in POWERS:
            multiplied = entry.ratio.multiplied((power,) * len(context.field.nonzero))
            cofactors, remainder = basis.reduce(multiplied.numerator)
            if remainder == 0:
                entry.ratio, entry.cofactors, entry.multiplied = multiplied, cofactors, True
                break
        else:
            return False
    return not _suspects(todo)
