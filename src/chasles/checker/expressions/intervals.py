"""Enclosing with rational ends that hold a real number for certain: sums, products, roots, and elementary functions.

An end is a whole multiple of 2^-bits, rounded outwards. Elementary functions are their power series with a bound of
what is left out, after the argument has been made small.
"""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass
from fractions import Fraction
from functools import cache
from math import isqrt

HALVINGS = 8
LARGEST = 4096
"""Arguments of the exponential function are no larger than this, and angles than 2 to the power of a quarter of it."""


class Unbounded(ArithmeticError):
    """An interval is too wide to tell a divisor from zero, or a radicand from a negative number."""


@dataclass(frozen=True, slots=True)
class Enclosure:
    """From `low` to `high`, in units of 2^-bits."""

    low: int
    high: int

    def __add__(self, other: Enclosure) -> Enclosure:
        return Enclosure(self.low + other.low, self.high + other.high)

    def __neg__(self) -> Enclosure:
        return Enclosure(-self.high, -self.low)

    def __sub__(self, other: Enclosure) -> Enclosure:
        return self + (-other)

    def meets(self, other: Enclosure) -> bool:
        """Whether some number is in both."""
        return self.low <= other.high and other.low <= self.high

    @property
    def sign(self) -> int | None:
        """The sign of every number in it; None if they differ."""
        if self.low > 0 or self.high < 0:
            return 1 if self.low > 0 else -1
        return 0 if self.low == self.high == 0 else None


def _increasing(function: Callable[[Enclosing, int], Enclosure]) -> Callable[[Enclosing, Enclosure], Enclosure]:
    """A function that increases, from what it is at both ends."""
    return lambda at, x: Enclosure(function(at, x.low).low, function(at, x.high).high)


