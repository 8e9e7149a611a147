"""Does a counterexample to an equation of SymPy expressions refute it? It is evaluated again at the point it shows."""

from __future__ import annotations

from fractions import Fraction
from typing import Any

from chasles.checker.expressions.asked import Asked
from chasles.checker.expressions.at_point import AtPoint
from chasles.checker.expressions.complexes import parts
from chasles.checker.expressions.motion import require_given
from chasles.checker.expressions.quantities import atoms_of, require_independent
from chasles.checker.expressions.reading_of_proof import Spoken
from chasles.checker.expressions.symbolic import Symbolic, UnknownValue
from chasles.checker.expressions.widened import check_enclosed
from chasles.checker.sparse import Polynomial, Rejected, number, variable, well_formed

NEAR = Fraction(1, 2**100)
"""So near to a value with functions of numbers is a text that tells it."""


def check_refutation(found: Any, lhs: Any, rhs: Any, given: Any = (), nonzero: Any = ()) -> None:
    """The point satisfies all that is given, at all times where it moves, and there one entry's two sides differ.

    Raises `Rejected` with the reason if not.
    """
    with well_formed("counterexample"):
        asked = Asked(lhs, rhs, given, nonzero)
        row, column = found.entry
        place = row - 1, column - 1
        if place not in asked.left:
            raise Rejected(f"the equation has no entry {row}, {column}")
        try:
            _check(found, place, asked)
        except Rejected:
            _check_values(found, place, asked)


def _check(found: Any, place: tuple[int, int], asked: Asked) -> None:
    point = AtPoint(Symbolic({}, {}), found.at)
    atoms = [atom for expression in asked.expressions for atom in atoms_of(expression)]
    require_independent(atoms)
    for e in atoms:
        point.symbolic.place(e)
    require_given(asked, point)
    for e in asked.hidden:
        parts(point, e)
    left, right = (_value(point, side[place]) for side in (asked.left, asked.right))
    point.require_angles()
    if not any(point.sign(one - other) for one, other in zip(left, right, strict=True)):
        raise Rejected("both sides are equal at the point")
    imaginary = variable(point.fresh("I", number(-1)))
    spoken = Spoken(point, point.spelled() | {"I": imaginary})
    for text, (real, rest) in ((found.left, left), (found.right, right)):
        gap = spoken(text) - (real + rest * imaginary)
        if not (point.vanishes(gap) or (not rest and point.is_near(gap, Fraction(0), NEAR))):
            raise Rejected(f"a side is not {text} at the point")


def _check_values(found: Any, place: tuple[int, int], asked: Asked) -> None:
    """Where the values are no numbers that the checker knows exactly, what encloses them may tell them apart."""
    places = sorted(asked.left)
    sides = [[*map(side.get, places), *asked.hidden] for side in (asked.left, asked.right)]
    given = [(item.text, list(item.pairs.values())) for item in asked.given]
    check_enclosed(found.at, places.index(place), (found.left, found.right), sides, given, asked.nonzero)


def _value(point: AtPoint, e: Any) -> tuple[Polynomial, Polynomial]:
    """The real and imaginary part at the point; what cancels by equations between angles needs no value."""
    try:
        return parts(point, e)
    except UnknownValue:
        real, imaginary = parts(point.symbolic, e)
        return point.value_of(real), point.value_of(imaginary)
