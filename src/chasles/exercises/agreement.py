"""Whether an answer agrees with the expected one: number by number, exactly or within a tolerance, or undecided."""

from __future__ import annotations

from collections.abc import Iterable, Iterator
from functools import cached_property
from itertools import chain
from typing import Any

import sympy as sp
from mpmath.libmp import round_nearest, to_int

from chasles.exact.enclosures import NoEnclosure, enclosed
from chasles.exact.numbers import NotDecided, is_zero
from chasles.exact.polynomial_roots import Root
from chasles.exact.tower import TooManyRoots

BITS = 256


class Equality:
    """Whether two numbers are equal: exactly, or, with a tolerance, up to so much of the largest number of a value.

    Where all numbers of the value are zero, the tolerance is absolute; angles are compared up to whole turns. None
    where nothing decides it.
    """

    def __init__(self, tolerance: Any, value: Any, is_angle: bool = False) -> None:
        self.is_exact = tolerance is None
        self._tolerance, self._value, self._is_angle = tolerance, value, is_angle

    def __call__(self, one: Any, other: Any) -> bool | None:
        try:
            difference = _without_turns(other - one) if self._is_angle else other - one
            if self.is_exact:
                return is_zero(difference)
            return not abs(enclosed(difference, BITS)) > self._allowed
        except (NoEnclosure, NotDecided, TooManyRoots, RecursionError):
            return None

    @cached_property
    def _allowed(self) -> Any:
        sizes = [size for number in _numbers(self._value) if (size := abs(enclosed(number, BITS))) > 0]
        return enclosed(self._tolerance, BITS) * max(sizes, key=lambda size: size.mid, default=1)


def agree(expected: Any, given: Any, equal: Equality) -> bool | None:
    """Whether an answer is the expected one; words and truth values are if they are the same."""
    match expected:
        case None | bool() | str():
            return bool(expected == given)
        case dict():
            return isinstance(given, dict) and _all(agree(expected[key], given[key], equal) for key in expected)
        case list():
            if not isinstance(given, list) or len(expected) != len(given):
                return False
            return _all(agree(one, other, equal) for one, other in zip(expected, given, strict=True))
    return isinstance(given, sp.Expr) and equal(expected, given)


def are_along_axes(matrix: Any, moments: Any, rows: Any, equal: Equality) -> bool | None:
    """Whether the rows are principal axes of the matrix, of any length, normal to each other, in the moments' order."""
    zero, size = sp.Integer(0), range(len(rows))
    exact = Equality(None, zero)
    # A row that may be zero is no axis, so that where nothing decides it, this does not either.
    lengths = [_all(exact(zero, entry) for entry in row) for row in rows]
    if True in lengths:
        return False
    units = rows if equal.is_exact else [[entry / sp.sqrt(_product(row, row)) for entry in row] for row in rows]
    own = (equal(moments[i] * units[i][j], _product(matrix[j], units[i])) for i in size for j in size)
    normal = (equal(zero, _product(units[i], units[j])) for i in size for j in range(i))
    return _all(chain(own, normal, (None for length in lengths if length is None)))


def in_lists(value: Any) -> Any:
    """Matrices as lists, of rows or of the entries of a column; roots as SymPy has them."""
    match value:
        case sp.MatrixBase():
            return list(value) if value.cols == 1 else value.tolist()
        case list() | tuple():
            return [in_lists(part) for part in value]
        case dict():
            return {key: in_lists(part) for key, part in value.items()}
        case Root():
            return value.value
        case _:
            return value


def opposite(value: Any) -> Any:
    """With the other sign, each number of it."""
    if isinstance(value, list):
        return [opposite(part) for part in value]
    return -value if isinstance(value, sp.Expr) else value


def _all(verdicts: Iterable[bool | None]) -> bool | None:
    found: bool | None = True
    for verdict in verdicts:
        if verdict is False:
            return False
        found = found if verdict else None
    return found


def _without_turns(angle: Any) -> Any:
    """The angle less the whole turns that leave it smallest. Raises NoEnclosure."""
    turns = enclosed(angle / (2 * sp.pi), BITS)
    if not turns.delta < 0.25:
        raise NoEnclosure(angle)
    return angle - 2 * sp.pi * int(to_int(turns.mid._mpi_[0], round_nearest))


def _product(one: Any, other: Any) -> Any:
    return sp.Add(*(a * b for a, b in zip(one, other, strict=True)))


def _numbers(value: Any) -> Iterator[Any]:
    if isinstance(value, list | dict):
        for part in value.values() if isinstance(value, dict) else value:
            yield from _numbers(part)
    elif isinstance(value, sp.Expr):
        yield value
