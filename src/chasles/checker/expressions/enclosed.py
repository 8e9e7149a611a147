"""Values of SymPy expressions where symbols have exact values, between rational numbers; and numbers that vanish.

Whether an algebraic number vanishes is seen from a bound below which none does (C. Burnikel et al., A separation bound
for real algebraic expressions, 2009).
"""

from __future__ import annotations

from collections.abc import Callable, Mapping
from fractions import Fraction
from functools import reduce
from itertools import combinations
from math import lcm, prod
from operator import truediv
from typing import Any

import sympy
from sympy.core.relational import Relational

from chasles.checker.expressions.complexes import QUOTIENTS
from chasles.checker.expressions.defined_functions import BOUNDED, gamma_at, is_entire, remainder
from chasles.checker.expressions.intervals import Enclosing, Enclosure, Unbounded
from chasles.checker.expressions.readings import Floor, is_integral
from chasles.checker.sparse import Rejected

BITS = 200
MOST_BITS = 20_000
LARGEST_EXPONENT = 10_000
Sign = Callable[[Any], int | None]
"""The sign of an expression, where it is known."""
HOLDING = {"==": (0,), "!=": (1, -1), ">": (1,), ">=": (0, 1), "<": (-1,), "<=": (0, -1)}


class EnclosedValues:
    """Encloses expressions at a point: exact values of symbols and of functions."""

    def __init__(self, point: Mapping[Any, Any], bits: int = BITS) -> None:
        self.point = point
        self.at = Enclosing(bits)
        self.known: dict[Any, Enclosure] = {}

    def __call__(self, e: Any) -> Enclosure:
        """What holds the value; raises `Rejected` where there may be none, or none is known."""
        if e not in self.known:
            try:
                self.known[e] = self._of(e)
            except Unbounded as reason:
                raise Rejected(f"{e} may have no value at the point: {reason}") from None
        return self.known[e]

    def _of(self, e: Any) -> Enclosure:
        if e in self.point:
            return self(sympy.sympify(self.point[e]))
        for kind in type(e).__mro__:
            if kind in ENCLOSED:
                return ENCLOSED[kind](self, e)
        raise Rejected(f"{e} has no value that is known to the checker")

    def sign(self, e: Any) -> int:
        """The sign; raises `Rejected` where it is not clear."""
        exact, sign = self.exactly(e), self(e).sign  # what cancels has to be real
        if exact == 0 or (sign is None and vanishes(exact)):
            return 0
        if sign is None:
            raise Rejected(f"the sign of {e} is not clear at the point")
        return sign

    def exactly(self, e: Any) -> Any:
        """The expression at the point, as SymPy writes it out."""
        try:
            return sympy.expand(e.xreplace(dict(self.point)))
        except ZeroDivisionError:
            raise Rejected(f"{e} has no value at the point") from None

    def power(self, e: Any) -> Enclosure:
        """A power: of a root if the exponent is rational, else by the logarithm; one over a pole is zero."""
        exponent = e.exp.xreplace(dict(self.point))
        if not exponent.is_Rational:
            return self.at.exp(self.at.times(self(e.exp), self.at.log(self(e.base))))
        if abs(exponent.p) > LARGEST_EXPONENT:
            raise Rejected(f"the exponent {exponent} is very large")
        if is_entire(e) and self.exactly(e.base) == sympy.zoo:
            return self.at.number(0)
        base = self(e.base)
        return self.at.power(base if exponent.q == 1 else self.at.root(base, int(exponent.q)), int(exponent.p))


def truth(condition: Any, sign_of: Sign) -> bool | None:
    """Whether a condition holds, as far as the signs of differences say."""
    signs = {relation: sign_of(relation.lhs - relation.rhs) for relation in condition.atoms(Relational)}
    known = {r: sympy.sympify(sign in HOLDING[r.rel_op]) for r, sign in signs.items() if sign is not None}
    found = condition.xreplace(known)
    return bool(found) if found in (sympy.true, sympy.false) else None


