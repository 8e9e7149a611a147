"""Functions of scalars on intervals: enclosures of their values."""

from __future__ import annotations

from collections.abc import Callable
from functools import reduce
from typing import Any

from chasles.numerics.enclosures import ends


class Undetermined(ArithmeticError):
    """What holds of one number in an interval and not of another: more digits may tell."""


def function_of(name: str, context: Any) -> Callable[..., Any]:
    """The function of that name; raises ValueError where it is not real, `Undetermined` where that is not known."""

    def sqrt(x: Any) -> Any:
        low, high = ends(x)
        if high < 0:
            raise ValueError("the square root of a negative number is not real")
        return context.sqrt(x if low >= 0 else context.mpf([0, x.b]))

    def log(x: Any) -> Any:
        if sign_of(x) <= 0:
            raise ValueError("the logarithm of a number that is not positive is not real")
        return context.log(x)

    def sinh(x: Any) -> Any:
        return (context.exp(x) - context.exp(-x)) / 2

    def cosh(x: Any) -> Any:
        return (context.exp(x) + context.exp(-x)) / 2

    found: dict[str, Callable[..., Any]] = {
        "sqrt": sqrt,
        "abs": abs,
        "exp": context.exp,
        "log": log,
        "arcsin": lambda x: context.atan2(x, sqrt(1 - x**2)),
        "arccos": lambda x: context.atan2(sqrt(1 - x**2), x),
        "arctan": lambda x: context.atan2(x, context.mpf(1)),
        "atan2": context.atan2,
        "sinh": sinh,
        "cosh": cosh,
        "tanh": lambda x: sinh(x) / cosh(x),
        "sign": lambda x: context.mpf(sign_of(x)),
        "max": lambda *xs: reduce(lambda a, b: (a + b + abs(a - b)) / 2, xs),
        "min": lambda *xs: reduce(lambda a, b: (a + b - abs(a - b)) / 2, xs),
    }
    return found[name]


def sign_of(x: Any) -> int:
    """1, 0 or -1; raises `Undetermined` for an interval that holds numbers of different signs."""
    low, high = ends(x)
    if low > 0 or high < 0:
        return 1 if low > 0 else -1
    if low == high:
        return 0
    raise Undetermined("the sign is not known")
