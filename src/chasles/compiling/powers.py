"""Which steps compute a rational power? Products and roots, where these are few."""

from __future__ import annotations

from fractions import Fraction

from chasles.lowering.builder import Builder

MOST_FACTORS = 32
"""A whole power of more factors is left to the function `pow`: so many roundings would add up."""


def power(build: Builder, base: int, exponent: Fraction) -> int:
    """The base to a positive rational power: by products and roots, by `pow` where these are many or there are none."""
    twos, rest = _parted(exponent.denominator, 2)
    threes, rest = _parted(rest, 3)
    if exponent.numerator > MOST_FACTORS * exponent.denominator or rest > 1 or twos + threes > 2:
        return build.function("pow", base, build.constant(exponent))
    whole, left = divmod(exponent.numerator, exponent.denominator)
    if threes:
        whole, left = 0, exponent.numerator
    root = base
    for _ in range(threes):
        root = where_nonnegative(build, root, build.function("cbrt", root))
    for _ in range(twos):
        root = build.square_root(root)
    total = build.multiply(_whole_power(build, root, left), _whole_power(build, base, whole))
    if exponent > 1 and root != base:
        # The slope of a root is infinite at zero, and that of its third power is not.
        build.rate_by(total, (base, build.multiply(build.constant(exponent), power(build, base, exponent - 1))))
    return total


def _parted(number: int, prime: int) -> tuple[int, int]:
    """How often a prime divides the number, and what is left of it."""
    count = 0
    while number % prime == 0:
        number, count = number // prime, count + 1
    return count, number


def _whole_power(build: Builder, base: int, exponent: int) -> int:
    """The power by squaring."""
    total = build.one
    while exponent:
        if exponent % 2:
            total = build.multiply(total, base)
        exponent //= 2
        base = build.multiply(base, base) if exponent else base
    return total


def where_nonnegative(build: Builder, a: int, value: int) -> int:
    """The value where a is not negative, and not a number elsewhere."""
    return build.select(build.less(a, build.zero), build.not_a_number(), value)
