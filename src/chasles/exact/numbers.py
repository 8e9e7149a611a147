"""Exact real numbers as SymPy spells them: their normal form, their sign, and whether they are zero.

Numbers made of rational numbers by square roots, however nested, are brought into the normal form of their tower, where
zero is told by its form. Of any number, a sign that an enclosure tells is its sign. What may be zero is so if it is
algebraic and below its separation bound, or vanishes for all values of the angles and cosines in it that are
independent; else the question is declined rather than guessed.
"""

from __future__ import annotations

from contextlib import suppress
from fractions import Fraction
from functools import lru_cache, reduce
from textwrap import shorten
from typing import Any

import sympy as sp
from mpmath.libmp import finf, fninf, to_rational

from chasles.exact.enclosures import NoEnclosure, enclosed, sign_by_enclosure
from chasles.exact.grounds import NotDecided, RationalFunctions
from chasles.exact.independent import by_sine_and_cosine, coefficients, vanishes, without_squares
from chasles.exact.separation import NotAlgebraic, is_algebraic_zero
from chasles.exact.tower import NegativeRadicand, QuadraticTower
from chasles.exact.tower_elements import NotInTower, has_roots_of_atoms, in_tower, independent_atoms, is_surd, spelled

__all__ = ["NotDecided", "angle", "compare", "decimals", "is_zero", "normal", "root", "sign"]

FEW_BITS = 256
MOST_BITS = 1 << 12
MOST_OPERATIONS = 800
"""In a number that square roots do not express: beyond, expanding it may take hours."""
LARGEST_TURN = 1000
"""Denominators of multiples of pi that an angle is compared with."""


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
        tower = QuadraticTower()
        return spelled(tower, in_tower(tower, expression))
    except NotInTower:
        atoms = independent_atoms(expression)
    if atoms is None or expression.free_symbols or not has_roots_of_atoms(expression):
        return _with_atoms(expression)
    tower = QuadraticTower(RationalFunctions(atoms))
    try:
        return spelled(tower, in_tower(tower, expression))
    except NotInTower:
        return _with_atoms(expression)


def is_zero(value: Any) -> bool:
    """Whether the value is zero; raises NotDecided where nothing decides it."""
    expression = sp.sympify(value)
    if expression.is_Rational or expression.free_symbols:
        return bool(normal(expression) == 0)
    return _number_is_zero(expression)


@lru_cache(maxsize=20_000)
def _number_is_zero(number: Any) -> bool:
    if sign_by_enclosure(number, FEW_BITS):
        return False
    if has_roots_of_atoms(number) and normal(number) == 0:
        return True
    try:
        found = is_algebraic_zero(number)
    except NotAlgebraic:
        found = True if vanishes(number) else None
    if found is None and is_surd(number):
        return bool(normal(number) == 0)
    if found is None and not sign_by_enclosure(number, MOST_BITS):
        raise NotDecided(f"nothing decides whether {shorten(str(number), 80)} is zero")
    return bool(found)


def sign(value: Any) -> int:
    """1, 0 or -1; raises NotDecided where nothing decides it."""
    expression = sp.sympify(value)
    if expression.is_Rational:
        return int(sp.sign(expression))
    if expression.free_symbols:
        raise NotDecided(f"the sign of {expression} depends on what its symbols stand for")
    if found := sign_by_enclosure(expression, FEW_BITS):
        return found
    if is_zero(expression):
        return 0
    if found := sign_by_enclosure(expression, MOST_BITS):
        return found
    raise NotDecided(f"nothing decides the sign of {shorten(str(expression), 80)}")


def compare(one: Any, other: Any) -> int:
    """1, 0 or -1: the sign of the first less the second."""
    return sign(one - other)


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
    """The number in decimals, to that many significant digits: both ends of an enclosure are rounded to them."""
    expression = normal(value)
    bits = 4 * digits + 64
    with suppress(NoEnclosure):
        while bits <= MOST_BITS:
            ends = enclosed(expression, bits)._mpi_
            near = {str(sp.Float(sp.Rational(*to_rational(end)), digits)) for end in ends if end not in (finf, fninf)}
            if len(near) == 1 and finf not in ends and fninf not in ends:
                return near.pop()
            bits *= 2
    if expression.has(sp.cot):
        # Near a right angle SymPy's decimals of it are not what they say.
        raise NotDecided(f"nothing tells {digits} digits of {shorten(str(expression), 80)}")
    return str(sp.N(expression, digits))


def _multiple_of_pi(cosine: Any) -> Any:
    """The angle as a multiple of pi, if it is one by a fraction of no large denominator."""
    turns = enclosed(sp.acos(cosine) / sp.pi, FEW_BITS)
    near = Fraction(*to_rational(turns.mid._mpi_[0])).limit_denominator(LARGEST_TURN)
    found = sp.pi * sp.Rational(near.numerator, near.denominator)
    return found if is_zero(cosine - sp.cos(found)) else None


def _with_atoms(expression: Any) -> Any:
    """A quotient of polynomials in what is no surd, with surds in normal form as coefficients."""
    is_number = not expression.free_symbols
    if is_number:
        _require_short(expression)
    expression = by_sine_and_cosine(expression)
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


def _polynomial(expression: Any, symbols: list[Any]) -> Any:
    return sp.Add(*(normal(c) * powers for powers, c in coefficients(expression, symbols).items()))


def _atoms(expression: Any) -> set[Any]:
    """The largest parts that neither arithmetic nor square roots of surds make."""
    if expression.is_Rational:
        return set()
    if expression.is_Add or expression.is_Mul or (expression.is_Pow and expression.exp.is_Integer):
        return set().union(*map(_atoms, expression.args))
    return set() if is_surd(expression) else {expression}
