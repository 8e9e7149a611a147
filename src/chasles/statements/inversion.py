"""Inverses with cases: the map back is declared branch by branch, and each branch is a bundle of equations.

On each branch the forward map must return its input; the branches must cover the domain; and wherever an angle is
measured by its cosine and sine, these must lie on the unit circle.
"""

from __future__ import annotations

from dataclasses import dataclass
from typing import ClassVar

from chasles.statements.hypotheses import Hypothesis
from chasles.statements.problem import Problem
from chasles.statements.statement import Kernel, Statement
from chasles.vocabulary import Node, Symbol

__all__ = ["Branch", "Inverse"]


@dataclass(frozen=True, slots=True)
class Branch:
    """One case: where `where` does not vanish and `on` holds, the values of the forward map's arguments.

    `values` gives each argument's value; an angle is given as (cosine, sine) instead.
    """

    says: str
    values: tuple[tuple[Symbol, Node | tuple[Node, Node]], ...]
    assuming: tuple[Hypothesis, ...] = ()
    vanishing: tuple[Node, ...] = ()


@dataclass(frozen=True, eq=False)
class Inverse:
    """The inverse of the statement `of` (a formula for a symbol), case by case."""

    role: ClassVar[str] = "inverse"

    number: str
    of: Statement
    branches: tuple[Branch, ...]
    says: str = ""
    assuming: tuple[Hypothesis, ...] = ()
    given: tuple[Statement, ...] = ()
    part: int = 1
    kernel: Kernel | None = None
    fault: None = None


def problems_of_inverse(sentence: Inverse, standing: object) -> Problem:
    """The equations that make the branches an inverse."""
    raise NotImplementedError
