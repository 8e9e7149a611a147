"""Explicit motions: a smooth function of time for every symbol that no rule defines, chosen to satisfy the hypotheses.

Vectors and matrices are polynomials of time, unit vectors and triads are normalised and turned ones, rotations are
products of three elementary rotations with polynomial angles. What differs from element to element of a body has a
function of its own in each element.
"""

from __future__ import annotations

from collections.abc import Iterable
from random import Random
from typing import Any

from chasles.evaluation.matrices import Matrix, plus, product, transposed
from chasles.statements import Hypothesis
from chasles.vocabulary import Node, Symbol

__all__ = ["Motion"]

DEGREE = 3
"""Of the polynomials of time: second rates are not constant then."""


class Motion:
    """The functions of time of one drawing: the same seed gives the same functions in every process."""

    def __init__(self, hypotheses: Iterable[Hypothesis], context: Any, seed: int) -> None:
        self._context, self._seed = context, seed
        self._bonds: dict[Node, list[Hypothesis]] = {}
        for hypothesis in hypotheses:
            for subject in hypothesis.subjects:
                self._bonds.setdefault(subject, []).append(hypothesis)

    def at(self, symbol: Symbol, moment: Any, element: int | None = None) -> Matrix:
        """The symbol's value at a moment, in one element of the body where it differs; constants are at moment 0."""
        when = moment * 0 if symbol.constant else moment
        kinds = {h.kind: h for h in self._bonds.get(symbol, ())}
        rows, columns = symbol.shape
        if "orthonormal" in kinds:
            triad = transposed(self._turning("triad", when))
            return [[entry] for entry in triad[kinds["orthonormal"].subjects.index(symbol)]]
        if "rotation" in kinds and "symmetric" not in kinds:
            return self._turning(symbol.name, when)
        if "half_turn" in kinds or "rotation" in kinds:
            axis = self._normalised(self._polynomials(symbol.name, when, 3, 1, element))
            return _less_identity(_doubled(product(axis, transposed(axis))))
        drawn = self._polynomials(symbol.name, when, rows, columns, element)
        if "definite" in kinds:
            return _less_identity(product(drawn, transposed(drawn)), -1)
        if "symmetric" in kinds:
            return plus(drawn, transposed(drawn))
        if "positive" in kinds:
            return [[1 + drawn[0][0] ** 2]]
        if "perpendicular" in kinds and kinds["perpendicular"].subjects[1] == symbol:
            drawn = _without(drawn, self.at(kinds["perpendicular"].subjects[0], moment, element))  # type: ignore[arg-type]
        return self._normalised(drawn) if {"unit", "direction"} & kinds.keys() else drawn

    def _polynomials(self, name: str, moment: Any, rows: int, columns: int, element: int | None) -> Matrix:
        """Independent polynomials of the moment, their coefficients halves, thirds... between -2 and 2."""
        draw = Random(f"{self._seed} {name} {element}")
        number = self._context.mpf
        return [
            [
                sum(
                    (number(draw.randint(-34, 34)) / 17 * moment**k for k in range(1, DEGREE + 1)), _start(draw, number)
                )
                for _ in range(columns)
            ]
            for _ in range(rows)
        ]

    def _normalised(self, vector: Matrix) -> Matrix:
        length = self._context.sqrt(sum(row[0] ** 2 for row in vector))
        return [[row[0] / length] for row in vector]

    def _turning(self, name: str, moment: Any) -> Matrix:
        """Turned about the axes 3, 1 and 3 through three angles."""
        angles = self._polynomials(f"angles of {name}", moment, 3, 1, None)
        first, second, third = ((self._context.cos(row[0]), self._context.sin(row[0])) for row in angles)
        zero, one = moment * 0, moment * 0 + 1
        (c, s), (k, z), (x, y) = first, second, third
        about_3 = [[c, -s, zero], [s, c, zero], [zero, zero, one]]
        about_1 = [[one, zero, zero], [zero, k, -z], [zero, z, k]]
        about_3_again = [[x, -y, zero], [y, x, zero], [zero, zero, one]]
        return product(product(about_3, about_1), about_3_again)


def _start(draw: Random, number: Any) -> Any:
    """A value that is not close to zero."""
    return number(draw.choice((-1, 1)) * draw.randint(7, 34)) / 17


def _doubled(matrix: Matrix) -> Matrix:
    return [[2 * entry for entry in row] for row in matrix]


def _less_identity(matrix: Matrix, times: int = 1) -> Matrix:
    return [[entry - times * int(i == j) for j, entry in enumerate(row)] for i, row in enumerate(matrix)]


def _without(vector: Matrix, other: Matrix) -> Matrix:
    """The vector less its component along the other."""
    share = sum(a[0] * b[0] for a, b in zip(vector, other, strict=True)) / sum(b[0] ** 2 for b in other)
    return [[a[0] - share * b[0]] for a, b in zip(vector, other, strict=True)]
