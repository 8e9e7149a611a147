"""Angles of points, for the checker: their cosines and sines, and the bounds between which their sums lie."""

from __future__ import annotations

from fractions import Fraction

from chasles.checker.expressions.algebra import constant
from chasles.checker.expressions.factoring import Terms
from chasles.checker.expressions.functions import Functions
from chasles.checker.expressions.known_roots import KnownRoots
from chasles.checker.expressions.signs import is_nonnegative, is_positive
from chasles.checker.sparse import ONE, ZERO, Polynomial, Rejected, exponents, number, variable

MOST_HALVINGS = 10


class Arcs:
    """The angles of points in a reading, each a variable; `points` are their coordinates, y first."""

    def __init__(self, reading: KnownRoots, functions: Functions) -> None:
        self.reading, self.functions = reading, functions
        self.places: dict[tuple[Terms, ...], int] = {}
        self.points: dict[int, tuple[Polynomial, Polynomial]] = {}

    def arc(self, y: Polynomial, x: Polynomial) -> Polynomial:
        """The angle of the point (x, y), which is not the origin."""
        if not y and (is_positive(self.reading, x) or is_positive(self.reading, -x)):
            return ZERO if is_positive(self.reading, x) else self.reading.half_turn()
        sizes = () if constant(x) is not None else (x, -x)
        if size := next((size for size in sizes if is_positive(self.reading, size)), None):
            y, x = (self.reading.in_lowest_terms(side * self.reading.inverse(size)) for side in (y, x))
        if self.reading.complete and self.reading.is_number(x) and self.reading.is_number(y):
            multiple = self.reading.part_of_turn(y, x)
            if multiple is not None:
                return self.reading.half_turn() * number(multiple)
        (above, below), (other, another) = self.reading.cleared(y), self.reading.cleared(x)
        key = tuple(frozenset((*p.terms.items(), (-1, p.below))) for p in (above, other))
        key = (*key, frozenset(below.items()), frozenset(another.items()))
        opposite = (frozenset((*(-above).terms.items(), (-1, above.below))), *key[1:])
        # Where y is zero and x is negative, the angles of (x, y) and of (x, -y) are the same, pi.
        mirrored = is_nonnegative(self.reading, x) or any(is_positive(self.reading, side) for side in (y, -y))
        if key not in self.places and opposite in self.places and mirrored:
            return -variable(self.places[opposite])
        if key not in self.places:
            place = self.places[key] = self.functions.named("arc", y, x)
            self.points[place], self.reading.adds_roots = (y, x), True
            self.functions.require_nonzero(x * x + y * y)
        return variable(self.places[key])

    def direction(self, place: int, multiple: Fraction, both: bool = True) -> tuple[Polynomial, Polynomial]:
        """Cosine and sine of a multiple of the angle of a point; where not `both` count, half a turn may be halved.

        Of a place below zero it is that of its complement, whose sine is not negative, nor is that of half of it.
        """
        read, (y, x) = self.reading, self.points[place] if place >= 0 else self.points[~place][::-1]
        square = read.normal(x * x + y * y)
        for _ in range(multiple.denominator.bit_length() - 1):
            inverse = read.normal(read.root(square) * self.functions.inverse(square))
            cosine, sine = read.normal(x * inverse), read.normal(y * inverse)
            half = (ONE + cosine) * number(Fraction(1, 2))
            for side in (half, ONE - half):
                read.know(side)
            x, y, square = read.root(half), ZERO, ONE
            if both:
                y = read.root(ONE - half) if place < 0 else read.normal(sine * x * self.functions.inverse(half + half))
        power = abs(multiple.numerator)
        cosine, sine = read.complex_power(x, y, power)
        inverse = read.power(self.functions.inverse(square), (power + 1) // 2)
        inverse = inverse * read.root(square) if power % 2 else inverse
        return read.normal(cosine * inverse), read.normal((sine if multiple > 0 else -sine) * inverse)

    def split(self, angle: Polynomial) -> tuple[list[tuple[int, Fraction]], Polynomial]:
        """The angles of points in a sum, with their multiples, and the rest."""
        parts, rest, turn = [], ZERO, Fraction(0)
        for monomial, coefficient in angle.terms.items():
            multiple = Fraction(coefficient, angle.below)
            match exponents(monomial):
                case [(place, 1)] if place in self.points and multiple.denominator.bit_count() == 1:
                    parts.append((place, multiple))
                case _ if self.reading.is_half_turn(monomial):
                    turn += multiple
                case _:
                    rest += Polynomial({monomial: coefficient}, angle.below)
        for k, (place, multiple) in enumerate(parts):
            simpler = multiple.denominator > 1 and (turn + multiple / 2).denominator < turn.denominator
            if simpler and is_nonnegative(self.reading, self.points[place][1]):
                parts[k], turn = (~place, -multiple), turn + multiple / 2
        return parts, rest + self.reading.half_turn() * number(turn)

    def ends(self, place: int) -> list[tuple[Fraction, bool]]:
        """The bounds of the angle of a point in half turns, and whether each is open: -1 is never attained."""
        y, x = self.points[place]
        right, ahead = is_nonnegative(self.reading, x), is_positive(self.reading, x)
        above, below = is_positive(self.reading, y), is_positive(self.reading, -y)
        most = Fraction(1, 2) if right else Fraction(1)
        low = (Fraction(0), above) if is_nonnegative(self.reading, y) else (-most, ahead or not right)
        falls = below or (right and is_nonnegative(self.reading, -y))
        return [low, (Fraction(0), below) if falls else (most, ahead or (above and not right))]

    def bounds(self, angle: Polynomial) -> list[tuple[Fraction, bool]]:
        """The bounds of a sum of angles in half turns, and whether each is open; raises `Rejected` for others."""
        found = [(Fraction(0), False)] * 2
        for monomial, coefficient in angle.terms.items():
            multiple = Fraction(coefficient, angle.below)
            match exponents(monomial):
                case [(place, 1)] if place in self.points:
                    ends = self.ends(place)[:: 1 if multiple > 0 else -1]
                case _ if self.reading.is_half_turn(monomial):
                    ends = [(Fraction(1), False)] * 2
                case _:
                    raise Rejected("what is said to be a sum of angles is none")
            found = [(a + multiple * b, one or other) for (a, one), (b, other) in zip(found, ends, strict=True)]
        return found

    def turned(self, difference: Polynomial, halvings: int) -> Polynomial:
        """What vanishes only where a sum of angles does: its cosine less one, if that is one nowhere else."""
        size = 2 ** min(halvings + 1, MOST_HALVINGS)
        within = all(abs(end) < size or (abs(end) == size and strict) for end, strict in self.bounds(difference))
        if halvings >= MOST_HALVINGS or not within:
            raise Rejected("a sum of angles is not known to be less than a turn")
        return self.reading.turn(difference * number(Fraction(1, 2**halvings)), both=False)[0] - ONE
