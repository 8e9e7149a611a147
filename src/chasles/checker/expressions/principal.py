"""Arguments of functions where hypotheses say more of them: angles between bounds, unit vectors.

An inverse function of a cosine, a sine or both is the angle itself where what is assumed keeps it between the right
bounds; a square of the last entry of a unit vector is one less those of the others.
"""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass
from fractions import Fraction
from math import inf
from typing import Any

import sympy as sp

from chasles.checker.expressions.visible import signs_of

HALF = Fraction(1, 2)


@dataclass(slots=True)
class Bounds:
    """What is assumed of an angle, in multiples of pi: it is between `low` and `high`, neither if strict."""

    low: Fraction | float = -inf
    high: Fraction | float = inf
    strictly_above: bool = False
    strictly_below: bool = False
    texts: tuple[str, ...] = ()

    def sign_of_cosine(self, strict: bool = False) -> int:
        """1 or -1 where the cosine of every angle between both has that sign, or is zero unless `strict`; else 0."""
        turns = ((self.low + self.high) / 2 + HALF) // 1
        ends = (self.low - turns, self.strictly_above), (turns - self.high, self.strictly_below)
        within = all(end > -HALF or (end == -HALF and (apart or not strict)) for end, apart in ends)
        return 0 if not within else -1 if turns % 2 else 1

    def narrow(self, difference: Any, angle: Any, strict: bool, text: str) -> bool:
        """Whether a multiple of the angle and one of pi add up to what is said not to be negative: it counts then."""
        multiples = _multiples(difference, angle)
        if multiples is None:
            return False
        slope, at_zero = multiples
        end = -at_zero / slope
        if slope > 0 and (end > self.low or (end == self.low and strict)):
            self.low, self.strictly_above = end, strict
        if slope < 0 and (end < self.high or (end == self.high and strict)):
            self.high, self.strictly_below = end, strict
        self.texts = (*self.texts, text)
        return True


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
        self.told: dict[Any, tuple[str, ...]] = {}

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

    def _by(self, ends: Bounds, angle: Any) -> Any:
        self.used |= dict.fromkeys(ends.texts)
        return angle

    def _ends(self, angle: Any) -> Bounds | None:
        """Between which multiples of pi an angle lies."""
        (symbol, *others) = angle.free_symbols or {None}
        known = self.bounds.get(symbol)
        multiples = None if others or known is None else _multiples(angle, symbol)
        if known is None or multiples is None or inf in (-known.low, known.high):
            return None
        slope, rest = multiples
        low, high = (slope * end + rest for end in (known.low, known.high))
        above, below = known.strictly_above, known.strictly_below
        ends = (low, high, above, below) if slope > 0 else (high, low, below, above)
        return Bounds(*ends, known.texts)

    def signs_of_turns(self, sides: Any) -> dict[Any, tuple[str, ...]]:
        """What bounds say of the signs of cosines and sines of the angles in the sides, and the texts of the bounds."""
        angles = sorted({e.args[0] for e in sides.atoms(sp.cos, sp.sin)}, key=str)
        for turn in (kind(angle) for angle in angles for kind in (sp.cos, sp.sin)):
            if (ends := self._ends_of_turn(turn)) and ends.sign_of_cosine():
                size = sp.Eq(sp.Abs(turn), ends.sign_of_cosine() * turn, evaluate=False)
                self.told[size] = ends.texts
        return self.told

    def _ends_of_turn(self, turn: Any) -> Bounds | None:
        """Between what the angle lies of which it is the cosine, or the sine said as a cosine."""
        shift = sp.pi / 2 if isinstance(turn, sp.sin) else 0
        return self._ends(turn.args[0] - shift) if isinstance(turn, sp.sin | sp.cos) else None

    def _is_positive(self, e: Any) -> bool:
        """Whether each factor is positive, by what is assumed."""
        factors = [power.base if power.is_Pow and power.exp.is_Integer else power for power in sp.Mul.make_args(e)]
        texts = [self._why_positive(factor) for factor in factors]
        if None in texts:
            return False
        self.used |= dict.fromkeys(text for each in filter(None, texts) for text in each)
        return True

    def _why_positive(self, factor: Any) -> tuple[str, ...] | None:
        """The texts of the hypotheses by which a factor is positive; None if it is not seen to be."""
        if (visible := signs_of(factor) == {1}) or factor in self.positive:
            return () if visible else (self.positive[factor],)
        ends = self._ends_of_turn(factor)
        return ends.texts if ends and ends.sign_of_cosine(strict=True) > 0 else None

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
