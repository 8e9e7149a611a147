"""Does a counterexample to an equation of SymPy expressions refute it? It is evaluated again at the point it shows."""

from __future__ import annotations

from fractions import Fraction
from typing import Any

from chasles.proof.recheck.questions.asked import Asked
from chasles.proof.recheck.questions.at_point import AtPoint
from chasles.proof.recheck.questions.complexes import parts
from chasles.proof.recheck.questions.given import require_given
from chasles.proof.recheck.questions.spoken import Spoken
from chasles.proof.recheck.questions.symbolic import Symbolic
from chasles.proof.recheck.sparse import Rejected, number, variable

__all__ = ["check_refutation"]

NEAR = Fraction(1, 2**100)
"""So near to a value with functions of numbers is a text that tells it."""


def check_refutation(found: Any, lhs: Any, rhs: Any, given: Any = (), nonzero: Any = ()) -> None:
    """The point satisfies all that is given, at all times where it moves, and there one entry's two sides differ.

    Raises `Rejected` with the reason if not.
    """
    try:
        _check(found, Asked(lhs, rhs, given, nonzero))
    except Rejected:
        raise
    except (ArithmeticError, AttributeError, LookupError, RecursionError, TypeError, ValueError) as error:
        raise Rejected(f"the counterexample is malformed: {type(error).__name__}: {error}") from error


def _check(found: Any, asked: Asked) -> None:
    row, column = found.entry
    place = row - 1, column - 1
    if place not in asked.left:
        raise Rejected(f"the equation has no entry {row}, {column}")
    point = AtPoint(Symbolic({}, {}), found.at)
    require_given(asked, point)
    left, right = parts(point, asked.left[place]), parts(point, asked.right[place])
    point.require_angles()
    if not any(point.sign(one - other) for one, other in zip(left, right, strict=True)):
        raise Rejected("both sides are equal at the point")
    imaginary = variable(point.fresh("I", number(-1)))
    spoken = Spoken(point, point.spelled() | {"I": imaginary})
    for text, (real, rest) in ((found.left, left), (found.right, right)):
        value = real + rest * imaginary
        gap = spoken(text) - value
        if not (point.vanishes(gap) or (not rest and point.is_near(gap, Fraction(0), NEAR))):
            raise Rejected(f"a side is not {text} at the point")
