"""Angles that a given equation determines, as alpha + beta + gamma = pi does, are put in wherever they occur."""

from __future__ import annotations

from collections.abc import Iterable
from typing import Any

import sympy

from chasles.checker.expressions.quantities import is_atom
from chasles.checker.expressions.readings import CIRCULAR, FUNCTIONS
from chasles.from_sympy.given_equations import SideConditions
from chasles.from_sympy.opening import parts_of

ELEMENTARY = tuple(getattr(sympy, name) for name in FUNCTIONS)


def without_given_angles(result: SideConditions, expressions: list[Any]) -> list[Any]:
    """Use equations between angles, such as alpha + beta + gamma = pi, to eliminate one of the angles."""
    for item in list(result.equations):
        for pair in list(item.pairs):
            spoken = [*expressions, *(side for other in result.equations for side in other.sides)]
            solved = _solved_for_angle(pair[0] - pair[1], _angles_in(spoken))
            if solved is None or not _keeps_its_meaning(spoken, *solved):
                continue
            atom, value = solved
            item.pairs.remove(pair)
            result.substitutions.append((item.text, atom, value))
            expressions = [_put_in(e, atom, value) for e in expressions]
            for other in result.equations:
                other.pairs = [(_put_in(a, atom, value), _put_in(b, atom, value)) for a, b in other.pairs]
    result.equations = [item for item in result.equations if item.pairs]
    return expressions


def _angles_in(expressions: Iterable[Any]) -> set[Any]:
    """The atoms that occur in arguments of functions, of which the angles are the most common."""
    return _arguments(expressions, *CIRCULAR, *ELEMENTARY, sympy.Pow)


def _arguments(expressions: Iterable[Any], *kinds: Any) -> set[Any]:
    calls = {call for e in expressions for call in parts_of(e) if isinstance(call, kinds)}
    calls = {
        call for call in calls if not (call.is_Pow and call.exp.is_Rational and call.exp.q & (call.exp.q - 1) == 0)
    }
    parts = (part for call in calls for argument in call.args for part in parts_of(argument))
    return {part for part in parts if is_atom(part)}


def _solved_for_angle(difference: Any, angles: set[Any]) -> tuple[Any, Any] | None:
    """The angle that a linear equation with rational coefficients determines, and its value.

    Nothing is lost by putting it in: the angle is no rate, and neither it nor a rate of it occurs in the value.
    """
    terms = sympy.expand(difference).as_coefficients_dict()
    if not all(term in (sympy.pi, sympy.S.One) or is_atom(term) for term in terms):
        return None
    moved = [term.expr for term in terms if isinstance(term, sympy.Derivative)]
    candidates = sorted((term for term in terms if term in angles and term not in moved), key=str)
    candidates = [term for term in candidates if not isinstance(term, sympy.Derivative)]
    if not candidates:
        return None
    atom = candidates[-1]
    return atom, sympy.expand(atom - difference / terms[atom])


def _keeps_its_meaning(expressions: list[Any], atom: Any, value: Any) -> bool:
    """Whether all is real, and an angle or defined, where a value that is no sum of angles is put in, as before."""
    rest = value.as_coefficients_dict().get(sympy.S.One, 0)
    if rest == 0 and value.free_symbols:
        return True
    powers = [part for e in expressions for part in parts_of(e) if part.is_Pow and part.exp.has(atom)]
    turned = rest != 0 and atom in _arguments(expressions, *CIRCULAR)
    if turned or not all(part.base.is_positive for part in powers):
        return False
    lost = (sympy.zoo, sympy.nan, sympy.oo, sympy.I)
    return not any(_put_in(e, atom, value).has(*lost) and not e.has(*lost) for e in expressions)


def _put_in(expression: Any, atom: Any, value: Any) -> Any:
    return expression.subs(atom, value).doit() if expression.has(atom) else expression
