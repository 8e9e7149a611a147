"""Does a point satisfy all that is assumed? Each hypothesis is evaluated there, exactly."""

from __future__ import annotations

from collections.abc import Mapping
from fractions import Fraction
from math import isqrt, prod
from typing import Any

from chasles.checker.quantities import squeezed
from chasles.checker.reading import PolynomialProblem
from chasles.checker.sparse import Polynomial, Rejected, exponents

QUARTERS = tuple((Fraction(cosine), Fraction(sine)) for cosine, sine in ((1, 0), (0, 1), (-1, 0), (0, -1)))
"""Cosine and sine of none, one, two and three quarter turns."""
Point = dict[int, tuple[Fraction, int]]
"""For each variable a rational number, and the power, 0 or 1, of the one transcendental number by which it is
multiplied."""


def point_of(reading: PolynomialProblem, values: Mapping[str, Any]) -> Point:
    """The point with these values; raises `Rejected` where they contradict what the variables mean.

    An angle that occurs beside its own cosine and sine is transcendental, because these are rational (Lindemann). With
    pi, or another such angle, in play it is given in units of pi: its cosine and sine must be those of quarter turns.
    """
    stated = (*reading.vanishing.values(), *reading.nonzero, *(positive for _, positive in reading.positive))
    in_play = "pi" in values or any(reading.places.get("pi") in polynomial.places for polynomial in stated)
    pi = {reading.places["pi"]} if "pi" in reading.places and in_play else set()
    numbers: dict[int, Any] = dict.fromkeys(pi, Fraction(1))
    for name, value in values.items():
        place = reading.places.get(squeezed(name))
        if place is not None and numbers.setdefault(place, here := Fraction(str(value))) != here:
            raise Rejected(f"{name} is given two values")
    angles = [(place, *what[1:]) for place, what in enumerate(reading.variables) if what[0] == "cos"]
    bare = pi | {reading.places[symbol.name] for _, symbol, _ in angles} & numbers.keys()
    for place, symbol, unit in angles:
        bare_place = reading.places[symbol.name]
        if bare_place in bare and (in_play or len(bare) > 1 or not numbers[bare_place]):
            quarters = 2 * unit * numbers[bare_place]
            cosine, sine = QUARTERS[int(quarters) % 4]
            fits = numbers.get(place, cosine) == cosine and numbers.get(place + 1, sine) == sine
            if quarters.denominator != 1 or not fits:
                raise Rejected(f"cosine and sine of {symbol} are not those of the angle given")
    lengths = {reading.places.get(symbol.name) for symbol in reading.problem.nonnegative}
    for place, value in numbers.items():
        if (place in lengths or reading.variables[place][0] == "norm") and value < 0:
            raise Rejected("a norm is given a negative value")
    return {place: (value, int(place in bare)) for place, value in numbers.items()}


def value_at(polynomial: Polynomial, point: Point) -> dict[int, Any]:
    """The value, by power of the transcendental number; empty if it is zero."""
    total: dict[int, Any] = {}
    for monomial, coefficient in polynomial.terms.items():
        powers = exponents(monomial)
        power = sum(point[place][1] * exponent for place, exponent in powers)
        value = prod((point[place][0] ** exponent for place, exponent in powers), start=Fraction(coefficient))
        total[power] = total.get(power, Fraction(0)) + value
    return {power: value / polynomial.below for power, value in total.items() if value}


def root_of(square: Fraction) -> Fraction | None:
    """The rational square root, if there is one."""
    root = Fraction(isqrt(max(square.numerator, 0)), isqrt(square.denominator))
    return root if root * root == square else None


def _standing_for(reading: PolynomialProblem, occurring: set[int]) -> set[int]:
    """The variables that occur, and those by which they are what they are: a norm's vector, a cosine's sine."""
    inverses = {place for place in occurring if place < len(reading.nonzero)}
    needed = occurring.union(*(reading.nonzero[place].places for place in inverses)) - inverses
    for place in tuple(needed):
        match reading.variables[place]:
            case ("cos", *_):
                needed.add(place + 1)
            case ("sin", *_):
                needed.add(place - 1)
            case ("norm", of):
                needed |= reading.vanishing[f"norm |{of}|"].places
    return needed


def require(reading: PolynomialProblem, point: Point, occurring: set[int]) -> None:
    """All that occurs has a value at the point; what vanishes does, no nonzero factor does, and what is positive is."""
    if lacking := _standing_for(reading, occurring) - point.keys():
        names = {place: name for name, place in reading.places.items()}
        raise Rejected(f"no value is given for {', '.join(names[place] for place in sorted(lacking))}")
    for label, polynomial in reading.vanishing.items():
        if polynomial.places <= point.keys() and value_at(polynomial, point):
            raise Rejected(f"the point does not satisfy {label}")
    for label, factor in zip(reading.places, reading.nonzero, strict=False):
        if factor.places <= point.keys() and not value_at(factor, point):
            raise Rejected(f"the point does not satisfy {label}")
    for label, positive in reading.positive:
        values = value_at(positive, point).values() if positive.places <= point.keys() else [1]
        if not values or any(value < 0 for value in values):
            raise Rejected(f"the point does not satisfy {label}")
