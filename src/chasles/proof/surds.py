"""Exact real numbers: rational multiples of square roots, and of the powers of one transcendental number.

Square roots of different squarefree integers are linearly independent over the rationals, and a transcendental number
is so over all of them: such a sum vanishes only if every coefficient does. The test for zero is exact.
"""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass
from fractions import Fraction
from math import gcd, isqrt

__all__ = ["Exact", "square_root", "squarefree"]

LARGEST_DIVISOR = 10_000
Key = tuple[int, int]


@dataclass(frozen=True, slots=True)
class Exact:
    """The sum of coefficient * theta ** power * sqrt(radicand), the keys being (power, squarefree radicand)."""

    terms: Mapping[Key, Fraction]

    @classmethod
    def rational(cls, value: Fraction | int) -> Exact:
        """A rational number."""
        return cls({(0, 1): Fraction(value)} if value else {})

    @classmethod
    def theta(cls) -> Exact:
        """The transcendental number itself."""
        return cls({(1, 1): Fraction(1)})

    def __add__(self, other: Exact) -> Exact:
        total = dict(self.terms)
        for key, coefficient in other.terms.items():
            total[key] = total.get(key, Fraction(0)) + coefficient
        return Exact({key: c for key, c in total.items() if c})

    def __neg__(self) -> Exact:
        return Exact({key: -c for key, c in self.terms.items()})

    def __sub__(self, other: Exact) -> Exact:
        return self + (-other)

    def __mul__(self, other: Exact) -> Exact:
        total: dict[Key, Fraction] = {}
        for (i, m), a in self.terms.items():
            for (j, n), b in other.terms.items():
                shared = gcd(m, n)
                key = i + j, m * n // shared**2
                total[key] = total.get(key, Fraction(0)) + a * b * shared
        return Exact({key: c for key, c in total.items() if c})

    def __pow__(self, exponent: int) -> Exact:
        total = Exact.rational(1)
        for _ in range(exponent):
            total = total * self
        return total

    @property
    def is_zero(self) -> bool:
        return not self.terms

    @property
    def as_rational(self) -> Fraction | None:
        """The number, if it is rational."""
        if not self.terms:
            return Fraction(0)
        return self.terms.get((0, 1)) if len(self.terms) == 1 else None

    def inverse(self) -> Exact | None:
        """One over the number; None for zero and for sums that contain the transcendental number."""
        if len(self.terms) == 1:
            (((power, radicand), c),) = self.terms.items()
            return Exact({(-power, radicand): 1 / (c * radicand)})
        if not self.terms or any(power for power, _ in self.terms):
            return None
        # With x = a + b sqrt(p) for a prime p, the inverse is the conjugate over a^2 - p b^2, where p is gone.
        prime = next(_least_prime(n) for _, n in self.terms if n != 1)
        conjugate = Exact({(k, n): -c if n % prime == 0 else c for (k, n), c in self.terms.items()})
        below = (self * conjugate).inverse()
        return None if below is None else conjugate * below

    def text(self, theta: str = "theta") -> str:
        """The number in SymPy's spelling, the transcendental number named."""
        text = ""
        for (power, radicand), c in sorted(self.terms.items()):
            factors = [f"sqrt({radicand})"] if radicand != 1 else []
            factors += [theta if power == 1 else f"{theta}**{power}"] if power else []
            size = abs(c)
            if size.numerator != 1 or not factors:
                factors.insert(0, str(size.numerator))
            piece = "*".join(factors) + (f"/{size.denominator}" if size.denominator != 1 else "")
            sign = "-" if c < 0 else "+"
            text = f"{text} {sign} {piece}" if text else piece if c > 0 else f"-{piece}"
        return text or "0"

    def __str__(self) -> str:
        return self.text()


def square_root(value: Fraction) -> Exact | None:
    """The square root of a rational number; None if it is negative or has large unknown factors."""
    if value < 0:
        return None
    if value == 0:
        return Exact({})
    parts = squarefree(value.numerator * value.denominator)
    return None if parts is None else Exact({(0, parts[1]): Fraction(parts[0], value.denominator)})


def squarefree(number: int) -> tuple[int, int] | None:
    """A positive integer as s^2 times m, m squarefree; None if it has large factors that cannot be told apart."""
    root, rest, divisor = 1, 1, 2
    while divisor <= LARGEST_DIVISOR and divisor * divisor <= number:
        count = 0
        while number % divisor == 0:
            number, count = number // divisor, count + 1
        root, rest = root * divisor ** (count // 2), rest * divisor ** (count % 2)
        divisor += 1 if divisor == 2 else 2
    whole = isqrt(number)
    if whole * whole == number:
        return root * whole, rest
    return (root, rest * number) if number < LARGEST_DIVISOR**2 else None


def _least_prime(number: int) -> int:
    return next((d for d in range(2, isqrt(number) + 1) if number % d == 0), number)
