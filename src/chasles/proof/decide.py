"""Is it true? Reduce what should vanish by what is known; if a remainder is left, look for an exact counterexample."""

from __future__ import annotations

from collections.abc import Callable, Mapping
from dataclasses import dataclass, replace
from itertools import islice
from math import inf
from typing import Any

from chasles.proof import points
from chasles.proof.completion import Basis, Combination, completed, stated
from chasles.proof.conditions import Solved, satisfying_point, solve_conditions
from chasles.proof.context import Context, Generator, build, difference, entries
from chasles.proof.counterexample import refute, solved_ratios
from chasles.proof.deadline import OutOfTime, remaining, within
from chasles.proof.polynomial_text import written
from chasles.proof.ratios import Ratio
from chasles.proof.rings import Polynomial
from chasles.proof.search import Search
from chasles.proof.unfold import UndeclaredDivisor
from chasles.proof.values import is_zero
from chasles.proof.variables import Untreatable
from chasles.proof.verdict import Fails, Holds, HoldsUnder, IllFormed, Posed, Undecided, Verdict
from chasles.statements import Goal, Hypothesis, Problem
from chasles.vocabulary import Symbol

__all__ = ["BUDGET", "decide_problem", "determining", "pose"]

BUDGET = 20.0
"""Seconds that a single decision may take before it gives up as undecided."""
SAMPLES = 40
"""So many sample points are looked at for one that satisfies all hypotheses."""


@dataclass(slots=True)
class _Entry:
    """One entry of one goal: what must vanish, and how it was found to."""

    goal: Goal
    label: str
    place: tuple[int, int]
    ratio: Ratio
    cofactors: Combination | None = None


def decide_problem(
    problem: Problem, own: tuple[Hypothesis, ...] = (), budget: float = BUDGET, search: Search | None = None
) -> Verdict:
    """The verdict on a problem; `own` are the hypotheses whose use is reported, `search` finds points for free ones.

    `Fails` always carries a counterexample and `Holds` a certificate; nothing is concluded from a remainder alone.
    """
    try:
        with within(budget):
            return _decide(problem, own, search)
    except OutOfTime:
        if remaining() < inf:
            raise
        return Undecided(f"{budget:g} seconds were not enough")


def _decide(problem: Problem, own: tuple[Hypothesis, ...], search: Search | None) -> Verdict:
    try:
        context = build(problem)
        conditions, solved = solve_conditions(context)
        unproved = _entries(context)
        proved = _prove(context, context.basis, unproved)
    except UndeclaredDivisor as error:
        return IllFormed(str(error))
    except Untreatable as error:
        return Undecided(str(error))
    if not proved:
        suspects = [e for e in unproved if e.cofactors is None]
        if search or not _vanish_here_and_there(context, solved, suspects):
            found = search.refute(context, suspects) if search else refute(context, solved, suspects)
            if found:
                return Fails(found)
        whole = completed(context.basis, lambda: remaining() > 0)
        if not _prove(context, whole, unproved):
            suspects = [e for e in unproved if e.cofactors is None]
            found = search.refute(context, suspects) if search else refute(context, solved, suspects)
            return Fails(found) if found else Undecided("a remainder is left, and no counterexample was found")
    witness = search.witness(context) if search else _witness(context, solved)
    if witness is None:
        return Undecided("it follows from its hypotheses, but no point was found that satisfies them all")
    return _certified(context, conditions, solved, unproved, own, witness)


def determining(problem: Problem, symbols: tuple[Symbol, ...]) -> Problem:
    """The problem whose conditions are what was to be decided, on the given symbols and those already determined."""
    conditions = (*problem.conditions, *problem.goals)
    return replace(problem, goals=(), conditions=conditions, unknowns=(*problem.unknowns, *symbols))


def pose(problem: Problem) -> Verdict:
    """A condition, with a point that satisfies it together with the hypotheses."""
    try:
        context = build(problem)
        witness = satisfying_point(context, islice(points.sample(context, {}), SAMPLES))
    except Untreatable as error:
        return Undecided(str(error))
    return Posed(witness) if witness is not None else Undecided("no point was found that satisfies the condition")


def _entries(context: Context) -> list[_Entry]:
    found = []
    for number, goal in enumerate(context.problem.goals):
        for i, j, ratio in entries(difference(context, goal)):
            found.append(_Entry(goal, f"{number}:{i},{j}", (i + 1, j + 1), ratio))
    return found


def _prove(context: Context, basis: Basis, todo: list[_Entry]) -> bool:
    """Try to reduce every entry to zero; each that does gets its cofactors."""
    for entry in todo:
        if entry.cofactors is None:
            cofactors, remainder = basis.reduce(entry.ratio.numerator)
            if remainder == 0:
                entry.cofactors = cofactors
    return all(entry.cofactors is not None for entry in todo)


