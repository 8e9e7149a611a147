"""Arguments that are rotation vectors, said by their lengths, which are angles, and by their directions."""

from __future__ import annotations

from collections.abc import Callable, Iterable
from dataclasses import replace as with_fields

from chasles.statements import Goal, Problem
from chasles.statements.directions import length_and_direction, with_directions
from chasles.statements.lengths import Lengths
from chasles.vocabulary import Node, Norm, Scale, Symbol, replace, undotted
from chasles.vocabulary.shorthand import opened

Said = tuple[Problem, Callable[[Node], Node], tuple[Norm, ...]]


def by_directions(problem: Problem, arguments: Iterable[Node]) -> Said:
    """The problem with each rotation vector said by its length and direction, how an expression is said, the lengths.

    A problem without rotation vectors stays as it is, and so do expressions.
    """
    lengths = Lengths(problem.hypotheses, dict(problem.rules))

    def simple(node: Node) -> Node:
        return lengths(opened(node))

    goals = tuple(Goal(goal.label, simple(goal.left), simple(goal.right)) for goal in problem.goals)
    hypotheses = tuple(lengths.hypothesis(hypothesis.rewritten(opened)) for hypothesis in problem.hypotheses)
    rules = tuple((left, simple(right)) for left, right in problem.rules)
    found = with_directions(with_fields(problem, goals=goals, rules=rules, hypotheses=hypotheses))
    if not found.nonnegative:
        return problem, lambda node: node, ()
    arguments = tuple(arguments)
    values: dict[Node, Node] = {}
    turning = []
    for vector in (undotted(node)[0] for node in arguments):
        if isinstance(vector, Symbol) and length_and_direction(vector)[0] in found.nonnegative:
            length, direction = length_and_direction(vector)
            turning.append(Norm(vector))
            values |= {Norm(vector): length, vector: Scale(length, direction)}

    def said(node: Node) -> Node:
        return replace(simple(node), values)

    # What a program reads has entries, whether or not the formula speaks of more than its cosine and sine.
    read = tuple(Goal("", said(node), said(node)) for node in arguments if said(node) != node)
    return with_fields(found, goals=(*found.goals, *read)), said, tuple(dict.fromkeys(turning))
