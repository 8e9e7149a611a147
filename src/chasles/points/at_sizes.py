"""Points of problems about matrices of any size: numbers for the sizes, small ones first, and rational entries."""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import replace as with_fields
from fractions import Fraction
from itertools import product

from chasles.checker.any_size.at_sizes import PointAtSizes, sizes_in
from chasles.checker.sparse import Rejected
from chasles.points.adjustment import solution
from chasles.points.rational import RationalRandom, SimpleRandom
from chasles.points.satisfying import SatisfyingValues, in_order
from chasles.problems.variables import entry_name
from chasles.statements import Problem
from chasles.statements.varied import opened_parts
from chasles.vocabulary import Symbol
from chasles.vocabulary.sizes import at_sizes

LARGEST, MOST_SIZES, EACH = 3, 30, 6
"""Sizes are numbers up to the largest; so many of these choices are tried, so often each."""


def points_at_sizes(problem: Problem, also: str = "") -> Iterator[dict[str, Fraction]]:
    """Points at which all that is assumed holds, of the kind `also` too; entries that are zero are not named.

    An equation that is given whole may hold of all values of its letters: a point that satisfies it refutes nothing.
    """
    names = sizes_in(problem)
    choices = sorted(
        product(range(1, LARGEST + 1), repeat=len(names)), key=lambda each: (max(each, default=0), sum(each), each)
    )
    symbols = _symbols(problem)
    draws = SimpleRandom(1), RationalRandom(1)
    for choice in choices[:MOST_SIZES]:
        for count in range(EACH):
            draw = draws[count % 2]
            draw.rich = count > 1
            at = _drawn(problem, symbols, dict(zip(names, choice, strict=True)), draw)
            try:
                at = _determined(problem, at) if problem.conditions else at
                PointAtSizes(problem, at).require(also)
            except Rejected:
                continue
            yield at


def _determined(problem: Problem, at: dict[str, Fraction]) -> dict[str, Fraction]:
    """The point with the unknowns of the conditions that satisfies them, if they are linear in these."""
    numbers = {name: int(at[name]) for name in sizes_in(problem)}
    names = [
        entry_name(sized, 0, i, j)
        for sized in (at_sizes(symbol, numbers) for symbol in problem.unknowns)
        if isinstance(sized, Symbol)
        for i, j in product(*map(range, sized.shape))
    ]
    known = {name: value for name, value in at.items() if name not in names}

    def missed(name: str = "") -> list[Fraction]:
        point = PointAtSizes(problem, known | ({name: Fraction(1)} if name else {}))
        sides = [(point(goal.left), point(goal.right)) for goal in problem.conditions]
        return [
            a - b
            for left, right in sides
            for row, other in zip(left, right, strict=True)
            for a, b in zip(row, other, strict=True)
        ]

    rest = missed()
    slopes = [[value - less for value, less in zip(missed(name), rest, strict=True)] for name in names]
    found = solution([[*row, -less] for *row, less in zip(*slopes, rest, strict=True)])
    return at if found is None else known | {name: value for name, value in zip(names, found, strict=True) if value}


def _symbols(problem: Problem) -> list[Symbol]:
    """The symbols that occur and are given by no rule."""
    sides = problem.sides
    sides += [side for _, side in problem.rules]
    sides += [node for h in problem.hypotheses for node in (*h.subjects, *h.nonvanishing)]
    ruled = {left for left, _ in problem.rules}
    found = dict.fromkeys(part for side in sides for part in opened_parts(side) if isinstance(part, Symbol))
    return [symbol for symbol in found if symbol.stands_for is None and symbol not in ruled]


def _drawn(
    problem: Problem, symbols: list[Symbol], numbers: dict[str, int], draw: RationalRandom
) -> dict[str, Fraction]:
    """Entries that satisfy hypotheses one by one; whether they satisfy all together is not asked here."""
    satisfying = SatisfyingValues(draw)
    for hypothesis in in_order(problem.hypotheses):
        subjects = tuple(at_sizes(node, numbers) for node in hypothesis.subjects)
        if hypothesis.kind == "of a rate":
            for node in subjects:
                assert isinstance(node, Symbol)
                satisfying.values[node, 0] = [[Fraction(0)] * node.shape[1] for _ in range(node.shape[0])]
        elif all(node in symbols for node in hypothesis.subjects):
            satisfying.bind(with_fields(hypothesis, subjects=subjects, equations=()))
    at = {name: Fraction(number) for name, number in numbers.items()}
    for symbol in symbols:
        sized = at_sizes(symbol, numbers)
        assert isinstance(sized, Symbol)
        entries = satisfying.values.get((sized, 0)) or draw.free(sized.shape)
        for i, row in enumerate(entries):
            at |= {entry_name(sized, 0, i, j): entry for j, entry in enumerate(row) if entry}
    return at
