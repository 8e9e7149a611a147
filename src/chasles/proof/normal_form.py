"""Is a polynomial in the ideal of the hypotheses, and with which cofactors?

Reduction by the generators one at a time, until nothing changes: goal = sum of cofactor times generator + remainder.
If the generators are a Groebner basis a nonzero remainder means that the goal is not in the ideal; a certificate does
not depend on that.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass
from math import comb

from chasles.proof.deadline import afford, check
from chasles.proof.rings import Polynomial, Ring

__all__ = ["Reduction", "reduce_by"]


@dataclass(frozen=True, slots=True)
class Reduction:
    """goal = sum of cofactors[k] * generators[k] + remainder."""

    cofactors: dict[int, Polynomial]
    remainder: Polynomial

    @property
    def is_zero(self) -> bool:
        return bool(self.remainder == 0)


def reduce_by(ring: Ring, polynomial: Polynomial, generators: Sequence[Polynomial]) -> Reduction:
    """The polynomial reduced by the generators, in their order, until none divides a term of it."""
    cofactors: dict[int, Polynomial] = {}
    changed = True
    while changed and polynomial != 0:
        changed = False
        for place, generator in enumerate(generators):
            check()
            afford(_growth(ring, polynomial, generator))
            quotient, remainder = ring.divide(polynomial, generator)
            if quotient != 0:
                cofactors[place] = cofactors[place] + quotient if place in cofactors else quotient
                polynomial = remainder
                changed = True
                if polynomial == 0:
                    break
    return Reduction({k: c for k, c in cofactors.items() if c != 0}, polynomial)


def _growth(ring: Ring, polynomial: Polynomial, generator: Polynomial) -> int:
    """At most so many terms arise when the generator's leading term is replaced by the others as often as it occurs."""
    lead = ring.leading(generator)[0]
    degrees = ring.degrees(polynomial)
    times = min((degree // exponent for degree, exponent in zip(degrees, lead, strict=False) if exponent), default=0)
    return len(polynomial) * comb(len(generator) + times - 2, times) if times > 1 else 0
