"""Questions on elementary functions beyond roots and angles: any of them may be declined, none answered wrongly."""

from __future__ import annotations

from random import Random
from typing import Any

import sympy as sp
from sympy import (
    Abs,
    I,
    Max,
    Min,
    Piecewise,
    Rational,
    acos,
    asin,
    atan,
    atan2,
    conjugate,
    cos,
    cosh,
    exp,
    im,
    log,
    pi,
    re,
    sign,
    sin,
    sinh,
    sqrt,
    tan,
    tanh,
)  # fmt: skip

from .equations import Equation
from .rewriting import distorted

__all__ = ["elementary", "imaginary"]

x, y, z = sp.symbols("x y z")
p, q = sp.symbols("p q", positive=True)
k = sp.Symbol("k", negative=True)

# Each line is the same thing twice wherever both sides have values, unless it says otherwise.
PAIRS: tuple[tuple[Any, Any], ...] = (
    (exp(x + y), exp(x) * exp(y)),
    (exp(x - y), exp(x) / exp(y)),
    (exp(2 * x), exp(x) ** 2),
    (sqrt(exp(2 * x)), exp(x)),
    (log(p * q), log(p) + log(q)),
    (log(x * y), log(x) + log(y)),
    (log(p / q), log(p) - log(q)),
    (log(p**3), 3 * log(p)),
    (log(x**2), 2 * log(Abs(x))),
    (log(exp(x)), x),
    (exp(log(p) + x), p * exp(x)),
    (p ** (x + y), p**x * p**y),
    ((p * q) ** x, p**x * q**x),
    ((p**x) ** 2, p ** (2 * x)),
    (p ** Rational(1, 3) * p ** Rational(2, 3), p),
    (cosh(x) ** 2 - sinh(x) ** 2, sp.Integer(1)),
    (sinh(2 * x), 2 * sinh(x) * cosh(x)),
    (cosh(x + y), cosh(x) * cosh(y) + sinh(x) * sinh(y)),
    (tanh(x), (exp(2 * x) - 1) / (exp(2 * x) + 1)),
    (cosh(x), (exp(x) + exp(-x)) / 2),
    (sin(asin(x)), x),
    (cos(asin(x)), sqrt(1 - x**2)),
    (asin(x) + acos(x), pi / 2),
    (tan(atan(x)), x),
    (cos(atan(x)), 1 / sqrt(1 + x**2)),
    (sin(2 * acos(x)), 2 * x * sqrt(1 - x**2)),
    (tan(atan2(y, x)), y / x),
    (sin(atan2(y, x)), y / sqrt(x**2 + y**2)),
    (atan(p) + atan(1 / p), pi / 2),
    (Max(x, y) + Min(x, y), x + y),
    (Max(x, y), (x + y + Abs(x - y)) / 2),
    (Max(x, y) * Min(x, y), x * y),
    (Max(x, -x), Abs(x)),
    (Piecewise((x, x > 0), (-x, True)), Abs(x)),
    (Piecewise((x**2, x < y), (y**2, True)), Min(x, y) ** 2),
    (Max(x, Max(y, z)), Max(Max(x, y), z)),
    (Abs(Min(p, q)), Min(p, q)),
    (sign(exp(x)), sp.Integer(1)),
    (Abs(k) ** x, (-k) ** x),
    (sin(sp.Integer(1)) ** 2 + cos(sp.Integer(1)) ** 2, sp.Integer(1)),
    (cos(x + 1), cos(x) * cos(1) - sin(x) * sin(1)),
    (cos(pi / 7) - cos(2 * pi / 7) + cos(3 * pi / 7), Rational(1, 2)),
    (sqrt(5 + 2 * sqrt(6)), sqrt(2) + sqrt(3)),
)
# These are false somewhere.
FALSE: tuple[tuple[Any, Any], ...] = (
    (asin(sin(x)), x),
    (acos(cos(x)), x),
    (atan(tan(x)), x),
    (atan(x) + atan(1 / x), pi / 2),
    (atan2(y, x), atan(y / x)),
    (log(x**2), 2 * log(x) + x - x),
    (log(p + q), log(p) + log(q)),
    (exp(x * y), exp(x) * exp(y)),
    (cosh(x) ** 2 + sinh(x) ** 2, sp.Integer(1)),
    (sqrt(cosh(x) ** 2 - 1), sinh(x)),
    (Max(x, y), x),
    (Min(x, y), (x + y + Abs(x - y)) / 2),
    (Piecewise((x, x > 0), (-x, True)), x),
    (Piecewise((1, x > 0), (-1, True)), sign(x) * Piecewise((1, x > y), (2, True))),
    ((x**2) ** Rational(1, 4), sqrt(x) + y - y),
    (atan(x) + atan(y), atan((x + y) / (1 - x * y))),
    (asin(x) + asin(y), asin(x * sqrt(1 - y**2) + y * sqrt(1 - x**2))),
    (acos(-x), acos(x)),
    (cos(pi / 9), Rational(47, 50)),
    (exp(sp.Integer(1)), Rational(1457, 536)),
    (log(sp.Integer(2)), Rational(9, 13)),
)


