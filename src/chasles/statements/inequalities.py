"""Inequalities, assumed and claimed: each is said by an equation, so that nothing else has to know of them."""

from __future__ import annotations

import re
from dataclasses import dataclass
from dataclasses import replace as with_fields
from fractions import Fraction

from chasles import vocabulary as w
from chasles.statements.hypotheses import Hypothesis
from chasles.statements.problem import Goal, Problem
from chasles.statements.statement import Equation
from chasles.vocabulary import Node
from chasles.vocabulary.arguments import Declared, declaring
from chasles.vocabulary.functions import FunctionOf, Relation, sign

PRINTED = {"<": "<", "<=": r"\leq", ">": ">", ">=": r"\geq"}
SAID = {"-": "minus", "+": "plus", "/": "over", "^": "to", ".": "dot"}
ZERO, ONE = w.Number(Fraction(0)), w.Number(Fraction(1))


def _difference(relation: Relation) -> Node:
    """What is positive, or at least not negative."""
    large, small = (relation.left, relation.right)[:: -1 if relation.sign in ("<", "<=") else 1]
    if not (large.is_scalar and small.is_scalar):
        raise w.Misfit(f"only scalars are compared: {relation}")
    if ZERO in (large, small):
        return large if small == ZERO else w.Negative(small)
    return w.Sum((large, w.Negative(small)))


@declaring
def inequality(relation: Relation) -> Hypothesis:
    """The relation holds: the difference is the square of a number, which is not zero where they are not equal."""
    difference = _difference(relation)
    text = str(relation)
    named = re.sub("[-+/^.]", lambda sign: f" {SAID[sign[0]]} ", w.plain(difference))
    name = "root_of_" + re.sub(r"\W+", "_", named).strip("_")
    root = w.Symbol(
        name, rf"\sqrt{{{w.latex(difference)}}}", w.uniform((1, 1), None), f"the root of {w.plain(difference)}"
    )
    said = f"{w.latex(relation.left)} {PRINTED[relation.sign]} {w.latex(relation.right)}"
    strict = (root, difference) if relation.sign in ("<", ">") else ()
    return Hypothesis("inequality", (difference, root), ((difference, root * root),), strict, said, text, free=True)


@declaring
def says_that(relation: Relation) -> Equation:
    """Both sides of an equation that says the same of the difference d: |d| = d, or sign(d) = 1 if it is strict."""
    difference = _difference(relation)
    if relation.sign in ("<", ">"):
        return sign(difference), ONE
    return abs(difference), difference


def difference_of(left: Node, right: Node) -> Node | None:
    """What two sides say to be positive, or not to be negative, as `says_that` does; None where they say no such."""
    if isinstance(left, FunctionOf) and (left.function, right) in (("abs", left.arguments[0]), ("sign", ONE)):
        return left.arguments[0]
    return None


@dataclass(frozen=True, slots=True)
class PositiveDefinite(Declared):
    """The matrix is symmetric and x . M x is never negative; and unless it is only `semi`, its determinant is positive.

    A symmetric matrix without negative eigenvalues, none of which is zero, is positive-definite.
    """

    matrix: Node
    semi: bool = False

    def equations(self) -> tuple[tuple[str, Node, Node], ...]:
        """What is to be decided: a label and two sides, for each equation."""
        x = w.Symbol("any_column", r"\mathbf{x}", w.uniform((self.matrix.shape[0], 1), None), "any column")
        form = Relation(w.Contract((w.Transpose(x), self.matrix, x)), ">=", ZERO)
        symmetric = "it is symmetric", self.matrix, w.Transpose(self.matrix)
        semidefinite = symmetric, ("its quadratic form is never negative", *says_that(form))
        regular = "its determinant is positive", *says_that(Relation(w.Determinant(self.matrix), ">", ZERO))
        return semidefinite if self.semi else (*semidefinite, regular)


def as_differences(problem: Problem) -> tuple[Problem, tuple[str, ...]] | None:
    """The problem that says that each difference is zero which is said to be "positive" or "not negative".

    None if the problem says nothing of this kind.
    """
    said = [(goal, difference_of(goal.left, goal.right)) for goal in problem.goals]
    goals = tuple(goal if large is None else Goal(goal.label, large, ZERO) for goal, large in said)
    signs = tuple("" if e is None else "not negative" if goal.right == e else "positive" for goal, e in said)
    return (with_fields(problem, goals=goals), signs) if any(signs) else None
