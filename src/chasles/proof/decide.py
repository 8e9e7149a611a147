"""Is it true? Reduce what should vanish by what is known; if a remainder is left, look for an exact counterexample."""

from __future__ import annotations

from collections.abc import Callable, Mapping
from dataclasses import dataclass, replace
from fractions import Fraction
from itertools import islice
from math import inf
from typing import Any

from chasles.proof import points
from chasles.proof.completion import Basis, Combination, completed, stated
from chasles.proof.conditions import Solved, satisfying_point, solve_conditions
from chasles.proof.context import Context, Generator, build, difference, entries
from chasles.proof.deadline import OutOfTime, remaining, within
from chasles.proof.polynomial_text import written
from chasles.proof.ratios import Ratio
from chasles.proof.rings import Polynomial, Ring
from chasles.proof.search import Search
from chasles.proof.unfold import UndeclaredDivisor
from chasles.proof.values import InPi, is_zero, shown
from chasles.proof.variables import Untreatable
from chasles.proof.verdict import Counterexample, Fails, Holds, HoldsUnder, IllFormed, Posed, Undecided, Verdict
from chasles.statements import Goal, Hypothesis, Problem
from chasles.statements.spins import with_spins
from chasles.vocabulary import PI, Symbol

__all__ = ["BUDGET", "decide_problem", "determining", "pose"]

BUDGET = 20.0
"""Seconds that a single decision may take before it gives up as undecided."""
SAMPLES = 40
FRUITLESS = 10
"""So many sample points are tried in vain before the best counterexample so far is taken."""


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
        turned = None if search else _by_spins(context, solved, unproved, own)
        if turned is not None:
            return turned
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
    return _certified(context, conditions, solved, unproved, own, witness)


def _by_spins(
    context: Context, solved: tuple[Solved, ...], unproved: list[_Entry], own: tuple[Hypothesis, ...]
) -> Verdict | None:
    """The verdict where rotations move: refuted at a point, or proved for all spins; None where neither is found."""
    spun = with_spins(context.problem)
    if spun is context.problem or all(entry.ratio.is_zero for entry in unproved):
        return None
    if not _vanish_here_and_there(context, solved, unproved):
        found = _refute(context, solved, unproved)
        return Fails(found) if found else None
    verdict = _decide(spun, own, None)
    if isinstance(verdict, Holds | HoldsUnder):
        return replace(verdict, certificate={**verdict.certificate, "spins": True})
    return None


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


def _solved_ratios(context: Context, solved: tuple[Solved, ...]) -> dict[str, tuple[Polynomial, Polynomial]]:
    return {s.variable: (s.value.numerator, context.field.power_product(s.value.denominator)) for s in solved}


def _vanish_here_and_there(context: Context, solved: tuple[Solved, ...], suspects: list[_Entry]) -> bool:
    """Whether the entries vanish at a few rich points: then they likely vanish everywhere, and a proof is worth it."""
    few = islice(points.sample(context, _solved_ratios(context, solved), simple=False), 3)
    return all(is_zero(points.ratio_at(context, e.ratio, point) or {}) for point in few for e in suspects)


def _refute(context: Context, solved: tuple[Solved, ...], suspects: list[_Entry]) -> Counterexample | None:
    """The counterexample that is easiest to evaluate by hand among those that a number of sample points give."""
    best: tuple[int, Counterexample] | None = None
    used = _used_variables(context, solved, suspects)
    angles = {context.variables[k].name for k in context.transcendental}
    fruitless = 0
    for point in _limited(context, solved):
        fruitless += 1
        if best is not None and fruitless > FRUITLESS:
            break
        shown_point = {name: InPi(point[name]) if name in angles else point[name] for name in used}
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


def _used_variables(context: Context, solved: tuple[Solved, ...], suspects: list[_Entry]) -> list[str]:
    """The variables on which the question depends, and those tied to them, in a reader's order.

    Those that were solved for are left out, and so is an angle beside its cosine and sine, but where pi measures it.
    """
    ring = context.field.ring
    polynomials = [p for e in suspects for p in (e.ratio.numerator, context.field.power_product(e.ratio.denominator))]
    for entry in suspects:
        for side in (entry.goal.left, entry.goal.right):
            polynomials += [r.numerator for _, _, r in entries(context.unfold(side))]
    places = _tied(context, {k for p in polynomials for k in _places(ring, p)})
    touched = {context.variables[k].symbol for k in places} - {None}
    circular = {context.variables[k].symbol for k in places if context.variables[k].kind in ("cos", "sin")}
    names = [
        v.name
        for k, v in enumerate(context.variables)
        if k in places
        or (v.symbol in touched and v.kind == "entry" and v.order == 0)
        or (v.symbol in circular and v.kind in ("cos", "sin"))
    ]
    hidden = {k for k in context.transcendental if not context.pi_measures or context.variables[k].symbol == PI}
    gone = {s.variable for s in solved} | {context.variables[k].name for k in hidden}
    return sorted(name for name in names if name not in gone)


def _places(ring: Ring, polynomial: Polynomial) -> set[int]:
    return {k for exponents, _ in ring.terms(polynomial) for k, exponent in enumerate(exponents) if exponent}


def _tied(context: Context, places: set[int]) -> set[int]:
    """The variables, and all that equations tie to them: a norm to its vector, a rate to what it is of."""
    ring = context.field.ring
    equations = [_places(ring, generator.polynomial) for generator in context.generators]
    while more := set().union(*(known for known in equations if known & places)) - places:
        places = places | more
    return places


def _witness(context: Context, solved: tuple[Solved, ...]) -> points.Point | None:
    return next(iter(_limited(context, solved)), None)


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
    needs = tuple(h.text for h in context.problem.hypotheses if h in used and h.kind != "given")
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
    used = {h.text for h in _used_hypotheses(context, solved, done)}
    return tuple(h.text for h in own if h.text not in used)


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
