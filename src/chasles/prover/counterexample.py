"""The search for a counterexample that is easy to evaluate by hand: one entry, what it depends on, small numbers."""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from dataclasses import replace
from itertools import islice

from chasles.algebra.rings import Polynomial, Ring
from chasles.algebra.values import is_zero, shown
from chasles.checker.refutation import check_counterexample
from chasles.checker.sparse import Rejected
from chasles.points import sampling as points
from chasles.points.evaluation import Point, measured, ratio_at
from chasles.points.search import UnreducedEntry, height
from chasles.problems.context import Context
from chasles.problems.generators import entries
from chasles.prover.conditions import Solved
from chasles.prover.consistency import point_of_the_rest
from chasles.statements.conditions import UNFINISHED
from chasles.verdict import Counterexample
from chasles.vocabulary import PI, Symbol, symbols_of

PLAIN, SAMPLES = 60, 40
FRUITLESS = 15
"""So many points are tried in vain before the best counterexample so far is taken."""


def refute(
    context: Context, solved: tuple[Solved, ...], suspects: Sequence[UnreducedEntry], fruitless: int = FRUITLESS
) -> Counterexample | None:
    """The counterexample that is easiest to evaluate by hand among those that a number of sample points give.

    After so many that are `fruitless` no easier one is looked for.
    Points of axes, quarter turns, ones and zeros come first; others are tried if none of these refutes, and then
    such as give a value to all that occurs, and to what is assumed besides. Only what the checker accepts refutes.
    """
    if any(h.kind == UNFINISHED for h in context.problem.hypotheses):
        return None
    used = _used_by_each(context, solved, suspects)
    gone = {s.variable for s in solved} | _unmeasured(context)
    whole = [sorted(v.name for v in context.variables if v.name not in gone)] * len(suspects)
    ratios = solved_ratios(context, solved)
    for names, beside in ((used, False), (whole, True)):
        more = point_of_the_rest(context) if beside else {}
        if more is None:
            break
        for drawn in (points.plain(context, ratios, PLAIN), islice(points.sample(context, ratios), SAMPLES)):
            for found in _easiest(context, suspects, names, drawn, fruitless):
                whole_point = replace(found, at={**found.at, **more})
                if _is_accepted(context, whole_point):
                    return whole_point
    return None


def _is_accepted(context: Context, found: Counterexample) -> bool:
    """Whether the checker, which imports nothing of the search, finds a motion through the point that refutes.

    What the hypotheses say of rates higher than all that occur may restrict those that do: the checker sees to that.
    """
    try:
        check_counterexample(context.problem, found)
    except Rejected:
        return False
    return True


def solved_ratios(context: Context, solved: tuple[Solved, ...]) -> dict[str, tuple[Polynomial, Polynomial]]:
    """Numerator and denominator of each variable that the conditions determine."""
    return {s.variable: (s.value.numerator, context.field.power_product(s.value.denominator)) for s in solved}


def _easiest(
    context: Context,
    suspects: Sequence[UnreducedEntry],
    used: Sequence[Sequence[str]],
    drawn: Iterator[Point],
    most: int,
) -> list[Counterexample]:
    """Counterexamples, each easier than those that come after it."""
    best: tuple[int, Counterexample] | None = None
    easier: list[Counterexample] = []
    fruitless = 0
    for point in drawn:
        fruitless += 1
        if best is not None and fruitless > most:
            break
        for entry, names in zip(suspects, used, strict=True):
            least = len(names) + 2 * sum(height(point[name]) for name in names)
            if best is not None and least >= best[0]:
                continue
            found = _refuted(context, entry, point, names)
            if found is not None:
                cost = least + 2 * (len(found.left) + len(found.right))
                if best is None or cost < best[0]:
                    best, fruitless = (cost, found), 0
                    easier.insert(0, found)
    return easier


