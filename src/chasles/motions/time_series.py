"""Power series in time, a few terms of each: a quantity with its rates, at several motions and elements at once."""

from __future__ import annotations

from collections.abc import Callable, Sequence
from functools import reduce
from typing import Any

import numpy as np

from chasles.evaluation import matrices
from chasles.evaluation.matrices import Matrix

Array = np.ndarray[Any, np.dtype[np.float64]]
LEAST_AT_ONCE = 9
"""So many products of entries are formed at once: fewer are sooner formed one by one."""


class TimeSeries:
    """The coefficients of 1, t, t^2, ...; arithmetic keeps as many as both sides have.

    Those from `reach` on are known to vanish.
    """

    __slots__ = ("reach", "terms")

    def __init__(self, terms: Array, reach: int | None = None) -> None:
        self.terms = terms
        n = len(terms)
        self.reach = n if reach is None or reach > n else reach

    def first(self, n: int) -> TimeSeries:
        """The first n coefficients."""
        return TimeSeries(self.terms[:n], self.reach)

    def __add__(self, other: TimeSeries) -> TimeSeries:
        n = min(len(self.terms), len(other.terms))
        if not other.reach:
            return self.first(n)
        if not self.reach:
            return other.first(n)
        return TimeSeries(self.terms[:n] + other.terms[:n], max(self.reach, other.reach))

    def __sub__(self, other: TimeSeries) -> TimeSeries:
        return self + -other

    def __neg__(self) -> TimeSeries:
        return TimeSeries(-self.terms, self.reach) if self.reach else self

    def __mul__(self, other: TimeSeries) -> TimeSeries:
        one, more = (self, other) if self.reach <= other.reach else (other, self)
        n = min(len(one.terms), len(more.terms))
        if not one.reach:
            return one.first(n)
        found = one.terms[0] * more.terms[:n]
        for k in range(1, min(one.reach, n)):
            found[k:] += one.terms[k] * more.terms[: n - k]
        return TimeSeries(found, one.reach + more.reach - 1)

    def __truediv__(self, other: TimeSeries) -> TimeSeries:
        n = min(len(self.terms), len(other.terms))
        if other.reach == 1:
            return TimeSeries(self.terms[:n] / other.terms[0], self.reach)
        found: list[Array] = []
        for k in range(n):
            rest = self.terms[k] - sum((found[j] * other.terms[k - j] for j in range(k)), np.float64(0.0))
            found.append(rest / other.terms[0])
        return TimeSeries(np.stack(np.broadcast_arrays(*found)))

    @property
    def rate(self) -> TimeSeries:
        """The time derivative, which has one term less."""
        n = len(self.terms)
        places = np.arange(1, n).reshape(-1, *[1] * (self.terms.ndim - 1))
        return TimeSeries(self.terms[1:] * places)

    def integrated(self, start: Array) -> TimeSeries:
        """What has this rate, and this value at the start."""
        places = np.arange(1, len(self.terms) + 1).reshape(-1, *[1] * (self.terms.ndim - 1))
        return TimeSeries(np.stack(np.broadcast_arrays(start, *(self.terms / places))))

    @property
    def now(self) -> Array:
        """The value at the time zero."""
        now: Array = self.terms[0]
        return now

    def __len__(self) -> int:
        return len(self.terms)


def matrix_product(left: Matrix, right: Matrix) -> Matrix:
    """The product of two matrices of series, all entries at once; raises ValueError if the inner sizes differ."""
    n, *others = {len(entry) for side in (left, right) for row in side for entry in row}
    if others or len(left) * len(right) * len(right[0]) < LEAST_AT_ONCE:
        return matrices.product(left, right)
    (one, reach), (more, other) = (_at_once(side, n) for side in (left, right))
    found = one[0] @ more
    for k in range(1, min(reach, n)):
        found[k:] += one[k] @ more[: n - k]
    series = np.ascontiguousarray(np.moveaxis(found, (-2, -1), (0, 1)))
    return [[TimeSeries(entry, max(reach + other - 1, 0)) for entry in row] for row in series]