class Enclosing:
    """Arithmetic with so many binary digits after the point."""

    def __init__(self, bits: int) -> None:
        self.bits = bits
        self.one = 1 << bits
        # As many as make up for the terms of a series that they save: Brent, Fast multiple-precision evaluation (1976).
        self.halvings = max(HALVINGS, isqrt(bits) // 2)

    def number(self, value: Fraction | int) -> Enclosure:
        """A rational number."""
        scaled = Fraction(value) * self.one
        return Enclosure(scaled.numerator // scaled.denominator, -(-scaled.numerator // scaled.denominator))

    def times(self, one: Enclosure, other: Enclosure) -> Enclosure:
        """The product."""
        if one.low >= 0 <= other.low:
            return Enclosure(one.low * other.low >> self.bits, -(-one.high * other.high >> self.bits))
        if one.low < 0 >= one.high:
            return -self.times(-one, other)
        if other.low < 0 >= other.high:
            return -self.times(one, -other)
        ends = [a * b for a in (one.low, one.high) for b in (other.low, other.high)]
        return Enclosure(min(ends) >> self.bits, -(-max(ends) >> self.bits))

    def inverse(self, x: Enclosure) -> Enclosure:
        """One over it; raises `Unbounded` if zero is in it."""
        if x.low <= 0 <= x.high:
            raise Unbounded("a divisor may be zero")
        return Enclosure(self.one**2 // x.high, -(-(self.one**2) // x.low))

    def power(self, x: Enclosure, exponent: int) -> Enclosure:
        """An integral power."""
        if exponent < 0:
            return self.inverse(self.power(x, -exponent))
        if exponent % 2 == 0 and exponent and x.low < 0:
            x = Enclosure(0 if x.high >= 0 else -x.high, max(-x.low, x.high))
        total, square = self.number(1), x
        while exponent:
            total = self.times(total, square) if exponent % 2 else total
            square, exponent = self.times(square, square), exponent // 2
        return total

    def root(self, x: Enclosure, degree: int) -> Enclosure:
        """The nonnegative root; raises `Unbounded` if the number may be negative."""
        if x.low < 0:
            raise Unbounded("a radicand may be negative")
        if degree > 2 and x.high:
            return Enclosure(self._by_logarithm(x.low, degree).low, self._by_logarithm(x.high, degree).high)
        return Enclosure(isqrt(x.low << self.bits), isqrt(x.high << self.bits) + 1 if x.high else 0)

    def _by_logarithm(self, x: int, degree: int) -> Enclosure:
        """A root: x^(1/n) = exp(log(x) / n)."""
        exponent = self.log(Enclosure(x, x)) if x else Enclosure(-LARGEST * self.one * degree, 0)
        return self.exp(Enclosure(exponent.low // degree, -(-exponent.high // degree)))

    @property
    def pi(self) -> Enclosure:
        """Machin's formula: pi = 16 arctan(1/5) - 4 arctan(1/239)."""
        return _pi(self.bits)

    @_increasing
    def exp(self, x: int) -> Enclosure:
        """The exponential function; raises `Unbounded` for a very large argument."""
        if abs(x) > LARGEST * self.one:
            raise Unbounded("an exponent is very large")
        halvings = max(self.halvings, abs(x).bit_length() - self.bits + self.halvings)
        finer = Enclosing(self.bits + 2 * halvings + max(0, 2 * (x >> self.bits)) + HALVINGS)
        total = finer.series(finer.number(Fraction(x, self.one << halvings)), lambda k: Fraction(1, k))
        for _ in range(halvings):
            total = finer.times(total, total)
        return self.coarser(total, finer)

    def series(self, x: Enclosure, ratio: Callable[[int], Fraction]) -> Enclosure:
        """1 + r(1) x + r(1) r(2) x^2 + ... for |x| at most 1/2 and ratios from 0 to 1."""
        total, term, k = self.number(1), self.number(1), 0
        while max(abs(term.low), abs(term.high)) > 1:
            k += 1
            term, part = self.times(term, x), ratio(k)
            above, below = part.numerator, part.denominator
            term = Enclosure(term.low * above // below, -(-term.high * above // below))
            total = total + term
        # What is left out is at most the last term times 1/2 + 1/4 + ...
        return Enclosure(total.low - 2, total.high + 2)

    def coarser(self, x: Enclosure, finer: Enclosing) -> Enclosure:
        """An interval of finer arithmetic."""
        shift = finer.bits - self.bits
        return Enclosure(x.low >> shift, -(-x.high >> shift))

    def cosine_and_sine(self, x: Enclosure) -> tuple[Enclosure, Enclosure]:
        """Of an angle: at its middle, widened by half its width, since neither changes faster than the angle."""
        middle, reach = (x.low + x.high) // 2, (x.high - x.low) // 2 + 1
        doublings = max(self.halvings, abs(middle).bit_length() - self.bits + self.halvings)
        if doublings > LARGEST // 4:
            raise Unbounded("an angle is of too many turns")
        finer = Enclosing(self.bits + 2 * doublings + HALVINGS)
        small = finer.number(Fraction(middle, self.one << doublings))
        square = -finer.times(small, small)
        cosine = finer.series(square, lambda k: Fraction(1, 2 * k * (2 * k - 1)))
        sine = finer.times(small, finer.series(square, lambda k: Fraction(1, 2 * k * (2 * k + 1))))
        for _ in range(doublings):
            both = finer.times(sine, cosine)
            cosine, sine = finer.times(cosine, cosine) - finer.times(sine, sine), both + both
        found = (self.coarser(value, finer) for value in (cosine, sine))
        cosine, sine = (Enclosure(max(e.low - reach, -self.one), min(e.high + reach, self.one)) for e in found)
        return cosine, sine

    @_increasing
    def log(self, x: int) -> Enclosure:
        """The natural logarithm, by that of x / 2^n and of 2; raises `Unbounded` where it may not be real."""
        if x <= 0:
            raise Unbounded("a logarithm may not be real")
        size = x.bit_length() - self.bits
        finer = Enclosing(self.bits + 4 * self.halvings + size.bit_length())
        rest = finer.log_of_moderate(finer.number(Fraction(x, self.one) / Fraction(2) ** size))
        two = _log_2(finer.bits)
        return self.coarser(rest + Enclosure(*sorted((size * two.low, size * two.high))), finer)

    def log_of_moderate(self, x: Enclosure) -> Enclosure:
        """Log x = 2^n log(x^(1/2^n)), and log y = 2 artanh((y - 1) / (y + 1)), for x from 1/2 to 2."""
        for _ in range(self.halvings):
            x = self.root(x, 2)
        ratio = self.times(x - self.number(1), self.inverse(x + self.number(1)))
        total = self.times(ratio, self.series(self.times(ratio, ratio), lambda k: Fraction(2 * k - 1, 2 * k + 1)))
        return Enclosure(total.low << self.halvings + 1, total.high << self.halvings + 1)

    @_increasing
    def atan(self, x: int) -> Enclosure:
        """The inverse tangent: twice that of x / (1 + sqrt(1 + x^2)), until the argument is small."""
        finer = Enclosing(self.bits + 4 * HALVINGS + max(0, x.bit_length() - self.bits))
        y, one = finer.number(Fraction(x, self.one)), finer.number(1)
        for _ in range(HALVINGS):
            y = finer.times(y, finer.inverse(one + finer.root(one + finer.power(y, 2), 2)))
        total = finer.times(y, finer.series(-finer.power(y, 2), lambda k: Fraction(2 * k - 1, 2 * k + 1)))
        return self.coarser(Enclosure(total.low << HALVINGS, total.high << HALVINGS), finer)

    @_increasing
    def erf(self, x: int) -> Enclosure:
        """The error function: 2 x/sqrt(pi) e^(-x^2) (1 + 2 x^2/3 (1 + 2 x^2/5 ...)); nearly 1 where x is large."""
        square = Fraction(x, self.one) ** 2
        if square > self.bits:
            return Enclosure(self.one - 1, self.one) if x > 0 else Enclosure(-self.one, 1 - self.one)
        finer = Enclosing(self.bits + 2 * int(square) + HALVINGS)
        # Once a term is small, each is at most half of the one before.
        total = finer.series(finer.number(Fraction(1, 2)), lambda k: 4 * square / (2 * k + 1))
        total = finer.times(
            total, finer.times(finer.number(Fraction(2 * x, self.one)), finer.exp(-finer.number(square)))
        )
        return self.coarser(finer.times(total, finer.inverse(finer.root(finer.pi, 2))), finer)


@cache
def _log_2(bits: int) -> Enclosure:
    finer = Enclosing(bits + 4 * Enclosing(bits).halvings)
    return Enclosing(bits).coarser(finer.log_of_moderate(finer.number(2)), finer)


@cache
def _pi(bits: int) -> Enclosure:
    one = 1 << bits + bits.bit_length() + HALVINGS
    (five, lost), (many, more) = _arctangent(5, one), _arctangent(239, one)
    total, error = 16 * five - 4 * many, 16 * lost + 4 * more
    shift = one.bit_length() - 1 - bits
    return Enclosure(total - error >> shift, -(-(total + error) >> shift))


def _arctangent(inverse: int, one: int) -> tuple[int, int]:
    """Arctan of one over an integer, and a bound of the error: each of its terms is rounded down, once."""
    power, total, count = one // inverse, 0, 0
    while power:
        total += (1 - count % 2 * 2) * (power // (2 * count + 1))
        power //= inverse * inverse
        count += 1
    return total, count + 1
