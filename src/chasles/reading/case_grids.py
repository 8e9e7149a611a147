"""What is said by cases: a value a row, each with its condition."""

from __future__ import annotations

from collections.abc import Callable
from itertools import product
from typing import NamedTuple

from chasles.reading.atoms import RELATIONS, Atom, Atoms, lines_of
from chasles.reading.context import FittingContext
from chasles.reading.fits import Fit
from chasles.reading.respelling import without_layout
from chasles.vocabulary.functions import Cases

ENVIRONMENTS = ("cases", "dcases", "rcases")
SIGNS = {"<": "<", ">": ">", r"\leq": "<=", r"\geq": ">="}
OPPOSITE = {"<": r"\geq", ">": r"\leq", r"\leq": ">", r"\geq": "<"}
ELSE = (r"\text{otherwise}", r"\operatorname{otherwise}", r"\text{else}", r"\operatorname{else}")


def case_fits(grid: Atom, ctx: FittingContext, read: Callable[[Atoms, FittingContext], list[Fit]]) -> list[Fit]:
    """The readings of an environment of cases; of the last row nothing is asked where it has what else there is."""
    values = [read(_bare(row[0]), ctx) for row in grid.rows]
    *asked, last = (_comparison(_bare(row[1]) if len(row) > 1 else ()) for row in grid.rows)
    if len(asked) == 1 and asked[0] and last and _are_opposite(asked[0], last):
        last = CaseCondition()
    if last != CaseCondition() or not asked or not all(asked):
        ctx.note("the cases are no comparisons, or do not say what holds otherwise", grid.place)
        return []
    conditions = [each for each in asked if each is not None]
    sides = [read(each.left, ctx) for each in conditions] + [read(each.right, ctx) for each in conditions]
    found = []
    for chosen in product(*values, *sides):
        at = [fit for each in chosen if (fit := each.at((1, 1))) is not None]
        nodes, count = tuple(fit.node for fit in at), len(conditions)
        if len(at) == len(chosen):
            parts = nodes[: count + 1], nodes[count + 1 : -count], nodes[-count:]
            signs = tuple(SIGNS[each.sign] for each in conditions)
            found += ctx.made(Cases, *parts, signs, cost=sum(fit.cost for fit in at))
    return found


class CaseCondition(NamedTuple):
    """The sides of a condition and its sign; without a sign it is "otherwise"."""

    left: Atoms = ()
    right: Atoms = ()
    sign: str = ""


def _bare(cell: Atoms) -> Atoms:
    return tuple(without_layout(list(cell)))


def _comparison(condition: Atoms) -> CaseCondition | None:
    """What the cell says of the case; None where it cannot be read."""
    if not condition or condition[0].text in ELSE:
        return CaseCondition()
    marks = tuple(token for token in condition if not token.text.startswith(r"\text{"))
    relations = [token.text for token in marks if token.text in RELATIONS]
    sides = [tuple(side) for side in lines_of(marks, tuple(SIGNS)) if side]
    return CaseCondition(sides[0], sides[1], relations[0]) if len(relations) == 1 and len(sides) == 2 else None


def _are_opposite(one: CaseCondition, other: CaseCondition) -> bool:
    """Whether one holds exactly where the other does not."""
    pairs = (one.left, other.left), (one.right, other.right)
    same = all([token.text for token in a] == [token.text for token in b] for a, b in pairs)
    return same and one.sign != "" and OPPOSITE.get(other.sign) == one.sign
