"""Arguments of functions where hypotheses say more of them: angles between bounds, unit vectors.

An inverse function of a cosine, a sine or both is the angle itself where what is assumed keeps it between the right
bounds; a square of the last entry of a unit vector is one less those of the others.
"""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass
from fractions import Fraction
from typing import Any

import sympy as sp

__all__ = ["Bounds", "in_fewer_squares", "principal"]


@dataclass(slots=True)
class Bounds:
    """What is assumed of an angle, in multiples of pi: it is at least `low` and at most `high`, or beyond if strict."""

    low: Fraction | None = None
    high: Fraction | None = None
    strictly_above: bool = False
    texts: tuple[str, ...] = ()

    @property
    def leave_room(self) -> bool:
        """Whether there is more than one angle between them."""
        return self.low is None or self.high is None or self.low < self.high

    def narrow(self, difference: Any, angle: Any, strict: bool, text: str) -> None:
        """Take into account that a multiple of the angle and a multiple of pi add up to nothing negative."""
        slope, at_zero = difference.coeff(angle), difference.subs(angle, 0) / sp.pi
        if difference.expand() != (slope * angle + at_zero * sp.pi).expand() or not slope.is_Rational:
            return
        if not at_zero.is_Rational or not slope:
            return
        end = _fraction(-at_zero / slope)
        if slope > 0 and (self.low is None or end > self.low or (end == self.low and strict)):
            self.low, self.strictly_above = end, strict
        if slope < 0 and (self.high is None or end <= self.high):
            self.high = end
        self.texts = (*self.texts, text)


def _fraction(rational: Any) -> Fraction:
    return Fraction(int(rational.p), int(rational.q))


def principal(e: Any, bounds: Mapping[Any, Bounds]) -> tuple[Any, tuple[str, ...]]:
    """The expression with inverse functions of sines and cosines replaced by angles, and the texts that allow it."""
    used: dict[str, None] = {}

    def between(angle: Any) -> tuple[Fraction, Fraction, bool] | None:
        (symbol, *others) = angle.free_symbols or {None}
        known = bounds.get(symbol)
        if others or known is None or known.low is None or known.high is None:
            return None
        slope, rest = angle.coeff(symbol), angle.subs(symbol, 0) / sp.pi
        if not (slope.is_Rational and rest.is_Rational and slope):
            return None
        if angle.expand() != (slope * symbol + rest * sp.pi).expand():
            return None
        ends = [_fraction(slope) * end + _fraction(rest) for end in (known.low, known.high)]
        used.update(dict.fromkeys(known.texts))
        return min(ends), max(ends), known.strictly_above and slope > 0

    def angle_of(found: Any) -> Any:
        match found:
            case sp.acos(args=[sp.cos(args=[inner])]) if ends := between(inner):
                if ends[0] >= 0 and ends[1] <= 1:
                    return inner
                return -inner if ends[0] >= -1 and ends[1] <= 0 else found
            case sp.asin(args=[sp.sin(args=[inner])]) if ends := between(inner):
                return inner if ends[0] >= Fraction(-1, 2) and ends[1] <= Fraction(1, 2) else found
            case sp.atan2(args=[above, below]):
                return _of_both(above, below, between) or found
            case _:
                return found

    inverse = (sp.acos, sp.asin, sp.atan2)
    changed = e.replace(lambda found: isinstance(found, inverse), angle_of)
    return changed, tuple(used) if changed != e else ()


def _of_both(above: Any, below: Any, between: Any) -> Any:
    """The angle of which the two are a sine and a cosine, times one positive factor; None if they are not."""
    sines = [factor for factor in sp.Mul.make_args(above) if isinstance(factor, sp.sin)]
    for sine in sines:
        factor, inner = above / sine, sine.args[0]
        ends = between(inner) if factor.is_positive and sp.expand(below - factor * sp.cos(inner)) == 0 else None
        if ends and ends[1] <= 1 and (ends[0] > -1 or (ends[0] == -1 and ends[2])):
            return inner
    return None


def in_fewer_squares(e: Any, units: Mapping[str, list[Any]]) -> tuple[Any, tuple[str, ...]]:
    """The expression with the last entry of each unit vector in no power above one, where it is shorter so."""
    used = []
    for text, entries in units.items():
        last = entries[-1]
        square = 1 - sum(entry**2 for entry in entries[:-1])

        def lowered(power: Any, last: Any = last, square: Any = square) -> Any:
            exponent = int(power.exp)
            return square ** (exponent // 2) * last ** (exponent % 2)

        found = e.expand().replace(
            lambda p, last=last: p.is_Pow and p.base == last and p.exp.is_Integer and p.exp > 1, lowered
        )
        found = sp.expand(found)
        if found != e and found.count_ops() < e.expand().count_ops():
            e = found
            used.append(text)
    return e, tuple(used)
