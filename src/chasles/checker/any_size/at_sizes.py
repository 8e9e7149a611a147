"""A problem about matrices of any size at a point: sizes are numbers, matrices have entries, and nothing is searched.

An entry that the point does not name is zero.
"""

from __future__ import annotations

from collections.abc import Mapping
from fractions import Fraction
from typing import TYPE_CHECKING, Any

from chasles import vocabulary as w
from chasles.checker.expansion import expanded, scaled
from chasles.checker.sparse import Matrix, Rejected, cofactor, determinant
from chasles.checker.witness import root_of
from chasles.statements import Hypothesis, Problem
from chasles.vocabulary.functions import FunctionOf
from chasles.vocabulary.letters import entry_names
from chasles.vocabulary.sizes import at_sizes, sizes_of

if TYPE_CHECKING:
    from chasles.verdict import Counterexample

SAYING_ALL = (
    "nonzero", "positive", "unit", "unit column", "symmetric", "definite", "perpendicular", "rotation", "orthonormal",
    "orthogonal", "orthonormal columns", "skew-symmetric", "idempotent", "commuting", "of a rate", "evident",
)  # fmt: skip
"""Hypotheses that say no more than their equations, what they keep from vanishing, and that something is positive."""


def sizes_in(problem: Problem) -> tuple[str, ...]:
    """The names of the letters for sizes."""
    nonvanishing = [node for hypothesis in problem.hypotheses for node in hypothesis.nonvanishing]
    return tuple(size.name for size in sizes_of([*problem.sides_and_rules, *problem.assumed_sides, *nonvanishing]))


class PointAtSizes:
    """Exact values of expressions at a point; raises `Rejected` where there is none."""

    def __init__(self, problem: Problem, at: Mapping[str, Any]) -> None:
        self.problem = problem
        self.at = {name: Fraction(value) for name, value in at.items()}
        self.sizes = {name: int(self.at.get(name, 0)) for name in sizes_in(problem)}
        for name, size in self.sizes.items():
            if size < 1 or size != self.at[name]:
                raise Rejected(f"{name} is a number of rows or columns, and the point does not say which")
        self.rules = {self._at(left): self._at(right) for left, right in problem.rules}
        self._known: dict[w.Node, Matrix] = {}

    def _at(self, node: w.Node) -> w.Node:
        return at_sizes(node, self.sizes)

    def __call__(self, node: w.Node) -> list[list[Fraction]]:
        """The entries of an expression."""
        return self._of(self._at(node))

    def _of(self, node: w.Node) -> Matrix:
        if node not in self._known:
            self._known[node] = self._of(self.rules[node]) if node in self.rules else self._made(node)
        return self._known[node]

    def _made(self, node: w.Node) -> Matrix:
        match node:
            case w.Symbol(stands_for=w.Node() as of) | w.Group(of) | w.At(of, "t"):
                return self._of(of)
            case w.Symbol(name):
                return [[self.at.get(each, Fraction(0)) for each in row] for row in entry_names(name, *node.shape)]
            case w.Inverse(of):
                matrix = self._of(of)
                size, one = range(len(matrix)), Fraction(1)
                turned = [[cofactor(matrix, j, i, one) for j in size] for i in size]
                return scaled(_over(determinant(matrix, one), of), turned)
            case w.Quotient(numerator, divisor):
                return scaled(_over(self._of(divisor)[0][0], divisor), self._of(numerator))
            case w.Norm(of):
                if (root := root_of(self._of(w.Dot(of, of))[0][0])) is None:
                    raise Rejected(f"the length of {of} is no rational number there")
                return [[root]]
            case FunctionOf("abs" | "sign" as function, (of,)):
                value = self._of(of)[0][0]
                return [[abs(value) if function == "abs" else Fraction((value > 0) - (value < 0))]]
            case _:
                return expanded(node, self._of, Fraction)

    def require(self, also: str = "") -> None:
        """All that is assumed holds there, hypotheses of the kind `also` too; raises `Rejected` with what does not."""
        for goal in self.problem.conditions:
            if self(goal.left) != self(goal.right):
                raise Rejected(f"the point does not satisfy {goal.label}")
        for hypothesis in self.problem.hypotheses:
            if not self._satisfies(hypothesis, also):
                raise Rejected(f"the point does not satisfy {hypothesis.text}")

    def _satisfies(self, hypothesis: Hypothesis, also: str) -> bool:
        if hypothesis.kind not in (*SAYING_ALL, also):
            raise Rejected(f"of matrices of any size it is not known what is meant by: {hypothesis.text}")
        fails = any(self(left) != self(right) for left, right in hypothesis.equations)
        if fails or any(not self(node)[0][0] for node in hypothesis.nonvanishing):
            return False
        positive = hypothesis.kind in ("positive", "definite")
        matrix = self._of(self._at(hypothesis.subjects[0])) if positive else []
        minors = (determinant([row[:k] for row in matrix[:k]], Fraction(1)) for k in range(1, len(matrix) + 1))
        return all(minor > 0 for minor in minors)


def check_at_sizes(problem: Problem, shown: Counterexample) -> None:
    """The point satisfies all that is assumed, and there the two sides of the entry differ and are as shown.

    Raises `Rejected` with the reason if not.
    """
    point = PointAtSizes(problem, shown.at)
    point.require()
    row, column = shown.entry
    for goal in problem.goals:
        left, right = point(goal.left), point(goal.right)
        if goal.label == shown.goal and 1 <= row <= len(left) and 1 <= column <= len(left[0]):
            sides = left[row - 1][column - 1], right[row - 1][column - 1]
            if sides[0] != sides[1] and tuple(map(str, sides)) == (shown.left, shown.right):
                return
    raise Rejected("the two sides are equal at the point, or not as shown, or there is no such entry")


def _over(divisor: Fraction, spelled: w.Node) -> Fraction:
    if not divisor:
        raise Rejected(f"{spelled} is not to be divided by there")
    return 1 / divisor
