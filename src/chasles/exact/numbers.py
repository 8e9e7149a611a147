"""Exact real numbers as SymPy spells them: their normal form, their sign, and whether they are zero.

Numbers made of rational numbers by square roots, however nested, are brought into the normal form of their tower, where
zero is told by its form. Of others, zero is told by the minimal polynomial; where even that does not exist, a number is
not zero if an enclosure says so, and else the question is declined rather than guessed.
"""

from __future__ import annotations

from fractions import Fraction
from functools import lru_cache, reduce
from typing import Any

import mpmath
import sympy as sp

from chasles.exact.circular import C, S, in_one_angle, without_squares
from chasles.exact.square_roots import NotInTower, in_tower, is_surd, spelled
from chasles.exact.tower import NegativeRadicand, Tower

__all__ = ["NotDecided", "angle", "compare", "decimals", "is_zero", "normal", "root", "sign"]

DIGITS = 30
MOST_DIGITS = 500
MOST_OPERATIONS = 800
"""In a number that square roots do not express: beyond, expanding it may take hours."""
LARGEST_TURN = 1000
"""Denominators of multiples of pi that an angle is compared with."""


_QUOTIENTS = {
    sp.tan: lambda x: sp.sin(x) / sp.cos(x),
    sp.cot: lambda x: sp.cos(x) / sp.sin(x),
    sp.sec: lambda x: 1 / sp.cos(x),
    sp.csc: lambda x: 1 / sp.sin(x),
}


class NotDecided(ArithmeticError):
    """Nothing that is known decides whether the number is zero."""


def normal(value: Any) -> Any:
    """The number, or the rational expression in free symbols, in normal form: zero exactly if it is equal to zero.

    Numbers that square roots do not express keep their spelling, with normal coefficients.
    Raises ValueError for the square root of a negative number, ZeroDivisionError for a division by zero.
    """
    expression = sp.sympify(value) if isinstance(value, int | Fraction) else value
    return expression if expression.is_Rational else _normal(expression)


@lru_cache(maxsize=20_000)
def _normal(expression: Any) -> Any:
    if expression.is_Symbol or expression == sp.pi:
        return expression
    try:
        tower = Tower()
        return spelled(tower, in_tower(tower, expression))
    except NotInTower:
        return _with_atoms(expression)


def is_zero(value: Any) -> bool:
    """Whether the value is zero; raises NotDecided where nothing decides it."""
    expression = normal(value)
    if expression.is_Rational or is_surd(expression) or expression.free_symbols:
        return bool(expression == 0)
    if expression.is_algebraic:
        x = sp.Dummy("x")
        return bool(sp.minimal_polynomial(expression, x) == x)
    written = in_one_angle(expression)
    if written is not None and _vanishes(written):
        return True
    if _bounded_away(expression):
        return False
    raise NotDecided(f"nothing decides whether {expression} is zero")


def sign(value: Any) -> int:
    """1, 0 or -1; raises NotDecided where nothing decides it."""
    expression = normal(value)
    if expression.is_Rational:
        return int(sp.sign(expression))
    try:
        tower = Tower()
        return tower.sign(in_tower(tower, expression))
    except NotInTower:
        pass
    if expression.free_symbols:
        raise NotDecided(f"the sign of {expression} depends on what its symbols stand for")
    if is_zero(expression):
        return 0
    digits = DIGITS
    while digits <= MOST_DIGITS:
        low, high = _enclosure(expression, digits)
        if low > 0 or high < 0:
            return 1 if low > 0 else -1
        digits *= 2
    raise NotDecided(f"nothing decides the sign of {expression}")


def compare(one: Any, other: Any) -> int:
    """1, 0 or -1: the sign of the first less the second."""
    return sign(normal(one) - normal(other))


def root(value: Any) -> Any:
    """The square root that is not negative, denested where that can be; raises ValueError for a negative number."""
    expression = normal(value)
    if not expression.free_symbols and sign(expression) < 0:
        raise NegativeRadicand(f"the square root of {expression}, which is negative")
    return normal(sp.sqrt(expression))


def angle(cosine: Any, sine: Any) -> Any:
    """The angle in (-pi, pi] with that cosine and sine: a rational multiple of pi where it is one, else an acos."""
    c = normal(cosine)
    turned = sp.acos(c)
    if not (turned / sp.pi).is_Rational:
        turned = _multiple_of_pi(c) or turned
    return -turned if sign(sine) < 0 else turned


