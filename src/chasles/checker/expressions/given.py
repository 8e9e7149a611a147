"""Does a point satisfy what is given? Equations between functions hold at all times, and so do their derivatives."""

from __future__ import annotations

from typing import Any

from chasles.checker.expressions.algebra import constant
from chasles.checker.expressions.asked import Asked
from chasles.checker.expressions.at_point import AtPoint
from chasles.checker.expressions.complexes import differences, parts
from chasles.checker.expressions.expressions import Expressions
from chasles.checker.expressions.motion import require_motion
from chasles.checker.expressions.quantities import atoms_of
from chasles.checker.expressions.readings import CIRCULAR
from chasles.checker.sparse import Polynomial, Rejected, number, variable


def require_given(asked: Asked, point: AtPoint, through: bool = True) -> None:
    """Every equation given holds at the point, and nothing vanishes there that must not.

    Where functions move, the derivatives hold too, and a motion goes `through` the point, if it is asked whether one
    does. Raises `Rejected` if not.
    """
    _eliminate(asked, point)
    for item in asked.given:
        read = point.symbolic
        # An equation by which an angle was eliminated says nothing more.
        pairs = {
            place: pair
            for place, pair in item.pairs.items()
            if not (read.values and all(map(read.vanishes, differences(read, {place: pair}).values())))
        }
        if not all(map(point.vanishes, differences(point, pairs).values())):
            raise Rejected(f"the point does not satisfy {item.text}")
    for e in asked.nonzero:
        if not any(map(point.sign, parts(point, e))):
            raise Rejected(f"{e} is zero at the point")
    require_motion(asked.given, point, through)


def _eliminate(asked: Asked, point: AtPoint) -> None:
    """Angles that equations give, and of which the point does not speak, have the values given."""
    calls = {call for expression in asked.expressions for call in expression.atoms(*CIRCULAR)}
    turned = {e for call in calls for e in atoms_of(call.args[0])}
    for item in asked.given:
        for difference in differences(point.symbolic, item.pairs).values():
            atoms = {point.symbolic.atoms.get(place) for place in difference.places} & turned
            unspoken = [e for e in atoms if not any(str(e) in name for name in point.turns)]
            if unspoken:
                eliminate_angle(point.symbolic, difference, max(unspoken, key=str))


def eliminate_angle(reading: Expressions, difference: Polynomial, e: Any) -> bool:
    """Let a quantity have the value that a linear equation with rational coefficients gives it, if this is one."""
    slopes = {place: constant(slope) for place, slope in difference.partials().items()}
    own, slope = next(((place, slopes[place]) for place in slopes if reading.atoms.get(place) == e), (0, None))
    if slope is None or None in slopes.values() or not slopes.keys() <= reading.atoms.keys():
        return False
    reading.substitute(e, variable(own) - difference * number(1 / slope))
    return True
