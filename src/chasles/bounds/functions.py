"""Which functions of libm are bounded, and how fast do they change? Enclosures of values and derivatives by balls.

The balls are Arb's: Johansson, Arb: efficient arbitrary-precision midpoint-radius interval arithmetic, 2017. Where a
function has no value, or no derivative, somewhere in a ball, what comes out is not finite.
"""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass
from typing import Any

Enclosure = Callable[..., Any]


@dataclass(frozen=True, slots=True)
class EnclosedFunction:
    """A ball that holds the function's values at all points of balls, and one for the derivative by each operand.

    A library's function is within `ulps` units in the last place: the GNU C Library Reference Manual, Known Maximum
    Errors in Math Functions, for the less accurate of both precisions; Zimmermann, Accuracy of Mathematical Functions
    in Single, Double, Extended Double and Quadruple Precision, 2021, where that found more.
    """

    value: Enclosure
    slopes: tuple[Enclosure, ...]
    ulps: int


def slope(name: str, operand: int) -> str:
    """The name of the derivative by an operand."""
    return f"{name} by {operand}"


def _root(x: Any) -> Any:
    """The cube root, of a ball on one side of zero."""
    return -_root(-x) if x < 0 else x.root(3) if x > 0 else x / 0


def _bell(x: Any) -> Any:
    return 2 * (-x * x).exp() / x.pi().sqrt()


ENCLOSED: dict[str, EnclosedFunction] = {
    "exp": EnclosedFunction(lambda x: x.exp(), (lambda x: x.exp(),), 1),
    "expm1": EnclosedFunction(lambda x: x.expm1(), (lambda x: x.exp(),), 1),
    "log": EnclosedFunction(lambda x: x.log(), (lambda x: 1 / x,), 1),
    "log1p": EnclosedFunction(lambda x: x.log1p(), (lambda x: 1 / (1 + x),), 1),
    "pow": EnclosedFunction(lambda x, y: x**y, (lambda x, y: y * x ** (y - 1), lambda x, y: x**y * x.log()), 1),
    "cbrt": EnclosedFunction(_root, (lambda x: 1 / (3 * _root(x) ** 2),), 4),
    "sinh": EnclosedFunction(lambda x: x.sinh(), (lambda x: x.cosh(),), 2),
    "cosh": EnclosedFunction(lambda x: x.cosh(), (lambda x: x.sinh(),), 2),
    "tanh": EnclosedFunction(lambda x: x.tanh(), (lambda x: 1 / x.cosh() ** 2,), 3),
    "asinh": EnclosedFunction(lambda x: x.asinh(), (lambda x: 1 / (1 + x * x).sqrt(),), 2),
    "acosh": EnclosedFunction(lambda x: x.acosh(), (lambda x: 1 / ((x - 1) * (x + 1)).sqrt(),), 3),
    "atanh": EnclosedFunction(lambda x: x.atanh(), (lambda x: 1 / ((1 - x) * (1 + x)),), 2),
    "erf": EnclosedFunction(lambda x: x.erf(), (_bell,), 2),
    "erfc": EnclosedFunction(lambda x: x.erfc(), (lambda x: -_bell(x),), 6),
    "tgamma": EnclosedFunction(lambda x: x.gamma(), (lambda x: x.gamma() * x.digamma(),), 10),
    "lgamma": EnclosedFunction(lambda x: x.lgamma(), (lambda x: x.digamma(),), 12),
}
"""By the name in C; where a logarithm of negative values is asked for, nothing finite comes out."""
