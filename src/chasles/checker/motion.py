"""Is a point one through which something moves as all that is assumed demands, at every later and earlier instant?

What is assumed, differentiated until the rates that it speaks of are higher than any that occur, is linear in these.
Where its rows there are independent, so they are nearby, and they stay the same however often it is differentiated
further: these rates are functions of all lower ones, and a motion through the point exists. Pryce, A simple structural
analysis method for DAEs, BIT 41 (2001); Campbell and Gear, The index of general nonlinear DAEs, Numer. Math. 72 (1995).

Rows are independent but for those of polynomials of which a sum of multiples vanishes whatever the variables are, as
w . (w x v) does: near a point at which one of these multiples is not zero, its polynomial vanishes with the others.
"""

from __future__ import annotations

from collections.abc import Sequence
from fractions import Fraction

from chasles import vocabulary as w
from chasles.checker.reading import PolynomialProblem
from chasles.checker.sparse import ZERO, Polynomial, Rejected, packed
from chasles.checker.witness import Point, value_at

Row = dict[int, Fraction]
MOST_MULTIPLES = 400
"""So many products of polynomials and variables are looked at, at most."""


def eliminated(rows: Sequence[Sequence[Fraction]], size: int) -> tuple[list[list[Fraction]], list[int]]:
    """The rows in reduced echelon form, and those of the first `size` columns in which they begin."""
    reduced, pivots = [list(row) for row in rows], list[int]()
    for column in range(size):
        done = len(pivots)
        pivot = next((row for row in range(done, len(reduced)) if reduced[row][column]), None)
        if pivot is not None:
            reduced[done], reduced[pivot] = reduced[pivot], reduced[done]
            lead = reduced[done] = [x / reduced[done][column] for x in reduced[done]]
            for row in {*range(len(reduced))} - {done}:
                if factor := reduced[row][column]:
                    reduced[row] = [x - factor * y for x, y in zip(reduced[row], lead, strict=True)]
            pivots.append(column)
    return reduced, pivots


def rank(rows: Sequence[Sequence[Fraction]]) -> int:
    """The rank."""
    return len(eliminated(rows, len(rows[0]))[1]) if rows else 0


def independent(polynomials: Sequence[Polynomial], point: Point) -> list[Polynomial]:
    """Those of the polynomials of which the others are multiples near the point, by relations of degree one."""
    kept = list(dict.fromkeys(polynomials))
    variables = sorted({place for p in kept for place in p.places if place in point and not point[place][1]})
    multiples = [(k, place) for k in range(len(kept)) for place in (-1, *variables)]
    if len(multiples) > MOST_MULTIPLES:
        return kept
    products = [
        {m + (packed(place) if place >= 0 else 0): Fraction(c, kept[k].below) for m, c in kept[k].terms.items()}
        for k, place in multiples
    ]
    relations: list[list[Fraction]] = []
    for relation in _relations(products):
        values = [Fraction(0)] * len(kept)
        for which, factor in relation.items():
            k, place = multiples[which]
            values[k] += factor * (point[place][0] if place >= 0 else 1)
        relations.append(values)
    dropped = eliminated(relations, len(kept))[1]
    return [p for k, p in enumerate(kept) if k not in dropped]


def _relations(products: Sequence[Row]) -> list[Row]:
    """The combinations of the products that vanish, by elimination."""
    reduced: dict[int, tuple[Row, Row]] = {}
    found = []
    for which, terms in enumerate(products):
        row, made = dict(terms), {which: Fraction(1)}
        while row:
            lead = max(row)
            if lead not in reduced:
                reduced[lead] = row, made
                break
            other, from_others = reduced[lead]
            factor = row[lead] / other[lead]
            row, made = _less(row, other, factor), _less(made, from_others, factor)
        if not row:
            found.append(made)
    return found


def _less(one: Row, other: Row, factor: Fraction) -> Row:
    """One row less a multiple of another."""
    total = {key: one.get(key, Fraction(0)) - factor * other.get(key, Fraction(0)) for key in {*one, *other}}
    return {key: value for key, value in total.items() if value}


def require_motion(reading: PolynomialProblem, point: Point) -> None:
    """Raises `Rejected` unless a motion through the point is known to exist that satisfies all that is assumed.

    What vanishes must vanish at the point. What is at rest there, and tied to nothing that moves, may stay as it is.
    """
    if reading.unclosed:
        raise Rejected(f"it is not known what {reading.unclosed[0]} demands of all rates")
    new = [place for place, what in enumerate(reading.variables) if what[0] == "entry" and what[2] > reading.highest]
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
