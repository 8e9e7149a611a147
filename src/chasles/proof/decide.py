"""Is it true? Reduce what should vanish by what is known; if a remainder is left, look for an exact counterexample."""

from __future__ import annotations

from dataclasses import replace
from fractions import Fraction
from itertools import islice
from math import inf
from typing import Any

from chasles.proof import points
from chasles.proof.certifying import Entry, certified
from chasles.proof.completion import Basis, completed
from chasles.proof.conditions import Solved, satisfying_point, solve_conditions
from chasles.proof.context import Context, build, difference, entries
from chasles.proof.deadline import OutOfTime, remaining, within
from chasles.proof.rings import Polynomial
from chasles.proof.search import Search
from chasles.proof.unfold import UndeclaredDivisor
from chasles.proof.values import is_zero, shown
from chasles.proof.variables import Untreatable
from chasles.proof.verdict import Counterexample, Fails, IllFormed, Posed, Undecided, Verdict
from chasles.statements import Hypothesis, Problem
from chasles.vocabulary import PI, Symbol, symbols_of

__all__ = ["BUDGET", "decide_problem", "determining", "pose"]

BUDGET = 20.0
"""Seconds that a single decision may take before it gives up as undecided."""
SAMPLES = 40
FRUITLESS = 10
"""So many sample points are tried in vain before the best counterexample so far is taken."""


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
            found = search.refute(context, suspects) if search else _refute(context, solved, suspects)
            if found:
                return Fails(found)
        whole = completed(context.basis, lambda: remaining() > 0)
        if not _prove(context, whole, unproved):
            suspects = [e for e in unproved if e.cofactors is None]
            found = search.refute(context, suspects) if search else _refute(context, solved, suspects)
            return Fails(found) if found else Undecided("a remainder is left, and no counterexample was found")
    witness = search.witness(context) if search else _witness(context, solved)
    if witness is None:
        return Undecided("it follows from its hypotheses, but no point was found that satisfies them all")
    return certified(context, conditions, solved, unproved, own, witness)


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


def _entries(context: Context) -> list[Entry]:
    found = []
    for number, goal in enumerate(context.problem.goals):
        for i, j, ratio in entries(difference(context, goal)):
            found.append(Entry(goal, f"{number}:{i},{j}", (i + 1, j + 1), ratio))
    return found


def _prove(context: Context, basis: Basis, todo: list[Entry]) -> bool:
    """Try to reduce every entry to zero; each that does gets its cofactors."""
    for entry in todo:
        if entry.cofactors is None:
            cofactors, remainder = basis.reduce(entry.ratio.numerator)
            if remainder == 0:
                entry.cofactors, entry.by_division = cofactors, basis is context.basis
    return all(entry.cofactors is not None for entry in todo)


def _solved_ratios(context: Context, solved: tuple[Solved, ...]) -> dict[str, tuple[Polynomial, Polynomial]]:
    return {s.variable: (s.value.numerator, context.field.power_product(s.value.denominator)) for s in solved}


def _vanish_here_and_there(context: Context, solved: tuple[Solved, ...], suspects: list[Entry]) -> bool:
    """Whether the entries vanish at a few rich points: then they likely vanish everywhere, and a proof is worth it."""
    few = islice(points.sample(context, _solved_ratios(context, solved), simple=False), 3)
    return all(is_zero(points.ratio_at(context, e.ratio, point) or {}) for point in few for e in suspects)


def _refute(context: Context, solved: tuple[Solved, ...], suspects: list[Entry]) -> Counterexample | None:
    """The counterexample that is easiest to evaluate by hand among those that a number of sample points give."""
    best: tuple[int, Counterexample] | None = None
    used = _used_variables(context, solved, suspects)
    fruitless = 0
    for point in _limited(context, solved):
        fruitless += 1
        if best is not None and fruitless > FRUITLESS:
            break
        shown_point = {name: point[name] for name in used}
        height = sum(map(_height, shown_point.values()))
        if best is not None and height >= best[0]:
            continue
        for entry in suspects:
            value = points.ratio_at(context, entry.ratio, point)
            if value is None or is_zero(value):
                continue
            left, right = (
                context.unfold(side)[entry.place[0] - 1][entry.place[1] - 1]
                for side in (entry.goal.left, entry.goal.right)
            )
            sides = [points.ratio_at(context, side, point) for side in (left, right)]
            if sides[0] is None or sides[1] is None:
                continue
            texts = [shown(side, _transcendental_name(context)) for side in sides if side is not None]
            found = Counterexample(shown_point, entry.place, texts[0], texts[1], entry.goal.label)
            cost = height + len(texts[0]) + len(texts[1])
            if best is None or cost < best[0]:
                best, fruitless = (cost, found), 0
            break
    return best[1] if best else None


def _transcendental_name(context: Context) -> str:
    if context.pi_measures or not context.transcendental:
        return "pi"
    return context.variables[min(context.transcendental)].name


def _limited(context: Context, solved: tuple[Solved, ...]) -> Any:
    """Sample points, as many as are useful, given up after a while where they are rare."""
    return islice(points.sample(context, _solved_ratios(context, solved)), SAMPLES)


def _height(value: Fraction) -> int:
    return (
        0
        if value == 0
        else 1
        + 2 * (abs(value) != 1)
        + len(str(abs(value.numerator)))
        + 3 * (len(str(value.denominator)) if value.denominator != 1 else 0)
    )


def _used_variables(context: Context, solved: tuple[Solved, ...], suspects: list[Entry]) -> list[str]:
    """The variables on which the question depends, in a reader's order: those that were solved for left out."""
    ring = context.field.ring
    polynomials = [p for e in suspects for p in (e.ratio.numerator, context.field.power_product(e.ratio.denominator))]
    for entry in suspects:
        for side in (entry.goal.left, entry.goal.right):
            polynomials += [r.numerator for _, _, r in entries(context.unfold(side))]
    places = {k for p in polynomials for exponents, _ in ring.terms(p) for k, e in enumerate(exponents) if e}
    of_norms = [node for k in places if (node := context.variables[k].node) is not None]
    touched = {context.variables[k].symbol for k in places} - {None}
    touched |= {symbol for node in of_norms for symbol in symbols_of(node)}
    circular = {context.variables[k].symbol for k in places if context.variables[k].kind in ("cos", "sin")}
    names = [
        v.name
        for k, v in enumerate(context.variables)
        if k in places
        or (v.symbol in touched and v.kind == "entry" and v.order == 0 and k not in context.transcendental)
        or (v.symbol in circular and v.kind in ("cos", "sin"))
    ]
    multiples = {k for k in context.transcendental if context.pi_measures and context.variables[k].symbol != PI}
    gone = {s.variable for s in solved} | {context.variables[k].name for k in context.transcendental - multiples}
    return sorted(name for name in names if name not in gone)


def _witness(context: Context, solved: tuple[Solved, ...]) -> points.Point | None:
    return next(iter(_limited(context, solved)), None)
