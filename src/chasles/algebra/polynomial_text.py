"""Polynomials as text, for certificates: terms joined by " + ", factors by "*", the coefficient first.

Names are written without blanks, so that " + " in the name of a norm is not read as the end of a term, and the factors
of a moment in alphabetical order.
"""

from __future__ import annotations

from chasles.algebra.rings import Polynomial, Ring


def written(ring: Ring, polynomial: Polynomial) -> str:
    """The polynomial, as -1/2*e_1^2*cos(phi) + 3; zero is 0."""
    terms = []
    for exponents, coefficient in sorted(ring.terms(polynomial), reverse=True):
        factors = factors_text(ring, exponents)
        terms.append(f"{coefficient}*{factors}" if factors else str(coefficient))
    return " + ".join(terms) or "0"


def factors_text(ring: Ring, exponents: tuple[int, ...]) -> str:
    """A product of powers of the variables, as e_1^2*cos(phi); nothing where there are none."""
    powers = [(_squeezed(name), power) for name, power in zip(ring.names, exponents, strict=False) if power]
    return "*".join(name if power == 1 else f"{name}^{power}" for name, power in powers)


def _squeezed(name: str) -> str:
    """The name as a certificate spells it: int(rho p_1 p_1) becomes int(p_1.p_1.rho)."""
    if name.startswith("int(") and name.endswith(")"):
        return f"int({'.'.join(sorted(name[4:-1].split()))})"
    return name.replace(" ", "")
