"""Relations between polynomials: sums of multiples that vanish whatever the variables are, as w . (w x v) does.

Near a point at which one of these multiples is not zero, its polynomial vanishes wherever the others do.
"""

from __future__ import annotations

from collections.abc import Sequence
from fractions import Fraction

from chasles.checker.elimination import eliminated
from chasles.checker.sparse import Polynomial, packed
from chasles.checker.witness import Point

Row = dict[int, Fraction]
MOST_MULTIPLES = 400
"""So many products of polynomials and variables are looked at, at most."""


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
