"""Real roots of polynomials all of whose roots are real: by square roots where these express them, else as places.

A polynomial is factored over the field of its coefficients; real roots are counted by Sturm sequences, as SymPy does. A
factor of degree one or two has its roots by square roots, one of degree four where a square root splits it. No other
has: the degree of what square roots make is a power of two, and where all roots are real, a factor of degree four that
no square root splits is not such either.
"""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass
from functools import cmp_to_key
from typing import Any

import sympy as sp
from sympy import CRootOf, Poly, Symbol, latex

from chasles.exact.enclosures import enclosed
from chasles.exact.fields import NumberField
from chasles.exact.numbers import NotDecided, compare, is_zero, normal, root
from chasles.exact.tower_elements import independent_atoms

X = Symbol("x")
DIGITS = 30


@dataclass(frozen=True, slots=True)
class Root:
    """Real root number `index`, from the least, of an irreducible integer polynomial, highest power first."""

    coefficients: tuple[int, ...]
    index: int

    @property
    def value(self) -> Any:
        """The root as SymPy has it."""
        return CRootOf(Poly(self.coefficients, X), self.index, radicals=False)

    def as_data(self) -> dict[str, Any]:
        """What JSON holds of it: the coefficients, the index, 30 digits."""
        return {"root_of": list(self.coefficients), "index": self.index, "decimal": str(self.value.evalf(DIGITS))}

    def as_text(self) -> str:
        """The polynomial and the place of the root, and its first digits."""
        polynomial = str(Poly(self.coefficients, X).as_expr()).replace("**", "^")
        return f"root {self.index} of {polynomial} = {self.value.evalf(10)}..."

    def as_latex(self) -> str:
        """The first digits, and the polynomial that has the root."""
        return rf"{self.value.evalf(10)}\ldots \;\left({latex(Poly(self.coefficients, X).as_expr())} = 0\right)"


def real_roots(coefficients: list[Any]) -> list[tuple[Any, int]]:
    """The distinct roots in ascending order, each with its multiplicity: exact expressions, or a Root.

    `coefficients`, exact real numbers, highest power first, are of a polynomial that has real roots only. NotDecided
    if it has a factor of degree three or more over a field that contains pi.
    """
    if len(coefficients) < 4:
        return merged([(value, 1) for value in _of_low_degree(*coefficients[1:])])
    field = NumberField(*coefficients)
    found: list[tuple[Any, int]] = []
    for factor, multiplicity in _factors(coefficients, field):
        found += [(value, multiplicity) for value in _roots_of_factor(factor, field)]
    return merged(found)


def same_number(one: Any, other: Any) -> bool:
    """Whether two such roots are equal; a Root and a number that square roots express are not."""
    if isinstance(one, Root) or isinstance(other, Root):
        return bool(one == other)
    return is_zero(one - other)


def merged(found: list[tuple[Any, int]]) -> list[tuple[Any, int]]:
    """Numbers with multiplicities in ascending order, those of equal ones added."""
    counted: dict[Any, int] = {}
    for value, multiplicity in found:
        known = next((other for other in counted if same_number(value, other)), value)
        counted[known] = counted.get(known, 0) + multiplicity
    return sorted(counted.items(), key=cmp_to_key(_order))


def _order(one: tuple[Any, int], other: tuple[Any, int]) -> int:
    return 0 if one[0] is other[0] else compare(value_of(one[0]), value_of(other[0]))


def _of_low_degree(*rest: Any) -> list[Any]:
    if len(rest) == 1:
        return [normal(-rest[0])]
    if independent_atoms(*rest) is None:
        raise NotDecided(f"square roots of sines, as in that of {rest[-1]}, are not told apart")
    return _of_quadratic(*rest)


def remainders(coefficients: list[Any], values: list[Any]) -> list[Any]:
    """What is left when a polynomial is divided by its supposed roots, one after the other: zeros if they are that.

    An exact number is divided out as a linear factor. A Root is by the integer polynomial that has it: this must
    divide the product of the polynomial with its conjugates.
    """
    left = list(coefficients)
    found: list[Any] = []
    for value in values:
        if isinstance(value, Root):
            continue
        quotient = [left[0]]
        for c in left[1:]:
            quotient.append(normal(c + value * quotient[-1]))
        found.append(quotient.pop())
        left = quotient
    field = NumberField(*left)
    rest = Poly.from_list([field(c) for c in left], X, domain=field.domain)
    product = rest.norm() if field.domain.is_Algebraic else rest
    places = dict.fromkeys(value for value in values if isinstance(value, Root))
    found += [product.rem(Poly(place.coefficients, X, domain="QQ")).as_expr() for place in places]
    return [*found, sp.Integer(rest.degree() - len(places))]


