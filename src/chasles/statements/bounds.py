"""Between which numbers scalars lie, whatever symbols stand for: intervals with rational ends."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass
from dataclasses import replace as with_fields
from fractions import Fraction
from functools import reduce
from math import inf
from operator import add, mul

from chasles import vocabulary as w
from chasles.statements.hypotheses import Hypothesis, nonzero
from chasles.vocabulary import Node
from chasles.vocabulary.parts import with_entries

ZERO = Fraction(0)


@dataclass(frozen=True, slots=True)
class RealInterval:
    """All numbers from `low` to `high`, without these where they are `open`."""

    low: Fraction | float = -inf
    high: Fraction | float = inf
    low_open: bool = False
    high_open: bool = False

    @property
    def is_positive(self) -> bool:
        """Whether all of it is greater than zero."""
        return self.low > 0 or (self.low == 0 and self.low_open)

    def __neg__(self) -> RealInterval:
        return RealInterval(-self.high, -self.low, self.high_open, self.low_open)

    def __add__(self, other: RealInterval) -> RealInterval:
        opened = self.low_open or other.low_open, self.high_open or other.high_open
        return RealInterval(self.low + other.low, self.high + other.high, *opened)

    def __mul__(self, other: RealInterval) -> RealInterval:
        if inf in (-self.low, self.high, -other.low, other.high):
            return self._times_unbounded(other)
        corners = [
            (a * b, (a_open and b != 0) or (b_open and a != 0) or (a_open and b_open))
            for a, a_open in self._ends
            for b, b_open in other._ends
        ]
        low, high = min(at for at, _ in corners), max(at for at, _ in corners)
        reached = {at for at, is_open in corners if not is_open}
        return RealInterval(low, high, low not in reached, high not in reached)

    def _times_unbounded(self, other: RealInterval) -> RealInterval:
        """Of what has no ends, only the sign is kept."""
        for one, by in ((self, other), (-self, -other)):
            if one.low >= 0 and by.low >= 0:
                return RealInterval(ZERO, inf, one.is_positive and by.is_positive)
            if one.low >= 0 >= by.high:
                return RealInterval(-inf, ZERO, False, one.is_positive and (-by).is_positive)
        return RealInterval()

    def power(self, exponent: int) -> RealInterval:
        """The powers of its numbers."""
        found = reduce(mul, [self] * exponent)
        return found.within(NOT_NEGATIVE) if exponent % 2 == 0 else found

    def within(self, other: RealInterval) -> RealInterval:
        """The numbers that are in both."""
        low, high = zip(self._ends, other._ends, strict=True)
        least, most = max(low), min(high, key=lambda end: (end[0], not end[1]))
        return RealInterval(least[0], most[0], least[1], most[1])

    @property
    def _ends(self) -> tuple[tuple[Fraction | float, bool], ...]:
        return (self.low, self.low_open), (self.high, self.high_open)


POSITIVE, NOT_NEGATIVE = RealInterval(ZERO, inf, True), RealInterval(ZERO)


def seen_not_to_vanish(divisor: Node, rules: Mapping[Node, Node]) -> Hypothesis:
    """That a scalar is not zero: "evident" where it is positive or negative whatever symbols stand for, else a need."""
    interval, said = bounds_of(divisor, rules), nonzero(with_entries(divisor))
    evident = interval.is_positive or (-interval).is_positive
    return with_fields(said, kind="evident") if evident else with_fields(said, free=True)


def bounds_of(node: Node, rules: Mapping[Node, Node]) -> RealInterval:
    """Between which numbers a scalar lies, whatever symbols stand for."""

    def inside(part: Node) -> RealInterval:
        return bounds_of(part, rules)

    match node:
        case w.PI:
            return POSITIVE
        case w.Symbol() if node in rules:
            return inside(rules[node])
        case w.Symbol(stands_for=w.Node() as of) | w.Group(of):
            return inside(of)
        case w.Number(value):
            return RealInterval(value, value)
        case w.Negative(of):
            return -inside(of)
        case w.Sum(terms):
            return reduce(add, map(inside, terms))
        case w.Scale(one, other) if one == other and one.is_scalar:
            return inside(one).power(2)
        case w.Scale(one, other) if other.is_scalar:
            return inside(one) * inside(other)
        case w.Quotient(above, below) if above.is_scalar and inside(below).is_positive:
            return inside(above) * POSITIVE
        case w.Power(base, int(exponent)) if base.is_scalar:
            return inside(base).power(exponent)
        case w.Dot(one, other) | w.Contract((w.Transpose(one), other)) if one == other and one.shape[1] == 1:
            return NOT_NEGATIVE
        case w.Norm():
            return NOT_NEGATIVE
        case w.Integral(w.Number(value)) if value > 0:
            return POSITIVE
        case w.Call():
            return RealInterval(Fraction(-1), Fraction(1))
        case _:
            return RealInterval()
