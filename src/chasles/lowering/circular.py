"""Functions of one angle: quotients of polynomials in its cosine and sine, modulo cos^2 + sin^2 = 1.

Powers of the sine and of the cosine are split off, and cancel where they stand above and below a line: so
sin(2x) / (1 - cos(2x)) is cos(x) / sin(x), in which nothing is lost where x is small.
"""

from __future__ import annotations

from collections.abc import Iterable
from dataclasses import dataclass
from fractions import Fraction

Polynomial = dict[tuple[int, int], Fraction]
"""Coefficients by the exponents of sine and cosine."""


@dataclass(frozen=True, slots=True)
class Circular:
    """sine^powers[0] cosine^powers[1] above / below; neither polynomial has a sine or a cosine as a factor."""

    powers: tuple[int, int]
    above: tuple[tuple[tuple[int, int], Fraction], ...]
    below: tuple[tuple[tuple[int, int], Fraction], ...]

    @property
    def is_constant(self) -> bool:
        """Whether it is the same for all angles."""
        return self.powers == (0, 0) and all(exponents == (0, 0) for exponents, _ in self.above + self.below)

    def __add__(self, other: Circular) -> Circular:
        one, another = (self.over, other.over)
        if one[1] == another[1]:
            return _quotient(_plus(one[0], another[0]), one[1])
        above = _plus(_times(one[0], another[1]), _times(another[0], one[1]))
        return _quotient(above, _times(one[1], another[1]))

    def __sub__(self, other: Circular) -> Circular:
        return self + -other

    def __neg__(self) -> Circular:
        return Circular(self.powers, tuple((exponents, -q) for exponents, q in self.above), self.below)

    def __mul__(self, other: Circular) -> Circular:
        (a, b), (c, d) = self.over, other.over
        return _quotient(_times(a, c), _times(b, d))

    def __truediv__(self, other: Circular) -> Circular:
        """The quotient; raises ZeroDivisionError for zero."""
        (a, b), (c, d) = self.over, other.over
        return _quotient(_times(a, d), _times(b, c))

    @property
    def over(self) -> tuple[Polynomial, Polynomial]:
        """Numerator and denominator as polynomials."""
        rise: Polynomial = {(max(self.powers[0], 0), max(self.powers[1], 0)): Fraction(1)}
        fall: Polynomial = {(max(-self.powers[0], 0), max(-self.powers[1], 0)): Fraction(1)}
        return _times(dict(self.above), rise), _times(dict(self.below), fall)


def constant(value: Fraction) -> Circular:
    """A number."""
    return _quotient({(0, 0): value}, {(0, 0): Fraction(1)})


def multiple_of_angle(times: int) -> tuple[Circular, Circular]:
    """The cosine and the sine of so many times the angle."""
    cosine: Polynomial = {(0, 0): Fraction(1)}
    sine: Polynomial = {}
    one: Polynomial = {(0, 1): Fraction(1)}
    side: Polynomial = {(1, 0): Fraction(1 if times > 0 else -1)}
    for _ in range(abs(times)):
        turned = _plus(_times(cosine, one), _negative(_times(sine, side)))
        sine = _plus(_times(sine, one), _times(cosine, side))
        cosine = turned
    unit = {(0, 0): Fraction(1)}
    return _quotient(cosine, unit), _quotient(sine, unit)


def _quotient(above: Polynomial, below: Polynomial) -> Circular:
    if not _lowered(below, 0):
        raise ZeroDivisionError("a function of an angle is divided by zero")
    if not _lowered(above, 0):
        return Circular((0, 0), (), (((0, 0), Fraction(1)),))
    over, top = _split(above)
    under, bottom = _split(below)
    if len(bottom) == 1:
        # What is left below is a number.
        top = {exponents: q / bottom[0, 0] for exponents, q in top.items()}
        bottom = {(0, 0): Fraction(1)}
    powers = over[0] - under[0], over[1] - under[1]
    return Circular(powers, tuple(sorted(top.items())), tuple(sorted(bottom.items())))


def _split(polynomial: Polynomial) -> tuple[tuple[int, int], Polynomial]:
    """The powers of sine and cosine that divide a polynomial, and what is left, in as few terms as may be."""
    sines = cosines = 0
    rest = polynomial
    while True:
        by_sine, by_cosine = _lowered(rest, 1), _lowered(rest, 0)
        i = min(exponents[0] for exponents in by_sine)
        j = min(exponents[1] for exponents in by_cosine)
        if i:
            rest = {(k - i, m): q for (k, m), q in by_sine.items()}
        elif j:
            rest = {(k, m - j): q for (k, m), q in by_cosine.items()}
        else:
            return (sines, cosines), min((by_sine, by_cosine), key=len)
        sines, cosines = sines + i, cosines + (0 if i else j)


def _lowered(polynomial: Polynomial, which: int) -> Polynomial:
    """No power of the sine (0) or cosine (1) above the first: squares are one minus those of the other."""
    terms = dict(polynomial)
    while (high := max(terms, key=lambda exponents: exponents[which], default=(0, 0)))[which] > 1:
        q = terms.pop(high)
        kept = list(high)
        kept[which] -= 2
        swapped = list(kept)
        swapped[1 - which] += 2
        terms = _plus(terms, {(kept[0], kept[1]): q, (swapped[0], swapped[1]): -q})
    return terms


def _plus(a: Polynomial, b: Polynomial) -> Polynomial:
    return _gathered([*a.items(), *b.items()])


def _times(a: Polynomial, b: Polynomial) -> Polynomial:
    return _gathered(((i + k, j + m), p * q) for (i, j), p in a.items() for (k, m), q in b.items())


def _negative(a: Polynomial) -> Polynomial:
    return {exponents: -q for exponents, q in a.items()}


def _gathered(terms: Iterable[tuple[tuple[int, int], Fraction]]) -> Polynomial:
    total: Polynomial = {}
    for exponents, q in terms:
        total[exponents] = total.get(exponents, Fraction(0)) + q
    return {exponents: q for exponents, q in total.items() if q}
