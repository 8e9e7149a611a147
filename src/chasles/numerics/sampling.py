"""Inputs that satisfy a kernel's hypotheses, as floats: drawn at large, near a singular set, or simple.

A unit vector, a rotation or a triad is made with 50 digits and then rounded: each entry is within half a unit in the
last place of a point that satisfies the hypothesis exactly.
"""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import dataclass
from typing import Any

import numpy as np
from numpy.typing import NDArray

from chasles.evaluation.matrices import Matrix, product, transposed
from chasles.numerics.draws import AXES, CONTEXT, Draws, DrawsNearby, SimpleDraws, turned, unit_of
from chasles.numerics.enclosures import exactly
from chasles.numerics.specification import Specification
from chasles.statements import Hypothesis, Packed
from chasles.statements.arrays import core_shape
from chasles.vocabulary import Node

STRATEGIES: dict[str, type[Draws]] = {"generic": Draws, "near": DrawsNearby, "simple": SimpleDraws}
ATTEMPTS = 200


@dataclass(frozen=True, slots=True)
class Sample:
    """The values of the symbols as arrays, and the point of which they are the rounding."""

    arrays: dict[Node, NDArray[np.floating]]
    exact: dict[Node, Matrix]


class Unsatisfiable(ValueError):
    """No input was found that satisfies the hypotheses; the message names kernel and strategy."""


def draw(
    asked: Specification,
    strategy: str,
    generator: np.random.Generator,
    dtype: type[np.floating] = np.float64,
) -> Iterator[Sample]:
    """Inputs of the kernel without end, as arrays of the given type.

    They satisfy the hypotheses that name inputs, up to rounding; what a hypothesis says is not zero is not. Raises
    `Unsatisfiable` where the strategy finds no such point, KeyError for an unknown strategy.
    """
    draws = STRATEGIES[strategy](generator, np.finfo(dtype).precision + 1)
    failures = 0
    while failures < ATTEMPTS:
        point = _point(asked, draws)
        arrays = {
            node: np.array([[float(x) for x in row] for row in point[node]], dtype).reshape(core_shape(node))
            for node in asked.nodes
        }
        if asked.admits(point if asked.exact_inputs else arrays):
            failures = 0
            yield Sample(arrays, point)
        else:
            failures += 1
    raise Unsatisfiable(
        f"{asked.name}: none of {ATTEMPTS} {strategy} inputs satisfies its hypotheses "
        f"({', '.join(hypothesis.text for hypothesis in asked.hypotheses)})"
    )


def _point(asked: Specification, draws: Draws) -> dict[Node, Matrix]:
    point: dict[Node, Matrix] = {}
    for node in asked.nodes:
        point[node] = _free(node, point, asked, draws)
    for hypothesis in sorted(asked.hypotheses, key=lambda h: h.kind == "perpendicular"):
        if all(subject in point for subject in hypothesis.subjects):
            point |= _bound(hypothesis, point, asked, draws)
    return point


def _free(node: Node, point: dict[Node, Matrix], asked: Specification, draws: Draws) -> Matrix:
    """A value that no hypothesis binds; it may be drawn close to that of an earlier input of the same kind."""
    rows, columns = node.shape
    if node in asked.angles and columns == 1:
        # An array is a rotation vector: its length is the angle.
        angle = draws.angle()
        return [[angle * x] for x in _unit(rows, draws)] if rows > 1 else [[angle]]
    relatives = [other for other in point if other.measure == node.measure]
    if relatives and columns == 1:
        related = draws.related([row[0] for row in point[draws.pick(relatives)]])
        if related is not None:
            return [[x] for x in related]
    return [draws.vector(columns) for _ in range(rows)] if columns > 1 else [[x] for x in draws.vector(rows)]


