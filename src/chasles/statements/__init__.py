"""Statements: what the book says, as data. A declaration holds no verdict and no code; `load` reads the whole book.

How a chapter is read is imported on first use: who checks a statement has nothing to do with it.
"""

from typing import TYPE_CHECKING

from chasles.statements.forms import Always, Definite, Exists, Iff, Minimum, OnlyWhere, Unique
from chasles.statements.hypotheses import (
    Hypothesis,
    definite,
    half_turn,
    nonzero,
    orthonormal,
    perpendicular,
    positive,
    rotation,
    symmetric,
    unit,
    unit_column,
)
from chasles.statements.inversion import Branch, Inverse
from chasles.statements.kernel import Kernel, Packed, Stack
from chasles.statements.posing import problem_of
from chasles.statements.problem import Goal, Problem
from chasles.statements.statement import Claim, Condition, Definition, Postulate, Statement, Theorem

if TYPE_CHECKING:
    from chasles.statements.chapter import Chapter, Entry, Section
    from chasles.statements.loading import load
    from chasles.statements.packages import DeclarationError

__all__ = [
    "Always",
    "Branch",
    "Chapter",
    "Claim",
    "Condition",
    "DeclarationError",
    "Definite",
    "Definition",
    "Entry",
    "Exists",
    "Goal",
    "Hypothesis",
    "Iff",
    "Inverse",
    "Kernel",
    "Minimum",
    "OnlyWhere",
    "Packed",
    "Postulate",
    "Problem",
    "Section",
    "Stack",
    "Statement",
    "Theorem",
    "Unique",
    "definite",
    "half_turn",
    "load",
    "nonzero",
    "orthonormal",
    "perpendicular",
    "positive",
    "problem_of",
    "rotation",
    "symmetric",
    "unit",
    "unit_column",
]


def __getattr__(name: str) -> object:
    if name not in ("Chapter", "DeclarationError", "Entry", "Section", "load"):
        raise AttributeError(f"module {__name__!r} has no attribute {name!r}")
    from chasles.statements import loading

    return getattr(loading, name)
