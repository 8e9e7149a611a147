"""Which steps compute a function of SymPy? Each function once, in the operations and functions of a program."""

from __future__ import annotations

from collections.abc import Callable, Iterable, Mapping, Sequence
from functools import partial

import sympy
from sympy.codegen import cfunctions

from chasles.compiling.elimination import solved
from chasles.compiling.exponentials import (
    Apart,
    DividedExponential,
    HeldLargest,
    apart,
    divided_exponential,
    held_largest,
)
from chasles.compiling.powers import where_nonnegative
from chasles.compiling.taylor import Stumpff, TaylorPolynomial, horner
from chasles.lowering.builder import Builder
from chasles.lowering.program import Op
from chasles.lowering.refusal import LoweringError

_SAME_IN_C: Mapping[type, str] = {
    sympy.Abs: "fabs",
    sympy.floor: "floor",
    sympy.Rem: "fmod",
    sympy.exp: "exp",
    sympy.sinh: "sinh",
    sympy.cosh: "cosh",
    sympy.tanh: "tanh",
    sympy.asinh: "asinh",
    sympy.acosh: "acosh",
    sympy.atanh: "atanh",
    sympy.erf: "erf",
    sympy.erfc: "erfc",
    sympy.gamma: "tgamma",
    sympy.besselj: "jv",
    sympy.bessely: "yv",
    sympy.besseli: "iv",
    sympy.besselk: "kv",
    sympy.Ei: "expi",
    sympy.Si: "si",
    sympy.Shi: "shi",
    sympy.fresnels: "fresnel_s",
    sympy.fresnelc: "fresnel_c",
    sympy.airyai: "airy_ai",
    sympy.airybi: "airy_bi",
    sympy.airyaiprime: "airy_ai_prime",
    sympy.airybiprime: "airy_bi_prime",
    sympy.LambertW: "lambertw",
    sympy.erfi: "erfi",
    sympy.erfinv: "erfinv",
    sympy.erfcinv: "erfcinv",
    sympy.zeta: "zeta",
    sympy.elliptic_k: "ellipk",
    sympy.elliptic_e: "ellipe",
    cfunctions.expm1: "expm1",
    cfunctions.log1p: "log1p",
    cfunctions.Cbrt: "cbrt",
}


class Inverted(sympy.Function):  # type: ignore[misc]
    """An entry of an inverse: its row and column, how many rows the matrix has, and the entries of that."""

    is_real = True


class HeldErfc(sympy.Function):  # type: ignore[misc]
    """The complementary error function; SymPy would write it as 2 less that of the opposite."""

    nargs = (1,)
    is_real = True


class PowerTimesLog(sympy.Function):  # type: ignore[misc]
    """A positive power of a base times the logarithm of a multiple of the base; zero where the base is."""

    nargs = (3,)
    is_real = True


def functions_by_class(build: Builder) -> dict[type, Callable[..., int]]:
    """The steps of each function of SymPy that is known, of the steps of its arguments."""

    def over(a: int) -> int:
        return build.divide(build.one, a)

    inverse_sine, inverse_cosine = partial(_arcsine, build), partial(_arccosine, build)
    found: dict[type, Callable[..., int]] = {key: partial(build.function, name) for key, name in _SAME_IN_C.items()}
    return found | {
        sympy.sin: build.sine,
        sympy.cos: build.cosine,
        sympy.tan: lambda a: build.divide(build.sine(a), build.cosine(a)),
        sympy.cot: lambda a: build.divide(build.cosine(a), build.sine(a)),
        sympy.sec: lambda a: over(build.cosine(a)),
        sympy.csc: lambda a: over(build.sine(a)),
        sympy.sinc: lambda a: build.function("stumpff", build.one, a),
        Stumpff: partial(build.function, "stumpff"),
        TaylorPolynomial: lambda a, limit, *coefficients: horner(build, a, *coefficients),
        sympy.atan2: build.arctangent2,
        sympy.atan: lambda a: build.arctangent2(a, build.one),
        sympy.acot: partial(_arccotangent, build),
        sympy.asin: inverse_sine,
        sympy.acos: inverse_cosine,
        sympy.asec: lambda a: inverse_cosine(over(a)),
        sympy.acsc: lambda a: inverse_sine(over(a)),
        sympy.coth: lambda a: over(build.function("tanh", a)),
        sympy.sech: lambda a: over(build.function("cosh", a)),
        sympy.csch: lambda a: over(build.function("sinh", a)),
        sympy.acoth: lambda a: build.function("atanh", over(a)),
        sympy.asech: partial(_inverse_hyperbolic_secant, build),
        sympy.acsch: lambda a: build.function("asinh", over(a)),
        DividedExponential: lambda *points: divided_exponential(build, list(points)),
        HeldErfc: partial(build.function, "erfc"),
        Inverted: partial(_inverted, build, {}),
        sympy.expint: partial(_exponential_integral, build),
        sympy.Ci: lambda a: where_nonnegative(build, a, build.function("ci", a)),
        sympy.Chi: lambda a: where_nonnegative(build, a, build.function("chi", a)),
        sympy.li: lambda a: build.function("expi", build.function("log", a)),
        sympy.polygamma: partial(_polygamma, build),
        sympy.loggamma: lambda a: where_nonnegative(build, a, build.function("lgamma", a)),
        sympy.factorial: lambda a: build.function("tgamma", build.add(a, build.one)),
        sympy.ceiling: lambda a: build.negate(build.function("floor", build.negate(a))),
        sympy.frac: lambda a: build.subtract(a, build.function("floor", a)),
        sympy.Mod: partial(_remainder, build),
        sympy.sign: partial(_sign, build),
        sympy.Heaviside: partial(_unit_step, build),
        HeldLargest: partial(held_largest, build),
        Apart: partial(apart, build),
        sympy.Max: lambda *many: _extreme(build, many, largest=True),
        sympy.Min: lambda *many: _extreme(build, many, largest=False),
        cfunctions.Sqrt: build.square_root,
        cfunctions.exp2: lambda a: build.function("pow", build.constant(2), a),
        cfunctions.hypot: lambda a, b: build.square_root(build.add(build.multiply(a, a), build.multiply(b, b))),
    }


