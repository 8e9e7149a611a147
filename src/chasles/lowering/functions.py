"""Which functions does a program call besides its own operations? Each by the name that it has in C, or in SciPy.

What is said of a function here is all that the project knows of it: its rates by what goes in, written in the
operations of any arithmetic, and how it is called where programs run.
"""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass
from fractions import Fraction
from functools import partial, reduce
from typing import Any

Rates = Callable[..., tuple[Any, ...]]
"""The derivative by each operand: of an arithmetic, the function's value and the operands."""
_HALF_ROOT = Fraction("0.886226925452758013649083741670572591398774728061193564106903895")
"""Half the root of pi."""


@dataclass(frozen=True, slots=True)
class KnownFunction:
    """A function of so many numbers.

    `decimals` is its name in mpmath, or computes it in a context of mpmath; `special` says that SciPy computes it and C
    does not. A function that is `exact` rounds nothing. `rates` is None where no function of this table is the
    derivative; `rates_by_square` are those of an even function by the square of what goes in.
    """

    operands: int
    decimals: str | Callable[..., Any]
    rates: Rates | None
    special: bool = False
    exact: bool = False
    rates_by_square: Rates | None = None

    def value(self, context: Any, *operands: Any) -> Any:
        """The value in a context of mpmath; complex where it is not real. Raises ValueError where there is none."""
        called = getattr(context, self.decimals) if isinstance(self.decimals, str) else partial(self.decimals, context)
        return called(*operands)


def _one_over(arithmetic: Any, *factors: Any) -> tuple[Any, ...]:
    product = reduce(arithmetic.multiply, factors)
    return (arithmetic.divide(_number(arithmetic, 1), product),)


def _above_one(arithmetic: Any, a: Any) -> Any:
    return arithmetic.add(_number(arithmetic, 1), a)


def _of_inverse_cosine(arithmetic: Any, value: Any, a: Any) -> tuple[Any, ...]:
    one = _number(arithmetic, 1)
    legs = arithmetic.multiply(arithmetic.subtract(a, one), arithmetic.add(a, one))
    return _one_over(arithmetic, arithmetic.square_root(legs))


def _number(arithmetic: Any, value: Fraction | int) -> Any:
    return arithmetic.constant(Fraction(value))


def _square(arithmetic: Any, a: Any) -> Any:
    return arithmetic.multiply(a, a)


def _sign(arithmetic: Any, value: Any, a: Any) -> tuple[Any, ...]:
    zero, one = _number(arithmetic, 0), _number(arithmetic, 1)
    positive = arithmetic.select(arithmetic.less(zero, a), one, a)
    return (arithmetic.select(arithmetic.less(a, zero), arithmetic.negate(one), positive),)


def _power(arithmetic: Any, value: Any, a: Any, b: Any) -> tuple[Any, ...]:
    lowered = arithmetic.function("pow", a, arithmetic.subtract(b, _number(arithmetic, 1)))
    # Of 0 to a positive power the derivative by the exponent is 0, and 0 times the logarithm of 0 is no number.
    logarithm = arithmetic.multiply(value, arithmetic.function("log", a))
    zero = _number(arithmetic, 0)
    return arithmetic.multiply(b, lowered), arithmetic.select(arithmetic.equal(value, zero), value, logarithm)


def _of_remainder(arithmetic: Any, value: Any, a: Any, b: Any) -> tuple[Any, ...]:
    return _number(arithmetic, 1), arithmetic.divide(arithmetic.subtract(value, a), b)


def _bell(arithmetic: Any, a: Any) -> Any:
    bell = arithmetic.function("exp", arithmetic.negate(_square(arithmetic, a)))
    return arithmetic.multiply(_number(arithmetic, 1 / _HALF_ROOT), bell)


def _stumpff(context: Any, order: Any, a: Any) -> Any:
    order = int(order)
    if abs(a) < order + 2:
        half = context.mpf(1) / 2
        return context.hyp1f2(1, (order + 1) * half, (order + 2) * half, -a * a / 4) / context.factorial(order)
    value = context.sin(a) / a if order % 2 else context.cos(a)
    for lower in range(order % 2, order, 2):
        value = (1 / context.factorial(lower) - value) / (a * a)
    return value