def _vanish_here_and_there(context: Context, solved: tuple[Solved, ...], suspects: list[_Entry]) -> bool:
    """Whether the entries vanish at a few rich points: then they likely vanish everywhere, and a proof is worth it."""
    few = islice(points.sample(context, solved_ratios(context, solved), simple=False), 3)
    return all(is_zero(points.ratio_at(context, e.ratio, point) or {}) for point in few for e in suspects)


def _witness(context: Context, solved: tuple[Solved, ...]) -> points.Point | None:
    return next(islice(points.sample(context, solved_ratios(context, solved)), SAMPLES), None)


def _certified(
    context: Context,
    conditions: tuple[Generator, ...],
    solved: tuple[Solved, ...],
    done: list[_Entry],
    own: tuple[Hypothesis, ...],
    witness: Mapping[str, Any],
) -> Verdict:
    unused = _drop_unneeded(context, solved, done, own)
    used = _used_hypotheses(context, solved, done)
    needs = tuple(h.text for h in context.active if h in used)
    certificate = _certificate(context, conditions, solved, done, witness)
    if needs:
        return HoldsUnder(needs, certificate, witness, unused)
    return Holds(certificate, witness, unused)


def _used_hypotheses(context: Context, solved: tuple[Solved, ...], done: list[_Entry]) -> set[Hypothesis]:
    places = {k for entry in done for k in (entry.cofactors or {})} | {k for s in solved for k in s.cofactors}
    used = {h for k in places if (h := context.generators[k].hypothesis) is not None}
    used |= set(context.problem.presupposed)
    denominators = [e.ratio.denominator for e in done] + [s.value.denominator for s in solved]
    for place, (hypothesis, _) in enumerate(context.atoms):
        if hypothesis is not None and any(len(d) > place and d[place] for d in denominators):
            used.add(hypothesis)
    return used


def _drop_unneeded(
    context: Context, solved: tuple[Solved, ...], done: list[_Entry], own: tuple[Hypothesis, ...]
) -> tuple[str, ...]:
    """Do without each hypothesis in turn where that is possible; the statement's own that are not needed, by name."""
    ring = context.field.ring
    dropped: set[Hypothesis] = set()
    in_solved = {h for s in solved for k in s.cofactors if (h := context.generators[k].hypothesis) is not None}
    for hypothesis in context.active:
        if not hypothesis.equations or hypothesis in in_solved:
            continue
        kept = [
            k
            for k, g in enumerate(context.generators)
            if g.hypothesis is None or g.hypothesis not in dropped | {hypothesis}
        ]
        basis = stated(ring, tuple(context.generators[k].polynomial for k in kept), complete=False)
        attempts = [basis.reduce(entry.ratio.numerator) for entry in done]
        if all(remainder == 0 for _, remainder in attempts):
            dropped.add(hypothesis)
            for entry, (cofactors, _) in zip(done, attempts, strict=True):
                entry.cofactors = {kept[k]: c for k, c in cofactors.items()}
    used = _used_hypotheses(context, solved, done)
    return tuple(h.text for h in own if h not in used)


def _certificate(
    context: Context,
    conditions: tuple[Generator, ...],
    solved: tuple[Solved, ...],
    done: list[_Entry],
    witness: Mapping[str, Any],
) -> dict[str, Any]:
    """What a checker needs, as text: cofactors on the stated hypotheses by name, and a point that satisfies them.

    What is divided by, and the conditions, are numbered in the order in which the problem declares them.
    """
    write: Callable[[Polynomial], str] = lambda p: written(context.field.ring, p)  # noqa: E731
    divisors = [h for h in context.problem.hypotheses for _ in h.nonvanishing]
    atoms = []
    for hypothesis, _ in context.atoms:
        assert hypothesis is not None
        label = f"{divisors.index(hypothesis) + 1}. {hypothesis.text}"
        atoms.append(label)

    def said(denominator: tuple[int, ...], cofactors: Combination, on_conditions: Combination) -> dict[str, Any]:
        named = {f"{k + 1}. {conditions[k].label}": write(c) for k, c in on_conditions.items()}
        named |= {context.generators[k].label: write(c) for k, c in cofactors.items()}
        powers = zip(atoms, denominator, strict=False)
        return {"denominator": {label: power for label, power in powers if power}, "cofactors": named}

    return {
        "solved": {
            s.variable: {"numerator": write(s.value.numerator)} | said(s.value.denominator, s.cofactors, s.conditions)
            for s in solved
        },
        "entries": {e.label: said(e.ratio.denominator, e.cofactors or {}, {}) for e in done},
        "witness": {name: str(value) for name, value in sorted(witness.items())},
    }
