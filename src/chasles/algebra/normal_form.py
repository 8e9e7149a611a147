"""Division of a polynomial by several others, with cofactors: membership in the ideal of the hypotheses.

The multivariate division algorithm (Cox, Little and O'Shea, Ideals, Varieties, and Algorithms, Section 2.3): goal = sum
of cofactor times generator + remainder. If the generators are a Groebner basis a nonzero remainder means that the goal
is not in the ideal; a certificate does not depend on that.
"""

from __future__ import annotations

from collections.abc import Sequence
from fractions import Fraction
from math import comb
from operator import ge

from chasles.algebra.rings import Exponents, Polynomial, Ring
from chasles.algebra.work_limit import afford, check, spend

LARGE = 2_000
"""So many products of terms are worth to be counted while they are formed."""


def reduce_by(
    ring: Ring, polynomial: Polynomial, generators: Sequence[Polynomial], leads: Sequence[Exponents] | None = None
) -> tuple[dict[int, Polynomial], Polynomial]:
    """Cofactors of the generators, and what is left of the polynomial, reduced by them until none divides a term of it.

    `leads` are the exponents of the generators' leading terms, where the caller knows them already.
    """
    leads = leads_of(ring, generators) if leads is None else leads
    cofactors: dict[int, Polynomial] = {}
    changed = True
    while changed and polynomial != 0:
        changed = False
        degrees = ring.degrees(polynomial)
        for place, (generator, lead) in enumerate(zip(generators, leads, strict=True)):
            check()
            if not all(map(ge, degrees, lead)):
                continue
            quotient, remainder = _divided(ring, polynomial, generator, lead, degrees)
            if quotient != 0:
                cofactors[place] = cofactors[place] + quotient if place in cofactors else quotient
                polynomial = remainder
                changed = True
                if polynomial == 0:
                    break
                degrees = ring.degrees(polynomial)
    return {k: c for k, c in cofactors.items() if c != 0}, polynomial


def _divided(
    ring: Ring, polynomial: Polynomial, generator: Polynomial, lead: Exponents, degrees: Exponents
) -> tuple[Polynomial, Polynomial]:
    """Quotient and remainder; large ones step by step where nothing says how often the leading term comes back."""
    if len(polynomial) * len(generator) > LARGE:
        rest = ring.degrees(generator - ring.from_terms({lead: ring.leading(generator)[1]}))
        if any(lead) and all(map(ge, rest, lead)):
            return _by_steps(ring, polynomial, generator, lead)
    # At most so often does the leading term occur in a term; each time the others take its place.
    times = min((degree // own for degree, own in zip(degrees, lead, strict=False) if own), default=1)
    afford(len(polynomial) * comb(len(generator) + times - 2, times) if times > 1 else 0)
    quotient, remainder = ring.divide(polynomial, generator)
    _count(ring, quotient, generator)
    return quotient, remainder


def _by_steps(
    ring: Ring, polynomial: Polynomial, generator: Polynomial, lead: Exponents
) -> tuple[Polynomial, Polynomial]:
    """Quotient and remainder, with all terms replaced at once that the leading term divides, again and again."""
    total, first = ring.constant(Fraction(0)), ring.from_terms({lead: ring.leading(generator)[1]})
    while True:
        quotient, _ = ring.divide(polynomial, first)
        if quotient == 0:
            return total, polynomial
        _count(ring, quotient, generator)
        polynomial, total = polynomial - quotient * generator, total + quotient


def _count(ring: Ring, quotient: Polynomial, generator: Polynomial) -> None:
    if quotient != 0:
        spend(len(quotient) * _words(ring, quotient) * len(generator) * _words(ring, generator))


def leads_of(ring: Ring, generators: Sequence[Polynomial]) -> tuple[Exponents, ...]:
    """The exponents of the leading terms."""
    return tuple(ring.leading(generator)[0] for generator in generators)


def _words(ring: Ring, polynomial: Polynomial) -> int:
    """How many machine words a coefficient takes, judged by the leading one: so much longer takes a product."""
    coefficient = ring.leading(polynomial)[1]
    return 1 + (coefficient.numerator.bit_length() + coefficient.denominator.bit_length()) // 64
