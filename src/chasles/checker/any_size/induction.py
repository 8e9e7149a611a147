"""Induction over an exponent: what is said of a letter n holds for 1, and for n + 1 if it holds for n."""

from __future__ import annotations

from dataclasses import replace as with_fields

from chasles.checker.any_size.at_sizes import sizes_in
from chasles.checker.sparse import Rejected
from chasles.statements import Goal, Problem
from chasles.vocabulary import Node, walk
from chasles.vocabulary.measure import Extent
from chasles.vocabulary.sizes import Size, at_exponent, sizes_of


def first_and_next(problem: Problem, name: str) -> tuple[Problem, Problem]:
    """The problem for 1 and for n + 1; `Rejected` if n is no exponent, or something is assumed of it."""
    letter = Size(name)
    said = [node for goal in problem.conditions for node in goal.sides]
    said += [node for h in problem.hypotheses for node in (*h.subjects, *h.nonvanishing, *sum(h.equations, ()))]
    sides = [node for goal in problem.goals for node in goal.sides]
    parts = {part for node in (*said, *sides) for part in walk(node)}
    # What is defined by n is something else for n + 1, and has one name.
    if letter in sizes_of(said) or (
        letter in sizes_of(right for _, right in problem.rules) and parts & {*dict(problem.rules)}
    ):
        raise Rejected(f"something is assumed of {name}: what is said of another number does not follow from it")

    def at(exponent: Extent) -> Problem:
        def put(node: Node) -> Node:
            return at_exponent(node, letter, exponent)

        goals = tuple(Goal(goal.label, put(goal.left), put(goal.right)) for goal in problem.goals)
        return with_fields(problem, goals=goals)

    first = at(1)
    if name not in sizes_in(problem) or name in sizes_in(first):
        raise Rejected(f"{name} is no exponent, or a number of rows or columns too")
    return first, at(letter + 1)