def written(part: Any, sign_of: Sign) -> Any:
    """What a part is that changes its form; None where that takes a sign that is not known."""
    if isinstance(part, sympy.Piecewise):
        for value, condition in part.args:
            holds = truth(condition, sign_of)
            if holds is None or holds:
                return value if holds else None
        return sympy.nan
    if isinstance(part, sympy.Max | sympy.Min):
        for one, other in combinations(sorted(part.args, key=str), 2):
            sign = sign_of(one - other)
            if sign is not None:
                lost = other if (sign >= 0 if isinstance(part, sympy.Max) else sign <= 0) else one
                return part.func(*(e for e in part.args if e != lost))
        return None
    sign = sign_of(part.args[0])
    if sign is None or isinstance(part, sympy.Abs | sympy.sign):
        return None if sign is None else sign * (part.args[0] if isinstance(part, sympy.Abs) else sympy.S.One)
    return sympy.Integer(max(sign, 0)) if sign else part.args[1]


def _larger(one: Enclosure, other: Enclosure) -> Enclosure:
    return Enclosure(max(one.low, other.low), max(one.high, other.high))


def _rewritten(rule: Callable[[Any], Any], power: int = 1) -> Callable[[EnclosedValues, Any], Enclosure]:
    """By others, as in Abramowitz and Stegun, Handbook of Mathematical Functions, 4.4, 4.5 and 4.6."""
    return lambda of, e: of(rule(e.args[0] ** power))


