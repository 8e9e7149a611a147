"""What is visibly not negative, or positive: the checker's own short rules."""

from __future__ import annotations

from collections.abc import Collection, Iterator
from fractions import Fraction
from itertools import chain, islice
from math import comb, gcd

from chasles.checker.expressions.algebra import primitive
from chasles.checker.expressions.factoring import Terms, divides
from chasles.checker.expressions.symbolic import Symbolic
from chasles.checker.sparse import ZERO, Polynomial, exponents, number, packed, variable

MOST_SQUARES, MOST_TERMS, MOST_BOUNDS, MOST_PARTS, LARGEST_DEGREE = 6, 8, 2, 32, 60
"""So many squares are completed, each with fewer terms; so often a bound of roots or of an angle is taken; and so often
a half line is divided, for polynomials in one variable up to this degree."""
Sign = tuple[int, bool]
"""1 or -1, and whether it cannot be zero."""


class SignedReading(Symbolic):
    """Reads expressions, with what is known not to be negative; `numeric` are the variables that are numbers."""

    def __init__(self, names: dict[str, str], units: dict[str, Fraction]) -> None:
        super().__init__(names, units)
        self.numeric: set[int] = set()
        self._nonnegative: set[Terms] = set()

    def know(self, value: Polynomial) -> None:
        """Something is not negative where the question is meant."""
        self._nonnegative.add(_signed(value))

    def is_seen(self, polynomial: Polynomial) -> bool:
        """Whether something is not negative, visibly or where the roots are real."""
        return self.is_known(polynomial) or is_nonnegative(self, polynomial)

    def is_known(self, polynomial: Polynomial) -> bool:
        """Whether something is not negative where the roots are real."""
        return _signed(polynomial) in self._nonnegative

    def is_number(self, polynomial: Polynomial) -> bool:
        """Whether something is made of numbers alone."""
        return all(map(self.is_numeric, polynomial.places))

    def is_numeric(self, place: int) -> bool:
        """Whether a variable is a number."""
        parts = (self.inverses[place],) if place in self.inverses else self.calls.get(place, (None, None))[1]
        return place in self.numeric or (parts is not None and all(map(self.is_number, parts)))


def is_nonnegative(reading: SignedReading, polynomial: Polynomial) -> bool:
    """Whether a polynomial is visibly not negative: a sum of what is not, a cosine or sine being at least -1."""
    return _strictly(reading, polynomial) is not None


def is_positive(reading: SignedReading, polynomial: Polynomial) -> bool:
    """Whether a polynomial is visibly positive."""
    return _strictly(reading, polynomial) is True


def may_vanish(reading: SignedReading, polynomial: Polynomial) -> bool:
    """Whether it is not seen to have one sign, nor to be by an integer no multiple of another, as an odd one is."""
    divisor = gcd(*(c for monomial, c in polynomial.terms.items() if monomial))
    integral = (place in reading.atoms and reading.atoms[place].is_integer for place in polynomial.places)
    if divisor and polynomial.terms.get(0, 0) % divisor and all(integral):
        return False
    return not (is_positive(reading, polynomial) or is_positive(reading, -polynomial))


def _strictly(
    reading: SignedReading, polynomial: Polynomial, squares: int = MOST_SQUARES, bounds: int = MOST_BOUNDS
) -> bool | None:
    """Whether a polynomial is visibly positive rather than not negative; None where neither is visible.

    It is more by a square than what is left when that is completed; after the first one they are taken in order.
    Of what a sum of roots or circles needs, the last is positive if the sum is.
    """
    if (strict := _by_terms(reading, polynomial)) is not None or (strict := _in_one(reading, polynomial)) is not None:
        return strict
    for rest in islice(_completed(polynomial), None if squares == MOST_SQUARES else min(squares, 1)):
        if (strict := _strictly(reading, reading.normal(rest), squares - 1, bounds)) is not None:
            return strict
    for needed in chain(_by_roots(reading, polynomial), _by_circles(reading, polynomial)) if bounds else ():
        if None not in (found := [_strictly(reading, reading.normal(e), bounds=bounds - 1) for e in needed]):
            return found[-1]
    return None


def _in_one(reading: SignedReading, polynomial: Polynomial) -> bool | None:
    """The same for a polynomial in one variable, or one cosine, wherever that may be."""
    (place, *others) = polynomial.places or {-1}
    degree = max(polynomial.terms, default=0) >> 16 * max(place, 0)
    if others or place < 0 or degree > LARGEST_DEGREE:
        return None
    line = [polynomial.terms.get(packed(place, k), 0) for k in range(degree + 1)]
    if bounded := any(place in c.places | s.places for _, c, s in reading.circles.values()):
        # What is between -1 and 1 is -1 + 2/(1 + t) for a positive t.
        line = _shifted([c << k for k, c in enumerate(_shifted(line, -1))][::-1])
    known = (1, False) if bounded else _of_variable(reading, place)
    whole = bool(getattr(reading.atoms.get(place), "is_integer", False))
    halves = [[c * side**k for k, c in enumerate(line)] for side in ((known[0],) if known else (1, -1))]
    ends = [line[-1]] * bounded + [line[0]] * (not known or not known[1]) + [sum(half) for half in halves if whole]
    found = [_on_half_line(_shifted(half) if whole else half) for half in halves]
    return None if None in found or min(ends, default=1) < 0 else all(found) and min(ends, default=1) > 0


def _shifted(line: list[int], by: int = 1) -> list[int]:
    """The coefficients of a polynomial where the variable is more by a number."""
    return [sum(comb(k, j) * by ** (k - j) * c for k, c in enumerate(line[j:], j)) for j in range(len(line))]


