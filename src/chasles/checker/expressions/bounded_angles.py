"""Quantities between bounds, said by symbols that may have any value; squares of the last entry of a unit vector.

What is said of a quantity between two numbers is said of all values of an expression in a new symbol, of an arc if it
is an angle: everything between the bounds is such a value, and every such value is between them. Between two
multiples of pi an angle is said by its tangent, its sine or its direction.
"""

from __future__ import annotations

from collections.abc import Callable, Iterable, Mapping
from dataclasses import dataclass
from typing import Any

import sympy as sp
from sympy.functions.elementary.trigonometric import InverseTrigonometricFunction

from chasles.checker.expressions.readings import CIRCULAR

RIGHT = sp.pi / 2
MOST_HALVINGS = 2
Fresh = Callable[..., Any]
"""A new symbol by its name and assumptions."""


@dataclass(slots=True)
class Bounds:
    """What is assumed of a quantity, in multiples of 1 or of pi: it is between `low` and `high`, neither if strict."""

    unit: Any
    low: Any = -sp.oo
    high: Any = sp.oo
    strictly_above: bool = False
    strictly_below: bool = False
    texts: tuple[str, ...] = ()

    def narrow(self, difference: Any, quantity: Any, strict: bool, text: str) -> None:
        """Take note of what is said not to be negative, if a multiple of the quantity and a number add up to that."""
        slope, rest = difference.coeff(quantity), difference.subs(quantity, 0) / self.unit
        if not (slope.is_Rational and rest.is_Rational and slope):
            return
        if difference.expand() != (slope * quantity + rest * self.unit).expand():
            return
        end = -rest / slope
        if slope > 0 and (end > self.low or (end == self.low and strict)):
            self.low, self.strictly_above = end, strict
        if slope < 0 and (end < self.high or (end == self.high and strict)):
            self.high, self.strictly_below = end, strict
        self.texts = (*self.texts, text)

    def value(self, quantity: Any, spoken: Iterable[Any], fresh: Callable[..., Any]) -> Any:
        """An expression whose values are all between the bounds; None where it is not simple, or there is no room."""
        after, before, room = self.strictly_above, self.strictly_below, self.high - self.low
        if not room.is_finite or room < 0 or (room == 0 and (after or before)):
            return None
        if room == 0:
            return self.low * self.unit
        if self.unit == 1:
            return ratio(self.low, self.high, after, before, fresh)
        # A sine or a tangent of a whole angle does not tell the sign of one of its half.
        turns = [call.args[0] for e in spoken for call in e.atoms(*CIRCULAR)]
        halves = any(turn.coeff(quantity).is_Rational and turn.coeff(quantity).q % 2 == 0 for turn in turns)
        part = sp.S.Half if halves else sp.S.One
        arc = between(self.low * sp.pi * part, self.high * sp.pi * part, after, before, fresh)
        # SymPy comes to no end with the roots of what is halved in an inverse function.
        inside = any(e.has(quantity) for each in spoken for e in each.atoms(InverseTrigonometricFunction))
        return None if arc is None or (inside and is_halved(arc)) else arc / part


def is_halved(value: Any) -> bool:
    """Whether an angle is a multiple of an arctangent with roots of numbers in it."""
    calls = value.atoms(sp.atan)
    return any(abs(value.coeff(e)) > 1 and any(p.exp == sp.S.Half for p in e.atoms(sp.Pow)) for e in calls)


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


def between(low: Any, high: Any, after: bool, before: bool, fresh: Fresh, halvings: int = 0) -> Any:
    """An expression whose values are all angles between two others, without the first or the second one if so said.

    It is `after` the first one if that is excluded, and `before` the second one. None if there is no simple one.
    """
    if after and not before:
        opposite = between(-high, -low, before, after, fresh, halvings)
        return opposite and -opposite
    if high - low == 4 * RIGHT and before and not after:
        return (low + high) / 2 - sp.atan2(fresh("s_1"), fresh("c_1"))
    quarter = sp.floor(low / RIGHT)
    for middle in (quarter * RIGHT, (quarter + 1) * RIGHT):
        if high - middle <= RIGHT and (angle := _near(low - middle, high - middle, after, before, fresh)):
            return middle + angle
    half = between(low / 2, high / 2, after, before, fresh, halvings + 1) if halvings < MOST_HALVINGS else None
    return half and 2 * half


def _near(low: Any, high: Any, after: bool, before: bool, fresh: Fresh) -> Any:
    """The same between two angles that are not more than a right one away from zero."""
    if not before and RIGHT in (high, -low):
        known = {} if low else {"nonnegative": True}
        return sp.asin(fresh("s_1", **known)) if high == RIGHT and low in (-RIGHT, 0) else None
    if low == -RIGHT and not after:
        return None
    least, most = (None if abs(end) == RIGHT else sp.tan(end) for end in (low, high))
    if any(end is not None and end.has(sp.tan) for end in (least, most)):
        return None
    if least is None and most is None:
        return sp.atan(fresh("s_1"))
    if not before:
        return sp.atan(closed(least, most, fresh("s_1")))
    size = fresh("s_1", **{"positive" if after else "nonnegative": True})
    if least is None or most is None:
        return sp.atan(most - size if least is None else least + size)
    return sp.atan((least + most * size) / (1 + size))


def closed(low: Any, high: Any, any_: Any) -> Any:
    """An expression in a symbol of any value, whose values are all numbers between two others, and both of these."""
    return sp.factor(low + (high - low) * (1 + any_) ** 2 / (2 * (1 + any_**2)))


def ratio(low: Any, high: Any, after: bool, before: bool, fresh: Fresh, name: str = "d_1") -> Any:
    """An expression whose values are all numbers between two others, without those that are excluded."""
    if not (after or before):
        return closed(low, high, fresh(name))
    d = fresh(name, **{"positive" if after and before else "nonnegative": True})
    return (low + high * d) / (1 + d) if before else (high + low * d) / (1 + d)