def _floor(of: EnclosedValues, e: Any) -> Enclosure:
    """The greatest integer, of a number that is exact or not near to one."""
    exact = of.exactly(e.args[0])
    if exact.is_Rational:
        return of.at.number(int(exact // 1))
    found = of(e.args[0])
    low, high = (end >> of.at.bits for end in (found.low, found.high))
    if low != high:
        raise Rejected(f"{e} is not clear at the point")
    return of.at.number(low)


def _bounded(of: EnclosedValues, e: Any) -> Enclosure:
    """No more than that it is bounded, where its arguments have values."""
    if e.args[:-1] and not is_integral(e.args[0]):
        raise Rejected(f"{e} is not known to be real")
    of(e.args[-1])
    return Enclosure(-BOUNDED[e.func] * of.at.one, BOUNDED[e.func] * of.at.one)


def _direction(of: EnclosedValues, e: Any) -> Enclosure:
    """By the arctangent, in a half plane in which the point surely lies."""
    y, x = e.args
    if of(x).sign == 1:
        return of(sympy.atan(y / x))
    side = of.sign(y)
    if not side and of.sign(x) == 0:
        raise Rejected(f"{e} has no value at the point")
    return of(side * sympy.pi / 2 - sympy.atan(x / y)) if side else of.at.pi


ENCLOSED: dict[type, Callable[[EnclosedValues, Any], Enclosure]] = {
    sympy.Rational: lambda of, e: of.at.number(Fraction(int(e.p), int(e.q))),
    type(sympy.pi): lambda of, _: of.at.pi, type(sympy.E): lambda of, _: of.at.exp(of.at.number(1)),
    sympy.Add: lambda of, e: reduce(Enclosure.__add__, map(of, e.args)), sympy.Pow: EnclosedValues.power,
    sympy.Mul: lambda of, e: reduce(of.at.times, map(of, e.args)), sympy.atan2: _direction,
    sympy.Abs: lambda of, e: _larger(of(e.args[0]), -of(e.args[0])),
    **dict.fromkeys((sympy.Piecewise, sympy.sign, sympy.Heaviside), lambda of, e: of(written(e, of.sign))),
    **dict.fromkeys((Floor, sympy.floor), _floor), **dict.fromkeys(BOUNDED, _bounded),
    sympy.Mod: lambda of, e: of(remainder(e)), sympy.gamma: lambda of, e: of(gamma_at(of.exactly(e.args[0]))),
    sympy.erf: lambda of, e: of.at.erf(of(e.args[0])),
    sympy.Max: lambda of, e: reduce(_larger, map(of, e.args)),
    sympy.Min: lambda of, e: -reduce(_larger, (-of(part) for part in e.args)),
    sympy.cos: lambda of, e: of.at.cosine_and_sine(of(e.args[0]))[0],
    sympy.sin: lambda of, e: of.at.cosine_and_sine(of(e.args[0]))[1],
    sympy.exp: lambda of, e: of.at.exp(of(e.args[0])), sympy.atan: lambda of, e: of.at.atan(of(e.args[0])),
    sympy.log: lambda of, e: of(reduce(truediv, map(sympy.log, e.args))) if e.args[1:] else of.at.log(of(e.args[0])),
    **{function: _rewritten(rule) for function, rule in {
        **QUOTIENTS,
        sympy.sinh: lambda x: (sympy.exp(x) - sympy.exp(-x)) / 2,
        sympy.cosh: lambda x: (sympy.exp(x) + sympy.exp(-x)) / 2,
        sympy.asinh: lambda x: sympy.log(x + sympy.sqrt(x**2 + 1)),
        sympy.acosh: lambda x: sympy.log(x + sympy.sqrt(x - 1) * sympy.sqrt(x + 1)),
        sympy.atanh: lambda x: (sympy.log(1 + x) - sympy.log(1 - x)) / 2,
        sympy.asin: lambda x: 2 * sympy.atan(x / (1 + sympy.sqrt(1 - x**2))),
        sympy.acos: lambda x: sympy.pi / 2 - 2 * sympy.atan(x / (1 + sympy.sqrt(1 - x**2))),
    }.items()},
    **{function: _rewritten(rule, -1) for function, rule in {
        sympy.acot: sympy.atan, sympy.asec: sympy.acos, sympy.acsc: sympy.asin,
        sympy.acoth: sympy.atanh, sympy.asech: sympy.acosh, sympy.acsch: sympy.asinh,
    }.items()},
}  # fmt: skip


def sign_of_number(e: Any) -> int | None:
    """The sign of a number, if it is known."""
    if e == 0:
        return 0
    try:
        return EnclosedValues({})(e).sign
    except Rejected:
        return None


def sign_of_multiple(e: Any, known: Any) -> int | None:
    """The sign of the number by which one expression is a multiple of another, if it is one."""
    e, known = sympy.expand(e), sympy.expand(known)
    number, part = sympy.Add.make_args(known)[-1].as_independent(*known.free_symbols, as_Add=False)
    terms = (term.as_independent(*known.free_symbols, as_Add=False) for term in sympy.Add.make_args(e))
    multiple = sum(n for n, other in terms if other == part) / number
    return sign_of_number(multiple) if multiple and sympy.expand(e - multiple * known) == 0 else None


def vanishes(e: Any) -> bool:
    """Whether an algebraic number is known to be zero."""
    above, below = _sizes(e)
    bits = (_degree(e) - 1) * above + below
    if bits > MOST_BITS:
        return False
    precise = EnclosedValues({}, 2 * bits + BITS)
    found = precise(e)
    return max(-found.low, found.high) << bits < precise.at.one


def _sizes(e: Any) -> tuple[int, int]:
    """Binary logarithms of bounds of the conjugates of two algebraic integers of which a number is the quotient."""
    if isinstance(e, sympy.Rational):
        return abs(int(e.p)).bit_length(), int(e.q).bit_length()
    if isinstance(e, sympy.Add | sympy.Mul):
        parts = [_sizes(part) for part in e.args]
        below = sum(b for _, b in parts)
        if isinstance(e, sympy.Mul):
            return sum(a for a, _ in parts), below
        return max(a - b for a, b in parts) + below + len(parts).bit_length(), below
    if isinstance(e, sympy.Pow) and e.exp.is_Rational:
        (a, b), degree, power = _sizes(e.base), int(e.exp.q), int(e.exp.p)
        a = (a + (degree - 1) * b + degree - 1) // degree
        return (a * power, b * power) if power > 0 else (-b * power, -a * power)
    if isinstance(e, sympy.cos) and (e.args[0] / sympy.pi).is_Rational:
        return 1, 1
    raise Rejected(f"{e} is no algebraic number that the checker knows")


def _degree(e: Any) -> int:
    """A bound of the degree of a field in which a number and all of its parts are."""
    roots = {(part.base, int(part.exp.q)) for part in e.atoms(sympy.Pow)}
    parts = lcm(1, *(int((call.args[0] / sympy.pi).q) for call in e.atoms(sympy.cos)))
    return prod(degree for _, degree in roots) * max(1, int(sympy.totient(2 * parts)) // 2)
