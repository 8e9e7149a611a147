"""What may the machine do to a value? The rounding model under which every bound is proved."""

from __future__ import annotations

from dataclasses import dataclass
from fractions import Fraction

from chasles.lowering.program import Op

__all__ = ["DOUBLE", "SINGLE", "Model"]


@dataclass(frozen=True, slots=True)
class Model:
    """Each operation returns its exact result times 1 + d, |d| <= `roundoff`; a function is within its `ulps` units.

    A function is what rounding to nearest makes of something within `excess`, which is half a unit less. A unit in the
    last place is at most twice the roundoff of the value. A contracted a b + c rounds once where the
    model lets it round twice, so that contraction is allowed and never needed. Nothing overflows, and nothing
    underflows but where `least` says by how much a result below the smallest normal number is rounded.
    """

    roundoff: Fraction
    ulps: Fraction = Fraction(4, 5)
    least: Fraction = Fraction(0)

    def __post_init__(self) -> None:
        if not 0 < self.roundoff <= Fraction(1, 2**20):
            raise ValueError(f"a roundoff lies between 0 and 2^-20, not at {self.roundoff}")
        if not 0 <= self.ulps <= 2**10:
            raise ValueError(f"a function is within 0 to 1024 units in the last place, not {self.ulps}")

    def loss(self, op: Op) -> Fraction:
        """The largest relative error of the operation itself."""
        if op in (Op.SINE, Op.COSINE, Op.ARCTANGENT2):
            return 2 * self.ulps * self.roundoff
        return self.roundoff

    @property
    def rounding(self) -> Fraction:
        """By how much a function is rounded, in parts of the power of two below what is rounded."""
        return min(2 * self.ulps, Fraction(1)) * self.roundoff

    @property
    def excess(self) -> Fraction:
        """How far what a function rounds is from its value, in parts of the power of two below the value."""
        return 2 * self.ulps * self.roundoff - self.rounding

    def is_exact(self, value: Fraction) -> bool:
        """Whether a constant is a number of the precision."""
        above, below = abs(value.numerator), value.denominator
        odd = above // (above & -above) if above else 0
        return below & (below - 1) == 0 and odd * self.roundoff <= 1


DOUBLE = Model(Fraction(1, 2**53))
SINGLE = Model(Fraction(1, 2**24))
"""What is proved here holds in double precision too: a bound in units of the roundoff grows with the roundoff."""
