"""Rational values that satisfy a hypothesis, with the rates that go with them."""

from __future__ import annotations

from collections import Counter
from collections.abc import Iterable, Mapping
from fractions import Fraction
from functools import reduce
from itertools import combinations
from math import comb
from operator import mul
from types import MappingProxyType

from chasles.checker.witness import root_of
from chasles.evaluation.matrices import plus, product
from chasles.points.rational import Numbers, RationalRandom
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


class SatisfyingValues:
    """Values of symbols and, up to `orders`, of their rates, which satisfy the hypotheses that were bound."""

    def __init__(self, draw: RationalRandom, orders: Mapping[Symbol, int] = MappingProxyType({})) -> None:
        self.draw, self.orders = draw, orders
        self.values: dict[tuple[Symbol, int], Numbers] = {}

    def bind(self, hypothesis: Hypothesis) -> set[Symbol]:
        """Give the subjects of a hypothesis values that satisfy it; those that are bound by it."""
        subjects = [s for s in hypothesis.subjects if isinstance(s, Symbol)]
        values, draw = self.values, self.draw
        match hypothesis.kind:
            case "unit" | "direction" | "rotation" | "half_turn" as kind:
                (symbol,) = subjects
                if (symbol, 0) not in values:
                    matrix = {"rotation": draw.rotation, "half_turn": draw.half_turn}.get(kind)
                    numbers = matrix() if matrix else [[x] for x in draw.unit_vector(symbol.shape[0])]
                    rates = self._turning(numbers, self.orders.get(symbol, 0))
                    values |= {(symbol, k): rate for k, rate in enumerate(rates)}
            case "orthonormal":
                order = max(self.orders.get(s, 0) for s in subjects)
                rates = self._turning(draw.rotation(), order)
                for j, vector in enumerate(subjects):
                    values |= {(vector, k): [[row[j]] for row in rate] for k, rate in enumerate(rates)}
            case "unit column":
                self._on_sphere(subjects)
            case "positive" if subjects:
                (quantity,) = subjects
                known = values.get((quantity, 0))
                values[quantity, 0] = [[abs(known[0][0])]] if known else [[Fraction(draw.randint(1, 5))]]
            case "definite" | "symmetric":
                self._bind_symmetric(hypothesis.kind, subjects[0])
            case "orthogonal" | "orthonormal columns" | "skew-symmetric" | "idempotent" | "commuting":
                self._bind_matrices(hypothesis.kind, subjects)
            case "perpendicular":
                return self._perpendicular(subjects)
            case _:
                return set()
        return set(subjects)

    def _bind_symmetric(self, kind: str, matrix: Symbol) -> None:
        """A symmetric matrix and its rates, positive-definite where that is assumed."""
        if (matrix, 0) in self.values:
            self.values[matrix, 0] = self._symmetric_too(self.values[matrix, 0], kind)
            return
        for k in range(self.orders.get(matrix, 0) + 1):
            m = (self.draw.definite if kind == "definite" else self.draw.free)(matrix.shape)
            self.values[matrix, k] = [[m[min(i, j)][max(i, j)] for j in range(len(m))] for i in range(len(m))]

    def _symmetric_too(self, rotation: Numbers, kind: str) -> Numbers:
        """A rotation that is symmetric: the same if it is, the identity if it shall be definite, else a half-turn."""
        if kind == "definite":
            return _unit(len(rotation))
        return rotation if rotation == [*map(list, zip(*rotation, strict=True))] else self.draw.half_turn()

    def _bind_matrices(self, kind: str, subjects: list[Symbol]) -> None:
        """The same of matrices of any size; those that move are not treated."""
        (rows, columns), draw = subjects[0].shape, self.draw
        mirror = _reflection(rows, draw)
        if kind in ("orthogonal", "orthonormal columns"):
            turned = product(mirror, _reflection(rows, draw)) if draw.randint(0, 1) else mirror
            self.values[subjects[0], 0] = [row[:columns] for row in turned]
        elif kind == "skew-symmetric":
            self.values[subjects[0], 0] = _spin(_unit(rows), draw.spin(rows))
        elif kind == "idempotent":
            kept, aslant = draw.randint(0, rows), draw.randint(0, 2)
            part = [[Fraction(i == j < kept or (i < kept <= j and aslant)) for j in range(rows)] for i in range(rows)]
            self.values[subjects[0], 0] = product(mirror, product(part, mirror))
        else:
            m = self.values.setdefault((subjects[0], 0), draw.free((rows, rows)))
            a, b = (Fraction(draw.randint(-2, 2)) for _ in range(2))
            shifted = plus(product(m, m), [[a * x for x in row] for row in m])
            self.values[subjects[1], 0] = plus(shifted, [[b * x for x in row] for row in _unit(rows)])

    def _on_sphere(self, subjects: list[Symbol]) -> None:
        """Entries whose squares add to one, with their rates; those that have values keep them."""
        open_ = [symbol for symbol in subjects if (symbol, 0) not in self.values]
        known = [entry for symbol in subjects if symbol not in open_ for (entry,) in self.values[symbol, 0]]
        radius = root_of(1 - sum((entry * entry for entry in known), Fraction(0)))
        if radius is None or not open_:
            return
        lengths = self.draw.on_sphere(len(open_))
        parts = [(1,) if symbol.is_scalar else self.draw.unit_vector(symbol.shape[0]) for symbol in open_]
        column = [[radius * length * x] for length, part in zip(lengths, parts, strict=True) for x in part]
        order = 0 if known else max(self.orders.get(symbol, 0) for symbol in open_)
        for k, rate in enumerate(self._turning(column, order)):
            entries = iter(rate)
            self.values |= {(symbol, k): [next(entries) for _ in range(symbol.shape[0])] for symbol in open_}

    def _perpendicular(self, subjects: list[Symbol]) -> set[Symbol]:
        """Two vectors at right angles; one that has a rational length keeps it."""
        values, draw = self.values, self.draw
        one, other = subjects if (subjects[0], 0) in values or (subjects[1], 0) not in values else subjects[::-1]
        size = one.shape[0]
        first = [row[0] for row in values.setdefault((one, 0), draw.free((size, 1)))]
        length, kept = (root_of(sum((x * x for (x,) in values.get((s, 0), ())), Fraction(0))) for s in (one, other))
        if length and kept:
            # The reflection that turns the last axis into the first vector turns the others into normals of it.
            mirror = [x / length - axis for x, axis in zip(first, (*(0,) * (size - 1), 1), strict=True)]
            square = sum(x * x for x in mirror) or Fraction(1)
            across = draw.on_sphere(size - 1) if size != 3 else draw.circle()
            normal = [*across, Fraction(0)]
            along = 2 * sum(map(mul, mirror, normal)) / square
            values[other, 0] = [[kept * (x - along * y)] for x, y in zip(normal, mirror, strict=True)]
        elif size == 3:
            values[other, 0] = _spin(draw.free((3, 1)), first)
        else:  # what a skew-symmetric matrix makes of a column
            values[other, 0] = _spin([[entry] for entry in first], draw.spin(size))
        return {one, other}

    def _turning(self, numbers: Numbers, order: int) -> list[Numbers]:
        """Values and rates of something that turns: x, w x x, w' x x + w x (w x x) and so on, by Leibniz's rule."""
        rates = [numbers]
        spins = [self.draw.spin(len(numbers)) for _ in range(max(order, 2))]
        for reached in range(order):
            parts = [_spin(rates[reached - k], [comb(reached, k) * x for x in spins[k]]) for k in range(reached + 1)]
            rates.append(reduce(plus, parts))
        return rates


def _unit(size: int) -> Numbers:
    return [[Fraction(i == j) for j in range(size)] for i in range(size)]


def _reflection(size: int, draw: RationalRandom) -> Numbers:
    """A reflection at a plane through the origin, or the identity."""
    v = [draw.randint(-2, 2) for _ in range(size)]
    square = sum(x * x for x in v) or 1
    return [[Fraction(i == j) - Fraction(2 * v[i] * v[j], square) for j in range(size)] for i in range(size)]


def _spin(numbers: Numbers, spin: list[Fraction]) -> Numbers:
    """The skew-symmetric matrix of the spin times each column: in three dimensions, spin x each column."""
    total = [[Fraction(0)] * len(row) for row in numbers]
    for (j, i), rate in zip(combinations(reversed(range(len(numbers))), 2), spin, strict=True):
        turn = rate if (i + j) % 2 else -rate
        total[j] = [sum_ + turn * entry for sum_, entry in zip(total[j], numbers[i], strict=True)]
        total[i] = [sum_ - turn * entry for sum_, entry in zip(total[i], numbers[j], strict=True)]
    return total
