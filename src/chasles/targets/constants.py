"""How is an exact constant written so that the machine's value is the correctly rounded one?

A short finite decimal stands as it is, another fraction as a division of two numbers that the precision holds
exactly, and what is left as the decimal of the correctly rounded value.
"""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass
from decimal import Context, Decimal, Inexact
from fractions import Fraction

from chasles.targets.dialect import Level
from chasles.targets.kernel import EmissionError

_DIGITS = 17


@dataclass(frozen=True, slots=True)
class Precision:
    """A binary floating-point format: its significand's bits, and the normal range as powers of two."""

    name: str
    bits: int
    least: int
    most: int
    digits: int
    suffix: str = ""

    def holds(self, value: Fraction) -> bool:
        """Whether the nearest number is in the normal range, or else is the value itself."""
        size = abs(rounded(value, self.bits))
        if size < Fraction(2) ** self.least:
            return (size / Fraction(2) ** (self.least - self.bits + 1)).denominator == 1
        return size < Fraction(2) ** self.most


DOUBLE = Precision("double", 53, -1022, 1024, 17)
SINGLE = Precision("float", 24, -126, 128, 9, "f")


def literals(precision: Precision) -> Callable[[Fraction], tuple[str, Level]]:
    """The `constant` of a dialect of this precision."""
    return lambda value: literal(value, precision)


def literal(value: Fraction, precision: Precision) -> tuple[str, Level]:
    """The text of `value` and how tightly it binds. Raises EmissionError for what the precision does not hold."""
    if not precision.holds(value):
        about = Context(prec=6).divide(Decimal(value.numerator), Decimal(value.denominator))
        raise EmissionError(f"the constant {about} is outside the normal range of {precision.name}")
    finite = _finite_decimal(value)
    if finite is not None:
        return _signed(finite + precision.suffix)
    if max(abs(value.numerator), value.denominator) <= 2**precision.bits:
        # A division always stands in parentheses: 1.0 / 3.0 * x would read as 1.0 / (3.0 * x).
        return f"{value.numerator}.0{precision.suffix} / {value.denominator}.0{precision.suffix}", Level.SUM
    return _signed(_pointed(f"{float(rounded(value, precision.bits)):.{precision.digits}g}") + precision.suffix)


def rounded(value: Fraction, bits: int) -> Fraction:
    """The number of so many significant bits nearest to `value`, ties to even, the exponent unbounded."""
    if not value:
        return value
    exponent = abs(value.numerator).bit_length() - value.denominator.bit_length() - bits
    while abs(value) >= Fraction(2) ** (bits + exponent):
        exponent += 1
    while abs(value) < Fraction(2) ** (bits + exponent - 1):
        exponent -= 1
    return round(value / Fraction(2) ** exponent) * Fraction(2) ** exponent


def _finite_decimal(value: Fraction) -> str | None:
    """The decimal expansion, where it ends within `_DIGITS` digits."""
    context = Context(prec=_DIGITS, traps=[Inexact])
    try:
        quotient = context.divide(Decimal(value.numerator), Decimal(value.denominator)).normalize(context)
    except Inexact:
        return None
    plain = -5 <= quotient.adjusted() <= 15
    return _pointed(format(quotient, "f" if plain else "e"))


def _pointed(numeral: str) -> str:
    """The numeral with the point or exponent that makes it a floating-point literal."""
    return numeral if set(numeral) & set(".e") else f"{numeral}.0"


def _signed(numeral: str) -> tuple[str, Level]:
    return numeral, Level.SIGN if numeral.startswith("-") else Level.ATOM
