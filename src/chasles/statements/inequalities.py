"""Inequalities, assumed and claimed: each is said by an equation, so that nothing else has to know of them."""

from __future__ import annotations

import re
from fractions import Fraction

from chasles.statements.hypotheses import Hypothesis
from chasles.statements.statement import Equation
from chasles.vocabulary import Misfit, Negative, Node, Number, Sum, Symbol, latex, plain, uniform
from chasles.vocabulary.arguments import declaring
from chasles.vocabulary.functions import Relation, sign

__all__ = ["inequality", "says_that"]

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
