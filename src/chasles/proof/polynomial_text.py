"""Polynomials as text, for certificates: terms joined by " + ", factors by "*", the coefficient first.

Names are written without blanks, so that " + " in the name of a norm is not read as the end of a term, and the factors
of a moment in alphabetical order.
"""

from __future__ import annotations

from chasles.proof.rings import Polynomial, Ring

__all__ = ["written"]


def written(ring: Ring, polynomial: Polynomial) -> str:
    """The polynomial, as -1/2*e_1^2*cos(phi) + 3; zero is 0."""
    names = [_squeezed(name) for name in ring.names]
    terms = []
    for exponents, coefficient in sorted(ring.terms(polynomial), reverse=True):
        factors = [str(coefficient)]
        for name, exponent in zip(names, exponents, strict=True):
            if exponent:
                factors.append(name if exponent == 1 else f"{name}^{exponent}")
        terms.append("*".join(factors))
    return " + ".join(terms) or "0"


def _squeezed(name: str) -> str:
    """The name as a certificate spells it: int(rho p_1 p_1) becomes int(p_1.p_1.rho)."""
    if name.startswith("int(") and name.endswith(")"):
        return f"int({'.'.join(sorted(name[4:-1].split()))})"
    return name.replace(" ", "")
