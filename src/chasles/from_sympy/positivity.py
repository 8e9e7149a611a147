"""Polynomials that are positive for all real values of their variables, with the reason.

Either every term is a product of squares and of variables whose sign is known, or the polynomial is quadratic and a sum
of squares and a positive number, by completing squares (Lagrange's reduction).
"""

from __future__ import annotations

from collections.abc import Mapping
from fractions import Fraction

from chasles.algebra.rings import Polynomial, Ring

__all__ = ["definite_by"]

Signs = Mapping[int, tuple[int, bool]]
"""By the place of a variable its sign, and whether it cannot vanish either."""


def definite_by(ring: Ring, polynomial: Polynomial, signs: Signs) -> list[int] | None:
    """The places of the variables by whose signs the polynomial is positive, or negative; None if it may vanish."""
    found = _by_terms(ring, polynomial, signs)
    return _by_squares(ring, polynomial) if found is None else found


def _by_terms(ring: Ring, polynomial: Polynomial, signs: Signs) -> list[int] | None:
    used: dict[int, None] = {}
    found: set[int] = set()
    strict = False
    for exponents, coefficient in ring.terms(polynomial):
        sign = 1 if coefficient > 0 else -1
        for place, exponent in enumerate(exponents):
            if exponent % 2:
                if place not in signs:
                    return None
                used[place] = None
                sign *= signs[place][0]
        found.add(sign)
        occurring = [place for place, exponent in enumerate(exponents) if exponent]
        if all(place in signs and signs[place][1] for place in occurring):
            strict = True
            used |= dict.fromkeys(occurring)
    return list(used) if strict and len(found) == 1 else None


def _by_squares(ring: Ring, polynomial: Polynomial) -> list[int] | None:
    terms = ring.terms(polynomial)
    if any(sum(exponents) > 2 for exponents, _ in terms):
        return None
    places = [k for k in range(len(ring.names)) if any(exponents[k] for exponents, _ in terms)]
    size = len(places)
    form = [[Fraction(0)] * (size + 1) for _ in range(size + 1)]
    for exponents, coefficient in terms:
        ends = [i for i, k in enumerate(places) for _ in range(exponents[k])]
        i, j = (*ends, size, size)[:2]
        form[i][j] += coefficient / 2
        form[j][i] += coefficient / 2
    sign = 1 if form[size][size] > 0 else -1
    form = [[sign * entry for entry in row] for row in form]
    for k in range(size):
        if form[k][k] < 0 or (form[k][k] == 0 and any(form[k][k:])):
            return None
        for i in range(k + 1, size + 1):
            factor = form[i][k] / form[k][k] if form[k][k] else Fraction(0)
            form[i] = [a - factor * b for a, b in zip(form[i], form[k], strict=True)]
    return [] if form[size][size] > 0 else None
