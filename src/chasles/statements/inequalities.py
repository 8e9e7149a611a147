"""Inequalities, assumed and claimed: each is said by an equation, so that nothing else has to know of them."""

from __future__ import annotations

import re
from dataclasses import dataclass
from dataclasses import replace as with_fields
from fractions import Fraction

from chasles.statements.goals import Goal
from chasles.statements.hypotheses import Hypothesis
from chasles.statements.problem import Problem
from chasles.statements.statement import Equation
from chasles.vocabulary import (
    Contract,
    Determinant,
    Misfit,
    Negative,
    Node,
    Number,
    Sum,
    Symbol,
    Transpose,
    latex,
    plain,
    uniform,
)
from chasles.vocabulary.arguments import Declared, declaring
from chasles.vocabulary.functions import FunctionOf, Relation, sign

PRINTED = {"<": "<", "<=": r"\leq", ">": ">", ">=": r"\geq"}
ZERO = Number(Fraction(0))


def _difference(relation: Relation) -> Node:
    """What is positive, or at least not negative."""
    large, small = relation.left, relation.right
    if relation.sign in ("<", "<="):
        large, small = small, large
    if not (large.is_scalar and small.is_scalar):
        raise Misfit(f"only scalars are compared: {relation}")
    if ZERO in (large, small):
        return large if small == ZERO else Negative(small)
    return Sum((large, Negative(small)))


@declaring
def inequality(relation: Relation) -> Hypothesis:
    """The relation holds: the difference is the square of a number, which is not zero where they are not equal."""
    difference = _difference(relation)
    text = str(relation)
    name = "root_of_" + re.sub(r"\W+", "_", plain(difference)).strip("_")
    root = Symbol(name, rf"\sqrt{{{latex(difference)}}}", uniform((1, 1), None), f"the root of {plain(difference)}")
    said = f"{latex(relation.left)} {PRINTED[relation.sign]} {latex(relation.right)}"
    strict = (root, difference) if relation.sign in ("<", ">") else ()
    return Hypothesis("inequality", (difference, root), ((difference, root * root),), strict, said, text, free=True)


@declaring
def says_that(relation: Relation) -> Equation:
    """Both sides of an equation that says the same of the difference d: |d| = d, or sign(d) = 1 if it is strict."""
    difference = _difference(relation)
    if relation.sign in ("<", ">"):
        return sign(difference), Number(Fraction(1))
    return abs(difference), difference


@dataclass(frozen=True, slots=True)
class PositiveDefinite(Declared):
    """The matrix is symmetric and x . M x is never negative; and unless it is only `semi`, its determinant is positive.

    A symmetric matrix without negative eigenvalues, none of which is zero, is positive-definite.
    """

    matrix: Node
    semi: bool = False

    def equations(self) -> tuple[tuple[str, Node, Node], ...]:
        """What is to be decided: a label and two sides, for each equation."""
        x = Symbol("any_column", r"\mathbf{x}", uniform((self.matrix.shape[0], 1), None), "any column")
        form = Relation(Contract((Transpose(x), self.matrix, x)), ">=", ZERO)
        found: list[tuple[str, Node, Node]] = [("it is symmetric", self.matrix, Transpose(self.matrix))]
        found.append(("its quadratic form is never negative", *says_that(form)))
        if not self.semi:
            found.append(("its determinant is positive", *says_that(Relation(Determinant(self.matrix), ">", ZERO))))
        return tuple(found)


def as_differences(problem: Problem) -> tuple[Problem, tuple[str, ...]] | None:
    """The problem that says that each difference is zero which is said to be "positive" or "not negative".

    None if the problem says nothing of this kind.
    """
    goals: list[Goal] = []
    signs: list[str] = []
    for goal in problem.goals:
        match goal.left, goal.right:
            case FunctionOf("abs", (of,)), same if of == same:
                goals.append(Goal(goal.label, of, ZERO))
                signs.append("not negative")
            case FunctionOf("sign", (of,)), Number(value) if value == 1:
                goals.append(Goal(goal.label, of, ZERO))
                signs.append("positive")
            case _:
                goals.append(goal)
                signs.append("")
    return (with_fields(problem, goals=tuple(goals)), tuple(signs)) if any(signs) else None
