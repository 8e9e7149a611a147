"""What is said of exponentials that may overflow or meet, and which steps compute it.

Over all differences of three and more points they are divided differences: the solution of a chain of decays (Bateman,
1910). Of points that are close that is a series in their complete homogeneous polynomials, of others the difference of
two of fewer points (McCurdy, Ng and Parlett, Accurate computation of divided differences of the exponential function,
1984).
"""

from __future__ import annotations

from collections.abc import Sequence
from fractions import Fraction
from functools import reduce
from math import factorial
from typing import Any

import sympy

from chasles.lowering.builder import Builder

_TERMS = 16
"""So many are enough where numbers are at most a half."""
_MOST_POINTS = 6


class HeldLargest(sympy.Function):  # type: ignore[misc]
    """The largest of some numbers, zero where it is infinite; a constant in derivatives: nothing depends on it."""

    is_real = True


class Apart(sympy.Function):  # type: ignore[misc]
    """The difference of two numbers, zero where both are the same infinity."""

    is_real = True


class DividedExponential(sympy.Function):  # type: ignore[misc]
    """The divided difference of the exponential at some points, which may meet."""

    is_real = True


def held_largest(build: Builder, *many: int) -> int:
    """The step of the largest."""
    most = reduce(lambda a, b: build.select(build.less(a, b), b, a), many)
    return build.held(build.select(build.equal(build.subtract(most, most), build.zero), most, build.zero))


def apart(build: Builder, a: int, b: int) -> int:
    """The step of the difference, which changes as it does."""
    difference = build.subtract(a, b)
    return build.rate_by(build.select(build.equal(a, b), build.zero, difference), (difference, build.one))


def divided_exponential(build: Builder, points: list[int]) -> int:
    """Of points in their order: a series where they are close, elsewhere the difference of those of fewer points."""
    for end in range(len(points) - 1, 0, -1):
        for k in range(end):
            a, b = points[k : k + 2]
            turned = build.less(b, a)
            points[k : k + 2] = build.select(turned, b, a), build.select(turned, a, b)
    found = [build.function("exp", point) for point in points]
    for more in range(1, len(points)):
        for k in range(len(points) - more):
            between = points[k : k + more + 1]
            apart = build.subtract(between[-1], between[0])
            far = build.divide(build.subtract(found[k + 1], found[k]), apart)
            found[k] = build.select(build.less(apart, build.one), _series_of_exponential(build, between), far)
    return found[0]


def _series_of_exponential(build: Builder, points: Sequence[int]) -> int:
    """The exponential at the middle of the points times their complete homogeneous polynomials over factorials."""
    middle = build.multiply(build.constant(Fraction(1, 2)), build.add(points[0], points[-1]))
    homogeneous = [build.one] + [build.zero] * (_TERMS - 1)
    for point in points:
        away = build.subtract(point, middle)
        for k in range(1, _TERMS):
            homogeneous[k] = build.add(homogeneous[k], build.multiply(away, homogeneous[k - 1]))
    weights = (build.constant(Fraction(1, factorial(k + len(points) - 1))) for k in range(_TERMS))
    terms = [build.multiply(weight, each) for weight, each in zip(weights, homogeneous, strict=True)]
    return build.multiply(build.function("exp", middle), reduce(build.add, reversed(terms)))


def with_points_together(total: Any) -> Any:
    """The sum; terms that are one exponential's at all points, over their differences, are its divided difference."""
    found: dict[Any, dict[Any, Any]] = {}
    for term in total.args:
        split = _split(term)
        if split is not None:
            point, *of = split
            found.setdefault(tuple(of), {})[point] = term
    for (points, slope, rest), terms in found.items():
        if terms.keys() == points:
            nodes = [slope * point for point in sorted(points, key=sympy.default_sort_key)]
            others = (term for term in total.args if term not in terms.values())
            return sympy.Add(rest * slope ** (len(nodes) - 1) * DividedExponential(*nodes), *others)
    return total


def _split(term: Any) -> tuple[Any, frozenset[Any], Any, Any] | None:
    """The point that a term is at, all points, the slope of its exponent, and its factors that are no difference."""
    factors = sympy.Mul.make_args(term)
    exponents = [f.exp for f in factors if isinstance(f, sympy.exp)]
    below = [f for f in factors if f.is_Pow and f.exp == -1 and _is_difference(f.base)]
    points = frozenset[Any]().union(*(f.free_symbols for f in below))
    shared = points.intersection(*(f.free_symbols for f in below))
    if len(exponents) != 1 or not 1 < len(below) < _MOST_POINTS or len(shared) != 1 or len(points) != len(below) + 1:
        return None
    [point], exponent = shared, exponents[0].expand()
    slope = exponent.coeff(point)
    left = exponent - slope * point
    if slope == 0 or not points.isdisjoint(slope.free_symbols | left.free_symbols):
        return None
    signs = [f.base.coeff(point) for f in below]
    others = [f for f in factors if f not in below and not isinstance(f, sympy.exp)]
    return point, points, slope, sympy.Mul(*signs, sympy.exp(left), *others)


def _is_difference(base: Any) -> bool:
    return (
        base.is_Add
        and sorted(base.as_coefficients_dict().values()) == [-1, 1]
        and all((term if term.is_Symbol else -term).is_Symbol for term in base.args)
    )
