"""What is said of exponentials that may overflow or meet, and which steps compute it."""

from __future__ import annotations

from collections.abc import Sequence
from fractions import Fraction
from functools import reduce
from math import factorial

import sympy

from chasles.lowering.builder import Builder

_TERMS = 16
"""So many are enough where numbers are at most a half."""


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
