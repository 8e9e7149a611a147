"""Conditions that no linear system solves for what they are posed on: they are assumed, or say what one symbol is."""

from __future__ import annotations

from collections.abc import Collection, Container, Iterable, Iterator, Mapping, Sequence
from dataclasses import replace as with_fields
from math import prod

from chasles import vocabulary as w
from chasles.statements.angles import linear_terms
from chasles.statements.hypotheses import Hypothesis
from chasles.statements.problem import Goal, Problem
from chasles.statements.rules import fit_together
from chasles.statements.statement import Equation
from chasles.statements.varied import opened_parts
from chasles.vocabulary import Node
from chasles.vocabulary.shorthand import Shorthand
from chasles.vocabulary.sizes import sizes_of

ASSUMED = ("condition", "field equation")
"""The kinds of hypotheses that conditions are: of what is where it is, and of fields, wherever they are taken."""
UNFINISHED = "not differentiated to the end"
"""The kind of a hypothesis where a point need not satisfy all that follows from what is given of fields."""


def solvable(conditions: Sequence[Goal], unknowns: Iterable[w.Symbol], rules: Mapping[Node, Node]) -> bool:
    """Whether there are as many equations as unknown entries, at least, and each of them is linear in the unknowns."""
    wanted = [*unknowns]
    sides = [side for goal in conditions for side in goal.sides]
    if sizes_of([*sides, *wanted]):
        return True
    enough = sum(prod(goal.left.shape) for goal in conditions) >= sum(prod(symbol.shape) for symbol in wanted)
    return enough and all(degree(side, {*wanted}, rules) < 2 for side in sides)


def assumed(conditions: Sequence[Goal], kind: str = ASSUMED[0]) -> Iterator[Hypothesis]:
    """Conditions as hypotheses, which determine nothing; parts of one number are told apart."""
    for k, goal in enumerate(conditions):
        difference = w.Sum((goal.left, w.Negative(goal.right)))
        text = goal.label + "'" * sum(each.label == goal.label for each in conditions[:k])
        yield Hypothesis(kind, (difference,), (goal.sides,), (), "", text, free=True)


def freed(problem: Problem) -> Problem:
    """The problem of which the conditions are assumed, and need not determine anything."""
    hypotheses = (*problem.hypotheses, *assumed(problem.conditions))
    return with_fields(problem, hypotheses=hypotheses, conditions=(), unknowns=())


def as_rules(
    conditions: Iterable[Goal], unknowns: Iterable[w.Symbol], rules: Sequence[Equation], bound: Container[Node]
) -> tuple[Equation, ...] | None:
    """The rules, and what each condition says that one of its unknowns is, which stands alone in it as a term.

    None where a condition has no such unknown; of those that are `bound` otherwise nothing is said.
    """
    found = [*rules]
    left = [symbol for symbol in unknowns if symbol not in bound]
    for goal in conditions:
        for symbol in left:
            rest = _rest(symbol, goal)
            if rest is not None and fit_together([*found, (symbol, rest)]):
                found.append((symbol, rest))
                left.remove(symbol)
                break
        else:
            return None
    return tuple(found)


def _rest(symbol: w.Symbol, goal: Goal) -> Node | None:
    """What a symbol is if both sides are equal; None if it is no term, times a number, that alone has it."""
    terms = [*linear_terms(w.Sum((goal.left, w.Negative(goal.right))), {})]
    alone = [multiple for term, multiple in terms if term == symbol]
    others = [(term, multiple) for term, multiple in terms if term != symbol]
    if len(alone) != 1 or not alone[0] or any(symbol in opened_parts(term) for term, _ in others):
        return None
    rest = tuple(term if by == -alone[0] else w.Scale(w.Number(-by / alone[0]), term) for term, by in others)
    return w.Sum(rest) if rest else w.Zero(*symbol.shape)


def degree(node: Node, unknowns: Collection[Node], rules: Mapping[Node, Node]) -> int:
    """The degree in the unknowns, by the words; 2 for what is no polynomial in them."""

    def inside(part: Node) -> int:
        return degree(part, unknowns, rules)

    match node:
        case w.Symbol() if node in unknowns:
            return 1
        case w.Symbol() if (inner := rules.get(node, node.stands_for)) is not None:
            return inside(inner)
        case Shorthand():
            return inside(node.definition)
        case w.Scale(w.Number(value)) if not value:
            return 0
        case w.Scale() | w.Contract() | w.Dot() | w.Cross():
            return sum(map(inside, w.children(node)))
        case w.Power(base, int(exponent)):
            return exponent * inside(base)
        case w.Quotient(above, below):
            return inside(above) + 2 * inside(below)
        case w.Norm() | w.Call() | w.Inverse() | w.Determinant() | w.Cofactor() | w.Rate():
            return 2 * max(map(inside, w.children(node)))
        case _:
            return max(map(inside, w.children(node)), default=0)