def decimals(value: Any, digits: int = 10) -> str:
    """The number in decimals, to that many significant digits."""
    return str(sp.N(normal(value), digits))


def _multiple_of_pi(cosine: Any) -> Any:
    """The angle as a multiple of pi, if it is a rational one: then cos(q phi) is 1 or -1 for its denominator q."""
    near = mpmath.acos(mpmath.mpf(str(sp.N(cosine, DIGITS)))) / mpmath.pi
    for below in range(1, LARGEST_TURN):
        above = round(near * below)
        if abs(near * below - above) < 1e-9 and is_zero(_chebyshev(cosine, below) - (-1) ** above):
            return sp.pi * sp.Rational(int(above), below)
    return None


def _chebyshev(cosine: Any, times: int) -> Any:
    """cos(n phi) from cos(phi)."""
    before, here = sp.Integer(1), cosine
    for _ in range(times - 1):
        before, here = here, normal(2 * cosine * here - before)
    return here


def _with_atoms(expression: Any) -> Any:
    """A quotient of polynomials in what is no surd, with surds in normal form as coefficients."""
    is_number = not expression.free_symbols
    if is_number:
        _require_short(expression)
    for function, by_sine_and_cosine in _QUOTIENTS.items():
        expression = expression.replace(function, by_sine_and_cosine)
    atoms = sorted(_atoms(expression), key=sp.default_sort_key)
    symbols = [sp.Dummy(f"x{place}") for place in range(len(atoms))]
    named = dict(zip(atoms, symbols, strict=True))
    circles = [(named[sp.cos(atom.args[0])], named[atom]) for atom in atoms
               if isinstance(atom, sp.sin) and sp.cos(atom.args[0]) in named]  # fmt: skip
    sides = sp.fraction(sp.together(expression.xreplace(named)))
    above, below = (_polynomial(_on_circles(side, circles), symbols) for side in sides)
    if above == 0:
        return sp.Integer(0)
    constant, powers = below.as_independent(*symbols, as_Add=False)
    if powers.is_Add or constant.is_Add:
        if is_number:
            _require_short(above, below)
        above, below = sp.fraction(sp.cancel(above / below))
        constant, powers = below.as_independent(*symbols, as_Add=False)
    quotient = _polynomial(_on_circles(above / constant, circles), symbols) / powers
    return quotient.xreplace(dict(zip(symbols, atoms, strict=True)))


def _require_short(*expressions: Any) -> None:
    if sum(expression.count_ops() for expression in expressions) > MOST_OPERATIONS:
        raise NotDecided(f"a number grows beyond {MOST_OPERATIONS} operations")


def _on_circles(polynomial: Any, circles: list[tuple[Any, Any]]) -> Any:
    """The polynomial without squares of sines whose cosines occur as well."""
    return reduce(lambda rest, pair: without_squares(rest, *pair), circles, polynomial)


def _vanishes(expression: Any) -> bool:
    """Whether an expression in the cosine and sine of one angle is zero, since these are on the unit circle."""
    above = without_squares(sp.fraction(sp.together(expression))[0])
    terms = sp.Poly(above, C, S, domain="EX").terms()
    return all(is_zero(coefficient) for _, coefficient in terms)


def _polynomial(expression: Any, symbols: list[Any]) -> Any:
    polynomial = sp.Poly(sp.expand(expression), *symbols, domain="EX")
    return sp.Add(*(normal(c) * sp.prod(s**k for s, k in zip(symbols, powers, strict=True))
                    for powers, c in polynomial.terms()))  # fmt: skip


def _atoms(expression: Any) -> set[Any]:
    """The largest parts that neither arithmetic nor square roots of surds make."""
    if expression.is_Rational:
        return set()
    if expression.is_Add or expression.is_Mul or (expression.is_Pow and expression.exp.is_Integer):
        return set().union(*map(_atoms, expression.args))
    return set() if is_surd(expression) else {expression}


def _bounded_away(expression: Any) -> bool:
    digits = DIGITS
    while digits <= MOST_DIGITS:
        low, high = _enclosure(expression, digits)
        if low > 0 or high < 0:
            return True
        digits *= 2
    return False


def _enclosure(expression: Any, digits: int) -> tuple[Any, Any]:
    """Two numbers between which the value lies."""
    with mpmath.workdps(digits + 10):
        value = mpmath.mpf(str(sp.N(expression, digits + 10, maxn=20 * digits)))
        width = mpmath.mpf(10) ** -digits * max(1, abs(value))
        return value - width, value + width
