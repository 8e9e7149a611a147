"""Polynomials from the text of a certificate."""

from __future__ import annotations

from collections.abc import Mapping
from fractions import Fraction

from chasles.proof.recheck.sparse import ZERO, Polynomial, Rejected, number, variable

__all__ = ["parsed", "powered"]

LARGEST_EXPONENT = 127


def parsed(text: str, places: Mapping[str, int]) -> Polynomial:
    """A polynomial in the variables with these places, from text such as -1/2*e_1^2*cos(phi) + 3."""
    total = ZERO
    for term in text.split(" + "):
        coefficient, *factors = term.split("*")
        product = number(Fraction(coefficient))
        for factor in factors:
            name, _, power = (factor, "", "1") if factor in places else factor.rpartition("^")
            if name not in places:
                raise Rejected(f"the certificate has a factor {factor!r}, which is no power of a variable")
            product *= powered(places[name], power)
        total += product
    return total


def powered(place: int, power: str | int) -> Polynomial:
    """A power of a variable; raises `Rejected` for an exponent that is none."""
    if not 1 <= int(power) <= LARGEST_EXPONENT:
        raise Rejected(f"the certificate has {power!r} where an exponent from 1 to 127 is due")
    return variable(place, int(power))
