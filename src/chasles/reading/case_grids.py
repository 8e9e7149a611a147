"""What is said by cases: a value a row, each with its condition."""

from __future__ import annotations

from collections.abc import Callable
from itertools import product

from chasles.reading.context import FittingContext
from chasles.reading.fits import Fit, made
from chasles.reading.grouping import RELATIONS, Grid, Tokens, lines_of
from chasles.reading.tokens import without_layout
from chasles.vocabulary.functions import Cases

__all__ = ["ENVIRONMENTS", "case_fits"]

ENVIRONMENTS = ("cases", "dcases", "rcases")
SIGNS = {"<": "<", ">": ">", r"\leq": "<=", r"\geq": ">="}
OPPOSITE = {"<": ">=", ">": "<=", "<=": ">", ">=": "<"}
ELSE = (r"\text{otherwise}", r"\operatorname{otherwise}", r"\text{else}", r"\operatorname{else}")


def case_fits(grid: Grid, ctx: FittingContext, read: Callable[[Tokens, FittingContext], list[Fit]]) -> list[Fit]:
    """The readings of an environment of cases; of the last row nothing is asked where it has what else there is."""
    values, left, right, signs = [], [], [], []
    for row in grid.rows:
        value, condition = (tuple(without_layout(list(cell))) for cell in (*row, ())[:2])
        values.append(read(value, ctx))
        condition = tuple(token for token in condition if not token.text.startswith(r"\text{") or token.text in ELSE)
        sides = [side for side in lines_of(condition, tuple(SIGNS)) if side]
        sign = next((SIGNS[token.text] for token in condition if token.text in SIGNS), "")
        if len(sides) == 2 and not any(token.text in RELATIONS for side in sides for token in side):
            left, right, signs = [*left, tuple(sides[0])], [*right, tuple(sides[1])], [*signs, sign]
        elif row is not grid.rows[-1] or (condition and condition[0].text not in ELSE):
            ctx.note("a case without a comparison that can be read", grid.place)
            return []
    texts = [[token.text for token in (*one, *other)] for one, other in zip(left, right, strict=True)]
    if len(signs) == len(values) == 2 and texts[0] == texts[1] and signs[0] == OPPOSITE[signs[1]]:
        left, right, signs = left[:1], right[:1], signs[:1]
    if len(signs) != len(values) - 1 or not signs:
        ctx.note("the cases do not say what holds otherwise", grid.place)
        return []
    found = []
    for chosen in product(*values, *(read(side, ctx) for side in (*left, *right))):
        at = [fit for each in chosen if (fit := each.at((1, 1))) is not None]
        nodes = tuple(fit.node for fit in at)
        if len(at) == len(chosen):
            count = len(signs)
            parts = nodes[: count + 1], nodes[count + 1 : -count], nodes[-count:], tuple(signs)
            node = made(Cases, *parts, tolerant=ctx.tolerant)
            found += [Fit(node, ctx.said(node), sum(fit.cost for fit in at))] if node is not None else []
    return found