def _stumpff_by_square(arithmetic: Any, value: Any, order: Any, a: Any) -> tuple[Any, ...]:
    """Half of k c_(k+2) - c_(k+1); of (c_(k-1) - k c_k) / a^2, in which less cancels, where the angle is large."""
    one, two, square = _number(arithmetic, 1), _number(arithmetic, 2), _square(arithmetic, a)
    lower, following, after = (
        arithmetic.function("stumpff", shifted(order, by), a)
        for shifted, by in ((arithmetic.subtract, one), (arithmetic.add, one), (arithmetic.add, two))
    )
    near = arithmetic.subtract(arithmetic.multiply(order, after), following)
    far = arithmetic.divide(arithmetic.subtract(lower, arithmetic.multiply(order, value)), square)
    twice = arithmetic.select(arithmetic.less(square, _number(arithmetic, 9)), near, far)
    return arithmetic.not_a_number(), arithmetic.multiply(_number(arithmetic, Fraction(1, 2)), twice)


def _of_stumpff(arithmetic: Any, value: Any, order: Any, a: Any) -> tuple[Any, ...]:
    nothing, slope = _stumpff_by_square(arithmetic, value, order, a)
    return nothing, arithmetic.multiply(_number(arithmetic, 2), arithmetic.multiply(a, slope))


def _without_rate(arithmetic: Any, value: Any, *operands: Any) -> tuple[Any, ...]:
    return (_number(arithmetic, 0),) * len(operands)


def _following(arithmetic: Any, value: Any, order: Any, a: Any) -> tuple[Any, ...]:
    above = arithmetic.function("polygamma", arithmetic.add(order, _number(arithmetic, 1)), a)
    return arithmetic.not_a_number(), above


def _neighbours(name: str, sign: int) -> Rates:
    """The rate (f_(n-1) -+ f_(n+1)) / 2 of a cylindrical function by its argument; there is none by its order."""

    def rates(arithmetic: Any, value: Any, order: Any, a: Any) -> tuple[Any, ...]:
        one = _number(arithmetic, 1)
        below, above = (
            arithmetic.function(name, turned(order, one), a) for turned in (arithmetic.subtract, arithmetic.add)
        )
        total = arithmetic.add(below, above) if sign else arithmetic.subtract(below, above)
        half = arithmetic.multiply(_number(arithmetic, Fraction(-1 if sign < 0 else 1, 2)), total)
        return arithmetic.not_a_number(), half

    return rates


def _preceding(arithmetic: Any, value: Any, order: Any, a: Any) -> tuple[Any, ...]:
    """The function of the order before it, which is e^(-a)/a before the first; there is none by the order."""
    one = _number(arithmetic, 1)
    first = arithmetic.divide(arithmetic.function("exp", arithmetic.negate(a)), a)
    below = arithmetic.function("expn", arithmetic.subtract(order, one), a)
    return arithmetic.not_a_number(), arithmetic.negate(arithmetic.select(arithmetic.equal(order, one), first, below))


def _of_shi(arithmetic: Any, value: Any, a: Any) -> tuple[Any, ...]:
    zero, one = _number(arithmetic, 0), _number(arithmetic, 1)
    quotient = arithmetic.divide(arithmetic.function("sinh", a), a)
    return (arithmetic.select(arithmetic.equal(a, zero), one, quotient),)


def _of_fresnel(arithmetic: Any, a: Any) -> Any:
    """The angle pi a^2 / 2."""
    return arithmetic.multiply(_number(arithmetic, 2 * _HALF_ROOT**2), _square(arithmetic, a))


def _slope(name: str) -> Rates:
    return lambda arithmetic, value, a: (arithmetic.function(name, a),)


def _airy_prime(kind: str) -> Callable[..., Any]:
    return lambda context, a: getattr(context, f"airy{kind}")(a, derivative=1)


def _of_airy_prime(kind: str) -> Rates:
    return lambda arithmetic, value, a: (arithmetic.multiply(a, arithmetic.function(f"airy_{kind}", a)),)


def _of_lambert(arithmetic: Any, value: Any, a: Any) -> tuple[Any, ...]:
    """1 / ((1 + w) e^w), which has a value at zero."""
    return _one_over(arithmetic, arithmetic.add(_number(arithmetic, 1), value), arithmetic.function("exp", value))


