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
from chasles.evaluation.matrices import Matrix, each, product, transposed
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
    conditions = tuple(_polynomials(context))
    places = [k for k, v in enumerate(context.variables) if v.kind == "entry" and v.symbol in problem.unknowns]
    matrix, constants = _linear(context, conditions, places)
    exponents, scale, multipliers = _left_inverse(context, matrix)
    solved = []
    for row, place in enumerate(places):
        solved.append(_one(context, conditions, constants, place, exponents, scale, multipliers[row]))
    for symbol in problem.unknowns:
        rows, columns = symbol.shape
        values = {
            (context.variables[k].symbol, context.variables[k].row, context.variables[k].column): s.value
            for k, s in zip(places, solved, strict=True)
        }
        context.unfold.values[symbol] = [[values[symbol, i, j] for j in range(columns)] for i in range(rows)]
    context.unfold.forget()
    context.conditions = conditions
    return conditions, tuple(solved)


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


def _linear(
    context: Context, conditions: tuple[Generator, ...], places: list[int]
) -> tuple[list[list[Polynomial]], list[Polynomial]]:
    """M and v with condition = M u - v."""
    if not (conditions and places):
        raise Underdetermined(f"the conditions do not say what {describe(context.problem.unknowns)} is")
    ring = context.field.ring
    matrix = [[ring.derivative(c.polynomial, place) for place in places] for c in conditions]
    zero = ring.constant(Fraction(0))
    constants = []
    for condition, row in zip(conditions, matrix, strict=True):
        rest = (
            reduce(add, (m * ring.generators[p] for m, p in zip(row, places, strict=True)), zero) - condition.polynomial
        )
        constants.append(rest)
    for polynomial in (*constants, *(m for row in matrix for m in row)):
        if any(ring.derivative(polynomial, place) != 0 for place in places):
            raise Underdetermined(f"the conditions are not linear in {describe(context.problem.unknowns)}")
    return matrix, constants


def _left_inverse(
    context: Context, matrix: list[list[Polynomial]]
) -> tuple[tuple[int, ...], Fraction, list[list[Polynomial]]]:
    """Exponents, a constant and X: X M is the constant times powers of nonzero factors, modulo the hypotheses."""
    columns = transposed(matrix)

    def reduced(matrix: Matrix) -> Matrix:
        return each(matrix, lambda entry: _reduced(context, entry))

    determinant, adjugate = _adjugate(context, reduced(product(columns, matrix)))
    return *_as_atoms(context, determinant), reduced(product(adjugate, columns))


def _one(
    context: Context,
    conditions: tuple[Generator, ...],
    constants: list[Polynomial],
    place: int,
    exponents: tuple[int, ...],
    scale: Fraction,
    multipliers: list[Polynomial],
) -> Solved:
    ring, field = context.field.ring, context.field
    inverse = ring.constant(1 / scale)
    factors = {k: m * inverse for k, m in enumerate(multipliers) if m != 0}
    numerator = _reduced(
        context, reduce(add, (f * constants[k] for k, f in factors.items()), ring.constant(Fraction(0)))
    )
    claim = field.power_product(exponents) * ring.generators[place] - numerator
    rest = claim - reduce(add, (f * conditions[k].polynomial for k, f in factors.items()), ring.constant(Fraction(0)))
    cofactors, remainder = context.basis.reduce(rest)
    if remainder != 0:
        raise Underdetermined(f"the conditions could not be solved for {context.variables[place].name}")
    return Solved(context.variables[place].name, Ratio(field, numerator, exponents), factors, cofactors)


def _reduced(context: Context, polynomial: Polynomial) -> Polynomial:
    return context.basis.reduce(polynomial)[1]


def _adjugate(context: Context, gram: list[list[Polynomial]]) -> tuple[Polynomial, list[list[Polynomial]]]:
    """Determinant and adjugate of a small matrix, reduced by the hypotheses on the way."""
    one = context.field.ring.constant(Fraction(1))

    @cache
    def minor(rows: tuple[int, ...], columns: tuple[int, ...]) -> Polynomial:
        if not rows:
            return one
        total = context.field.ring.constant(Fraction(0))
        for k, column in enumerate(columns):
            if gram[rows[0]][column] != 0:
                term = times(gram[rows[0]][column], minor(rows[1:], columns[:k] + columns[k + 1 :]))
                total = total + term if k % 2 == 0 else total - term
        return _reduced(context, total)

    def cofactor(row: int, column: int) -> Polynomial:
        found = minor(whole[:row] + whole[row + 1 :], whole[:column] + whole[column + 1 :])
        return found if (row + column) % 2 == 0 else -found

    whole = tuple(range(len(gram)))
    return minor(whole, whole), [[cofactor(j, i) for j in whole] for i in whole]


def _as_atoms(context: Context, determinant: Polynomial) -> tuple[tuple[int, ...], Fraction]:
    """The determinant as a constant times powers of the nonzero factors, modulo the hypotheses."""
    ring, field = context.field.ring, context.field
    if determinant != 0:
        for exponents in _exponents(len(field.nonzero)):
            candidate = _reduced(context, field.power_product(exponents))
            if candidate == 0:
                continue
            (mine, c), (theirs, d) = ring.leading(determinant), ring.leading(candidate)
            if mine == theirs and determinant == candidate * ring.constant(c / d):
                return exponents, c / d
    raise Underdetermined(
        f"the conditions determine {describe(context.problem.unknowns)} only where a determinant is not zero "
        "that no hypothesis declares nonzero: assume it, pose them on what they determine, or give a `solution`"
    )


def _exponents(size: int) -> Iterator[tuple[int, ...]]:
    """Exponents of so many factors, the least total first."""
    for total in range(LARGEST_POWER + 1):
        for first in combinations_with_replacement(range(size), total):
            yield tuple(first.count(k) for k in range(size))


def satisfying_point(context: Context, candidates: Iterable[Point]) -> Point | None:
    """A point at which the conditions hold: the unknowns solved for exactly, those left free set to zero."""
    conditions = tuple(_polynomials(context))
    places = [k for k, v in enumerate(context.variables) if v.kind == "entry" and v.symbol in context.problem.unknowns]
    if not conditions:
        return next(iter(candidates), None)
    matrix, constants = _linear(context, conditions, places)
    names = [context.variables[place].name for place in places]
    for point in candidates:
        rows = [
            [evaluate(context, entry, point).get(0, Fraction(0)) for entry in (*line, constant)]
            for line, constant in zip(matrix, constants, strict=True)
        ]
        found = solution(rows)
        if found is not None:
            return point | dict(zip(names, found, strict=True))
    return None