def _leg(build: Builder, a: int) -> int:
    """The root of 1 - a^2, in factors, which lose nothing near 1; of 1 - b and b - 1 one of them is b as it is."""
    step, less, more = build.step(a), build.subtract(build.one, a), build.add(build.one, a)
    if step.op is Op.SUBTRACT:
        less = step.operands[1] if step.operands[0] == build.one else less
        more = step.operands[0] if step.operands[1] == build.one else more
    return build.square_root(build.multiply(less, more))


def _arcsine(build: Builder, a: int) -> int:
    return build.arctangent2(a, _leg(build, a))


def _arccosine(build: Builder, a: int) -> int:
    return build.arctangent2(_leg(build, a), a)


def _arccotangent(build: Builder, a: int) -> int:
    """The angle in (-pi/2, pi/2], which jumps at zero."""
    turned = build.negate(build.arctangent2(build.one, build.negate(a)))
    return build.select(build.less(a, build.zero), turned, build.arctangent2(build.one, build.function("fabs", a)))


def _inverted(build: Builder, known: dict[tuple[int, ...], Sequence[Sequence[int]]], *of: int) -> int:
    row, column, size = (int(build.value(each) or 0) for each in of[:3])
    entries = of[3:]
    if entries not in known:
        unit = [[build.one if i == j else build.zero for j in range(size)] for i in range(size)]
        known[entries] = solved(build, [entries[k : k + size] for k in range(0, size * size, size)], unit)
    return known[entries][row][column]


def _polygamma(build: Builder, order: int, a: int) -> int:
    return build.function("digamma", a) if build.value(order) == 0 else build.function("polygamma", order, a)


def _exponential_integral(build: Builder, order: int, a: int) -> int:
    value = build.value(order)
    if value is None or value.denominator > 1 or value < 1:
        raise LoweringError("expint is computed for orders that are positive whole numbers")
    return build.function("expn", order, a)


def _sign(build: Builder, a: int) -> int:
    positive = build.select(build.less(build.zero, a), build.one, a)
    return build.select(build.less(a, build.zero), build.negate(build.one), positive)


def _unit_step(build: Builder, a: int, at_zero: int) -> int:
    """0 below zero and 1 above; not a number for what is none."""
    zero = build.select(build.equal(a, build.zero), at_zero, a)
    return build.select(build.less(a, build.zero), build.zero, build.select(build.less(build.zero, a), build.one, zero))


def _remainder(build: Builder, a: int, b: int) -> int:
    """What is left of a once multiples of b are taken away, with the sign of b, that of a zero too."""
    rest = build.function("fmod", a, b)
    # A zero plus a positive zero is positive.
    zero = build.subtract(rest, rest)
    positive = build.select(build.less(rest, build.zero), build.add(rest, b), build.add(rest, zero))
    negative = build.select(build.less(build.zero, rest), build.add(rest, b), build.negate(build.subtract(zero, rest)))
    value = build.value(b)
    if value is not None:
        return negative if value < 0 else positive
    return build.select(build.less(b, build.zero), negative, positive)


def _inverse_hyperbolic_secant(build: Builder, a: int) -> int:
    """By half of it: 1/a has no more digits than a, and near 1 those that count are lost."""
    half = build.divide(build.square_root(build.subtract(build.one, a)), build.square_root(build.add(a, a)))
    return build.multiply(build.constant(2), build.function("asinh", half))


def _extreme(build: Builder, many: Iterable[int], *, largest: bool) -> int:
    """The largest or the smallest; not a number where one of them is none."""
    found, *rest = many
    for other in rest:
        low, high = (found, other) if largest else (other, found)
        same = build.select(build.equal(found, other), found, build.not_a_number())
        found = build.select(build.less(low, high), other, build.select(build.less(high, low), found, same))
    return found