def place_of(polynomial: Poly, number: Any) -> Root:
    """The root of a rational polynomial that the number is: its irreducible factor and its place."""
    factors = [factor for factor, _ in polynomial.factor_list()[1]]
    places = [Root(_integers(factor), index) for factor in factors for index in range(factor.count_roots())]
    (found,) = _where_zero(places, lambda x: x - number, 1)
    return found


def _where_zero(places: list[Root], value: Callable[[Any], Any], count: int) -> list[Root]:
    """The places, so many in number, at which a value is zero: enclosures leave out the others."""
    bits = 128
    while len(places) > count:
        within = [(place, enclosed(value(place.value), bits)) for place in places]
        places = [place for place, interval in within if not (interval > 0 or interval < 0)]
        bits *= 2
    return places


def value_of(found: Any) -> Any:
    """The number as SymPy has it."""
    return found.value if isinstance(found, Root) else found


def _factors(coefficients: list[Any], field: NumberField) -> list[tuple[Poly, int]]:
    polynomial = Poly.from_list([field(c) for c in coefficients], X, domain=field.domain)
    return [(factor.monic(), multiplicity) for factor, multiplicity in polynomial.factor_list()[1]]


def _roots_of_factor(factor: Poly, field: NumberField) -> list[Any]:
    _, *rest = [field.expression(c) for c in factor.rep.to_list()]
    if len(rest) < 3:
        return _of_low_degree(*rest)
    if field.free:
        strangers = ", ".join(map(str, field.free))
        raise NotDecided(
            f"a polynomial with {strangers} in it has roots beyond square roots, and no integer coefficients"
        )
    halves = _halves(rest, field) if len(rest) == 4 else ()
    return [value for half in halves for value in _of_quadratic(*half)] or _places(factor)


def _of_quadratic(b: Any, c: Any) -> list[Any]:
    """The roots of x^2 + b x + c."""
    width = root(b**2 - 4 * c)
    return [normal((-b - width) / 2), normal((-b + width) / 2)]


def _halves(coefficients: list[Any], field: NumberField) -> tuple[tuple[Any, Any], ...]:
    """Two quadratics whose product is x^4 + b x^3 + c x^2 + d x + e, by Descartes; none if no square root splits it."""
    b, c, d, e = coefficients
    p = normal(c - 3 * b**2 / 8)
    q = normal(d - b * c / 2 + b**3 / 8)
    r = normal(e - b * d / 4 + b**2 * c / 16 - 3 * b**4 / 256)
    if q == 0:
        width = root(p**2 - 4 * r)
        halves = ((sp.Integer(0), (p - width) / 2), (sp.Integer(0), (p + width) / 2))
    else:
        resolvent = _factors([sp.Integer(1), 2 * p, p**2 - 4 * r, -(q**2)], field)
        square = next(
            (-field.expression(factor.rep.to_list()[1]) for factor, _ in resolvent if factor.degree() == 1), None
        )
        if square is None:
            return ()
        u = root(square)
        halves = ((u, (p + square - q / u) / 2), (-u, (p + square + q / u) / 2))
    # x + b / 4 stands in for the unknown of the depressed equation.
    return tuple((normal(m + b / 2), normal(n + m * b / 4 + b**2 / 16)) for m, n in halves)


def _places(factor: Poly) -> list[Any]:
    """The roots of an irreducible factor among those of the least integer polynomial that it divides."""
    rational = factor.norm() if factor.domain.is_Algebraic else factor
    least = rational.sqf_part()
    places = [Root(_integers(least), index) for index in range(least.count_roots())]
    return [*_where_zero(places, lambda x: factor.as_expr().xreplace({X: x}), factor.degree())]


def _integers(polynomial: Poly) -> tuple[int, ...]:
    """The coefficients of the primitive integer polynomial with the same roots."""
    _, cleared = polynomial.clear_denoms(convert=True)
    _, primitive = cleared.primitive()
    sign = 1 if primitive.LC() > 0 else -1
    return tuple(sign * int(c) for c in primitive.all_coeffs())
