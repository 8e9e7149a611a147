"""Rational bounds of exponentials, logarithms, cosines, sines and arctangents, from their power series."""

from __future__ import annotations

from fractions import Fraction

from chasles.checker.sparse import Rejected

__all__ = ["Bounds", "arctangent", "bounds_of", "inverted", "product"]

Bounds = tuple[Fraction, Fraction]
LARGEST = 500
"""Series of exponentials, cosines and sines are summed for arguments up to this size."""


def product(one: Bounds, other: Bounds) -> Bounds:
    """Bounds of a product."""
    ends = [a * b for a in one for b in other]
    return min(ends), max(ends)


def inverted(bounds: Bounds) -> Bounds:
    """Bounds of one over a number; raises `Rejected` where it may be zero."""
    if bounds[0] <= 0 <= bounds[1]:
        raise Rejected("whether a number is zero cannot be told")
    return 1 / bounds[1], 1 / bounds[0]


def bounds_of(function: str, argument: Bounds, digits: int) -> Bounds:
    """Bounds of exp, log, cos, sin or atan of what lies between bounds, to about so many binary digits."""
    low, high = _rounded(argument[0], digits, up=False), _rounded(argument[1], digits, up=True)
    if function == "log" and low <= 0:
        raise Rejected("the logarithm is taken of what is not seen to be positive")
    if max(abs(low), abs(high)) > LARGEST and function in ("exp", "cos", "sin"):
        raise Rejected(f"{function} of a number as large is not bounded")
    if function in ("cos", "sin"):
        # Neither changes faster than its argument.
        middle, doubt = _rounded((low + high) / 2, digits, up=False), high - low + Fraction(1, 2**digits)
        least, most = _circular(middle, digits, int(function == "sin"))
        return max(least - doubt, Fraction(-1)), min(most + doubt, Fraction(1))
    rule = {"exp": _exponential, "log": _logarithm, "atan": arctangent}[function]
    return rule(low, digits)[0], rule(high, digits)[1]


def _rounded(value: Fraction, digits: int, up: bool) -> Fraction:
    """A dyadic number that is not more, or, if `up`, not less."""
    scaled = value * 2**digits
    return Fraction(-(-scaled // 1) if up else scaled // 1, 2**digits)


def _exponential(x: Fraction, digits: int) -> Bounds:
    """Taylor's series for a number up to 1/2, squared again and again."""
    if x < 0:
        return inverted(_exponential(-x, digits + 3 * LARGEST))
    halvings = int(x // 1).bit_length() + 1
    digits += 4 * halvings + 2 * int(x) + 8
    small, unit = x / 2**halvings, 1 << digits
    term = total = unit
    count = 0
    while term:
        count += 1
        term = term * small.numerator // (small.denominator * count)
        total += term
    low, high = Fraction(total, unit), Fraction(total + 2 * count + 2, unit)
    for _ in range(halvings):
        low, high = _rounded(low * low, digits, up=False), _rounded(high * high, digits, up=True)
    return low, high


def _logarithm(x: Fraction, digits: int) -> Bounds:
    """log(2^k m) = k log(2) + 2 artanh((m - 1) / (m + 1)), m between 1/2 and 2."""
    power = x.numerator.bit_length() - x.denominator.bit_length()
    m = x / Fraction(2) ** power
    (least, most), (low, high) = _artanh((m - 1) / (m + 1), digits), _artanh(Fraction(1, 3), digits)
    low, high = product((low, high), (Fraction(power), Fraction(power)))
    return 2 * (least + low), 2 * (most + high)


def _artanh(z: Fraction, digits: int) -> Bounds:
    """The sum of z^(2k+1) / (2k+1), z being at most 1/3 in size."""
    if z < 0:
        low, high = _artanh(-z, digits)
        return -high, -low
    unit = 1 << digits + 8
    power, total, count = int((z * unit) // 1), 0, 0
    while power:
        total, count = total + power // (2 * count + 1), count + 1
        power = int((power * z * z) // 1)
    return Fraction(total, unit), Fraction(total + 3 * count + 4, unit)


def _circular(x: Fraction, digits: int, first: int) -> Bounds:
    """Taylor's series of the cosine, or, from the `first` power on, of the sine: less than a term is left out."""
    digits += 2 * int(abs(x)) + 16
    unit, square = 1 << digits, x * x
    term, total, count = int((x * unit) // 1) if first else unit, 0, first
    while abs(term) > 1 or count <= abs(x):
        total, count = total + term, count + 2
        term = -int((term * square / (count * (count - 1))) // 1)
    doubt = 4 * count * (1 + int(abs(x))) ** 2
    return Fraction(total - doubt, unit), Fraction(total + doubt, unit)


def arctangent(x: Fraction, digits: int) -> Bounds:
    """Euler's series, whose terms are positive and each less than x^2/(1 + x^2) times the one before."""
    if x < 0:
        low, high = arctangent(-x, digits)
        return -high, -low
    if x > 1:
        (least, most), (low, high) = arctangent(Fraction(1), digits), arctangent(1 / x, digits)
        return 2 * least - high, 2 * most - low
    unit, ratio = 1 << digits, x * x / (1 + x * x)
    term = int(x / (1 + x * x) * unit)
    total = count = 0
    while term:
        total, count = total + term, count + 1
        term = term * 2 * count * ratio.numerator // ((2 * count + 1) * ratio.denominator)
    # Each term is less than its number of units too small, and what is left out less than twice that of the next.
    return Fraction(total, unit), Fraction(total + (count + 2) * (count + 2), unit)
