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

HALF = Fraction(1, 2)


@dataclass(frozen=True, slots=True)
class _Ends:
    """Between which multiples of pi an angle lies, and whether it is neither; `texts` say so."""

    low: Fraction
    high: Fraction
    strictly_above: bool
    strictly_below: bool
    texts: tuple[str, ...]

    def within(self, low: Fraction, high: Fraction) -> bool:
        """Whether it lies between two others, and is neither."""
        above = self.low > low or (self.low == low and self.strictly_above)
        return above and (self.high < high or (self.high == high and self.strictly_below))


@dataclass(slots=True)
class Bounds:
    """What is assumed of an angle, in multiples of pi: it is between `low` and `high`, neither if strict."""

    low: Fraction | None = None
    high: Fraction | None = None
    strictly_above: bool = False
    strictly_below: bool = False
    texts: tuple[str, ...] = ()

    @property
    def leave_room(self) -> bool:
        """Whether there is more than one angle between them."""
        return self.low is None or self.high is None or self.low < self.high

    def narrow(self, difference: Any, angle: Any, strict: bool, text: str) -> None:
        """Take into account that a multiple of the angle and a multiple of pi add up to nothing negative."""
        multiples = _multiples(difference, angle)
        if multiples is None:
            return
        slope, at_zero = multiples
        end = -at_zero / slope
        if slope > 0 and (self.low is None or end > self.low or (end == self.low and strict)):
            self.low, self.strictly_above = end, strict
        if slope < 0 and (self.high is None or end < self.high or (end == self.high and strict)):
            self.high, self.strictly_below = end, strict
        self.texts = (*self.texts, text)


def _multiples(e: Any, angle: Any) -> tuple[Fraction, Fraction] | None:
    """Of which multiples of an angle, not zero, and of pi an expression is the sum; None if it is no such sum."""
    slope, rest = e.coeff(angle), e.subs(angle, 0) / sp.pi
    if not (slope.is_Rational and rest.is_Rational and slope):
        return None
    if e.expand() != (slope * angle + rest * sp.pi).expand():
        return None
    return Fraction(int(slope.p), int(slope.q)), Fraction(int(rest.p), int(rest.q))


class PrincipalValues:
    """Says inverse functions of sines and cosines by angles, where `bounds` and what is `positive` allow it.

    `used` are the texts of the hypotheses that did.
    """

    def __init__(self, bounds: Mapping[Any, Bounds], positive: Mapping[Any, str]) -> None:
        self.bounds = bounds
        self.positive = positive
        self.used: dict[str, None] = {}

    def __call__(self, e: Any) -> Any:
        """The expression, said by angles."""
        return e.replace(lambda found: isinstance(found, (sp.acos, sp.asin, sp.atan2, sp.Abs)), self._said)

    def _said(self, e: Any) -> Any:
        match e:
            case sp.acos(args=[of]):
                return self._of_cosine(_of_double_angle(of)) or e
            case sp.asin(args=[sp.sin(args=[inner])]) if ends := self._ends(inner):
                return self._by(ends, inner) if ends.low >= -HALF and ends.high <= HALF else e
            case sp.atan2(args=[above, below]):
                return self._of_both(above, below) or e
            case sp.Abs(args=[of]) if self._is_positive(of):
                return of
            case _:
                return e

    def _of_cosine(self, cosine: Any) -> Any:
        """The angle between 0 and pi that has this cosine; None where it is not known."""
        ends = self._ends(cosine.args[0]) if isinstance(cosine, sp.cos) else None
        if ends is None or not (-1 <= ends.low <= ends.high <= 0 or 0 <= ends.low <= ends.high <= 1):
            return None
        return self._by(ends, cosine.args[0] if ends.high > 0 else -cosine.args[0])

    def _by(self, ends: _Ends, angle: Any) -> Any:
        self.used |= dict.fromkeys(ends.texts)
        return angle

    def _ends(self, angle: Any) -> _Ends | None:
        """Between which multiples of pi an angle lies."""
        (symbol, *others) = angle.free_symbols or {None}
        known = self.bounds.get(symbol)
        if others or known is None or known.low is None or known.high is None:
            return None
        multiples = _multiples(angle, symbol)
        if multiples is None:
            return None
        slope, rest = multiples
        low, high = (slope * end + rest for end in (known.low, known.high))
        above, below = known.strictly_above, known.strictly_below
        return _Ends(low, high, above, below, known.texts) if slope > 0 else _Ends(high, low, below, above, known.texts)

    def _is_positive(self, e: Any) -> bool:
        """Whether each factor is positive, by what is assumed."""
        used = dict(self.used)
        for power in sp.Mul.make_args(e):
            factor = power.base if power.is_Pow and power.exp.is_Integer else power
            if factor.is_positive:
                continue
            if factor in self.positive:
                self.used[self.positive[factor]] = None
                continue
            shift = sp.pi / 2 if isinstance(factor, sp.sin) else 0
            ends = self._ends(factor.args[0] - shift) if isinstance(factor, sp.sin | sp.cos) else None
            if ends is None or not ends.within(-HALF, HALF):
                self.used = used
                return False
            self.used |= dict.fromkeys(ends.texts)
        return True

    def _of_both(self, above: Any, below: Any) -> Any:
        """The angle of which the two are a sine and a cosine, times one positive factor; None if they are not."""
        for sign in (1, -1):
            for sine in (factor for factor in sp.Mul.make_args(above) if isinstance(factor, sp.sin)):
                factor, inner = sign * above / sine, sine.args[0]
                ends = self._ends(inner)
                if ends is None or sp.expand(below - factor * sp.cos(inner)) != 0 or not self._is_positive(factor):
                    continue
                if ends.high <= 1 and (ends.low > -1 or (ends.low == -1 and ends.strictly_above)):
                    return self._by(ends, sign * inner)
        return None


def _of_double_angle(e: Any) -> Any:
    """The expression with squares of cosines and sines said by the double angle, if it is one cosine then."""
    squared = {
        power: (1 + sign * sp.cos(2 * power.base.args[0])) / 2
        for power in e.atoms(sp.Pow)
        for sign, kind in ((1, sp.cos), (-1, sp.sin))
        if isinstance(power.base, kind) and power.exp == 2
    }
    found = sp.expand(e.xreplace(squared)) if squared else e
    return found if isinstance(found, sp.cos) else e


def in_fewer_squares(e: Any, units: Mapping[str, list[Any]]) -> tuple[Any, tuple[str, ...]]:
    """The expression with the last entry of each unit vector in no power above one, where it is shorter so."""
    used = []
    for text, entries in units.items():
        last = entries[-1]
        square = 1 - sum(entry**2 for entry in entries[:-1])

        def lowered(power: Any, last: Any = last, square: Any = square) -> Any:
            exponent = int(power.exp)
            return square ** (exponent // 2) * last ** (exponent % 2)

        before = e.expand()
        above, below = before.together().as_numer_denom()
        found = above.expand().replace(
            lambda p, last=last: p.is_Pow and p.base == last and p.exp.is_Integer and p.exp > 1, lowered
        ).expand() / below  # fmt: skip
        if found != e and found.count_ops() < before.count_ops():
            e = found
            used.append(text)
    return e, tuple(used)
