"""How each class of SymPy expressions is read; see `expressions` for what else a new function needs.

Hyperbolic and inverse functions are read in terms of exponentials, logarithms and angles of points: Abramowitz and
Stegun, Handbook of Mathematical Functions, 4.5.1 to 4.5.6, 4.6.20 to 4.6.25. Half turns and signs (-1)^n are read
without whole turns, where n is m k + r.
"""

from __future__ import annotations

from collections.abc import Callable, Mapping
from fractions import Fraction
from functools import reduce
from operator import add
from typing import TYPE_CHECKING, Any

import sympy

from chasles.checker.expressions.complexes import OF_COMPLEX, parts
from chasles.checker.expressions.quantities import rebuilt
from chasles.checker.sparse import ONE, Polynomial, Rejected, number

if TYPE_CHECKING:
    from chasles.checker.expressions.expressions import Expressions


HALF, TWO = number(Fraction(1, 2)), number(2)
CIRCULAR = {
    sympy.sin: ("sin", ""), sympy.cos: ("cos", ""), sympy.tan: ("sin", "cos"), sympy.cot: ("cos", "sin"),
    sympy.sec: ("", "cos"), sympy.csc: ("", "sin"),
}  # fmt: skip
"""What each function of an angle has above and below the line: 1, the cosine or the sine."""
MOST_PARTS = 90
"""Half a turn is divided into at most so many parts, and integers are by no larger number."""


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


def _power(reading: Expressions, e: Any) -> Polynomial:
    if not e.exp.is_Rational or e.exp.q & (e.exp.q - 1):
        return reading.powered(reading(e.base), reading(e.exp))
    return reading.raised(e.base, Fraction(int(e.exp.p), int(e.exp.q)))


def _of_angle(reading: Expressions, e: Any) -> Polynomial:
    above, below = CIRCULAR[e.func]
    numerator = reading.circular(above, e.args[0])
    return numerator * reading.over(reading.circular(below, e.args[0]), f"{below}({e.args[0]})") if below else numerator


def _sign(reading: Expressions, e: Any) -> Polynomial:
    inverse = reading.divide(e.args[0])
    return reading(e.args[0]) * reading.absolute(reading(e.args[0])) * inverse * inverse


def _part(reading: Expressions, e: Any) -> Polynomial:
    """A real part, an imaginary part, or a size."""
    if isinstance(e, sympy.Abs) and not e.has(*OF_COMPLEX):
        return reading.absolute(reading(e.args[0]))
    real, imaginary = parts(reading, e)
    if imaginary:
        raise Rejected(f"{e} is not seen to be real")
    return real


def _function(name: str) -> Callable[[Expressions, Any], Polynomial]:
    return lambda reading, e: FUNCTIONS[name](reading, *map(reading, e.args))


READINGS: Mapping[type, Callable[[Expressions, Any], Polynomial]] = {
    sympy.Rational: lambda reading, e: number(Fraction(int(e.p), int(e.q))),
    type(sympy.pi): lambda reading, e: reading.half_turn(),
    sympy.Add: lambda reading, e: reduce(add, map(reading, e.args)),
    sympy.Mul: lambda reading, e: reduce(lambda total, factor: reading.normal(total * reading(factor)), e.args, ONE),
    sympy.Pow: _power,
    sympy.sign: _sign,
    sympy.Derivative: lambda reading, e: reduce(reading.rate, e.variables, reading(e.expr)),
    **dict.fromkeys((sympy.conjugate, sympy.re, sympy.im, sympy.Abs), _part),
    **dict.fromkeys(CIRCULAR, _of_angle),
    **{getattr(sympy, name): _function(name) for name in FUNCTIONS},
    type(sympy.E): lambda reading, e: reading.exp(ONE),
}
"""How each class of expressions is read."""


class Floor(sympy.Function):  # type: ignore[misc]
    """The greatest integer; SymPy's own (1.14) takes a sixth of an even number, or of 2 (k + 1), for an integer."""

    is_integer = True

    @classmethod
    def eval(cls, x: Any) -> Any:
        """What is seen to be whole is taken out; None if nothing is."""
        whole = sympy.Add(*(term for term in sympy.Add.make_args(sympy.expand(x)) if is_whole(term)))
        rest = sympy.expand(x - whole)
        return whole + (sympy.floor(rest) if rest.is_number else cls(rest)) if rest.is_number or rest != x else None


Floor.__name__ = "floor"


def at_integer(e: Any, put: Any) -> Any:
    """The expression where an integer has a value, without whole turns and with powers of positive numbers alone."""
    if e in put or not e.args or not (e.has(*put) if put else any(symbol.is_integer for symbol in e.free_symbols)):
        return put.get(e, e)
    parts = [at_integer(part, put) for part in e.args]
    if type(e) in CIRCULAR:
        terms = sympy.Add.make_args(sympy.expand(parts[0]))
        left = [term for term in terms if not is_whole(term / sympy.pi / 2)]
        # SymPy drops half turns of a tangent's argument as if they were whole ones, if they are no numbers.
        turning = any(term.has(sympy.pi) and term.free_symbols for term in left)
        return e.func(sympy.Add(*left), evaluate=not turning) if put or len(left) < len(terms) else e
    if e.is_Pow and parts[0].is_negative and parts[1].is_integer and parts[1].free_symbols:
        exponent = sympy.expand(parts[1])
        odd = sympy.Add(*(term for term in sympy.Add.make_args(exponent) if not is_whole(term / 2)))
        return sympy.Pow(-1, odd) * (-parts[0]) ** exponent
    return rebuilt(e, parts)


def is_whole(term: Any) -> bool:
    """Whether a term is an integral multiple of a product of integers."""
    multiple, rest = term.as_coeff_Mul()
    factors = (
        isinstance(base, sympy.Symbol | Floor) and base.is_integer and n.is_Integer and n > 0
        for base, n in rest.as_powers_dict().items()
    )
    return bool(multiple.is_Integer) and (rest == 1 or all(factors))


def is_integral(e: Any) -> bool:
    """Whether an expression is a sum of integral multiples of products of integers."""
    return all(map(is_whole, sympy.Add.make_args(sympy.expand(e))))
