"""Symbols that conditions determine: a linear system over the ring, solved by its normal equations.

For conditions M u = v, a left inverse of M is adj(M^T M) M^T / det(M^T M). It exists where the determinant is, modulo
the hypotheses, a product of nonzero factors; the multipliers of the conditions are the certificate that u has the value
found.
"""

from __future__ import annotations

from collections.abc import Iterable, Iterator
from dataclasses import dataclass
from fractions import Fraction
from functools import cache, reduce
from itertools import combinations_with_replacement
from operator import add

from chasles.algebra.groebner import Combination
from chasles.algebra.localization import Ratio, times
from chasles.algebra.rings import Polynomial
from chasles.evaluation.matrices import each, product, transposed
from chasles.points.adjustment import solution
from chasles.points.evaluation import Point, evaluate
from chasles.problems.context import Context, describe, difference
from chasles.problems.generators import Generator, entries
from chasles.problems.variables import Untreatable

LARGEST_POWER = 16


class Underdetermined(Untreatable):
    """Conditions do not determine what they are posed on."""


@dataclass(frozen=True, slots=True)
class Solved:
    """variable = numerator / product of nonzero factors: product variable - numerator is a combination of zeros.

    `conditions` are cofactors on the conditions' polynomials, `cofactors` on the context's generators.
    """

    variable: str
    value: Ratio
    conditions: Combination
    cofactors: Combination


def solve_conditions(context: Context) -> tuple[tuple[Generator, ...], tuple[Solved, ...]]:
    """The conditions as polynomials, and what they determine, which the context's unfolding uses from then on.

    Raises `Underdetermined` if the conditions are not linear in the unknowns or do not determine them.
    """
    problem = context.problem
    if not problem.conditions:
        return (), ()
    _refuse_angles(context)
    linear = LinearConditions(context)
    solved = linear.solved()
    for symbol in problem.unknowns:
        rows, columns = symbol.shape
        variables = (context.variables[k] for k in linear.places)
        values = {(v.symbol, v.row, v.column): s.value for v, s in zip(variables, solved, strict=True)}
        context.unfold.values[symbol] = [[values[symbol, i, j] for j in range(columns)] for i in range(rows)]
    context.unfold.forget()
    context.conditions = linear.conditions
    return linear.conditions, solved


def _refuse_angles(context: Context) -> None:
    """Raise `Untreatable` if an unknown is an angle whose cosine and sine occur: no linear system determines these."""
    angles = {v.symbol for v in context.variables if v.kind == "cos" and v.symbol in context.problem.unknowns}
    if angles:
        raise Underdetermined(
            f"a condition is to determine the angle {describe(tuple(s for s in angles if s is not None))}: "
            "only one that says it is a sum of rational multiples of other angles does"
        )


def _polynomials(context: Context) -> Iterator[Generator]:
    for goal in context.problem.conditions:
        for i, j, entry in entries(difference(context, goal)):
            if not entry.is_zero:
                yield Generator(f"{goal.label} [{i + 1}, {j + 1}]", entry.numerator)


