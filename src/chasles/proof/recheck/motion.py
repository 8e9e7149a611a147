"""Is a point one through which something moves as all that is assumed demands, at every later and earlier instant?

What is assumed, differentiated until the rates that it speaks of are higher than any that occur, is linear in these.
Where its rows there are independent, so they are nearby, and they stay the same however often it is differentiated
further: these rates are functions of all lower ones, and a motion through the point exists. Pryce, A simple structural
analysis method for DAEs, BIT 41 (2001); Campbell and Gear, The index of general nonlinear DAEs, Numer. Math. 72 (1995).
"""

from __future__ import annotations

from fractions import Fraction

from chasles.proof.recheck.reading import Reading
from chasles.proof.recheck.sparse import ZERO, Rejected
from chasles.proof.recheck.witness import Point, value_at

__all__ = ["require_motion"]


def require_motion(reading: Reading, point: Point) -> None:
    """Raises `Rejected` unless a motion through the point is known to exist that satisfies all that is assumed.

    What vanishes must vanish at the point. Where nothing speaks of rates, rest is such a motion.
    """
    if reading.unclosed:
        raise Rejected(f"it is not known what {reading.unclosed[0]} demands of all rates")
    variables = enumerate(reading.variables)
    new = [place for place, what in variables if what[0] == "entry" and what[2] > reading.highest]
    rows = []
    for polynomial in reading.ahead:
        partials = polynomial.partials()
        values = [value_at(partials.get(place, ZERO), point) for place in new]
        if any(value.keys() - {0} for value in values):
            raise Rejected("a rate is tied by a transcendental number")
        if any(reading.variables[place][0] == "norm" and not point[place][0] for place in polynomial.places - {*new}):
            raise Rejected("a norm that is zero at the point ties rates")
        rows.append([value.get(0, Fraction(0)) for value in values])
    if _rank(rows) < len(rows):
        raise Rejected("it is not known whether a motion through the point satisfies all that is assumed")


def _rank(rows: list[list[Fraction]]) -> int:
    """The rank, by elimination."""
    rank = 0
    for column in range(len(rows[0]) if rows else 0):
        pivot = next((row for row in range(rank, len(rows)) if rows[row][column]), None)
        if pivot is not None:
            rows[rank], rows[pivot] = rows[pivot], rows[rank]
            for row in rows[rank + 1 :]:
                factor = row[column] / rows[rank][column]
                row[:] = [x - factor * y for x, y in zip(row, rows[rank], strict=True)]
            rank += 1
    return rank
