"""Polynomials that are positive for all real values of their variables, with the reason.

Either every term is a product of squares and of variables whose sign is known, or the polynomial is a sum of squares
and a positive number.
"""

from __future__ import annotations

from collections.abc import Mapping
from fractions import Fraction

from chasles.algebra import squares
from chasles.algebra.rings import Polynomial, Ring

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


def sum_of_squares(terms: Terms) -> list[tuple[Fraction, Terms]]:
    """A polynomial as a sum of positive multiples of squares; nothing if none is found."""
    return [(factor, base) for factor, _, base in squares.sum_of_squares(terms, ()) or ()]
