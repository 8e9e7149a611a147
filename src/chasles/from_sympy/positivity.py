"""Polynomials that are positive for all real values of their variables, with the reason.

Either every term is a product of squares and of variables whose sign is known, or the polynomial is a sum of squares
and a positive number, by completing squares (Lagrange's reduction).
"""

from __future__ import annotations

from collections.abc import Mapping
from fractions import Fraction
from itertools import product

from chasles.algebra.rings import Polynomial, Ring

MOST_SQUARES, MOST_TERMS = 3, 16
Exponents = tuple[int, ...]
Terms = Mapping[Exponents, Fraction]

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
    terms = dict(ring.terms(polynomial))
    return [] if is_definite(terms) or is_definite({exponents: -c for exponents, c in terms.items()}) else None


def is_definite(terms: Terms) -> bool:
    """Whether a polynomial, given by its terms, is a sum of squares and a positive number, by completing squares."""
    return any(not any(exponents) for _, base in sum_of_squares(terms) for exponents in base if len(base) == 1)


def sum_of_squares(terms: Terms, squares: int = MOST_SQUARES) -> list[tuple[Fraction, Terms]]:
    """A polynomial as a sum of positive multiples of squares, by completing these; nothing if none is found."""
    bad = [m for m, c in terms.items() if c < 0 or any(power % 2 for power in m)]
    if not bad:
        return [(c, {tuple(power // 2 for power in m): Fraction(1)}) for m, c in terms.items()]
    for square in terms if squares and len(terms) < MOST_TERMS else ():
        half = tuple(power // 2 for power in square)
        if square in bad or not any(half):
            continue
        crossed = [m for m in bad if all(a >= b for a, b in zip(m, half, strict=True))]
        rest = _without_square(terms, square, crossed) if crossed else {}
        found = sum_of_squares(rest, squares - 1) if rest else []
        if found or (crossed and not rest):
            c = terms[square]
            sides = {tuple(a - b for a, b in zip(m, half, strict=True)): terms[m] / (2 * c) for m in crossed}
            return [(c, {half: Fraction(1), **sides}), *found]
    return []


def _without_square(terms: Terms, square: Exponents, crossed: list[Exponents]) -> dict[Exponents, Fraction]:
    """What c (m + b/2c)^2 leaves, where c m^2 is one of the terms and m b are others: -b^2/4c and the rest."""
    half = [power // 2 for power in square]
    rest = {m: c for m, c in terms.items() if m != square and m not in crossed}
    for one, other in product(crossed, repeat=2):
        m = tuple(i + j - 2 * k for i, j, k in zip(one, other, half, strict=True))
        rest[m] = rest.get(m, Fraction(0)) - terms[one] * terms[other] / (4 * terms[square])
    return {m: c for m, c in rest.items() if c}
