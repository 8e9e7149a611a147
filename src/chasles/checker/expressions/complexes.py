"""Complex expressions by their real and imaginary parts, for the checker, all quantities being real."""

from __future__ import annotations

from collections.abc import Mapping
from fractions import Fraction
from functools import reduce
from typing import TYPE_CHECKING, Any

import sympy

from chasles.checker.sparse import ONE, ZERO, Polynomial, number

if TYPE_CHECKING:
    from chasles.checker.expressions.expressions import Expressions

OF_COMPLEX = (type(sympy.I), sympy.re, sympy.im, sympy.conjugate, sympy.arg)
QUOTIENTS = {
    sympy.tan: (sympy.sin, sympy.cos), sympy.cot: (sympy.cos, sympy.sin),
    sympy.sec: (None, sympy.cos), sympy.csc: (None, sympy.sin),
    sympy.tanh: (sympy.sinh, sympy.cosh), sympy.coth: (sympy.cosh, sympy.sinh),
    sympy.sech: (None, sympy.cosh), sympy.csch: (None, sympy.sinh),
}  # fmt: skip
"""What stands above and below the line in functions of complex numbers."""
Pair = tuple[Polynomial, Polynomial]
Place = tuple[int, int]


def is_complex(e: Any) -> bool:
    """Whether an expression has to be taken apart."""
    return bool(e.has(*OF_COMPLEX))


def parts(reading: Expressions, e: Any) -> Pair:
    """The real and the imaginary part; raises `Rejected` for functions of complex numbers that are not taken apart."""
    if not is_complex(e):
        return reading(e), ZERO
    match e:
        case sympy.core.numbers.ImaginaryUnit():
            return ZERO, ONE
        case sympy.Add():
            return reduce(_plus, (parts(reading, term) for term in e.args))
        case sympy.Mul():
            return reduce(lambda one, other: _times(reading, one, other), (parts(reading, factor) for factor in e.args))
        case sympy.Pow(base=sympy.Abs()) if e.exp.is_Integer and e.exp.is_even:
            a, b = parts(reading, e.base.args[0])
            square, half = reading.normal(a * a + b * b), int(e.exp) // 2
            return reading.power(square if half > 0 else reading.over(square, str(e.base)), abs(half)), ZERO
        case sympy.Pow() if e.exp.is_Integer and is_complex(e.base):
            return _power(reading, parts(reading, e.base), int(e.exp), str(e.base))
        case sympy.conjugate():
            a, b = parts(reading, e.args[0])
            return a, -b
        case sympy.re():
            return parts(reading, e.args[0])[0], ZERO
        case sympy.im():
            return parts(reading, e.args[0])[1], ZERO
        case sympy.Abs():
            return size(reading, e.args[0]), ZERO
        case sympy.arg():
            a, b = parts(reading, e.args[0])
            return reading.arc(b, a), ZERO
        case sympy.exp() | sympy.cos() | sympy.sin() | sympy.cosh() | sympy.sinh():
            return _entire(reading, type(e), e.args[0])
    if type(e) in QUOTIENTS:
        above, below = QUOTIENTS[type(e)]
        inverse = _power(reading, parts(reading, below(*e.args)), -1, str(below(*e.args)))
        return _times(reading, parts(reading, above(*e.args)), inverse) if above else inverse
    return reading(e), ZERO


def size(reading: Expressions, e: Any) -> Polynomial:
    """The absolute value; of a product, that of each factor."""
    if isinstance(e, sympy.Mul) and is_complex(e):
        return reduce(lambda one, other: reading.normal(one * other), (size(reading, factor) for factor in e.args))
    a, b = parts(reading, e)
    return reading.root(reading.normal(a * a + b * b)) if b else reading.absolute(a)


def _entire(reading: Expressions, function: type, argument: Any) -> Pair:
    """The exponential, cosine, sine, ... of a + b i, by the addition formulas."""
    turned = function in (sympy.cos, sympy.sin)
    angles = reading.argument_parts(argument)
    c, s = reading.turn(angles[0 if turned else 1])
    rest = reading.value(angles[1 if turned else 0])
    if function is sympy.exp:
        size = reading.exp(rest)
        return reading.normal(size * c), reading.normal(size * s)
    e, inverse = reading.exp(rest), reading.exp(-rest)
    half = number(Fraction(1, 2))
    cosh, sinh = (e + inverse) * half, (e - inverse) * half
    if turned:
        pair = (c * cosh, -(s * sinh)) if function is sympy.cos else (s * cosh, c * sinh)
    else:
        pair = (cosh * c, sinh * s) if function is sympy.cosh else (sinh * c, cosh * s)
    return reading.normal(pair[0]), reading.normal(pair[1])


def _plus(one: Pair, other: Pair) -> Pair:
    return one[0] + other[0], one[1] + other[1]


def _times(reading: Expressions, one: Pair, other: Pair) -> Pair:
    (a, b), (c, d) = one, other
    return reading.normal(a * c - b * d), reading.normal(a * d + b * c)


def _power(reading: Expressions, base: Pair, exponent: int, spelled: str) -> Pair:
    if exponent < 0:
        a, b = base
        square = reading.normal(a * a + b * b) if b else a
        inverse = reading.over(square, f"Abs({spelled})**2" if b else spelled)
        base = (reading.normal(a * inverse), reading.normal(-b * inverse)) if b else (inverse, ZERO)
    return reduce(lambda one, other: _times(reading, one, other), [base] * abs(exponent), (ONE, ZERO))


def differences(reading: Expressions, pairs: Mapping[Place, tuple[Any, Any]]) -> dict[Place, Polynomial]:
    """What vanishes where the sides of each pair are equal; imaginary parts, if there are any, are further rows."""
    rows = 1 + max((row for row, _ in pairs), default=0)
    found: dict[Place, Polynomial] = {}
    for (row, column), (left, right) in pairs.items():
        (a, b), (c, d) = parts(reading, left), parts(reading, right)
        found[row, column] = a - c
        if b or d:
            found[row + rows, column] = b - d
    return found
