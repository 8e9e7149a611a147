"""Exact real numbers: rational multiples of square roots, and of the powers of one transcendental number.

Square roots of different squarefree integers are linearly independent over the rationals (Besicovitch, J. London Math.
Soc. 15, 1940); so are, over these, products of roots of numbers none of whose products is a square there; and the
rational powers of a transcendental number are so over all of them. Such a sum vanishes only if every coefficient does:
the test for zero is exact. A search for points needs no more, and no SymPy: it looks at thousands of them.
"""

from __future__ import annotations

from collections.abc import Iterable, Mapping
from dataclasses import dataclass
from fractions import Fraction
from itertools import combinations
from math import gcd, isqrt

from chasles.algebra.squarefree import primes_of, squarefree

MOST_NESTED = 3
Nested = frozenset["SurdSum"]
Key = tuple[Fraction | int, int, Nested]
NONE: Nested = frozenset()
ONE: Key = (0, 1, NONE)


@dataclass(frozen=True, slots=True)
class SurdSum:
    """The sum of coefficient * theta ** power * sqrt(radicand) * the roots of the `nested` numbers, by that key."""

    terms: Mapping[Key, Fraction]

    def __hash__(self) -> int:
        return hash(frozenset(self.terms.items()))

    @classmethod
    def rational(cls, value: Fraction | int) -> SurdSum:
        """A rational number."""
        return cls({ONE: Fraction(value)} if value else {})

    @classmethod
    def theta(cls) -> SurdSum:
        """The transcendental number itself."""
        return cls({(1, 1, NONE): Fraction(1)})

    @classmethod
    def root_of(cls, inside: SurdSum) -> SurdSum:
        """The root of a number, by itself."""
        return cls({(0, 1, frozenset({inside})): Fraction(1)})

    def __add__(self, other: SurdSum) -> SurdSum:
        total = dict(self.terms)
        for key, coefficient in other.terms.items():
            total[key] = total.get(key, Fraction(0)) + coefficient
        return SurdSum({key: c for key, c in total.items() if c})

    def __neg__(self) -> SurdSum:
        return SurdSum({key: -c for key, c in self.terms.items()})

    def __sub__(self, other: SurdSum) -> SurdSum:
        return self + (-other)

    def __mul__(self, other: SurdSum) -> SurdSum:
        total: dict[Key, Fraction] = {}
        squares = SurdSum({})
        for (i, m, one), a in self.terms.items():
            for (j, n, another), b in other.terms.items():
                shared = gcd(m, n)
                key = i + j, m * n // shared**2, one ^ another
                if one & another:
                    squares = squares + _product(one & another) * SurdSum({key: a * b * shared})
                else:
                    total[key] = total.get(key, Fraction(0)) + a * b * shared
        plain = SurdSum({key: c for key, c in total.items() if c})
        return plain + squares if squares.terms else plain

    def __pow__(self, exponent: int) -> SurdSum:
        rational = self.as_rational
        if rational is not None:
            return SurdSum.rational(rational**exponent)
        total, square = SurdSum.rational(1), self
        while exponent:
            total = total * square if exponent % 2 else total
            square, exponent = square * square, exponent // 2
        return total

    @property
    def is_zero(self) -> bool:
        """Whether the sum has no terms: like terms are always put together."""
        return not self.terms

    @property
    def as_rational(self) -> Fraction | None:
        """The number, if it is rational."""
        if not self.terms:
            return Fraction(0)
        return self.terms.get(ONE) if len(self.terms) == 1 else None

    @property
    def is_algebraic(self) -> bool:
        """Whether the transcendental number does not occur."""
        return not any(power for power, _, _ in self.terms)

    def inverse(self) -> SurdSum | None:
        """One over the number; None for zero and for sums that contain the transcendental number."""
        if len(self.terms) == 1 and not next(iter(self.terms))[2]:
            (((power, radicand, _), c),) = self.terms.items()
            return SurdSum({(-power, radicand, NONE): 1 / (c * radicand)})
        if not self.terms or not self.is_algebraic:
            return None
        # Of x = a + b sqrt(p) the inverse is the conjugate a - b sqrt(p) over a^2 - p b^2, where sqrt(p) is gone.
        conjugate = self._conjugate()
        below = (self * conjugate).inverse()
        return None if below is None else conjugate * below

    def _conjugate(self) -> SurdSum:
        """The number with the sign of one of the roots in it changed, nested ones first."""
        nested = next((one for _, _, roots in self.terms for one in roots), None)
        if nested is not None:
            return SurdSum({key: -c if nested in key[2] else c for key, c in self.terms.items()})
        prime = next((primes_of(n)[0] for _, n, _ in self.terms if n != 1), 2)
        return SurdSum({key: -c if key[1] % prime == 0 else c for key, c in self.terms.items()})

    @property
    def is_negative(self) -> bool:
        """Whether the number, in which the transcendental one does not occur, is less than zero."""
        digits = 64
        while self.terms:
            below, above = self._bounds(digits)
            if below > 0 or above < 0:
                return above < 0
            digits *= 2
        return False

    def _bounds(self, digits: int) -> tuple[Fraction, Fraction]:
        """Rational numbers between which the number lies, as close as so many binary digits make them."""
        below = above = Fraction(0)
        for (_, radicand, nested), c in self.terms.items():
            least, most = Fraction(abs(c)), Fraction(abs(c))
            for inside in (SurdSum.rational(radicand), *nested):
                low, high = inside._bounds(digits) if inside.as_rational is None else (inside.as_rational,) * 2
                least *= Fraction(isqrt(int(max(low, Fraction(0)) * 4**digits)), 2**digits)
                most *= Fraction(isqrt(int(high * 4**digits)) + 2, 2**digits)
            below, above = (below + least, above + most) if c > 0 else (below - most, above - least)
        return below, above

    def text(self, theta: str = "theta") -> str:
        """The number in SymPy's spelling, the transcendental number named."""
        text = ""
        for (power, radicand, nested), c in sorted(self.terms.items(), key=lambda term: (term[0][:2], len(term[0][2]))):
            factors = [f"sqrt({radicand})"] if radicand != 1 else []
            factors += sorted(f"sqrt({inside.text()})" for inside in nested)
            exponent = str(power) if power > 0 and power == int(power) else f"({power})"
            factors += [theta if power == 1 else f"{theta}**{exponent}"] if power else []
            size = abs(c)
            if size.numerator != 1 or not factors:
                factors.insert(0, str(size.numerator))
            piece = "*".join(factors) + (f"/{size.denominator}" if size.denominator != 1 else "")
            sign = "-" if c < 0 else "+"
            text = f"{text} {sign} {piece}" if text else piece if c > 0 else f"-{piece}"
        return text or "0"

    def __str__(self) -> str:
        return self.text()


