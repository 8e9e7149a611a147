"""Hyperbolic and inverse functions in terms of exponentials, logarithms and angles of points, for the checker.

Abramowitz and Stegun, Handbook of Mathematical Functions, 4.5.1 to 4.5.6, 4.6.20 to 4.6.25.
"""

from __future__ import annotations

from collections.abc import Callable, Mapping
from fractions import Fraction
from typing import TYPE_CHECKING

from chasles.checker.sparse import ONE, Polynomial, number

if TYPE_CHECKING:
    from chasles.checker.expressions.expressions import Expressions

HALF, TWO = number(Fraction(1, 2)), number(2)


def _halved(sign: int) -> Callable[[Expressions, Polynomial], Polynomial]:
    return lambda read, u: (read.exp(u) + read.exp(-u) * number(sign)) * HALF


def _quotient(sign: int) -> Callable[[Expressions, Polynomial], Polynomial]:
    def rule(read: Expressions, u: Polynomial) -> Polynomial:
        square = read.exp(u * TWO)
        return (square - number(sign)) * read.over(square + number(sign), "a hyperbolic function")

    return rule


def _under(sign: int) -> Callable[[Expressions, Polynomial], Polynomial]:
    return lambda read, u: read.exp(u) * TWO * read.over(read.exp(u * TWO) + number(sign), "a hyperbolic function")


def _log(read: Expressions, u: Polynomial, base: Polynomial | None = None) -> Polynomial:
    return read.log(u) if base is None else read.log(u) * read.over(read.log(base), "the logarithm of a base")


def _of_positive(read: Expressions, value: Polynomial) -> Polynomial:
    read.know(value)
    return read.log(read.normal(value), evident=True)


def _asinh(read: Expressions, u: Polynomial) -> Polynomial:
    return _of_positive(read, u + read.root(read.normal(u * u + ONE)))


def _acosh(read: Expressions, u: Polynomial) -> Polynomial:
    read.require_nonnegative(u - ONE)
    return _of_positive(read, u + read.root(read.normal(u * u - ONE)))


def _atanh(read: Expressions, u: Polynomial) -> Polynomial:
    return (read.log(ONE + u) - read.log(ONE - u)) * HALF


def _asin(read: Expressions, u: Polynomial) -> Polynomial:
    return read.arc(u, read.root(read.normal(ONE - u * u)))


def _acos(read: Expressions, u: Polynomial) -> Polynomial:
    return read.half_turn() * HALF - _asin(read, u)


def _inverted(rule: Callable[[Expressions, Polynomial], Polynomial]) -> Callable[[Expressions, Polynomial], Polynomial]:
    return lambda read, u: rule(read, read.over(u, "an inverse function"))


FUNCTIONS: Mapping[str, Callable[..., Polynomial]] = {
    "exp": lambda read, u: read.exp(u), "log": _log, "sinh": _halved(-1), "cosh": _halved(1),
    "tanh": _quotient(1), "coth": _quotient(-1), "sech": _under(1), "csch": _under(-1),
    "asinh": _asinh, "acosh": _acosh, "atanh": _atanh,
    "acsch": _inverted(_asinh), "asech": _inverted(_acosh), "acoth": _inverted(_atanh),
    "atan2": lambda read, y, x: read.arc(y, x), "atan": lambda read, u: read.arc(u, ONE), "asin": _asin, "acos": _acos,
    "acot": _inverted(lambda read, u: read.arc(u, ONE)), "asec": _inverted(_acos), "acsc": _inverted(_asin),
}  # fmt: skip
