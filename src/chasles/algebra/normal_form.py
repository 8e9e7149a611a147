"""Division of a polynomial by several others, with cofactors: membership in the ideal of the hypotheses.

The multivariate division algorithm (Cox, Little and O'Shea, Ideals, Varieties, and Algorithms, Section 2.3): goal = sum
of cofactor times generator + remainder. If the generators are a Groebner basis a nonzero remainder means that the goal
is not in the ideal; a certificate does not depend on that.
"""

from __future__ import annotations

from collections.abc import Sequence
from math import comb

from chasles.algebra.rings import Exponents, Polynomial, Ring
from chasles.algebra.work_limit import afford, check, spend


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
            times = _times(degrees, lead)
            if not times:
                continue
            afford(_growth(polynomial, generator, times))
            quotient, remainder = ring.divide(polynomial, generator)
            if quotient != 0:
                spend(len(quotient) * _words(ring, quotient) * len(generator) * _words(ring, generator))
            if quotient != 0:
                cofactors[place] = cofactors[place] + quotient if place in cofactors else quotient
                polynomial = remainder
                changed = True
                if polynomial == 0:
                    break
                degrees = ring.degrees(polynomial)
    return {k: c for k, c in cofactors.items() if c != 0}, polynomial


def leads_of(ring: Ring, generators: Sequence[Polynomial]) -> tuple[Exponents, ...]:
    """The exponents of the leading terms."""
    return tuple(ring.leading(generator)[0] for generator in generators)


def _words(ring: Ring, polynomial: Polynomial) -> int:
    """How many machine words a coefficient takes, judged by the leading one: so much longer takes a product."""
    coefficient = ring.leading(polynomial)[1]
    return 1 + (coefficient.numerator.bit_length() + coefficient.denominator.bit_length()) // 64


def _times(degrees: Exponents, lead: Exponents) -> int:
    """At most so often does the leading term occur in a term of a polynomial of these degrees; a constant does once."""
    return min((degree // exponent for degree, exponent in zip(degrees, lead, strict=False) if exponent), default=1)


def _growth(polynomial: Polynomial, generator: Polynomial, times: int) -> int:
    """At most so many terms arise when the generator's leading term is replaced by the others as often as it occurs."""
    return len(polynomial) * comb(len(generator) + times - 2, times) if times > 1 else 0