def _on_half_line(line: list[int], parts: int = MOST_PARTS) -> bool | None:
    """Whether a polynomial is positive, or not negative, wherever its variable is positive; None for neither.

    It is divided at one until no coefficient is negative, by Vincent's theorem (Akritas and Strzebonski 2005).
    """
    if min(line) >= 0 or not parts or min(line[0], line[-1], sum(line)) < 0:
        return True if min(line) >= 0 else None
    found = [_on_half_line(_shifted(part), parts - 1) for part in (line, line[::-1])]
    return None if None in found else all(found) and sum(line) > 0


def _by_roots(reading: SignedReading, polynomial: Polynomial) -> Iterator[tuple[Polynomial, ...]]:
    """What must not be negative: a and a^2 - b^2 for a + b, of which one has all terms with one product of roots."""
    for roots, factor in _grouped(polynomial, reading.words).items():
        one = factor * Polynomial({roots: 1})
        other = polynomial - one
        yield from ((a, a * a - b * b) for a, b in ((one, other), (other, one)) if roots)


def _by_circles(reading: SignedReading, polynomial: Polynomial) -> Iterator[tuple[Polynomial, ...]]:
    """What must not be negative: a and a^2 - b^2 - c^2 for a + b cos x + c sin x, or the minors of a quadratic form."""
    for _, cosine, sine in reading.circles.values():
        (c,), (s,) = cosine.terms, sine.terms
        parts = _grouped(polynomial, cosine.places | sine.places)
        a, b, d, e, f = (parts.pop(key, ZERO) for key in (0, c, s, 2 * c, c + s))
        if not parts and not (e or f) and (b or d):
            yield a, a * a - b * b - d * d
        elif not parts and not (b or d) and (e or f):
            yield a, a + e, a * (a + e) * number(4) - f * f


def _grouped(polynomial: Polynomial, places: Collection[int]) -> dict[int, Polynomial]:
    """By each product of the variables at these places what it is multiplied by."""
    groups: dict[int, Polynomial] = {}
    for monomial, coefficient in polynomial.terms.items():
        key = sum(packed(place, power) for place, power in exponents(monomial) if place in places)
        groups[key] = groups.get(key, ZERO) + Polynomial({monomial - key: coefficient}, polynomial.below)
    return groups


def _completed(polynomial: Polynomial) -> Iterator[Polynomial]:
    """What squares of a monomial and what it is multiplied by leave: c m^2 + m b = c (m + b/2c)^2 - b^2/4c."""
    for square, c in polynomial.terms.items():
        half = [(place, power // 2) for place, power in exponents(square)]
        if not half or not _is_square(square, c):
            continue
        m = sum(packed(*pair) for pair in half)
        terms = {k: n for k, n in polynomial.terms.items() if divides(m, k) and not _is_square(k, n)}
        b = Polynomial({k - m: n for k, n in terms.items()}, polynomial.below)
        if len(terms) in range(1, MOST_TERMS):
            own = Polynomial({square: c, **terms}, polynomial.below)
            yield polynomial - own - b * b * number(Fraction(polynomial.below, 4 * c))


def _is_square(monomial: int, coefficient: int) -> bool:
    return coefficient > 0 and not any(power % 2 for _, power in exponents(monomial))


def _by_terms(reading: SignedReading, polynomial: Polynomial) -> bool | None:
    """The same, because no term is negative."""
    unknown = {place for place in polynomial.places if not reading.is_numeric(place)}
    circular = unknown & {place for _, c, s in reading.circles.values() for place in c.places | s.places}
    positive = False
    for monomial, factor in _grouped(polynomial, unknown - circular).items():
        sign = _of_product(reading, monomial)
        least = ZERO if sign is None else _least(reading, _grouped(factor, circular), sign[0])
        side = reading.sign(least)
        if sign is None or side < 0:
            return None
        positive = positive or (side > 0 and sign[1])
    return positive


def _least(reading: SignedReading, group: dict[int, Polynomial], orientation: int) -> Polynomial:
    """The least that a sum of numbers times products of cosines and sines can be, up to the sign given."""
    total = ZERO
    for monomial, coefficient in group.items():
        size = coefficient if orientation > 0 else -coefficient
        sign = reading.sign(size)
        square = sign > 0 and all(power % 2 == 0 for _, power in exponents(monomial))
        if not monomial:
            total += size
        elif not square:
            total += size if sign < 0 else -size
    return total


def _of_product(reading: SignedReading, monomial: int) -> Sign | None:
    """The sign of a product of powers."""
    sign, strict = 1, True
    for place, power in exponents(monomial):
        known = _of_variable(reading, place)
        if known is None and power % 2:
            return None
        strict = strict and (bool(getattr(reading.atoms.get(place), "is_nonzero", 0)) if known is None else known[1])
        sign *= known[0] if known is not None and power % 2 else 1
    return sign, strict


def _of_variable(reading: SignedReading, place: int) -> Sign | None:
    if place in reading.positive:
        return 1, True
    if place in reading.words:
        return 1, is_positive(reading, reading.squares[place])
    if place in reading.inverses:
        signs = (sign for sign in (1, -1) if is_nonnegative(reading, reading.inverses[place] * number(sign)))
        return next(((sign, True) for sign in signs), None)
    e = reading.atoms.get(place)
    if e is None or reading.is_known(variable(place)):
        return None if e is None else (1, bool(e.is_positive))
    if e.is_nonnegative:
        return 1, bool(e.is_positive)
    return (-1, bool(e.is_negative)) if e.is_nonpositive else None


def _signed(polynomial: Polynomial) -> Terms:
    """The same for all positive multiples."""
    scale, base = primitive(polynomial)
    return frozenset((base if scale > 0 else -base).terms.items())
