"""Sums of square roots, for the checker: the coordinates of a witness where no rational ones exist."""

from __future__ import annotations

import re
from fractions import Fraction
from math import gcd, isqrt

from chasles.proof.recheck.sparse import Rejected

__all__ = ["Surd", "coordinate"]

TERM = re.compile(r"([+-])(?:(\d+)(?:\*|(?=[/+-]|$)))?(?:sqrt\((\d+)\))?(?:/(\d+))?")
LARGEST = 10**8


class Surd:
    """Rational multiples of square roots of squarefree integers, by integer; zero only if there are none.

    These roots are linearly independent over the rational numbers. Adds and multiplies with rational numbers too.
    """

    __slots__ = ("terms",)

    def __init__(self, terms: dict[int, Fraction]) -> None:
        self.terms = {radicand: value for radicand, value in terms.items() if value}

    def __bool__(self) -> bool:
        return bool(self.terms)

    def __eq__(self, other: object) -> bool:
        return self.terms == _lifted(other).terms if isinstance(other, Surd | Fraction | int) else NotImplemented

    def __hash__(self) -> int:
        return hash(frozenset(self.terms.items()))

    def __add__(self, other: Surd | Fraction | int) -> Surd:
        other = _lifted(other)
        return Surd({k: self.terms.get(k, Fraction(0)) + other.terms.get(k, 0) for k in self.terms | other.terms})

    def __mul__(self, other: Surd | Fraction | int) -> Surd:
        total: dict[int, Fraction] = {}
        for one, a in self.terms.items():
            for another, b in _lifted(other).terms.items():
                shared = gcd(one, another)
                radicand = one * another // shared**2
                total[radicand] = total.get(radicand, Fraction(0)) + a * b * shared
        return Surd(total)

    def __truediv__(self, other: Fraction | int) -> Surd:
        return self * (1 / Fraction(other))

    def __pow__(self, exponent: int) -> Surd:
        total = Surd({1: Fraction(1)})
        for _ in range(exponent):
            total *= self
        return total

    __radd__, __rmul__ = __add__, __mul__


def _lifted(value: Surd | Fraction | int) -> Surd:
    return value if isinstance(value, Surd) else Surd({1: Fraction(value)})


def coordinate(text: str) -> Fraction | Surd:
    """The number that a text such as -3/5 or 1/2 - 3*sqrt(2)/4 spells; raises `Rejected` if it spells none."""
    if "sqrt" not in text:
        return Fraction(text)
    squeezed = text.replace(" ", "")
    squeezed = squeezed if squeezed[0] in "+-" else f"+{squeezed}"
    total, end = Surd({}), 0
    for term in TERM.finditer(squeezed):
        sign, above, radicand, below = term.groups()
        if term.start() != end or not (above or radicand):
            break
        end = term.end()
        size = Fraction(int(sign + (above or "1")), int(below or 1))
        total += Surd({_squarefree(int(radicand or 1)): size})
    if end != len(squeezed):
        raise Rejected(f"{text!r} is no rational number and no sum of square roots")
    return total


def _squarefree(radicand: int) -> int:
    if not 0 < radicand < LARGEST or any(radicand % d**2 == 0 for d in range(2, isqrt(radicand) + 1)):
        raise Rejected(f"{radicand} under a root is not squarefree, or too large")
    return radicand