def _bound(hypothesis: Hypothesis, point: dict[Node, Matrix], asked: Specification, draws: Draws) -> dict[Node, Matrix]:
    """Values of the subjects that satisfy the hypothesis."""
    subjects = hypothesis.subjects
    match hypothesis.kind:
        case "unit":
            return {subjects[0]: [[x] for x in _unit(subjects[0].shape[0], draws)]}
        case "unit column":
            whole = iter(_unit(sum(subject.shape[0] for subject in subjects), draws))
            return {subject: [[next(whole)] for _ in range(subject.shape[0])] for subject in subjects}
        case "definite":
            m = point[subjects[0]]
            return {subjects[0]: product(m, transposed(m))}
        case "skew-symmetric":
            m = point[subjects[0]]
            return {subjects[0]: [[(m[i][j] - m[j][i]) / 2 for j in range(len(m))] for i in range(len(m))]}
        case "rotation":
            return {subjects[0]: turned(draws.direction(), draws.angle())}
        case "half_turn":
            axis = draws.direction()
            return {subjects[0]: [[2 * a * b - int(i == j) for j, b in enumerate(axis)] for i, a in enumerate(axis)]}
        case "orthonormal":
            columns = transposed(turned(draws.direction(), draws.angle()))
            return {subject: [[x] for x in column] for subject, column in zip(subjects, columns, strict=True)}
        case "symmetric":
            m = point[subjects[0]]
            size = range(len(m))
            return {subjects[0]: [[m[min(i, j)][max(i, j)] for j in size] for i in size]}
        case "positive":
            return {subjects[0]: [[abs(point[subjects[0]][0][0]) or 1]]}
        case "perpendicular":
            return _perpendicular(subjects, point, asked)
        case "nonzero":
            return {}
        case kind:
            raise TypeError(f"{asked.name}: inputs with the hypothesis {kind} cannot be drawn yet")


def _unit(size: int, draws: Draws) -> list[object]:
    if size < 3:
        angle = draws.angle()
        return (
            [CONTEXT.cos(angle), CONTEXT.sin(angle)] if size == 2 else [draws.pick((CONTEXT.mpf(1), CONTEXT.mpf(-1)))]
        )
    if size == 3:
        return draws.direction()
    return unit_of([*draws.direction(), *draws.vector(size - 3)])


def _perpendicular(subjects: tuple[Node, ...], point: dict[Node, Matrix], asked: Specification) -> dict[Node, Matrix]:
    """The second vector less its component along the first; of unit length still if it has to be."""
    one, other = ([row[0] for row in point[subject]] for subject in subjects)
    square = sum(x * x for x in one)
    if square == 0:
        return {}
    share = sum(x * y for x, y in zip(one, other, strict=True)) / square
    rest = [y - share * x for x, y in zip(one, other, strict=True)]
    if any(h.kind == "unit" and h.subjects == (subjects[1],) for h in asked.hypotheses) and any(rest):
        rest = unit_of(rest)
    return {subjects[1]: [[x] for x in rest]}


def moves(asked: Specification, node: Node, array: NDArray[np.floating], value: Any) -> Iterator[tuple[Any, Any]]:
    """The neighbours of an input's value, one unit in the last place away, forth and back, in every direction.

    The exact value of a rotation is turned by one unit about each axis; otherwise each entry that is not zero moves,
    one of a packed matrix together with the entry across the diagonal.
    """
    if asked.exact_inputs and any(h.kind == "rotation" and h.subjects == (node,) for h in asked.hypotheses):
        step = float(np.finfo(array.dtype).eps)
        for axis in AXES:
            yield product(turned(list(axis), step), value), product(turned(list(axis), -step), value)
        return
    packed = any(isinstance(given.holds, Packed) and given.nodes == (node,) for given in asked.inputs)
    for place in range(array.size):
        row, column = divmod(place, node.shape[1])
        if array.flat[place] != 0 and not (packed and row > column):
            alike = {(row, column), (column, row)} if packed else {(row, column)}
            below, above = (_moved(asked, node, array, value, alike, way) for way in (-np.inf, np.inf))
            yield below, above


def _moved(
    asked: Specification,
    node: Node,
    array: NDArray[np.floating],
    value: Any,
    alike: set[tuple[int, int]],
    way: float,
) -> NDArray[np.floating] | Matrix:
    """The value with the next float in place of equal entries, or with their exact value moved as far."""
    moved = array.copy()
    places = [row * node.shape[1] + column for row, column in sorted(alike)]
    moved.flat[places] = np.nextafter(array.flat[places[0]], array.dtype.type(way))
    if not asked.exact_inputs:
        return moved
    step = exactly(float(moved.flat[places[0]]) - float(array.flat[places[0]]), CONTEXT)
    return [[x + step if (i, j) in alike else x for j, x in enumerate(line)] for i, line in enumerate(value)]