def _product(factors: Iterable[SurdSum]) -> SurdSum:
    total = SurdSum.rational(1)
    for factor in factors:
        total = total * factor
    return total


def square_root(value: Fraction) -> SurdSum | None:
    """The square root of a rational number; None if it is negative or has large unknown factors."""
    if value < 0:
        return None
    if value == 0:
        return SurdSum({})
    parts = squarefree(value.numerator * value.denominator)
    return None if parts is None else SurdSum({(0, parts[1], NONE): Fraction(parts[0], value.denominator)})


def root_of(value: SurdSum, in_use: Iterable[SurdSum] = ()) -> SurdSum | None:
    """The nonnegative square root of a number, in terms of roots already `in_use`; None if none is known to be exact.

    The transcendental number counts as positive.
    """
    if len(value.terms) == 1:
        (((power, radicand, nested), coefficient),) = value.terms.items()
        root = square_root(coefficient) if power and radicand == 1 and not nested else None
        if root is not None:
            return root * SurdSum({(Fraction(power) / 2, 1, NONE): Fraction(1)})
    rational = value.as_rational
    if rational is not None:
        return square_root(rational)
    if not value.is_algebraic or any(nested for _, _, nested in value.terms) or value.is_negative:
        return None
    others = [other for other in in_use if other != value]
    denested = _denested(value)
    if denested is not None:
        return denested
    for other in others:
        together = value * other
        root = square_root(together.as_rational) if together.as_rational is not None else _denested(together)
        inverse = SurdSum.root_of(other).inverse()
        if root is not None and inverse is not None:
            return root * inverse
    sums = (_product((value, *some)) for size in range(len(others) + 1) for some in combinations(others, size))
    independent = len(others) < MOST_NESTED and all(_is_no_square(number) for number in sums)
    return SurdSum.root_of(value) if independent else None


def _denested(value: SurdSum) -> SurdSum | None:
    """sqrt(a + b sqrt(n)) as a sum of roots of rational numbers, if a^2 - b^2 n is a square (Borodin et al., 1985)."""
    a = value.terms.get(ONE, Fraction(0))
    others = [(n, b) for (_, n, _), b in value.terms.items() if n != 1]
    if len(others) != 1 or a <= 0:
        return None
    ((n, b),) = others
    c = square_root(a * a - b * b * n)
    rest = None if c is None else c.as_rational
    if rest is None:
        return None
    one, other = square_root((a + rest) / 2), square_root((a - rest) / 2)
    if one is None or other is None:
        return None
    return one + other if b > 0 else one - other


def _is_no_square(value: SurdSum) -> bool:
    """Whether a sum of roots is known to be no square of another: the product of its conjugates is no square."""
    if value.as_rational is not None:
        return False
    norm = value
    while norm.as_rational is None:
        norm = norm * norm._conjugate()
    root = square_root(norm.as_rational or Fraction(0))
    return root is None or root.as_rational is None
