"""What is said by cases: a value a row, each with its condition."""

from __future__ import annotations

from collections.abc import Callable, Sequence
from itertools import product

from chasles.reading.context import FittingContext
from chasles.reading.fits import Fit, made
from chasles.reading.grouping import RELATIONS, Grid, Tokens, lines_of
from chasles.reading.tokens import without_layout
from chasles.vocabulary.functions import Cases

__all__ = ["ENVIRONMENTS", "case_fits"]

ENVIRONMENTS = ("cases", "dcases", "rcases")
SIGNS = {"<": "<", ">": ">", r"\leq": "<=", r"\geq": ">="}
OPPOSITE = {"<": r"\geq", ">": r"\leq", r"\leq": ">", r"\geq": "<"}
ELSE = (r"\text{otherwise}", r"\operatorname{otherwise}", r"\text{else}", r"\operatorname{else}")


def case_fits(grid: Grid, ctx: FittingContext, read: Callable[[Tokens, FittingContext], list[Fit]]) -> list[Fit]:
    """The readings of an environment of cases; of the last row nothing is asked where it has what else there is."""
    values = [read(_bare(row[0]), ctx) for row in grid.rows]
    said = [_comparison(_bare(row[1]) if len(row) > 1 else ()) for row in grid.rows]
    *asked, last = said
    if len(asked) == 1 and _are_opposite(said):
        last = ()
    if last or not asked or not all(asked):
        ctx.note("the cases are no comparisons, or do not say what holds otherwise", grid.place)
        return []
    sides = [side for place in (0, 1) for side in (read(each[place], ctx) for each in asked if each)]
    found = []
    for chosen in product(*values, *sides):
        at = [fit for each in chosen if (fit := each.at((1, 1))) is not None]
        nodes, count = tuple(fit.node for fit in at), len(asked)
        if len(at) == len(chosen):
            signs = tuple(SIGNS[each[2]] for each in asked if each)
            node = made(
                Cases, nodes[: count + 1], nodes[count + 1 : -count], nodes[-count:], signs, tolerant=ctx.tolerant
            )
            found += [Fit(node, ctx.said(node), sum(fit.cost for fit in at))] if node is not None else []
    return found


def _bare(cell: Tokens) -> Tokens:
    return tuple(without_layout(list(cell)))


def _comparison(condition: Tokens) -> tuple[Tokens, Tokens, str] | tuple[()] | None:
    """The sides of a comparison and its sign; nothing where it says "otherwise", None for anything else."""
    if not condition or condition[0].text in ELSE:
        return ()
    marks = tuple(token for token in condition if not token.text.startswith(r"\text{"))
    relations = [token.text for token in marks if token.text in RELATIONS]
    sides = lines_of(marks, tuple(SIGNS))
    known = len(relations) == 1 and relations[0] in SIGNS and len(sides) == 2 and all(sides)
    return (tuple(sides[0]), tuple(sides[1]), relations[0]) if known else None


def _are_opposite(said: Sequence[tuple[Tokens, Tokens, str] | tuple[()] | None]) -> bool:
    """Whether of two comparisons one holds exactly where the other does not."""
    one, other = said
    if not one or not other:
        return False
    same = [[token.text for token in side] for side in one[:2]] == [
        [token.text for token in side] for side in other[:2]
    ]
    return same and one[2] == OPPOSITE[other[2]]
