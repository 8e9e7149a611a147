"""Sums of rational multiples of square roots, for the checker's points: zero only if every coefficient is."""

from __future__ import annotations

import re
from dataclasses import dataclass
from fractions import Fraction
from math import gcd, isqrt

from chasles.proof.recheck.sparse import Rejected

__all__ = ["Surd", "exact"]

TERM = re.compile(r"([+-]?)(?:(\d+)\*)?(?:(\d+)|sqrt\((\d+)\))(?:/(\d+))?")
LARGEST = 10**9
"""Radicands are tested for squares by trial, up to this one."""


@dataclass(frozen=True, slots=True)
class Surd:
    """Coefficients by radicand: roots of different squarefree numbers are linearly independent over the rationals."""

    terms: dict[int, Fraction]

    def __bool__(self) -> bool:
        return bool(self.terms)

    def __add__(self, other: Surd | Fraction | int) -> Surd:
        total = dict(self.terms)
        for radicand, coefficient in _terms(other).items():
            total[radicand] = total.get(radicand, Fraction(0)) + coefficient
        return Surd({radicand: c for radicand, c in total.items() if c})

    def __mul__(self, other: Surd | Fraction | int) -> Surd:
        total = Surd({})
        for m, a in self.terms.items():
            for n, b in _terms(other).items():
                shared = gcd(m, n)
                total += Surd({m * n // shared**2: a * b * shared})
        return total

    __radd__, __rmul__ = __add__, __mul__

    def __truediv__(self, divisor: int) -> Surd:
        return self * Fraction(1, divisor)

    def __pow__(self, exponent: int) -> Surd:
        total = Surd({1: Fraction(1)})
        for _ in range(exponent):
            total *= self
        return total

    def __lt__(self, other: int) -> bool:
        rest, digits = self + -other, 64
        while rest:
            # Each root lies between two rational numbers, as close as so many binary digits make them.
            ends = [
                (Fraction(isqrt(n * 4**digits), 2**digits), Fraction(1, 2**digits), c) for n, c in rest.terms.items()
            ]
            middle = sum((low * c for low, _, c in ends), Fraction(0))
            doubt = sum((gap * abs(c) for _, gap, c in ends), Fraction(0))
            if abs(middle) > doubt:
                return middle < 0
            digits *= 2
        return False


def _terms(number: Surd | Fraction | int) -> dict[int, Fraction]:
    return number.terms if isinstance(number, Surd) else {1: Fraction(number)} if number else {}


def exact(text: str) -> Fraction | Surd:
    """A rational number, or a sum such as 3/2 - 2*sqrt(5)/3, from its text; raises `Rejected` for any other."""
    if "sqrt" not in text:
        return Fraction(text)
    total = Surd({})
    for piece in re.sub(r" ([+-]) ", r" \1", text).split():
        found = TERM.fullmatch(piece)
        if not found or (total and piece[0] not in "+-"):
            raise Rejected(
                f"the witness has {text}, and the checker knows rational numbers and their square roots only"
            )
        sign, factor, whole, radicand, below = found.groups()
        root = int(radicand or 1)
        if root > LARGEST or any(root % (k * k) == 0 for k in range(2, isqrt(root) + 1)) or root == 0:
            raise Rejected(f"the witness has {text}, and {root} is not known to be free of squares")
        size = Fraction(int(factor or 1) * int(whole or 1), int(below or 1))
        total += Surd({root: -size if sign == "-" else size}) if size else Surd({})
    return total.terms.get(1, Fraction(0)) if total.terms.keys() <= {1} else total
