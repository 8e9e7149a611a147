"""Points moved so that they satisfy equations that are linear in free symbols, such as rules for rates.

First what is linear in all that may move is made to vanish; then the rest, by moving only what occurs nowhere but
linearly; then the rates of hypotheses, one order after the other, by moving what no lower order speaks of; at last all,
by moving some of it in which all is linear together.
"""

from __future__ import annotations

from dataclasses import dataclass
from fractions import Fraction

from chasles.algebra.rings import Polynomial
from chasles.algebra.values import is_zero
from chasles.checker.motion import eliminated
from chasles.points.evaluation import Point, evaluate, satisfies
from chasles.problems.context import Context
from chasles.vocabulary import PI

Slopes = dict[int, Polynomial]


@dataclass(frozen=True, slots=True)
class _Moves:
    """What may move, which of it occurs not only linearly, and the generators with their derivatives by it.

    Those are `flat` that are linear in all that may move; in what is `straight` all of them are together.
    """

    places: frozenset[int]
    curved: frozenset[int]
    straight: frozenset[int]
    flat: tuple[tuple[Polynomial, Slopes], ...]
    all: tuple[tuple[Polynomial, Slopes], ...]


def adjusted(context: Context, point: Point) -> bool:
    """Whether the point, once moved, satisfies all; free symbols move, and if need be the rates of bound ones too."""
    bound = {subject for h in context.active if h.equations and not h.free for subject in h.subjects}
    entries = [(k, v) for k, v in enumerate(context.variables) if v.kind == "entry" and v.symbol != PI]
    free = tuple(k for k, v in entries if v.symbol not in bound)
    rates = tuple(k for k, v in entries if v.order and v.symbol in bound)
    for places in (free, free + rates) if rates else (free,):
        moves = _moves(context, places)
        for generators, moving in ((moves.flat, moves.places), (moves.all, moves.places - moves.curved)):
            _solve(context, point, generators, moving)
            if satisfies(context, point):
                return True
    moves = _moves(context, free + rates)
    still = moves.places
    for order in range(max((g.order for g in context.generators), default=0) + 1):
        stated = [each for each, g in zip(moves.all, context.generators, strict=True) if g.order == order]
        _solve(context, point, tuple(stated), still if order else frozenset())
        still = still.difference(*(slopes for _, slopes in stated))
    if not satisfies(context, point):
        moves = _moves(context, free)
        _solve(context, point, moves.all, moves.straight)
    return satisfies(context, point)


def _moves(context: Context, places: tuple[int, ...]) -> _Moves:
    """The moves, found once for each choice of what may move."""
    if places not in context.moves:
        ring = context.field.ring
        flat, slopes = [], []
        curved: set[tuple[int, int]] = set()
        for generator in context.generators:
            mine = {k: slope for k in places if (slope := ring.derivative(generator.polynomial, k)) != 0}
            bent = {(k, j) for k, slope in mine.items() for j in places if ring.derivative(slope, j) != 0}
            slopes.append((generator.polynomial, mine))
            flat += [] if bent else slopes[-1:]
            curved |= bent
        straight: set[int] = set()
        for k in places:
            if not any((k, j) in curved for j in (k, *straight)):
                straight.add(k)
        bent_places = frozenset(k for k, _ in curved)
        context.moves[places] = _Moves(frozenset(places), bent_places, frozenset(straight), tuple(flat), tuple(slopes))
    found = context.moves[places]
    assert isinstance(found, _Moves)
    return found


def _solve(
    context: Context, point: Point, generators: tuple[tuple[Polynomial, Slopes], ...], places: frozenset[int]
) -> None:
    """Move so that the generators vanish, if that can be; what is not tied to a violated one stays."""
    concerned = [k for k, (p, _) in enumerate(generators) if not is_zero(evaluate(context, p, point))]
    moving: set[int] = set()
    while more := {k for g in concerned for k in generators[g][1]} & places - moving:
        moving |= more
        concerned = [g for g, (_, mine) in enumerate(generators) if g in concerned or not moving.isdisjoint(mine)]
    if not moving:
        return
    order = sorted(moving)
    rows = [
        [evaluate(context, mine[k], point).get(0, Fraction(0)) if k in mine else Fraction(0) for k in order]
        + [-evaluate(context, p, point).get(0, Fraction(0))]
        for p, mine in (generators[g] for g in concerned)
    ]
    change = solution(rows)
    for k, moved in zip(order, change or (), strict=bool(change)):
        point[context.variables[k].name] += moved


def solution(rows: list[list[Fraction]]) -> list[Fraction] | None:
    """A solution of the rational linear system whose last column is the right side; None if there is none."""
    size = len(rows[0]) - 1
    reduced, pivots = eliminated(rows, size)
    if any(row[-1] for row in reduced[len(pivots) :]):
        return None
    found = dict(zip(pivots, reduced, strict=False))
    return [found[column][-1] if column in found else Fraction(0) for column in range(size)]
