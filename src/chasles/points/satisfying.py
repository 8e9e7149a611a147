"""Rational values that satisfy a hypothesis, with the rates that go with them."""

from __future__ import annotations

from collections import Counter
from collections.abc import Iterable
from fractions import Fraction
from functools import reduce
from itertools import combinations
from math import comb
from operator import mul
from random import Random

from chasles.checker.witness import root_of
from chasles.evaluation.matrices import plus, product
from chasles.points.rational import CIRCLE, Numbers, circle, definite, free, half_turn, on_sphere, rotation, unit_vector
from chasles.statements import Hypothesis
from chasles.vocabulary import Symbol

KINDS = (
    "half_turn",
    "orthonormal",
    "rotation",
    "unit",
    "direction",
    "unit column",
    "definite",
    "symmetric",
    "positive",
    "perpendicular",
    "orthogonal",
    "orthonormal columns",
    "skew-symmetric",
    "idempotent",
    "commuting",
)
"""Of hypotheses on the same symbols, those that leave less of a choice come first."""


def in_order(hypotheses: Iterable[Hypothesis]) -> list[Hypothesis]:
    """The hypotheses as they are satisfied: what comes later keeps what its subjects already are."""
    spoken_of = Counter(subject for h in hypotheses if h.kind in KINDS for subject in h.subjects)
    shared = {h: any(spoken_of[subject] > 1 for subject in h.subjects) for h in hypotheses if h.kind in KINDS}
    return sorted(hypotheses, key=lambda h: KINDS.index(h.kind) if shared.get(h) else -1)


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
        case "unit" | "direction" | "rotation" | "half_turn" as kind:
            (symbol,) = subjects
            if (symbol, 0) not in values:
                matrix = {"rotation": rotation, "half_turn": half_turn}.get(kind)
                numbers = matrix(draw, rich) if matrix else [[x] for x in unit_vector(draw, rich, symbol.shape[0])]
                rates = _turning(numbers, orders.get(symbol, 0), draw, rich)
                values |= {(symbol, k): rate for k, rate in enumerate(rates)}
        case "orthonormal":
            order = max(orders.get(s, 0) for s in subjects)
            rates = _turning(rotation(draw, rich), order, draw, rich)
            for j, vector in enumerate(subjects):
                values |= {(vector, k): [[row[j]] for row in rate] for k, rate in enumerate(rates)}
        case "unit column":
            _on_sphere(subjects, orders, values, draw, rich)
        case "positive" if subjects:
            (quantity,) = subjects
            known = values.get((quantity, 0))
            values[quantity, 0] = [[abs(known[0][0])]] if known else [[Fraction(draw.randint(1, 5))]]
        case "definite" | "symmetric":
            _bind_symmetric(hypothesis.kind, subjects[0], orders, values, draw, rich)
        case "orthogonal" | "orthonormal columns" | "skew-symmetric" | "idempotent" | "commuting":
            _bind_matrices(hypothesis.kind, subjects, values, draw, rich)
        case "perpendicular":
            return _perpendicular(subjects, values, draw, rich)
        case _:
            return set()
    return set(subjects)


def _bind_symmetric(
    kind: str,
    matrix: Symbol,
    orders: dict[Symbol, int],
    values: dict[tuple[Symbol, int], Numbers],
    draw: Random,
    rich: bool,
) -> None:
    """A symmetric matrix and its rates, positive-definite where that is assumed."""
    if (matrix, 0) in values:
        values[matrix, 0] = _symmetric_too(values[matrix, 0], kind, draw, rich)
        return
    for k in range(orders.get(matrix, 0) + 1):
        m = (definite if kind == "definite" else free)(matrix.shape, draw, rich)
        values[matrix, k] = [[m[min(i, j)][max(i, j)] for j in range(len(m))] for i in range(len(m))]