def _instead(draw: Random, symbol: Any) -> Any:
    """What may be written for a symbol; positive for a positive one."""
    if symbol in (p, q):
        return draw.choice((p, q, p + q, 2 * p, p**2, p * q, sp.Integer(3), exp(x)))
    if symbol == k:
        return draw.choice((k, 2 * k, k - 1, k - p))
    numbers = sp.Integer(2), sp.Integer(-1)
    return draw.choice((x, y, z, x + y, 2 * x, x * y, -x, x - 1, x**2 + 1, p, k, x / 2, *numbers, 1 / x))


def elementary(draw: Random) -> Equation:
    """One of the lines, with other things in the places of its symbols, beside or times something."""
    true = draw.random() < 0.7
    left, right = draw.choice(PAIRS if true else FALSE)
    values = {s: _instead(draw, s) for s in sorted(left.free_symbols | right.free_symbols, key=str)}
    if draw.random() < 0.75:
        left, right = (side.subs(values, simultaneous=True) for side in (left, right))
    factor, term = draw.choice((sp.Integer(1), x, sp.Integer(-2))), draw.choice((sp.Integer(0), y, sp.Integer(1)))
    left, right = left * factor + term, right * factor + term
    if draw.random() < 0.15:
        right = distorted(right, draw)
    if any(side.has(sp.nan, sp.zoo, sp.oo, I) for side in (left, right)):
        return elementary(draw)
    given = () if draw.random() < 0.85 else (sp.Eq(x, draw.choice((y, sp.Integer(1), -y)), evaluate=False),)
    return Equation(left, right, given, kind="functions", lenient=True)


def imaginary(draw: Random) -> Equation:
    """Real and imaginary parts, sizes and conjugates of expressions with I, against what they are or are not."""
    a, b = draw.choice(((x, y), (p, x), (x + 1, y), (x, x), (y, 2 * x)))
    w = a + I * b
    pairs = (
        (re(w), a), (im(w), b), (Abs(w) ** 2, a**2 + b**2), (conjugate(w) * w, a**2 + b**2),
        (w * w, a**2 - b**2 + 2 * I * a * b),
        (im(a / w), -a * b / (a**2 + b**2)), (re(1 / w), a / (a**2 + b**2)), (exp(I * a), cos(a) + I * sin(a)),
        (im(b * exp(I * a)), b * sin(a)), (re(exp(I * a) * w), a * cos(a) - b * sin(a)),
        (Abs(exp(I * a)), sp.Integer(1)),
        (im(w**3), 3 * a**2 * b - b**3), (conjugate(exp(w)), exp(conjugate(w))),
        (re(w / conjugate(w)), (a**2 - b**2) / (a**2 + b**2)),
        (I**2 * a, -a), (exp(I * pi) * a, -a), (im(I * w), a), (Abs(w / (a - I * b)), sp.Integer(1)),
    )  # fmt: skip
    left, right = draw.choice(pairs)
    if draw.random() < 0.5:
        right = draw.choice((sp.Integer(0), -right, right + 1, right * I, conjugate(right)))
    return Equation(sp.sympify(left), sp.sympify(right), kind="imaginary", lenient=True)