class LinearConditions:
    """The conditions M u - v on the entries u of the unknowns; raises `Underdetermined` if they are not linear."""

    def __init__(self, context: Context) -> None:
        self.context, ring = context, context.field.ring
        self.zero, self.one = (ring.constant(Fraction(k)) for k in (0, 1))
        self.conditions = tuple(_polynomials(context))
        unknowns = context.problem.unknowns
        self.places = [k for k, v in enumerate(context.variables) if v.kind == "entry" and v.symbol in unknowns]
        if not (self.conditions and self.places):
            raise Underdetermined(f"the conditions do not say what {describe(unknowns)} is")
        self.matrix = [[ring.derivative(c.polynomial, place) for place in self.places] for c in self.conditions]
        self.constants = []
        for condition, row in zip(self.conditions, self.matrix, strict=True):
            parts = (m * ring.generators[p] for m, p in zip(row, self.places, strict=True))
            self.constants.append(reduce(add, parts, self.zero) - condition.polynomial)
        for polynomial in (*self.constants, *(m for row in self.matrix for m in row)):
            if any(ring.derivative(polynomial, place) != 0 for place in self.places):
                raise Underdetermined(f"the conditions are not linear in {describe(unknowns)}")

    def solved(self) -> tuple[Solved, ...]:
        """What they determine. Raises `Underdetermined`."""
        exponents, scale, multipliers = self._left_inverse()
        rows = zip(self.places, multipliers, strict=True)
        return tuple(self._one(place, exponents, scale, row) for place, row in rows)

    def _left_inverse(self) -> tuple[tuple[int, ...], Fraction, list[list[Polynomial]]]:
        """Exponents, a constant and X: X M is the constant times powers of nonzero factors, modulo the hypotheses."""
        columns = transposed(self.matrix)
        determinant, adjugate = self._adjugate(each(product(columns, self.matrix), self._reduced))
        return *self._as_atoms(determinant), each(product(adjugate, columns), self._reduced)

    def _one(self, place: int, exponents: tuple[int, ...], scale: Fraction, multipliers: list[Polynomial]) -> Solved:
        ring, field, name = self.context.field.ring, self.context.field, self.context.variables[place].name
        inverse = ring.constant(1 / scale)
        factors = {k: m * inverse for k, m in enumerate(multipliers) if m != 0}
        numerator = self._reduced(reduce(add, (f * self.constants[k] for k, f in factors.items()), self.zero))
        claim = field.power_product(exponents) * ring.generators[place] - numerator
        rest = claim - reduce(add, (f * self.conditions[k].polynomial for k, f in factors.items()), self.zero)
        cofactors, remainder = self.context.basis.reduce(rest)
        if remainder != 0:
            raise Underdetermined(f"the conditions could not be solved for {name}")
        return Solved(name, Ratio(field, numerator, exponents), factors, cofactors)

    def _reduced(self, polynomial: Polynomial) -> Polynomial:
        return self.context.basis.reduce(polynomial)[1]

    def _adjugate(self, gram: list[list[Polynomial]]) -> tuple[Polynomial, list[list[Polynomial]]]:
        """Determinant and adjugate of a small matrix, reduced by the hypotheses on the way."""

        @cache
        def minor(rows: tuple[int, ...], columns: tuple[int, ...]) -> Polynomial:
            if not rows:
                return self.one
            total = self.zero
            for k, column in enumerate(columns):
                if gram[rows[0]][column] != 0:
                    term = times(gram[rows[0]][column], minor(rows[1:], columns[:k] + columns[k + 1 :]))
                    total = total + term if k % 2 == 0 else total - term
            return self._reduced(total)

        def cofactor(row: int, column: int) -> Polynomial:
            found = minor(whole[:row] + whole[row + 1 :], whole[:column] + whole[column + 1 :])
            return found if (row + column) % 2 == 0 else -found

        whole = tuple(range(len(gram)))
        return minor(whole, whole), [[cofactor(j, i) for j in whole] for i in whole]

    def _as_atoms(self, determinant: Polynomial) -> tuple[tuple[int, ...], Fraction]:
        """The determinant as a constant times powers of the nonzero factors, modulo the hypotheses."""
        ring, field = self.context.field.ring, self.context.field
        if determinant != 0:
            for exponents in _exponents(len(field.nonzero)):
                candidate = self._reduced(field.power_product(exponents))
                if candidate == 0:
                    continue
                (mine, c), (theirs, d) = ring.leading(determinant), ring.leading(candidate)
                if mine == theirs and determinant == candidate * ring.constant(c / d):
                    return exponents, c / d
        raise Underdetermined(
            f"the conditions determine {describe(self.context.problem.unknowns)} only where a determinant is not zero "
            "that no hypothesis declares nonzero: assume it, pose them on what they determine, or give a `solution`"
        )


def _exponents(size: int) -> Iterator[tuple[int, ...]]:
    """Exponents of so many factors, the least total first."""
    for total in range(LARGEST_POWER + 1):
        for first in combinations_with_replacement(range(size), total):
            yield tuple(first.count(k) for k in range(size))


def satisfying_point(context: Context, candidates: Iterable[Point]) -> Point | None:
    """A point at which the conditions hold: the unknowns solved for exactly, those left free set to zero."""
    if not any(_polynomials(context)):
        return next(iter(candidates), None)
    linear = LinearConditions(context)
    names = [context.variables[place].name for place in linear.places]
    for point in candidates:
        rows = [
            [evaluate(context, entry, point).get(0, Fraction(0)) for entry in (*line, constant)]
            for line, constant in zip(linear.matrix, linear.constants, strict=True)
        ]
        found = solution(rows)
        if found is not None:
            return point | dict(zip(names, found, strict=True))
    return None
