"""Sums over three and more points of exponentials over all differences of the points, which may meet.

The sum of exp(u_k)/prod(u_k - u_j) is a divided difference of the exponential: the solution of a chain of decays
(Bateman, 1910). Of points that are close it is a series in their complete homogeneous polynomials, of others the
difference of two of fewer points (McCurdy, Ng and Parlett, Accurate computation of divided differences of the
exponential function, 1984).
"""

from __future__ import annotations

from typing import Any

import sympy

from chasles.compiling.exponentials import DividedExponential

_MOST_POINTS = 6


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
