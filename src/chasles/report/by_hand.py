"""What does a counterexample come to? The values of the quantities that the given statements define, worked out."""

from __future__ import annotations

from collections.abc import Iterator

from chasles.proof.context import Context, build
from chasles.proof.judge import Decision
from chasles.proof.points import ratio_at
from chasles.proof.unfold import UndeclaredDivisor
from chasles.proof.values import shown
from chasles.proof.variables import Untreatable, entry_name
from chasles.proof.verdict import Counterexample
from chasles.statements import Statement, problem_of
from chasles.vocabulary import Node, Symbol, symbols_of

__all__ = ["worked_out"]

LARGEST = 9
"""Entries of an array that is shown: those of six-dimensional arrays are in the equations that define them."""


def worked_out(statement: Statement, decision: Decision, found: Counterexample) -> dict[str, str]:
    """The entries, by name, of the symbols in the equation that have a definition, at the counterexample.

    Empty where the equation has none, or where they depend on what the counterexample leaves open.
    """
    problem = problem_of(statement, "printed", decision.standing)
    rules = dict(problem.rules)
    try:
        context = build(problem)
        named = dict.fromkeys(s for side in statement.printed for s in symbols_of(side) if s in rules)
        return {name: text for s in named for name, text in _entries(context, s, found)}
    except (Untreatable, UndeclaredDivisor, KeyError):
        return {}


def _entries(context: Context, symbol: Symbol, found: Counterexample) -> Iterator[tuple[str, str]]:
    rows, columns = symbol.shape
    if rows * columns > LARGEST or _is_side(context, symbol):
        return
    for i, row in enumerate(context.unfold(symbol)):
        for j, ratio in enumerate(row):
            value = ratio_at(context, ratio, dict(found.at))
            if value is not None:
                yield entry_name(symbol, 0, i, j), shown(value, "phi")


def _is_side(context: Context, node: Node) -> bool:
    """Whether it is one of the two sides, whose values are said anyway."""
    return any(node in (goal.left, goal.right) for goal in context.problem.goals)
