"""Quantities that a given equation defines, as x = r*cos(a) does, with their values put in wherever they occur."""

from __future__ import annotations

from collections.abc import Iterable, Sequence
from dataclasses import dataclass
from typing import Any

import sympy
from sympy.core.function import AppliedUndef

from chasles.from_sympy.atoms import ASSUMPTIONS

Pairs = list[tuple[Any, Any]]


@dataclass(frozen=True, slots=True)
class WithoutDefined:
    """What is spoken of and given, without what is defined: the values, and the equations and sides that have them.

    There are no values where something else would not be defined any more.
    """

    spoken: list[Any]
    given: Pairs
    values: dict[Any, Any]
    places: list[tuple[int, int]]


def without_defined(spoken: Sequence[Any], given: Pairs, kinds: Any = sympy.Symbol | AppliedUndef) -> WithoutDefined:
    """What each equation defines, of the quantities of some kinds, is put in, one after the other."""
    all_spoken, left = list(spoken), dict(enumerate(given))
    values: dict[Any, Any] = {}
    places = []
    for place in range(len(given)):
        everything = [*all_spoken, *(side for pair in left.values() for side in pair)]
        sides = (side for side in (0, 1) if isinstance(left[place][side], kinds))
        side = next((side for side in sides if _defines(left[place], side, everything)), None)
        if side is not None:
            pair = left.pop(place)
            atom, value = pair[side], pair[1 - side]
            places.append((place, side))
            values = {known: put(e, atom, value) for known, e in values.items()} | {atom: value}
            all_spoken = [put(e, atom, value) for e in all_spoken]
            left = {k: (put(a, atom, value), put(b, atom, value)) for k, (a, b) in left.items()}
    rest = list(left.values())
    lost = any(e.has(sympy.zoo, sympy.nan, sympy.oo) for e in (*all_spoken, *(e for pair in rest for e in pair)))
    return WithoutDefined(all_spoken, rest, {} if lost else values, places)


def _defines(pair: tuple[Any, Any], side: int, spoken: Iterable[Any]) -> bool:
    """Whether one side is a quantity that may have any value, and the other one does not speak of it."""
    atom, value = pair[side], pair[1 - side]
    if value.has(type(atom) if isinstance(atom, AppliedUndef) else atom):
        return False
    if any(getattr(atom, f"is_{name}") is not None for name in ASSUMPTIONS):
        return False
    if isinstance(atom, sympy.Symbol):
        return not any(call.has(atom) for e in spoken for call in e.atoms(AppliedUndef))
    return len(atom.args) == 1


def put(e: Any, atom: Any, value: Any) -> Any:
    """An expression with a value in the place of a quantity, of whose rates it may speak."""
    e = e.xreplace({atom: value})
    return e.doit() if e.has(sympy.Derivative) else e
