"""Division of one polynomial by others: whatever equals something else is replaced by it."""

from __future__ import annotations

from collections.abc import Sequence
from math import gcd

from chasles.checker.sparse import MOST_POWER, Polynomial, Rejected, exponents, packed

Division = tuple[int, int, Polynomial]
"""The factors of a term, a bit above each of their exponents, and what the term equals."""
MOST_REPLACED = 10**6
"""So many terms are replaced at most when a polynomial is divided."""


def solved_for(factors: int, vanishing: Polynomial) -> Division:
    """What the term with these factors equals, where the polynomial vanishes."""
    terms = vanishing.terms
    common = gcd(*terms.values())
    rest = {monomial: -c // common for monomial, c in terms.items() if monomial != factors}
    guard = sum(packed(place, MOST_POWER + 1) for place, _ in exponents(factors))
    return factors, guard, Polynomial(rest, terms[factors] // common)


def divided(polynomial: Polynomial, divisions: Sequence[Division]) -> Polynomial:
    """What is left when each of the terms is replaced by what it equals, in turn, until none occurs any more."""
    replaced, before = 0, -1
    while before < replaced:
        before = replaced
        for factors, guard, equal in divisions:
            # No bit of the guard is borrowed from where the exponents of the factors are not larger.
            while found := {m for m in polynomial.terms if (m | guard) - factors & guard == guard}:
                quotient = {monomial - factors: polynomial.terms[monomial] for monomial in found}
                kept = {monomial: c for monomial, c in polynomial.terms.items() if monomial not in found}
                polynomial = Polynomial(kept, polynomial.below) + Polynomial(quotient, polynomial.below) * equal
                replaced += len(found)
                if replaced > MOST_REPLACED:
                    raise Rejected("there is no end to the division that the certificate asks for")
    return polynomial
