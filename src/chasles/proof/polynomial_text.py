"""Polynomials as text, for certificates: terms joined by " + ", factors by "*", the coefficient first."""

from __future__ import annotations

from chasles.proof.rings import Polynomial, Ring

__all__ = ["written"]


def written(ring: Ring, polynomial: Polynomial) -> str:
    """The polynomial, as -1/2*e_1^2*cos(phi) + 3; zero is 0."""
    terms = []
    for exponents, coefficient in sorted(ring.terms(polynomial), reverse=True):
        factors = [str(coefficient)]
        for name, exponent in zip(ring.names, exponents, strict=True):
            if exponent:
                factors.append(name if exponent == 1 else f"{name}^{exponent}")
        terms.append("*".join(factors))
    return " + ".join(terms) or "0"