def _refuted(context: Context, entry: UnreducedEntry, point: Point, names: Sequence[str]) -> Counterexample | None:
    """The entry at the point, if its two sides differ there."""
    value = ratio_at(context, entry.ratio, point)
    if value is None or is_zero(value):
        return None
    row, column = entry.place
    sides = [
        ratio_at(context, context.unfold(side)[row - 1][column - 1], point)
        for side in (entry.goal.left, entry.goal.right)
    ]
    if sides[0] is None or sides[1] is None:
        return None
    left, right = (shown(side, transcendental_name(context)) for side in sides if side is not None)
    at = measured(context, {name: point[name] for name in names})
    return Counterexample(at, entry.place, left, right, entry.goal.label)


def transcendental_name(context: Context) -> str:
    """What the powers in a value are powers of: pi, or the only angle that occurs outside of functions."""
    if context.pi_measures or not context.transcendental:
        return "pi"
    return context.variables[min(context.transcendental)].name


def _used_by_each(
    context: Context, solved: tuple[Solved, ...], suspects: Sequence[UnreducedEntry]
) -> list[Sequence[str]]:
    """The variables on which each entry depends; all together where conditions tie what one entry leaves out."""
    if solved:
        together = _used(context, solved, suspects)
        return [together] * len(suspects)
    return [_used(context, (), [entry]) for entry in suspects]


def _used(context: Context, solved: tuple[Solved, ...], suspects: Sequence[UnreducedEntry]) -> list[str]:
    """The variables on which entries depend and what is tied to them; those that were solved for left out."""
    ring = context.field.ring
    polynomials = [p for e in suspects for p in (e.ratio.numerator, context.field.power_product(e.ratio.denominator))]
    for entry in suspects:
        for side in (entry.goal.left, entry.goal.right):
            row, column = entry.place
            ratios = [context.unfold(side)[row - 1][column - 1]]
            if solved:
                ratios = [ratio for _, _, ratio in entries(context.unfold(side))]
            polynomials += [r.numerator for r in ratios]
            polynomials += [context.field.power_product(r.denominator) for r in ratios]
    ties = [_places(ring, g.polynomial) for g in context.generators]
    ties += [_places(ring, factor) for _, factor in context.nonzero]
    ties += [*_together(context), *_below_norms(context)]
    # By which fraction of an angle its cosine and sine are measured is told from their names alone.
    places = {place for place, variable in enumerate(context.variables) if variable.unit != 1}
    places = places.union(*(_places(ring, polynomial) for polynomial in polynomials))
    while more := [tied for tied in ties if tied & places and not tied <= places]:
        places = places.union(*more)
    gone = {s.variable for s in solved} | _unmeasured(context)
    return sorted(context.variables[k].name for k in places if context.variables[k].name not in gone)


def _unmeasured(context: Context) -> set[str]:
    """What has no value but itself: pi, and an angle outside of functions where pi does not measure it."""
    multiples = {k for k in context.transcendental if context.pi_measures and context.variables[k].symbol != PI}
    return {context.variables[k].name for k in context.transcendental - multiples}


def _places(ring: Ring, polynomial: Polynomial) -> set[int]:
    return {place for exponents, _ in ring.terms(polynomial) for place, exponent in enumerate(exponents) if exponent}


def _below_norms(context: Context) -> Iterator[set[int]]:
    """Each norm with the entries of what it is the norm of: without these, its value says nothing."""
    for place, variable in enumerate(context.variables):
        if variable.node is not None:
            symbols = set(symbols_of(variable.node))
            below = {k for k, v in enumerate(context.variables) if v.kind == "entry" and v.symbol in symbols}
            yield {place, *(k for k in below if context.variables[k].order == 0 and k not in context.transcendental)}


def _together(context: Context) -> Iterator[set[int]]:
    """What is named together: a cosine and its sine, the components of a vector or of its rate."""
    groups: dict[tuple[Symbol, int], set[int]] = {}
    for place, variable in enumerate(context.variables):
        symbol = variable.symbol
        if symbol is not None and variable.kind in ("cos", "sin"):
            groups.setdefault((symbol, -1), set()).add(place)
        elif symbol is not None and variable.kind == "entry" and symbol.shape[1] == 1 < symbol.shape[0]:
            groups.setdefault((symbol, variable.order), set()).add(place)
    yield from groups.values()
