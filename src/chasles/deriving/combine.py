"""An expression as a combination of given terms: the coefficients are found, numbers or functions of angles.

They are found from a linear system at generic points, and are a conjecture until they are decided.
"""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from dataclasses import replace as with_fields
from fractions import Fraction
from itertools import combinations_with_replacement

from chasles.algebra.modular import Span, combination
from chasles.problems.context import build
from chasles.prover.conditions import solve_conditions
from chasles.repairs.residues import Sampled, generic_points
from chasles.rewriting.coefficients import ONE, AngleFunction, added, spelled, times
from chasles.rewriting.term_basis import fit
from chasles.statements import Goal, Problem
from chasles.vocabulary import Block, Call, Node, Scale, Symbol, Zero, number, walk
from chasles.vocabulary.dimension import NO_DIMENSION

SPARE = 12
"""So many equations more than unknowns: a combination that satisfies them all is no accident."""


class NoCombination(ValueError):
    """The expression is no combination of the terms, or of several: the message says of which."""


def combined(node: Node, terms: Sequence[Node], problem: Problem) -> Node:
    """The expression written with the terms, block by block unless they fit the whole.

    Raises `NoCombination` if it cannot be, or can be in several ways.
    """
    if isinstance(node, Block) and not any(fit(node, term) for term in terms):
        return Block(tuple(tuple(combined(block, terms, problem) for block in row) for row in node.rows))
    if isinstance(node, Zero):
        return node
    fitting = [term for term in terms if fit(node, term)]
    if not fitting and node.is_scalar and fit(node, ONE):
        fitting = [ONE]
    sampled, functions = _sampled(node, fitting, problem)
    target = sampled.flat(node)
    if not any(target):
        return number(0) if node.is_scalar else Zero(*node.shape)
    if not fitting:
        raise NoCombination(f"none of the terms {_listed(terms)} fits {node}")
    cores = [sampled.flat(term) for term in fitting]
    for stage in functions:
        columns = [sampled.times(function.node, core) for core in cores for function in stage]
        found = combination(columns, target)
        if found is not None:
            return _written(fitting, stage, found, sampled)
    raise NoCombination(f"{node} is no combination of {_listed(fitting)}, or one in several ways")


def _sampled(node: Node, terms: list[Node], problem: Problem) -> tuple[Sampled, list[list[AngleFunction]]]:
    """Values at generic points, and the functions that coefficients are made of, from simple to involved."""
    stages = list(_stages(node, terms, problem))
    everything = [node, *terms, *(f.node for stage in stages for f in stage)]
    context = build(with_fields(problem, goals=tuple(Goal("", part, part) for part in everything)))
    solved = solve_conditions(context)[1]
    largest = max(map(len, stages))
    rows, columns = node.shape
    count = max((len(terms) * largest + SPARE) // (rows * columns), largest) + SPARE // 3
    points, _ = generic_points(context, solved, count)
    if len(points) < count:
        raise NoCombination(f"not enough points were found at which {node} could be compared with {_listed(terms)}")
    sampled = Sampled(context, points)
    return sampled, [list(_independent(stage, sampled)) for stage in stages]


def _independent(functions: Sequence[AngleFunction], sampled: Sampled) -> Iterator[AngleFunction]:
    span = Span()
    for function in functions:
        if span.add(sampled.flat(function.node)):
            yield function


def _stages(node: Node, terms: list[Node], problem: Problem) -> Iterator[list[AngleFunction]]:
    """Numbers; functions of angles; products of two; all of these over what may be divided by."""
    sources = [node, *terms, *(side for rule in problem.rules for side in rule)]
    sources += [side for goal in problem.conditions for side in goal.sides]
    parts = [part for source in sources for part in walk(source)]
    calls: list[Node] = list(dict.fromkeys(part for part in parts if isinstance(part, Call)))
    known = {symbol for call in calls for symbol in walk(call)} | set(problem.unknowns)
    calls += dict.fromkeys(part for part in parts if _is_parameter(part) and part not in known)
    yield [AngleFunction()]
    if not calls:
        return
    single = [AngleFunction(), *map(AngleFunction, calls)]
    yield single
    double = [*single, *(AngleFunction(Scale(a, b)) for a, b in combinations_with_replacement(calls, 2))]
    yield double
    declared = [part for h in problem.hypotheses for part in h.nonvanishing]
    divisors = [part for part in declared if any(isinstance(p, Call) for p in walk(part))]
    for power in (1, 2):
        below = [d if power == 1 else d**2 for d in divisors]
        if below:
            yield [*single, *(AngleFunction(f.numerator, d) for d in below for f in single)]


def _is_parameter(node: Node) -> bool:
    """Whether a scalar may stand in a coefficient: it has no dimension, and stands for nothing else."""
    return (
        isinstance(node, Symbol)
        and node.is_scalar
        and node.stands_for is None
        and node.measure is not None
        and node.measure.grid[0][0] == NO_DIMENSION
    )


def _written(terms: list[Node], functions: list[AngleFunction], values: list[Fraction], sampled: Sampled) -> Node:
    pieces = []
    for k, term in enumerate(terms):
        own = [pair for pair in zip(values[k * len(functions) :], functions, strict=False) if pair[0]]
        coefficient = spelled(_over_one(own, functions, sampled))
        if coefficient is not None:
            pieces.append(times(coefficient, None if term == ONE else term))
    return added(pieces)


def _over_one(
    own: list[tuple[Fraction, AngleFunction]], functions: list[AngleFunction], sampled: Sampled
) -> list[tuple[Fraction, AngleFunction]]:
    """The coefficient as one fraction, where it is the sum of a fraction and terms without a divisor."""
    divisors = {function.denominator for _, function in own}
    if len(divisors) != 2 or None not in divisors:
        return own
    (divisor,) = divisors - {None}
    above = [AngleFunction(f.numerator, divisor) for f in functions if f.denominator is None]
    whole = spelled(own)
    assert whole is not None
    values = combination([sampled.flat(f.node) for f in above], sampled.flat(whole))
    return own if values is None else list(zip(values, above, strict=True))


def _listed(terms: Sequence[Node]) -> str:
    return ", ".join(map(str, terms))
