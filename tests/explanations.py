"""Why is a mutant true? An answer that is worked out anew for each, never looked up.

A mutant that holds must say what the original says, or something else that is true. The first is shown by proving the
two alike without any hypothesis, the second by finding what the mutant rests on, and by its exact values elsewhere.
"""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import replace
from itertools import chain, islice

from chasles.points import sampling as points
from chasles.problems.context import build
from chasles.prover.decide import decide_problem
from chasles.statements import Goal, Problem
from chasles.verdict import Counterexample, Holds, HoldsUnder
from chasles.vocabulary import Negative, Node, Sum

from .exact_words import Broken, Words

__all__ = ["completions", "evaluations", "explanation"]


def explanation(original: Problem, mutant: Problem) -> str:
    """What makes the mutant true, in a few words."""
    pairs = list(zip(original.goals, mutant.goals, strict=True))
    if _holds_for_all(
        mutant, [(x, y) for one, other in pairs for x, y in ((one.left, other.left), (one.right, other.right))]
    ):
        return "says the same: each side is the old one, whatever the symbols are"
    if _holds_for_all(mutant, [(_difference(one), _difference(other)) for one, other in pairs]):
        return "says the same: left less right is the old left less right, whatever the symbols are"
    return f"is true as well: it needs {_resting_on(mutant) or 'nothing at all'}"


def _difference(goal: Goal) -> Node:
    return Sum((goal.left, Negative(goal.right)))


def _holds_for_all(problem: Problem, equations: list[tuple[Node, Node]]) -> bool:
    """Whether equations hold for all values, with nothing given and only what is divided by restricted."""
    divisors = tuple(h for h in problem.hypotheses if h.nonvanishing)
    goals = tuple(Goal("", left, right) for left, right in equations)
    return isinstance(decide_problem(Problem(goals, hypotheses=divisors)), Holds | HoldsUnder)


def _resting_on(problem: Problem) -> str:
    """A smallest part of what is given and assumed from which the mutant follows, found by leaving out each in turn."""
    rest: list[str] = []
    for rule in problem.rules:
        without = replace(problem, rules=tuple(r for r in problem.rules if r != rule))
        if _holds(without):
            problem = without
        else:
            rest.append(f"{rule[0]} = {rule[1]}")
    if problem.unknowns:
        without = replace(problem, conditions=(), unknowns=())
        if _holds(without):
            problem = without
        else:
            rest.append(f"what {', '.join(map(str, problem.unknowns))} must satisfy")
    for hypothesis in problem.hypotheses:
        without = replace(problem, hypotheses=tuple(h for h in problem.hypotheses if h != hypothesis))
        if _holds(without):
            problem = without
        else:
            rest.append(hypothesis.text)
    return "; ".join(rest)


def _holds(problem: Problem) -> bool:
    return isinstance(decide_problem(problem), Holds | HoldsUnder)


def completions(problem: Problem, shown: Counterexample) -> Iterator[Words]:
    """The words at the point of a counterexample: what it leaves out is zero, or has any value that is possible.

    Raises `Broken` if the point satisfies the hypotheses with none of these.
    """
    found = 0
    for point in chain(({},), islice(points.sample(build(problem), {}, simple=False), 40)):
        try:
            words = Words(problem, {**point, **shown.at})
            words.require()
            for goal in problem.goals:
                words.sides(goal.left, goal.right)
        except Broken as broken:
            reason = broken
            continue
        yield words
        found += 1
    if not found:
        raise reason


def evaluations(problem: Problem, count: int) -> Iterator[bool]:
    """Whether the two sides have the same exact values at points which satisfy all that is given and assumed."""
    found = 0
    for point in islice(points.sample(build(problem), {}, simple=False), 40):
        try:
            words = Words(problem, point)
            words.require()
            values = [words.sides(goal.left, goal.right) for goal in problem.goals]
        except Broken:
            continue
        yield all(left == right for left, right in values)
        found += 1
        if found == count:
            return
