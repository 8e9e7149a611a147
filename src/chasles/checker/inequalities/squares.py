"""Is it a sum of squares? What is said not to be negative equals one; each square may have a factor that is not."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from fractions import Fraction
from typing import Any

from chasles import vocabulary as w
from chasles.checker.reading import PolynomialProblem
from chasles.checker.sparse import ZERO, Polynomial, Rejected, number, parsed, variable
from chasles.statements import Problem
from chasles.statements.inequalities import as_differences


class ReadingOfSquares(PolynomialProblem):
    """A problem as polynomials, in which the difference of a goal's sides is taken from the squares that are said."""

    def __init__(self, problem: Problem, certificate: Mapping[str, Any]) -> None:
        plain, signs = plain_problem(problem)
        self.squares: dict[tuple[w.Node, w.Node], Polynomial] = {}
        super().__init__(plain, certificate["witness"])
        above = {place for f in self.greater.values() for place in f.places if not f - variable(place)}
        lengths = {place for place, what in enumerate(self.variables) if what[0] == "norm"}
        found: dict[tuple[w.Node, w.Node], Polynomial] = {}
        for goal, sign, squares in zip(plain.goals, signs, certificate["squares"], strict=True):
            if sign == "positive" and not any(self._is_positive(above, *square) for square in squares):
                raise Rejected(f"{goal.left} is a sum of squares, all of which may be zero")
            if (goal.left, goal.right) in found or (squares and not sign):
                raise Rejected(f"squares are taken from {goal.left}, which is said to be {goal.right} too")
            found[goal.left, goal.right] = self._total(squares, above | lengths)
        self.squares = found

    def _is_positive(self, above: set[int], _: str, factor: str, root: str) -> bool:
        value = parsed(root, self.places)
        return bool(value) and not value.places and parsed(factor, self.places).places <= above

    def _total(self, squares: Sequence[tuple[str, str, str]], free: set[int]) -> Polynomial:
        """The sum of positive numbers times factors that are not negative times squares; `Rejected` for any other."""
        total = ZERO
        for coefficient, factor, root in squares:
            times, value = parsed(factor, self.places), parsed(root, self.places)
            if Fraction(coefficient) <= 0 or len(times.terms) != 1 or times.terms[max(times.terms)] != times.below:
                raise Rejected(f"{coefficient} {factor} is not seen not to be negative")
            if not times.places <= free:
                raise Rejected(f"of {factor} it is not known that it is not negative")
            total += number(Fraction(coefficient)) * times * value * value
        return total

    def difference(self, left: w.Node, right: w.Node) -> list[tuple[int, int, Polynomial]]:
        """Row, column and left - right, for each entry, less the squares."""
        squares = self.squares.get((left, right), ZERO)
        return [(i, j, entry - squares) for i, j, entry in super().difference(left, right)]


def plain_problem(problem: Problem) -> tuple[Problem, tuple[str, ...]]:
    """The problem that says of what is claimed not to be negative that it is zero; `Rejected` if none is claimed."""
    found = as_differences(problem)
    if found is None:
        raise Rejected("squares show that something is not negative, which the statement does not say")
    return found
