"""Angles between two multiples of pi, by symbols that may have any value, or any positive or nonnegative one."""

from __future__ import annotations

from collections.abc import Callable
from typing import Any

import sympy

RIGHT = sympy.pi / 2
MOST_HALVINGS = 2
Fresh = Callable[..., Any]
"""A new symbol by its name and assumptions."""


def between(low: Any, high: Any, after: bool, before: bool, fresh: Fresh, halvings: int = 0) -> Any:
    """An expression whose values are all angles between two others, without the first or the second one if so said.

    It is `after` the first one if that is excluded, and `before` the second one. None if there is no simple one.
    """
    if after and not before:
        opposite = between(-high, -low, before, after, fresh, halvings)
        return opposite and -opposite
    if high - low == 4 * RIGHT and before and not after:
        return (low + high) / 2 - sympy.atan2(fresh("s_1"), fresh("c_1"))
    quarter = sympy.floor(low / RIGHT)
    for middle in (quarter * RIGHT, (quarter + 1) * RIGHT):
        if high - middle <= RIGHT and (angle := _near(low - middle, high - middle, after, before, fresh)):
            return middle + angle
    half = between(low / 2, high / 2, after, before, fresh, halvings + 1) if halvings < MOST_HALVINGS else None
    return half and 2 * half


def _near(low: Any, high: Any, after: bool, before: bool, fresh: Fresh) -> Any:
    """The same between two angles that are not more than a right one away from zero."""
    if not before and RIGHT in (high, -low):
        known = {} if low else {"nonnegative": True}
        return sympy.asin(fresh("s_1", **known)) if high == RIGHT and low in (-RIGHT, 0) else None
    if low == -RIGHT and not after:
        return None
    least, most = (None if abs(end) == RIGHT else sympy.tan(end) for end in (low, high))
    if any(end is not None and end.has(sympy.tan) for end in (least, most)):
        return None
    if least is None and most is None:
        return sympy.atan(fresh("s_1"))
    if not before:
        return sympy.atan(closed(least, most, fresh("s_1")))
    size = fresh("s_1", **{"positive" if after else "nonnegative": True})
    if least is None or most is None:
        return sympy.atan(most - size if least is None else least + size)
    return sympy.atan((least + most * size) / (1 + size))


def closed(low: Any, high: Any, any_: Any) -> Any:
    """An expression in a symbol of any value, whose values are all numbers between two others, and both of these."""
    return sympy.factor(low + (high - low) * (1 + any_) ** 2 / (2 * (1 + any_**2)))


def ratio(low: Any, high: Any, after: bool, before: bool, fresh: Fresh, name: str = "d_1") -> Any:
    """An expression whose values are all numbers between two others, without those that are excluded."""
    if not (after or before):
        return closed(low, high, fresh(name))
    d = fresh(name, **{"positive" if after and before else "nonnegative": True})
    return (low + high * d) / (1 + d) if before else (high + low * d) / (1 + d)
