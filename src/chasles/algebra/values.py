"""Exact values at a point: rational numbers, or polynomials in one transcendental number.

An angle may occur outside of functions as well as in its own cosine and sine. Where these are rational the angle is
transcendental (Lindemann), so a polynomial in it with rational coefficients vanishes only if all its coefficients do.
With pi in play, angles are rational multiples of pi instead, and pi is the transcendental number.
"""

from __future__ import annotations

from fractions import Fraction

Value = dict[int, Fraction]
"""Coefficients by power of the transcendental number; a rational number has the power 0 only."""


class InPi(Fraction):
    """A rational multiple of pi, as an angle is measured where its sine and cosine are those of quarter turns."""

    __slots__ = ()

    def __str__(self) -> str:
        return shown({1: Fraction(self)}, "pi")


def is_zero(value: Value) -> bool:
    """Whether all coefficients are zero, which is whether the number is."""
    return not any(value.values())


def divided(one: Value, other: Value) -> Value | None:
    """The quotient, if the divisor is a single power; else None."""
    kept = {power: c for power, c in other.items() if c}
    if len(kept) != 1:
        return None
    ((shift, divisor),) = kept.items()
    return {power - shift: c / divisor for power, c in one.items() if c}


def shown(value: Value, name: str) -> str:
    """The value as text: 1/2, 2 pi, 1 - 3/4 phi."""
    text = ""
    for power, coefficient in sorted(value.items()):
        if not coefficient:
            continue
        size = abs(coefficient)
        unit = "" if power == 0 else name if power == 1 else f"{name}^{power}"
        piece = str(size) if not unit else unit if size == 1 else f"{size} {unit}"
        sign = "-" if coefficient < 0 else "+"
        text = f"{text} {sign} {piece}" if text else piece if sign == "+" else f"-{piece}"
    return text or "0"
