"""Equations whose parts do not fit together: Coq refuses to type them, and `Fail` says so."""

from __future__ import annotations

from dataclasses import replace

from chasles import vocabulary as w
from chasles.coq.expressions import Spelling, Unsaid
from chasles.coq.names import CoqNames
from chasles.coq.statement import opened
from chasles.statements import Statement
from chasles.vocabulary.dimension import NO_DIMENSION
from chasles.vocabulary.measure import Misfit, uniform


def misfit(name: str, statement: Statement) -> str:
    """A command that succeeds if the equation, at one instant, is no statement. Raises `Unsaid` if its sizes fit."""
    left, right = statement.printed
    if _sizes_fit(statement):
        raise Unsaid("its sizes fit together, and Coq is told neither of dimensions nor of divisors")
    names = CoqNames()
    sizes: dict[str, str] = {}

    def applied(node: w.Node, name: str) -> str:
        sizes[name] = "R" if node.is_scalar else f"M {node.shape[0]} {node.shape[1]}"
        return name

    for node in (part for side in (left, right) for part in opened(side)):
        if isinstance(node, w.Symbol):
            names.symbol(node)
    equation = Spelling(names, applied).equation(left, right)
    bound = " ".join(f"({each} : {size})" for each, size in sizes.items())
    return f"Fail Definition {name} : Prop :=\n  forall {bound},\n  {equation}.\n"


def _sizes_fit(statement: Statement) -> bool:
    """Whether the statement is a good one if nothing has a dimension."""
    symbols = {part for side in statement.printed for part in opened(side) if isinstance(part, w.Symbol)}
    bare: dict[w.Node, w.Node] = {
        each: w.Symbol(each.name, each.name, uniform(each.shape, NO_DIMENSION), home=__name__, has_units=False)
        for each in symbols
    }
    try:
        left, right = (w.replace(side, bare) for side in statement.printed)
        return not replace(statement, left=left, right=right, kernel=None, reading=None, corrected=None, sic=True).fault
    except Misfit:
        return False
