"""Inverses with cases: the way back from a formula's value to its arguments, branch by branch.

On each branch the formula, fed with the values found, returns what it was given; cosine and sine of an angle lie on the
unit circle; and together the branches cover the domain. Each of these is an equation that is decided.
"""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import dataclass
from fractions import Fraction
from typing import ClassVar

from chasles.statements.hypotheses import Hypothesis, nonzero
from chasles.statements.kernel import Kernel
from chasles.statements.problem import Goal, Problem, Standing, default_sides
from chasles.statements.statement import Statement
from chasles.vocabulary import Call, Node, Number, Power, Sum, replace

__all__ = ["Branch", "Cover", "Inverse", "problems_of_inverse"]


@dataclass(frozen=True, slots=True)
class Branch:
    """One case, taken where `where` is not zero: `values` stand for the formula's arguments.

    An angle is given by its cosine and sine, as the values of cos(phi) and sin(phi). What the branch assumes
    is in place of what the inverse assumes.
    """

    says: str
    where: Node
    values: tuple[tuple[Node, Node], ...]
    assuming: tuple[Hypothesis, ...] = ()


@dataclass(frozen=True, slots=True)
class Cover:
    """An equation from which one sees that no case is left out; `assuming` is in place of what the inverse assumes."""

    says: str
    left: Node
    right: Node
    assuming: tuple[Hypothesis, ...] = ()


@dataclass(frozen=True, eq=False)
class Inverse:
    """The inverse of the formula `of`, case by case; the first branch that applies is taken.

    `gives` are the results of its kernel, in terms of the formula's arguments and of symbols that `given` defines.
    Where several branches apply they agree, up to the sign that the values in `sign` share; the first of their entries
    that is not zero is made positive. With `largest` a machine takes the branch where `where` is largest, for accuracy.
    """

    role: ClassVar[str] = "inverse"

    number: str
    of: Statement
    branches: tuple[Branch, ...]
    covers: tuple[Cover, ...]
    gives: tuple[Node, ...]
    says: str = ""
    assuming: tuple[Hypothesis, ...] = ()
    given: tuple[Statement, ...] = ()
    part: int = 1
    kernel: Kernel | None = None
    largest: bool = False
    sign: tuple[Node, ...] = ()
    fault: None = None


def problems_of_inverse(sentence: Inverse, standing: Standing = default_sides) -> Iterator[tuple[str, Problem]]:
    """What makes the branches an inverse: a problem for each branch and for each equation of the cover."""
    left, right = standing(sentence.of)
    for branch in sentence.branches:
        values = dict(branch.values)
        goals = [Goal("the formula returns its input", replace(right, values), left), *_circles(values)]
        hypotheses = (*(branch.assuming or sentence.assuming), nonzero(branch.where))
        yield branch.says, Problem(tuple(goals), hypotheses=hypotheses)
    for cover in sentence.covers:
        goal = Goal("no case is left out", cover.left, cover.right)
        yield cover.says, Problem((goal,), hypotheses=cover.assuming or sentence.assuming)


def _circles(values: dict[Node, Node]) -> Iterator[Goal]:
    one = Number(Fraction(1))
    for key, cosine in values.items():
        if isinstance(key, Call) and key.function == "cos":
            sine = values[Call("sin", key.argument)]
            yield Goal("cosine and sine lie on the unit circle", Sum((Power(cosine, 2), Power(sine, 2))), one)
