"""Rational values that satisfy a hypothesis, with the rates that go with them."""

from __future__ import annotations

from fractions import Fraction
from functools import reduce
from math import comb
from random import Random

from chasles.proof.rational import Numbers, definite, free, half_turn, rotation, unit_vector
from chasles.statements import Hypothesis
from chasles.vocabulary import Symbol


def bind(
    hypothesis: Hypothesis,
    orders: dict[Symbol, int],
    values: dict[tuple[Symbol, int], Numbers],
    draw: Random,
    rich: bool,
) -> set[Symbol]:
    """Give the subjects of a hypothesis values that satisfy it."""
    subjects = [s for s in hypothesis.subjects if isinstance(s, Symbol)]
    match hypothesis.kind:
        case "unit":
            (vector,) = subjects
            if (vector, 0) not in values:
                rates = _turning([[x] for x in unit_vector(draw, rich)], orders.get(vector, 0), draw, rich)
                values |= {(vector, k): rate for k, rate in enumerate(rates)}
        case "rotation":
            (matrix,) = subjects
            rates = _turning(rotation(draw, rich), orders.get(matrix, 0), draw, rich)
            values |= {(matrix, k): rate for k, rate in enumerate(rates)}
        case "half_turn":
            (matrix,) = subjects
            rates = _turning(half_turn(draw, rich), orders.get(matrix, 0), draw, rich)
            values |= {(matrix, k): rate for k, rate in enumerate(rates)}
        case "orthonormal":
            order = max(orders.get(s, 0) for s in subjects)
            rates = _turning(rotation(draw, rich), order, draw, rich)
            for j, vector in enumerate(subjects):
                values |= {(vector, k): [[row[j]] for row in rate] for k, rate in enumerate(rates)}
        case "positive":
            (quantity,) = subjects
            values[quantity, 0] = [[Fraction(draw.randint(1, 5))]]
        case "definite":
            (matrix,) = subjects
            for k in range(orders.get(matrix, 0) + 1):
                values[matrix, k] = definite(matrix.shape[0], draw, rich)
        case "symmetric":
            (matrix,) = subjects
            if (matrix, 0) in values:
                values[matrix, 0] = half_turn(draw, rich)
                return set(subjects)
            for k in range(orders.get(matrix, 0) + 1):
                m = free(matrix.shape, draw, rich)
                values[matrix, k] = [[m[min(i, j)][max(i, j)] for j in range(len(m))] for i in range(len(m))]
        case "perpendicular":
            return _perpendicular(subjects, values, draw, rich)
        case _:
            return set()
    return set(subjects)


def _perpendicular(
    subjects: list[Symbol], values: dict[tuple[Symbol, int], Numbers], draw: Random, rich: bool
) -> set[Symbol]:
    one, other = subjects
    values.setdefault((one, 0), free((3, 1), draw, rich))
    values[other, 0] = _spin(free((3, 1), draw, rich), [row[0] for row in values[one, 0]])
    return {one, other}


def _turning(numbers: Numbers, order: int, draw: Random, rich: bool) -> list[Numbers]:
    """The values and rates of something that turns: x, w x x, w' x x + w x (w x x) and so on, by Leibniz's rule."""
    rates = [numbers]
    spins = [[row[0] for row in free((3, 1), draw, rich)] for _ in range(max(order, 2))]
    for reached in range(order):
        parts = [_spin(rates[reached - k], [comb(reached, k) * x for x in spins[k]]) for k in range(reached + 1)]
        rates.append(reduce(_plus, parts))
    return rates


def _spin(numbers: Numbers, spin: list[Fraction]) -> Numbers:
    """Spin x each column."""
    x, y, z = spin
    skew = [[Fraction(0), -z, y], [z, Fraction(0), -x], [-y, x, Fraction(0)]]
    return [
        [sum((skew[i][k] * numbers[k][j] for k in range(3)), Fraction(0)) for j in range(len(numbers[0]))]
        for i in range(3)
    ]


def _plus(one: Numbers, other: Numbers) -> Numbers:
    return [[a + b for a, b in zip(row, line, strict=True)] for row, line in zip(one, other, strict=True)]
