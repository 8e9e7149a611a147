"""Functions of scalars at exact values."""

from __future__ import annotations

from collections.abc import Sequence
from typing import Any

import sympy as sp

from chasles.exact.numbers import angle, compare, is_zero, root, sign

HOLDS = {"<": (-1,), "<=": (-1, 0), ">": (1,), ">=": (1, 0)}
"""The signs of a difference for which it compares so."""


def value_of(function: str, arguments: Sequence[Any]) -> Any:
    """The value of a function at exact numbers; None for a function that has none by roots and angles.

    Raises ValueError where the function is not real.
    """
    match function, *arguments:
        case "sqrt", of:
            return root(of)
        case "abs", of:
            return of if sign(of) >= 0 else -of
        case "sign", of:
            return sp.Integer(sign(of))
        case "arcsin", of:
            return angle(root(1 - of**2), of)
        case "arccos", of:
            return angle(of, root(1 - of**2))
        case "arctan", of:
            return value_of("atan2", (of, sp.Integer(1)))
        case "atan2", sine, cosine:
            length = root(sine**2 + cosine**2)
            if is_zero(length):
                raise ValueError("atan2(0, 0) is no angle")
            return angle(cosine / length, sine / length)
        case "max" | "min", *numbers:
            return _extreme(numbers, 1 if function == "max" else -1)
    return None


def _extreme(numbers: Sequence[Any], side: int) -> Any:
    found = numbers[0]
    for number in numbers[1:]:
        found = number if compare(number, found) == side else found
    return found


def compares(one: Any, sign_between: str, other: Any) -> bool:
    """Whether a comparison of two exact numbers is true."""
    return compare(one, other) in HOLDS[sign_between]