def _at_once(matrix: Matrix, n: int) -> tuple[Array, int]:
    """The first n coefficients of all entries, those of each motion and element as a matrix, and their reach."""
    entries = [entry for row in matrix for entry in row]
    found = stacked(entries, n).reshape(len(matrix), len(matrix[0]), n, -1, max(e.terms.shape[2] for e in entries))
    return np.ascontiguousarray(found.transpose(2, 3, 4, 0, 1)), max(entry.reach for entry in entries)


def stacked(series: Sequence[TimeSeries], n: int) -> Array:
    """The first n coefficients of each, one beside the other, for as many motions and elements as any of them has."""
    widths = (max(each.terms.shape[axis] for each in series) for axis in (1, 2))
    found = np.empty((len(series), n, *widths))
    for place, each in enumerate(series):
        found[place] = each.terms[:n]
    return found


def function_of(name: str) -> Callable[..., TimeSeries]:
    """The function of that name, NaN where it is not real; raises KeyError for an unknown one."""
    return FUNCTIONS[name]


def _by_slope(value: Callable[[Array], Array], slope: str | Callable[..., TimeSeries]) -> Callable[..., TimeSeries]:
    """A function by its value now and its derivative, or the name of that, which is asked for one term less."""

    def function(x: TimeSeries) -> TimeSeries:
        start = value(x.now)
        if len(x) == 1:
            return TimeSeries(start[None])
        derivative = FUNCTIONS[slope] if isinstance(slope, str) else slope
        return (derivative(TimeSeries(x.terms[:-1])) * x.rate).integrated(start)

    return function


def _one(x: TimeSeries) -> TimeSeries:
    return x / x


def chosen(x: TimeSeries, other: TimeSeries, taken: Array) -> TimeSeries:
    """The first at the motions at which it is taken, the other elsewhere."""
    n = min(len(x), len(other))
    return TimeSeries(np.where(taken, x.terms[:n], other.terms[:n]))


def _atan2(y: TimeSeries, x: TimeSeries) -> TimeSeries:
    start = np.arctan2(y.now, x.now)
    if min(len(x), len(y)) == 1:
        return TimeSeries(start[None])
    return ((x * y.rate - y * x.rate) / (x * x + y * y)).integrated(start)


def _root_of_rest(x: TimeSeries) -> TimeSeries:
    """The cosine of an angle by its sine, or its sine by its cosine."""
    return FUNCTIONS["sqrt"](_one(x) - x * x)


FUNCTIONS: dict[str, Callable[..., TimeSeries]] = {
    "sin": _by_slope(np.sin, "cos"),
    "cos": _by_slope(np.cos, lambda x: -FUNCTIONS["sin"](x)),
    "sqrt": _by_slope(np.sqrt, lambda x: TimeSeries(0.5 * (_one(x) / FUNCTIONS["sqrt"](x)).terms)),
    "exp": _by_slope(np.exp, "exp"),
    "log": _by_slope(np.log, lambda x: _one(x) / x),
    "arcsin": _by_slope(np.arcsin, lambda x: _one(x) / _root_of_rest(x)),
    "arccos": _by_slope(np.arccos, lambda x: -(_one(x) / _root_of_rest(x))),
    "arctan": _by_slope(np.arctan, lambda x: _one(x) / (_one(x) + x * x)),
    "sinh": _by_slope(np.sinh, "cosh"),
    "cosh": _by_slope(np.cosh, "sinh"),
    "tanh": lambda x: FUNCTIONS["sinh"](x) / FUNCTIONS["cosh"](x),
    "atan2": _atan2,
    "abs": lambda x: TimeSeries(x.terms * np.sign(x.now)),
    "sign": lambda x: TimeSeries(np.concatenate([np.sign(x.now)[None], 0.0 * x.terms[1:]])),
    "max": lambda *xs: reduce(lambda x, y: chosen(x, y, x.now >= y.now), xs),
    "min": lambda *xs: reduce(lambda x, y: chosen(x, y, x.now <= y.now), xs),
}