_OF_SCIPY = partial(KnownFunction, special=True)
FUNCTIONS: dict[str, KnownFunction] = {
    "fabs": KnownFunction(1, "fabs", _sign, exact=True),
    "floor": KnownFunction(1, "floor", _without_rate, exact=True),
    "fmod": KnownFunction(2, "fmod", _of_remainder, exact=True),
    "exp": KnownFunction(1, "exp", lambda on, value, a: (value,)),
    "expm1": KnownFunction(1, "expm1", lambda on, value, a: (on.function("exp", a),)),
    "log": KnownFunction(1, "ln", lambda on, value, a: _one_over(on, a)),
    "log1p": KnownFunction(1, "log1p", lambda on, value, a: _one_over(on, _above_one(on, a))),
    "pow": KnownFunction(2, "power", _power),
    "cbrt": KnownFunction(1, "cbrt", lambda on, value, a: _one_over(on, _number(on, 3), value, value)),
    "sinh": KnownFunction(1, "sinh", lambda on, value, a: (on.function("cosh", a),)),
    "cosh": KnownFunction(1, "cosh", lambda on, value, a: (on.function("sinh", a),)),
    "tanh": KnownFunction(1, "tanh", lambda on, value, a: (_square(on, *_one_over(on, on.function("cosh", a))),)),
    "asinh": KnownFunction(
        1, "asinh", lambda on, value, a: _one_over(on, on.square_root(_above_one(on, _square(on, a))))
    ),
    "acosh": KnownFunction(1, "acosh", _of_inverse_cosine),
    "atanh": KnownFunction(
        1, "atanh", lambda on, value, a: _one_over(on, on.subtract(_number(on, 1), a), _above_one(on, a))
    ),
    "erf": KnownFunction(1, "erf", lambda on, value, a: (_bell(on, a),)),
    "erfc": KnownFunction(1, "erfc", lambda on, value, a: (on.negate(_bell(on, a)),)),
    "tgamma": KnownFunction(1, "gamma", lambda on, value, a: (on.multiply(value, on.function("digamma", a)),)),
    "lgamma": KnownFunction(1, "loggamma", lambda on, value, a: (on.function("digamma", a),)),
    "stumpff": KnownFunction(2, _stumpff, _of_stumpff, rates_by_square=_stumpff_by_square),
    "digamma": _OF_SCIPY(1, "digamma", lambda on, value, a: (on.function("polygamma", _number(on, 1), a),)),
    "polygamma": _OF_SCIPY(2, lambda context, n, a: context.psi(int(n), a), _following),
    "jv": _OF_SCIPY(2, "besselj", _neighbours("jv", 0)),
    "yv": _OF_SCIPY(2, "bessely", _neighbours("yv", 0)),
    "iv": _OF_SCIPY(2, "besseli", _neighbours("iv", 1)),
    "kv": _OF_SCIPY(2, "besselk", _neighbours("kv", -1)),
    "expi": _OF_SCIPY(1, "ei", lambda on, value, a: (on.divide(on.function("exp", a), a),)),
    "expn": _OF_SCIPY(2, "expint", _preceding),
    "si": _OF_SCIPY(1, "si", lambda on, value, a: (on.function("stumpff", _number(on, 1), a),)),
    "ci": _OF_SCIPY(1, "ci", lambda on, value, a: (on.divide(on.cosine(a), a),)),
    "shi": _OF_SCIPY(1, "shi", _of_shi),
    "chi": _OF_SCIPY(1, "chi", lambda on, value, a: (on.divide(on.function("cosh", a), a),)),
    "fresnel_s": _OF_SCIPY(1, "fresnels", lambda on, value, a: (on.sine(_of_fresnel(on, a)),)),
    "fresnel_c": _OF_SCIPY(1, "fresnelc", lambda on, value, a: (on.cosine(_of_fresnel(on, a)),)),
    **{f"airy_{kind}": _OF_SCIPY(1, f"airy{kind}", _slope(f"airy_{kind}_prime")) for kind in ("ai", "bi")},
    **{f"airy_{kind}_prime": _OF_SCIPY(1, _airy_prime(kind), _of_airy_prime(kind)) for kind in ("ai", "bi")},
    "lambertw": _OF_SCIPY(1, "lambertw", _of_lambert),
    "erfi": _OF_SCIPY(1, "erfi", lambda on, value, a: _one_over(on, _number(on, _HALF_ROOT**2), _bell(on, a))),
    "erfinv": _OF_SCIPY(1, "erfinv", lambda on, value, a: _one_over(on, _bell(on, value))),
    "erfcinv": _OF_SCIPY(
        1,
        lambda context, a: context.erfinv(1 - a),
        lambda on, value, a: (on.negate(_one_over(on, _bell(on, value))[0]),),
    ),
    "zeta": _OF_SCIPY(1, "zeta", None),
    "ellipk": _OF_SCIPY(1, "ellipk", None),
    "ellipe": _OF_SCIPY(1, "ellipe", None),
}
"""By name."""
