"""Between which numbers scalars lie, whatever symbols stand for: intervals with rational ends."""

from __future__ import annotations

from collections.abc import Iterator, Mapping
from dataclasses import dataclass
from dataclasses import replace as with_fields
from fractions import Fraction
from functools import reduce
from operator import add, mul

from chasles import vocabulary as w
from chasles.statements.hypotheses import Hypothesis, nonzero
from chasles.vocabulary import Node
from chasles.vocabulary.parts import with_entries

ZERO = Fraction(0)


@dataclass(frozen=True, slots=True)
class RealInterval:
    """All numbers from `low` to `high`, without these where they are `open`; an end that is None is not there."""

    low: Fraction | None = None
    high: Fraction | None = None
    low_open: bool = False
    high_open: bool = False

    @property
    def is_positive(self) -> bool:
        """Whether all of it is greater than zero."""
        return self.low is not None and (self.low > 0 or (self.low == 0 and self.low_open))

    def __neg__(self) -> RealInterval:
        low, high = (None if end is None else -end for end in (self.high, self.low))
        return RealInterval(low, high, self.high_open, self.low_open)

    def __add__(self, other: RealInterval) -> RealInterval:
        low = None if self.low is None or other.low is None else self.low + other.low
        high = None if self.high is None or other.high is None else self.high + other.high
        return RealInterval(low, high, self.low_open or other.low_open, self.high_open or other.high_open)

    def __mul__(self, other: RealInterval) -> RealInterval:
        if not (self.is_bounded and other.is_bounded):
            return self._times_unbounded(other)
        corners = [
            (a * b, (a_open and b != 0) or (b_open and a != 0) or (a_open and b_open))
            for a, a_open in self._ends()
            for b, b_open in other._ends()
        ]
        low, high = min(at for at, _ in corners), max(at for at, _ in corners)
        reached = {at for at, is_open in corners if not is_open}
        return RealInterval(low, high, low not in reached, high not in reached)

    def _times_unbounded(self, other: RealInterval) -> RealInterval:
        """Of what has no ends, only the sign is kept."""
        for one, by in ((self, other), (-self, -other)):
            if one.low is not None and by.low is not None and one.low >= 0 and by.low >= 0:
                return RealInterval(ZERO, None, one.is_positive and by.is_positive)
            if one.low is not None and by.high is not None and one.low >= 0 >= by.high:
                return RealInterval(None, ZERO, False, one.is_positive and (-by).is_positive)
        return RealInterval()

    def power(self, exponent: int) -> RealInterval:
        """The powers of its numbers."""
        found = reduce(mul, [self] * exponent)
        return found.within(NOT_NEGATIVE) if exponent % 2 == 0 else found

    def within(self, other: RealInterval) -> RealInterval:
        """The numbers that are in both."""
        low, low_open = max(self._lows(other), default=(None, False))
        high, high_open = min(((-end, is_open) for end, is_open in (-self)._lows(-other)),
                              key=lambda end: (end[0], not end[1]), default=(None, False))  # fmt: skip
        return RealInterval(low, high, low_open, high_open)

    def _lows(self, other: RealInterval) -> list[tuple[Fraction, bool]]:
        return [(each.low, each.low_open) for each in (self, other) if each.low is not None]

    @property
    def is_bounded(self) -> bool:
        """Whether both of its ends are there."""
        return self.low is not None and self.high is not None

    def _ends(self) -> Iterator[tuple[Fraction, bool]]:
        assert self.low is not None
        assert self.high is not None
        yield from ((self.low, self.low_open), (self.high, self.high_open))


POSITIVE, NOT_NEGATIVE = RealInterval(ZERO, None, True), RealInterval(ZERO)


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
