"""What is given of fields: how they move, where conditions hold, and which leave free what is differentiated."""

from __future__ import annotations

from collections.abc import Iterable, Iterator, Mapping, Sequence
from dataclasses import replace as with_fields

from chasles import vocabulary as w
from chasles.statements.conditions import ASSUMED, assumed
from chasles.statements.goals import Goal
from chasles.statements.hypotheses import Hypothesis
from chasles.statements.problem import Problem
from chasles.statements.simpler_words import said_otherwise, sides_of
from chasles.statements.statement import Equation
from chasles.statements.varied import opened_parts
from chasles.vocabulary import Node, Rate
from chasles.vocabulary.fields import fields_of, rates_of_fields
from chasles.vocabulary.partial import PartialDerivative, differentiates, with_derivatives

MOST_RATES = 3
"""Rates of fields are said up to this order."""


def moving(sides: Sequence[Node], rules: Iterable[Equation]) -> Iterator[Equation]:
    """The rates of fields, where rates are taken, of which nothing else is given."""
    depth = sum(map(_order, sides))
    known = {left for left, _ in rules}
    found = rates_of_fields((each for each in fields_of(sides) if each not in known), min(depth, MOST_RATES))
    yield from ((left, right) for left, right in found.items() if left not in known)


def _order(node: Node) -> int:
    """How many rates are taken of each other."""
    return isinstance(node, Rate) + max(map(_order, node.below), default=0)


def carried_out(problem: Problem) -> Problem:
    """The same problem with all derivatives carried out, and those of what is assumed of fields."""
    rules = dict(problem.rules)

    def found(side: Node) -> Node:
        return with_derivatives(side, rules)

    told = said_otherwise(problem, found, lambda said: said.rewritten(found))
    return with_fields(told, hypotheses=(*told.hypotheses, *_everywhere(told)))


def _everywhere(problem: Problem) -> Iterator[Hypothesis]:
    """What is assumed of fields alone, differentiated by what they depend on: it holds wherever they are taken."""
    rules = dict(problem.rules)
    sides = [*sides_of(problem), *(side for rule in problem.rules for side in rule)]
    wanted = [each.taken for each in fields_of(sides)]
    highest, places = max(map(len, wanted), default=0), dict.fromkeys(sum(wanted, ()))
    for hypothesis in problem.hypotheses:
        # That a matrix is its own cofactor matrix says no more of its derivatives than that it is orthogonal.
        pairs = [pair for pair in hypothesis.equations if not any(isinstance(side, w.Cofactor) for side in pair)]
        parts = {part for pair in pairs for side in pair for part in opened_parts(side)}
        fields = fields_of(parts)
        local = hypothesis.kind == ASSUMED[0] or any(isinstance(part, Rate) and part not in rules for part in parts)
        found: list[tuple[Node, Node]] = []
        for _ in range(0 if local else highest - min((len(each.taken) for each in fields), default=highest)):
            slopes = [[PartialDerivative(side, place) for side in pair] for pair in pairs for place in places]
            told = ((with_derivatives(one, rules), with_derivatives(other, rules)) for one, other in slopes)
            pairs = [*dict.fromkeys(told)]
            found += pairs
        if found:
            text = f"{hypothesis.text} everywhere"
            kind = hypothesis.kind if hypothesis.kind in ASSUMED else "everywhere"
            yield Hypothesis(kind, sum(found, ()), tuple(found), (), hypothesis.latex, text, free=True)


def freely_assumed(
    conditions: Sequence[Goal], unknowns: Iterable[w.Symbol], sides: Sequence[Node], rules: Mapping[Node, Node]
) -> tuple[Hypothesis, ...]:
    """Conditions as hypotheses; none where they tie what is differentiated or expanded, for no hypothesis says how.

    They do not tie it if they are of fields, nor if they say what higher rates are than those of which derivatives are
    taken: equations of motion restrict no position and no velocity.
    """
    if all(symbol.is_field for symbol in unknowns):
        return tuple(assumed(conditions, ASSUMED[1]))
    parts = [part for side in sides for part in opened_parts(side)]
    taken = [part.of for part in parts if isinstance(part, PartialDerivative)]
    said = [side for goal in conditions for side in (goal.left, goal.right)]

    def highest(nodes: Iterable[Node], symbol: w.Symbol) -> int:
        return max((_rates_of(symbol, node, rules) for node in nodes), default=-1)

    bound = unknowns if any(map(differentiates, sides)) else ()
    tied = any(part.expands for part in parts) or any(highest(said, one) <= highest(taken, one) for one in bound)
    return () if tied else tuple(assumed(conditions))


def _rates_of(symbol: w.Symbol, node: Node, rules: Mapping[Node, Node]) -> int:
    """The highest rate of a symbol that occurs; -1 where none does."""
    inner = rules.get(node, getattr(node, "stands_for", None))
    parts = (inner,) if inner is not None else (*node.below, *getattr(node, "variables", ()))
    found = 0 if node == symbol else max((_rates_of(symbol, part, rules) for part in parts), default=-1)
    return found + 1 if found >= 0 and isinstance(node, w.Rate) and inner is None else found
