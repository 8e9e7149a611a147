"""Quantities that a given equation defines, as x = r*cos(a) does, with their values put in wherever they occur."""

from __future__ import annotations

from collections.abc import Sequence
from contextlib import suppress
from dataclasses import dataclass
from itertools import product
from typing import Any

import sympy
from sympy.core.function import AppliedUndef

from chasles.checker.expressions.cases import CheckedCase
from chasles.checker.expressions.widened import put, without_defined
from chasles.checker.sparse import Rejected

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


def values_put_in(spoken: Sequence[Any], given: Pairs, kinds: Any = sympy.Symbol | AppliedUndef) -> WithoutDefined:
    """What each equation defines, of the quantities of some kinds, is put in, one after the other."""
    case = CheckedCase((tuple(spoken), ()), tuple(given), ())
    values: dict[Any, Any] = {}
    places = []
    for place, side in product(range(len(given)), (0, 1)):
        pair = case.pairs[place]
        if pair and isinstance(pair[side], kinds):
            with suppress(Rejected):
                found = without_defined(case, pair, side)
                values = {known: put(e, *pair[:: 1 - 2 * side]) for known, e in values.items()}
                case = found
                places.append((place, side))
                values[pair[side]] = pair[1 - side]
    rest = list(filter(None, case.pairs))
    lost = any(e.has(sympy.zoo, sympy.nan, sympy.oo) for e in (*case.sides[0], *(e for pair in rest for e in pair)))
    return WithoutDefined(list(case.sides[0]), rest, {} if lost else values, places)
