"""Hyperbolic functions as rational functions of exponentials, and their inverses as logarithms."""

from __future__ import annotations

from collections.abc import Callable, Mapping
from typing import Any, Protocol

import sympy

from chasles.from_sympy.seen_signs import sees_nonnegative


class Exponentials(Protocol):
    """Writes exponentials and logarithms in variables."""

    needs: dict[str, Any]

    def exp(self, exponent: Any) -> Any: ...
    def log(self, value: Any, spelled: Any, evident: bool = False) -> Any: ...
    def nonvanishing(self, value: Any) -> None: ...


def _squared(function: Callable[[Any], Any]) -> Callable[[Exponentials, Any, Any], Any]:
    """A hyperbolic function as a rational function of exp(2 x)."""
    return lambda words, argument, _: function(words.exp(2 * argument))


def _halved(sign: int) -> Callable[[Exponentials, Any, Any], Any]:
    return lambda words, argument, _: (words.exp(argument) + sign * words.exp(-argument)) / 2


def _reciprocal(sign: int) -> Callable[[Exponentials, Any, Any], Any]:
    return lambda words, argument, _: 2 * words.exp(argument) / (words.exp(2 * argument) + sign)


def _asinh(words: Exponentials, u: Any, _: Any) -> Any:
    return words.log(sympy.cancel(u + _rooted(u**2 + 1)), u, evident=True)


def _acosh(words: Exponentials, u: Any, spelled: Any) -> Any:
    if not sees_nonnegative(spelled - 1):
        words.needs[f"{spelled - 1} >= 0"] = sympy.sqrt(spelled - 1)
    words.log(u, spelled, evident=True)
    return words.log(sympy.cancel(u + _rooted(u**2 - 1)), spelled, evident=True)


def _atanh(words: Exponentials, u: Any, spelled: Any) -> Any:
    return (words.log(1 + u, 1 + spelled) - words.log(1 - u, 1 - spelled)) / 2


def _inverted(rule: Callable[[Exponentials, Any, Any], Any]) -> Callable[[Exponentials, Any, Any], Any]:
    def of_reciprocal(words: Exponentials, u: Any, spelled: Any) -> Any:
        words.nonvanishing(u)
        return rule(words, 1 / u, 1 / spelled)

    return of_reciprocal


def _rooted(square: Any) -> Any:
    return sympy.sqrt(sympy.factor(square))


Rules = Mapping[type, Callable[[Exponentials, Any, Any], Any]]
EXPONENTIALS: Rules = {
    sympy.exp: lambda words, argument, _: words.exp(argument),
    sympy.sinh: _halved(-1),
    sympy.cosh: _halved(1),
    sympy.tanh: _squared(lambda e: (e - 1) / (e + 1)),
    sympy.coth: _squared(lambda e: (e + 1) / (e - 1)),
    sympy.sech: _reciprocal(1),
    sympy.csch: _reciprocal(-1),
}
# Abramowitz and Stegun, Handbook of Mathematical Functions, 4.6.20 to 4.6.25.
LOGARITHMS: Rules = {
    sympy.log: lambda words, argument, spelled: words.log(argument, spelled),
    sympy.asinh: _asinh,
    sympy.acosh: _acosh,
    sympy.atanh: _atanh,
    sympy.acsch: _inverted(_asinh),
    sympy.asech: _inverted(_acosh),
    sympy.acoth: _inverted(_atanh),
}
