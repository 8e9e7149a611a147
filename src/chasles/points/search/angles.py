"""Angles at a point: cosine and sine are rational where the angle is free, and fit the angle where it stands alone.

An angle with rational cosine and sine is zero or transcendental (Lindemann), so one angle that also stands alone may be
the transcendental number of `surds`. Where several do, or pi does, they are multiples of quarter turns.
"""

from __future__ import annotations

from collections.abc import Callable, Mapping, Sequence
from fractions import Fraction
from random import Random

from chasles.algebra.surds import SurdSum, square_root
from chasles.points.search.constraints import BoundAngle, ConstraintSystem
from chasles.points.search.values import Values
from chasles.vocabulary import Symbol

NO_TURN = 0.2
"""How often the angle is zero, the only one that is rational together with its cosine and sine."""
QUARTERS = tuple(Fraction(k, 2) for k in (1, 2, -1, 0))
NO_TURNS = (Fraction(0),)
TURNS = QUARTERS + tuple(Fraction(k, n) for k, n in ((1, 3), (-2, 3), (1, 4), (3, 4), (1, 6), (-5, 6)))
"""Angles in units of pi; all but the quarter turns have irrational cosines or sines."""
SINES = {Fraction(0): 0, Fraction(1, 6): 1, Fraction(1, 4): 2, Fraction(1, 3): 3, Fraction(1, 2): 4}
"""The square of twice the sine, by the angle in units of pi."""
Products = Mapping[Symbol, Mapping[Symbol, int]]


class Turning:
    """Which angles are fixed by something that stands alone, and what the transcendental number is."""

    def __init__(self, system: ConstraintSystem, products: Products, rigid: frozenset[Symbol]) -> None:
        self.system = system
        self.rigid = rigid
        self.products = {a.symbol: products[a.symbol] for a in system.angles if a.symbol in products}
        self.fixed = [a for a in system.angles if a.bare is not None]
        self.fixed += [a for a in system.angles if a.symbol in self.products and self._private(a.symbol) is None]
        self.by_quarters = system.pi is not None or len(self.fixed) > 1

    @property
    def theta(self) -> Symbol | None:
        """The angle that is the transcendental number; None if pi is."""
        return self.fixed[0].symbol if self.fixed and not self.by_quarters else None

    def _private(self, product: Symbol) -> Symbol | None:
        """A factor that occurs nowhere else: it can make the product any angle, give or take whole turns."""
        elsewhere = {a.symbol for a in self.system.angles} | self.rigid
        for other, factors in self.products.items():
            elsewhere |= set(factors) if other != product else set()
        free = (f for f in self.products[product] if f not in elsewhere and f.name not in self.system.place)
        return next(free, None)

    def nonzero(self) -> list[int]:
        """The places of factors that must not vanish for their product to be any angle."""
        return [
            self.system.place[factor.name]
            for factors in self.products.values()
            for factor in factors
            if factor.name in self.system.place
        ]

    def draw(
        self, values: Values, number: Callable[[int], Fraction], random: Random, turns: Sequence[Fraction] | None
    ) -> bool:
        """Give the fixed angles their values; False if that does not work out this time.

        `turns` are what to choose from, in units of pi, if only some will do.
        """
        if self.system.pi is not None:
            values[self.system.pi] = SurdSum.theta()
        return all(self._draw(angle, values, number, random, turns) for angle in self.fixed)

    def _draw(
        self,
        angle: BoundAngle,
        values: Values,
        number: Callable[[int], Fraction],
        random: Random,
        turns: Sequence[Fraction] | None,
    ) -> bool:
        if self.by_quarters or turns == NO_TURNS:
            turn = random.choice(turns or TURNS)
            turn += 2 * random.choice((0, 0, 1, -1, 2)) if turn else 0
            cosine, sine = _at_turn(turn)
            size = SurdSum.theta() * SurdSum.rational(turn / angle.unit)
        elif random.random() < NO_TURN:
            cosine, sine, size = SurdSum.rational(1), SurdSum({}), SurdSum({})
        else:
            t = random.choice((Fraction(1), Fraction(1, 2), Fraction(2), Fraction(1, 3), Fraction(-1, 2)))
            cosine, sine = SurdSum.rational((1 - t * t) / (1 + t * t)), SurdSum.rational(2 * t / (1 + t * t))
            size = SurdSum.theta()
        values[angle.cosine], values[angle.sine] = cosine, sine
        if angle.bare is not None:
            values[angle.bare] = size
            return True
        return self._split(angle, size, values, number)

    def _split(self, angle: BoundAngle, size: SurdSum, values: Values, number: Callable[[int], Fraction]) -> bool:
        """Let a product of factors have a given size: all but one of them are drawn."""
        factors = self.products[angle.symbol]
        inside = [f for f in factors if f.name in self.system.place]
        last = next((f for f in inside if abs(factors[f]) == 1 and self.system.place[f.name] not in values), None)
        turning = {a.symbol for a in self.system.angles}
        # A factor that does not stand alone counts as one, which an angle with a rational cosine is not.
        if last is None or any(factor in turning for factor in factors if factor not in inside):
            return False
        rest: SurdSum | None = SurdSum.rational(1)
        for factor in inside:
            place = self.system.place[factor.name]
            if factor == last:
                continue
            if place not in values:
                values[place] = number(place) or Fraction(1)
            inverse = values[place].inverse()
            base = values[place] if factors[factor] > 0 else inverse
            rest = None if rest is None or base is None else rest * base ** abs(factors[factor])
        inverse = None if rest is None else rest.inverse()
        value = None if inverse is None else size * inverse
        if value is None:
            return False
        if factors[last] < 0:
            value = value.inverse()
        if value is None:
            return False
        values[self.system.place[last.name]] = value
        return True


def _at_turn(turns: Fraction) -> tuple[SurdSum, SurdSum]:
    """Cosine and sine of an angle in units of pi."""
    return _sine(turns + Fraction(1, 2)), _sine(turns)


def _sine(turns: Fraction) -> SurdSum:
    turns %= 2
    sign = -1 if turns > 1 else 1
    turns %= 1
    root = square_root(Fraction(SINES[min(turns, 1 - turns)], 4))
    assert root is not None
    return root * SurdSum.rational(sign)
