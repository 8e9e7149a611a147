"""Quantities that a given equation defines, as x = r*cos(a) does, with their values put in wherever they occur."""

from __future__ import annotations

from collections.abc import Iterable, Sequence
from typing import Any

import sympy
from sympy.core.function import AppliedUndef

from chasles.from_sympy.atoms import ASSUMPTIONS

Pairs = list[tuple[Any, Any]]
Place = tuple[int, int]


def without_defined(spoken: Sequence[Any], pairs: Pairs) -> tuple[list[Place], list[Any], Pairs]:
    """What is spoken of and given, without what is defined: the equations that define it, and on which side.

    There are none where something else would not be defined any more.
    """
    spoken, left = list(spoken), dict(enumerate(pairs))
    places: list[Place] = []
    for place in range(len(pairs)):
        everything = [*spoken, *(side for pair in left.values() for side in pair)]
        side = next((side for side in (0, 1) if _defines(left[place], side, everything)), None)
        if side is not None:
            pair = left.pop(place)
            atom, value = pair[side], pair[1 - side]
            places.append((place, side))
            spoken = [_put(e, atom, value) for e in spoken]
            left = {k: (_put(a, atom, value), _put(b, atom, value)) for k, (a, b) in left.items()}
    pairs = list(left.values())
    lost = any(e.has(sympy.zoo, sympy.nan, sympy.oo) for e in (*spoken, *(side for pair in pairs for side in pair)))
    return [] if lost else places, spoken, pairs


def _defines(pair: tuple[Any, Any], side: int, spoken: Iterable[Any]) -> bool:
    """Whether one side is a quantity that may have any value, and the other one does not speak of it."""
    atom, value = pair[side], pair[1 - side]
    if not isinstance(atom, sympy.Symbol | AppliedUndef):
        return False
    if value.has(type(atom) if isinstance(atom, AppliedUndef) else atom):
        return False
    if any(getattr(atom, f"is_{name}") is not None for name in ASSUMPTIONS):
        return False
    if isinstance(atom, sympy.Symbol):
        return not any(call.has(atom) for e in spoken for call in e.atoms(AppliedUndef))
    return len(atom.args) == 1


def _put(e: Any, atom: Any, value: Any) -> Any:
    e = e.xreplace({atom: value})
    return e.doit() if e.has(sympy.Derivative) else e
