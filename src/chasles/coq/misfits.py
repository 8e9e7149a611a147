"""Equations whose parts do not fit together: Coq refuses to type them, and `Fail` says so."""

from __future__ import annotations

from chasles import vocabulary as w
from chasles.coq.expressions import Spelling
from chasles.coq.names import CoqNames
from chasles.coq.statement import opened


def misfit(name: str, left: w.Node, right: w.Node) -> str:
    """A command that succeeds if the equation, at one instant, is no statement. Raises `Unsaid`."""
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
