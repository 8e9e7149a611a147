"""Whether an algebraic number is zero: it is if it is smaller than its separation bound.

Burnikel, Funke, Mehlhorn, Schirra and Schmitt, "A separation bound for real algebraic expressions", Algorithmica 55
(2009): a number is a quotient U / L of algebraic integers; with u and l above all conjugates of these, and D not less
than their degree, it is zero or at least 1 / (l u^(D - 1)). Cosines of sums of angles enter by z = exp(i angle / m):
where the angle is an inverse function of a number, some L z and L / z are algebraic integers again.
"""

from __future__ import annotations

from collections.abc import Iterable
from math import isqrt, lcm, prod
from typing import Any

import sympy as sp

from chasles.exact.enclosures import INVERSES, NoEnclosure, enclosed

MOST_BITS = 1 << 15
"""Of an enclosure; beyond, a long number takes seconds."""
MOST_PRODUCTS = 1 << 8


class NotAlgebraic(ValueError):
    """The number is not made by arithmetic, roots, and cosines of sums of angles whose cosines are such numbers."""


def is_algebraic_zero(number: Any) -> bool | None:
    """Whether an algebraic number is zero; None if it takes too many bits to say. Raises NotAlgebraic."""
    size = _Size()
    above, below = size(number)
    separation = below + above * (size.degree - 1)
    for bits in (128, separation + 128, 2 * separation + 256):
        if bits > MOST_BITS:
            return None
        try:
            interval = enclosed(number, bits)
        except NoEnclosure:
            return None
        if interval > 0 or interval < 0:
            return False
        if separation < bits and abs(interval) * 2**separation < 1:
            return True
    return None


def is_algebraic(number: Any) -> bool:
    """Whether the number is written as such."""
    try:
        _Size()(number)
    except NotAlgebraic:
        return False
    return True


def degree_of(numbers: Iterable[Any]) -> int:
    """At least the degree of a field of real numbers in which all are. Raises NotAlgebraic."""
    size = _Size()
    for number in numbers:
        size(number)
    return size.degree // (1 if size.is_real else 2)


class _Size:
    """Bounds on the conjugates of U and of L, in bits, for the parts of one number; `degree` is that of all of them."""

    def __init__(self) -> None:
        self._degrees: dict[Any, int] = {}
        self._squares = {1}
        self._turns = 1

    @property
    def is_real(self) -> bool:
        """Whether the field is known to be, without the imaginary unit."""
        return self._turns == 1

    @property
    def degree(self) -> int:
        """At least the degree of a field in which all parts are."""
        turns = int(sp.totient(self._turns)) if self._turns < MOST_BITS else self._turns
        return turns * len(self._squares) * prod(self._degrees.values())

    def __call__(self, number: Any) -> tuple[int, int]:
        match number:
            case sp.Rational():
                return _bits(number.p), _bits(number.q)
            case sp.Add():
                return self._sum([term.as_coeff_Mul() for term in number.args])
            case sp.Mul():
                sizes = [self(factor) for factor in number.args]
                return sum(above for above, _ in sizes), sum(below for _, below in sizes)
            case sp.Pow(exp=sp.Rational(q=q)):
                above, below = self._root(number.base, int(q)) if q > 1 else self(number.base)
                times = int(number.exp.p)
                return (times * above, times * below) if times > 0 else (-times * below, -times * above)
            case sp.CRootOf():
                leading, *others = map(_bits, number.poly.all_coeffs())
                self._degrees[number] = len(others)
                return max(leading, *others) + 1, leading
            case sp.cos() | sp.sin():
                return self._circular(number.args[0])
            case sp.tan() | sp.cot() | sp.sec() | sp.csc():
                above, below = self._circular(number.args[0])
                return above + below, above + below
        raise NotAlgebraic(number)

    def _sum(self, terms: list[tuple[Any, Any]]) -> tuple[int, int]:
        """Over the common denominator of the rational factors."""
        common = lcm(*(int(times.q) for times, _ in terms))
        whole, divisor = 0, 0
        for times, rest in terms:
            above, below = self(rest)
            above += _bits(times.p * (common // times.q))
            whole, divisor = max(whole + below, above + divisor) + 1, divisor + below
        return whole, divisor + _bits(common)

    def _root(self, base: Any, degree: int) -> tuple[int, int]:
        above, below = self(base)
        if base.is_Rational and degree == 2 and len(self._squares) < MOST_PRODUCTS:
            self._adjoin(int(abs(base.p * base.q)))
        else:
            self._degrees[base, degree] = degree
        if above >= below:
            return -(-(above + (degree - 1) * below) // degree), below
        return above, -(-((degree - 1) * above + below) // degree)

    def _adjoin(self, radicand: int) -> None:
        """The square root of an integer, unless a product of those of others is a multiple of it."""
        if not any(isqrt(radicand * other) ** 2 == radicand * other for other in self._squares):
            self._squares |= {radicand * other for other in self._squares}

    def _circular(self, angle: Any) -> tuple[int, int]:
        """Of (z + 1/z) / 2 and (z - 1/z) / 2i, z a product of powers of exp(i angle / m)."""
        angles = _angles_in(angle)
        self._turns = lcm(self._turns, 4, 2 * int(angles.pop(sp.pi, sp.Integer(0)).q))
        above = below = 0
        for inverse, times in angles.items():
            size = max(self._inverse(inverse)) + 2
            self._degrees[inverse] = lcm(self._degrees.get(inverse, 2), 2 * int(times.q))
            above, below = above + abs(int(times.p)) * size, below + abs(int(times.p)) * size
        return above + 1, below + 1

    def _inverse(self, function: Any) -> tuple[int, int]:
        """Of the argument: if it is U / L, then L z or sqrt(L^2 + U^2) z is an integer for the angle's z, and 1/z."""
        return self(function.args[0])


def _angles_in(angle: Any) -> dict[Any, Any]:
    """The angle as a sum of rational multiples of pi and of inverse functions. Raises NotAlgebraic for another."""
    found: dict[Any, Any] = {}
    for term in sp.Add.make_args(sp.expand_mul(angle)):
        times, rest = term.as_coeff_Mul()
        if term == 0:
            continue
        if not times.is_Rational or not (rest == sp.pi or isinstance(rest, INVERSES)):
            raise NotAlgebraic(angle)
        found[rest] = found.get(rest, sp.Integer(0)) + times
    return found


def _bits(integer: Any) -> int:
    """The least power of two that is not less than its size."""
    return max(int(abs(integer)) - 1, 0).bit_length()
