"""Equations that give a variable as a polynomial in others: they are substituted before any division."""

from __future__ import annotations

from collections.abc import Iterable, Sequence
from fractions import Fraction

from chasles.algebra.rings import Polynomial, Ring
from chasles.algebra.work_limit import afford

Explicit = tuple[int, int, Polynomial]
"""The place of an equation, the place of a variable, and the variable less its value."""


def explicit(ring: Ring, equations: Sequence[Polynomial], places: Iterable[int]) -> list[Explicit]:
    """The equations in which the variable that ranks highest occurs alone, in one term: not in each other's values.

    Only those at the given places are looked at.
    """
    found: list[Explicit] = []
    for k in places:
        equation = equations[k]
        terms = ring.terms(equation)
        place = min((j for exponents, _ in terms for j, e in enumerate(exponents) if e), default=None)
        own = [(sum(exponents), c) for exponents, c in terms if place is not None and exponents[place]]
        if place is not None and len(terms) > 1 and len(own) == 1 and own[0][0] == 1:
            taken = any(place == other or ring.degrees(known)[place] for _, other, known in found)
            if not taken and not any(ring.degrees(equation)[other] for _, other, _ in found):
                found.append((k, place, equation * ring.constant(Fraction(1) / own[0][1])))
    return found


def put_in(ring: Ring, polynomial: Polynomial, values: Sequence[Explicit]) -> tuple[dict[int, Polynomial], Polynomial]:
    """The polynomial with these values put in, and the cofactors of the equations."""
    cofactors: dict[int, Polynomial] = {}
    for k, place, equation in values:
        while polynomial != 0 and ring.degrees(polynomial)[place]:
            lowered = {
                tuple(e - (j == place) for j, e in enumerate(exponents)): c
                for exponents, c in ring.terms(polynomial)
                if exponents[place]
            }
            cofactor = ring.from_terms(lowered)
            afford(len(lowered) * len(equation))
            polynomial = polynomial - cofactor * equation
            cofactors[k] = cofactors[k] + cofactor if k in cofactors else cofactor
    return cofactors, polynomial