def _bind_matrices(
    kind: str, subjects: list[Symbol], values: dict[tuple[Symbol, int], Numbers], draw: Random, rich: bool
) -> None:
    """The same of matrices of any size; those that move are not treated."""
    (rows, columns), mirror = subjects[0].shape, _reflection(subjects[0].shape[0], draw)
    if kind in ("orthogonal", "orthonormal columns"):
        turned = product(mirror, _reflection(rows, draw)) if draw.randint(0, 1) else mirror
        values[subjects[0], 0] = [row[:columns] for row in turned]
    elif kind == "skew-symmetric":
        values[subjects[0], 0] = _spin(_unit(rows), [row[0] for row in free((rows * (rows - 1) // 2, 1), draw, rich)])
    elif kind == "idempotent":
        kept, aslant = draw.randint(0, rows), draw.randint(0, 2)
        part = [[Fraction(i == j < kept or (i < kept <= j and aslant)) for j in range(rows)] for i in range(rows)]
        values[subjects[0], 0] = product(mirror, product(part, mirror))
    else:
        m = values.setdefault((subjects[0], 0), free((rows, rows), draw, rich))
        a, b = (Fraction(draw.randint(-2, 2)) for _ in range(2))
        shifted = plus(product(m, m), [[a * x for x in row] for row in m])
        values[subjects[1], 0] = plus(shifted, [[b * x for x in row] for row in _unit(rows)])


def _unit(size: int) -> Numbers:
    return [[Fraction(i == j) for j in range(size)] for i in range(size)]


def _reflection(size: int, draw: Random) -> Numbers:
    """A reflection at a plane through the origin, or the identity."""
    v = [draw.randint(-2, 2) for _ in range(size)]
    square = sum(x * x for x in v) or 1
    return [[Fraction(i == j) - Fraction(2 * v[i] * v[j], square) for j in range(size)] for i in range(size)]


def _symmetric_too(rotation: Numbers, kind: str, draw: Random, rich: bool) -> Numbers:
    """A rotation that is symmetric: the same if it is, the identity if it shall be definite, else a half-turn."""
    if kind == "definite":
        return [[Fraction(int(i == j)) for j in range(len(rotation))] for i in range(len(rotation))]
    return rotation if rotation == [*map(list, zip(*rotation, strict=True))] else half_turn(draw, rich)


def _on_sphere(
    subjects: list[Symbol],
    orders: dict[Symbol, int],
    values: dict[tuple[Symbol, int], Numbers],
    draw: Random,
    rich: bool,
) -> None:
    """Entries whose squares add to one, with their rates; those that have values keep them."""
    open_ = [symbol for symbol in subjects if (symbol, 0) not in values]
    known = [entry for symbol in subjects if symbol not in open_ for (entry,) in values[symbol, 0]]
    radius = root_of(1 - sum((entry * entry for entry in known), Fraction(0)))
    if radius is None or not open_:
        return
    lengths = on_sphere(len(open_), draw, rich)
    parts = [(1,) if symbol.is_scalar else unit_vector(draw, rich, symbol.shape[0]) for symbol in open_]
    column = [[radius * length * x] for length, part in zip(lengths, parts, strict=True) for x in part]
    order = 0 if known else max(orders.get(symbol, 0) for symbol in open_)
    for k, rate in enumerate(_turning(column, order, draw, rich)):
        entries = iter(rate)
        values |= {(symbol, k): [next(entries) for _ in range(symbol.shape[0])] for symbol in open_}


def _perpendicular(
    subjects: list[Symbol], values: dict[tuple[Symbol, int], Numbers], draw: Random, rich: bool
) -> set[Symbol]:
    """Two vectors at right angles; one that has a rational length keeps it."""
    one, other = subjects if (subjects[0], 0) in values or (subjects[1], 0) not in values else subjects[::-1]
    size = one.shape[0]
    first = [row[0] for row in values.setdefault((one, 0), free((size, 1), draw, rich))]
    length, kept = (root_of(sum((x * x for (x,) in values.get((s, 0), ())), Fraction(0))) for s in (one, other))
    if length and kept:
        # The reflection that turns the last axis into the first vector turns the others into normals of it.
        mirror = [x / length - axis for x, axis in zip(first, (*(0,) * (size - 1), 1), strict=True)]
        square = sum(x * x for x in mirror) or Fraction(1)
        across = on_sphere(size - 1, draw, rich) if size != 3 else circle(draw) if rich else draw.choice(CIRCLE)
        normal = [*across, Fraction(0)]
        along = 2 * sum(map(mul, mirror, normal)) / square
        values[other, 0] = [[kept * (x - along * y)] for x, y in zip(normal, mirror, strict=True)]
    else:
        values[other, 0] = _spin(free((3, 1), draw, rich), first) if size == 3 else _across(first, draw, rich)
    return {one, other}


def _across(column: list[Fraction], draw: Random, rich: bool) -> Numbers:
    """A column at right angles to another: what a skew-symmetric matrix makes of that."""
    size = len(column)
    spin = [row[0] for row in free((size * (size - 1) // 2, 1), draw, rich)]
    return _spin([[entry] for entry in column], spin)


def _turning(numbers: Numbers, order: int, draw: Random, rich: bool) -> list[Numbers]:
    """The values and rates of something that turns: x, w x x, w' x x + w x (w x x) and so on, by Leibniz's rule."""
    rates, size = [numbers], len(numbers)
    spins = [[row[0] for row in free((size * (size - 1) // 2, 1), draw, rich)] for _ in range(max(order, 2))]
    for reached in range(order):
        parts = [_spin(rates[reached - k], [comb(reached, k) * x for x in spins[k]]) for k in range(reached + 1)]
        rates.append(reduce(plus, parts))
    return rates


def _spin(numbers: Numbers, spin: list[Fraction]) -> Numbers:
    """The skew-symmetric matrix of the spin times each column: in three dimensions, spin x each column."""
    total = [[Fraction(0)] * len(row) for row in numbers]
    for (j, i), rate in zip(combinations(reversed(range(len(numbers))), 2), spin, strict=True):
        turn = rate if (i + j) % 2 else -rate
        total[j] = [sum_ + turn * entry for sum_, entry in zip(total[j], numbers[i], strict=True)]
        total[i] = [sum_ - turn * entry for sum_, entry in zip(total[i], numbers[j], strict=True)]
    return total
