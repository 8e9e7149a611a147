"""What may the machine do to a value? The rounding model under which every bound is proved.

It is the standard model of floating-point arithmetic: Higham, Accuracy and Stability of Numerical Algorithms, 2.2.
"""

from __future__ import annotations

from collections.abc import Collection
from dataclasses import dataclass, replace
from fractions import Fraction
from typing import Any

import numpy as np

from chasles.bounds.functions import ENCLOSED
from chasles.lowering.program import Op

IN_NUMPY = 4
"""Units in the last place within which NumPy holds its functions of vectors, as its own tests of accuracy have it."""


@dataclass(frozen=True, slots=True)
class Model:
    """Each operation returns its exact result times 1 + d, |d| <= `roundoff`.

    Sine and cosine are within `ulps` units in the last place, the arctangent within `directions`, what else libm has
    within what is known of it, or within `others` where that is more: they are what rounding to nearest makes of
    something within that less one half. A unit in the last place is at most twice the roundoff of the value. A
    contracted a b + c rounds once where the model lets it round twice, so that contraction is allowed and never needed.
    Nothing overflows, and nothing underflows but where `least` says by how much a result below the smallest normal
    number is rounded.
    """

    roundoff: Fraction
    ulps: Fraction = Fraction(4, 5)
    directions: Fraction = Fraction(1)
    least: Fraction = Fraction(0)
    others: int = 0

    def __post_init__(self) -> None:
        if not 0 < self.roundoff <= Fraction(1, 2**10):
            raise ValueError(f"a roundoff lies between 0 and 2^-10, not at {self.roundoff}")
        for ulps in (self.ulps, self.directions):
            if not 0 <= ulps <= 2**10:
                raise ValueError(f"a function is within 0 to 1024 units in the last place, not {ulps}")

    def loss(self, op: Op) -> Fraction:
        """The largest relative error of the operation itself."""
        return (1 + self.excess(op)) * (1 + self.rounding(op)) - 1

    def rounding(self, op: Op, function: str = "") -> Fraction:
        """By how much a result is rounded, in parts of the largest power of two below what is rounded."""
        return min(2 * self._within(op, function), Fraction(1)) * self.roundoff

    def excess(self, op: Op, function: str = "") -> Fraction:
        """How far what a function rounds is from its value, in parts of the largest power of two below the value."""
        return 2 * self._within(op, function) * self.roundoff - self.rounding(op, function)

    def _within(self, op: Op, function: str) -> Fraction:
        if op in (Op.SINE, Op.COSINE):
            return self.ulps
        if op is Op.FUNCTION:
            return Fraction(max(ENCLOSED[function].ulps, self.others))
        return self.directions if op is Op.ARCTANGENT2 else Fraction(1, 2)

    def in_words(self, operations: Collection[Op]) -> str:
        """What is supposed of the machine, as far as it concerns these operations."""
        said = ["every operation rounded to nearest, with or without FMA"]
        turns = [op.value for op in (Op.SINE, Op.COSINE) if op in operations]
        if turns:
            said.append(f"{' and '.join(turns)} within {float(self.ulps):g} ulp")
        if Op.ARCTANGENT2 in operations:
            said.append(f"arctangent within {float(self.directions):g} ulp")
        if Op.FUNCTION in operations:
            said.append("other functions within what is known of the GNU C library's")
        return ", ".join(said)

    def is_exact(self, value: Fraction) -> bool:
        """Whether a constant is a number of the precision."""
        above, below = abs(value.numerator), value.denominator
        odd = above // (above & -above) if above else 0
        return below & (below - 1) == 0 and odd * self.roundoff <= 1


DOUBLE = Model(Fraction(1, 2**53))
SINGLE = Model(Fraction(1, 2**24))
"""What is proved here holds in double precision too: a bound in units of the roundoff grows with the roundoff."""


def precision(dtype: Any, *, in_numpy: bool = False) -> tuple[Model, float]:
    """The model of float64 or float32 with gradual underflow, and the largest number.

    Functions are those of the C library, or what is in NumPy. Raises ValueError for other types.
    """
    try:
        wanted = np.dtype(dtype)
    except TypeError:
        wanted = None
    if wanted not in (np.float64, np.float32):
        raise ValueError(f"errors are bounded for float64 and float32, not for {dtype!r}")
    limits = np.finfo(wanted)
    unit = DOUBLE.roundoff if wanted == np.float64 else SINGLE.roundoff
    # Half of the smallest number is none in double precision: the whole of it stands for it.
    model = Model(unit, least=Fraction(float(limits.smallest_subnormal)))
    if in_numpy:
        model = replace(model, ulps=Fraction(IN_NUMPY), directions=Fraction(IN_NUMPY), others=IN_NUMPY)
    return model, float(limits.max)
