"""Is a point one through which something moves as all that is assumed demands, at every later and earlier instant?

What is assumed, differentiated until the rates that it speaks of are higher than any that occur, is linear in these.
Where its rows there are independent, so they are nearby, and they stay the same however often it is differentiated
further: these rates are functions of all lower ones, and a motion through the point exists. Pryce, A simple structural
analysis method for DAEs, BIT 41 (2001); Campbell and Gear, The index of general nonlinear DAEs, Numer. Math. 72 (1995).
"""

from __future__ import annotations

from fractions import Fraction

from chasles import vocabulary as w
from chasles.checker.elimination import rank
from chasles.checker.reading import PolynomialProblem
from chasles.checker.relations import independent
from chasles.checker.sparse import ZERO, Polynomial, Rejected
from chasles.checker.witness import Point, value_at


def require_motion(reading: PolynomialProblem, point: Point) -> None:
    """Raises `Rejected` unless a motion through the point is known to exist that satisfies all that is assumed.

    What vanishes must vanish at the point. What is at rest there, and tied to nothing that moves, may stay as it is.
    """
    if reading.unclosed:
        raise Rejected(f"it is not known what {reading.unclosed[0]} demands of all rates")
    variables = enumerate(reading.variables)
    new = [place for place, what in variables if what[0] == "entry" and what[2] > reading.highest]
    moving = _moving(reading, point)
    rows, stated = [], []
    for origin, polynomial in reading.ahead:
        if moving.isdisjoint(_symbols(reading, polynomial)):
            continue
        partials = polynomial.partials()
        values = [value_at(partials.get(place, ZERO), point) for place in new]
        if any(value.keys() - {0} for value in values):
            raise Rejected("a rate is tied by a transcendental number")
        if any(reading.variables[place][0] == "norm" and not point[place][0] for place in polynomial.places - {*new}):
            raise Rejected("a norm that is zero at the point ties rates")
        rows.append([value.get(0, Fraction(0)) for value in values])
        stated.append(origin)
    if rank(rows) < len(rows):
        needed = independent(stated, point)
        rows = [row for row, origin in zip(rows, stated, strict=True) if origin in needed]
    if rank(rows) < len(rows):
        raise Rejected("it is not known whether a motion through the point satisfies all that is assumed")


def _moving(reading: PolynomialProblem, point: Point) -> set[w.Node]:
    """What has a rate that is not zero at the point, or that a rule makes of something; and all that is tied to it."""
    entries = [(place, *what[1:3]) for place, what in enumerate(reading.variables) if what[0] == "entry"]
    moving = {of for place, of, order in entries if order and point.get(place, (0, 0))[0]}
    for left, right in reading.rules.items():
        base, order = w.undotted(left)
        if order and any(base == of for _, of, _ in entries):
            moving |= {base}.union(*(_symbols(reading, entry) for row in reading(right) for entry in row))
    tied = [_symbols(reading, polynomial) for _, polynomial in reading.ahead]
    while more := {symbol for symbols in tied if symbols & moving for symbol in symbols} - moving:
        moving |= more
    return moving


def _symbols(reading: PolynomialProblem, polynomial: Polynomial) -> set[w.Node]:
    """The symbols of which, or of whose norms, cosines and so on, a polynomial is made."""
    found: set[w.Node] = set()
    for place in polynomial.places:
        match reading.variables[place]:
            case ("inverse", int() as factor):
                found |= _symbols(reading, reading.nonzero[factor])
            case ("moment", int() as inside, *_):
                found |= _symbols(reading, Polynomial({inside: 1}))
            case (_, w.Node() as of, *_):
                found |= {*w.symbols_of(of)}
    return found
